#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdio>

namespace asperity {

/// Sum of all pixels: a look at every one of them. In lanes that do not wait for each other, so
/// that the look costs little beside the load.
template <class Number>
double sumOf(const Number* pixels, std::size_t count) {
    std::array<double, 16> lanes{};
    std::size_t i = 0;
    for (; i + lanes.size() <= count; i += lanes.size()) {
        for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
            lanes[lane] += static_cast<double>(pixels[i + lane]);
        }
    }
    double sum = 0.0;
    for (; i < count; ++i) {
        sum += static_cast<double>(pixels[i]);
    }
    for (const double lane : lanes) {
        sum += lane;
    }
    return sum;
}

/// Prints how long a load took since `begin` [ns], and the sum of the heights [m].
inline void printLoad(std::chrono::steady_clock::time_point begin, double sum) {
    const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - begin;
    std::printf("%.0f %.17g\n", time.count(), sum);
}

}  // namespace asperity
