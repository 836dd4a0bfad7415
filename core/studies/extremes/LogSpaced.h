#pragma once

#include <cmath>
#include <vector>

namespace asperity {

/// `count` >= 2 values of one sign from first to last, each the same factor apart.
[[nodiscard]] inline std::vector<double> logSpaced(double first, double last, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) {
        values.push_back(first * std::pow(last / first, static_cast<double>(i) / (count - 1)));
    }
    return values;
}

}  // namespace asperity
