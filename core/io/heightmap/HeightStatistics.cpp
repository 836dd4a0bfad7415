#include "core/io/heightmap/HeightStatistics.h"

#include "core/surface/HeightMap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

HeightStatistics heightStatistics(const std::function<void(const TakeRow&)>& giveRows) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    HeightStatistics result{kNone, kNone, kNone, kNone, 0};
    std::size_t valid = 0;
    double sum = 0.0;
    giveRows([&](std::span<const double> values) {
        for (const double value : values) {
            if (isFiniteHeight(value)) {
                result.lowest = valid == 0 ? value : std::min(result.lowest, value);
                result.highest = valid == 0 ? value : std::max(result.highest, value);
                sum += value;
                ++valid;
            } else {
                ++result.invalidPixels;
            }
        }
    });
    if (valid == 0) {
        return result;
    }
    result.mean = sum / static_cast<double>(valid);
    double squares = 0.0;
    giveRows([&](std::span<const double> values) {
        for (const double value : values) {
            if (isFiniteHeight(value)) {
                squares += (value - result.mean) * (value - result.mean);
            }
        }
    });
    result.rms = std::sqrt(squares / static_cast<double>(valid));
    return result;
}

}  // namespace asperity
