#pragma once

#include <vector>

namespace asperity {

/// Round numbers within [low, high], at most about `room` of them, but never only one: a single
/// number says nothing about distances.
[[nodiscard]] std::vector<double> axisTicks(double low, double high, int room);

}  // namespace asperity
