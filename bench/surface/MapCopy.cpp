#include "bench/surface/MapCopy.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <limits>
#include <vector>

namespace asperity {

CopyResult timeCopy(int pixels) {
    constexpr int kRepeats = 21;
    const auto count = static_cast<std::size_t>(pixels) * static_cast<std::size_t>(pixels);
    const std::vector<float> from(count, 1.0F);
    std::vector<float> to(count);
    double best = std::numeric_limits<double>::infinity();
    volatile float used = 0.0F;
    for (int i = 0; i < kRepeats; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        std::copy(from.begin(), from.end(), to.begin());
        const std::chrono::duration<double, std::nano> taken =
            std::chrono::steady_clock::now() - begin;
        used = to[static_cast<std::size_t>(i)];
        best = std::min(best, taken.count());
    }
    static_cast<void>(used);
    return {.pixels = pixels, .time = best};
}

}  // namespace asperity
