#pragma once

#include <string>
#include <vector>

namespace asperity {

/// The largest of 1, 2, 5 times a power of ten that is not above `value` (> 0).
[[nodiscard]] double niceBelow(double value);

/// Round numbers within [low, high], evenly spaced, at most about `count` of them.
[[nodiscard]] std::vector<double> niceTicks(double low, double high, int count);

/// Labels of evenly spaced ticks, all with the same number of decimals.
[[nodiscard]] std::vector<std::string> tickLabels(const std::vector<double>& ticks);

}  // namespace asperity
