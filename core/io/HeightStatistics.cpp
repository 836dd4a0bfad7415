#include "core/io/HeightStatistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

template <typename Visit>
void forEachValid(const HeightMap& map, Visit visit) {
    for (std::size_t i = 0; i < map.heights.size(); ++i) {
        if (map.invalid.empty() || !map.invalid[i]) {
            visit(map.heights[i]);
        }
    }
}

}  // namespace

HeightStatistics heightStatistics(const HeightMap& map) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    HeightStatistics result{kNone, kNone, kNone, kNone, 0};
    std::size_t valid = 0;
    double sum = 0.0;
    forEachValid(map, [&](double height) {
        result.lowest = valid == 0 ? height : std::min(result.lowest, height);
        result.highest = valid == 0 ? height : std::max(result.highest, height);
        sum += height;
        ++valid;
    });
    result.invalidPixels = map.heights.size() - valid;
    if (valid == 0) {
        return result;
    }
    result.mean = sum / static_cast<double>(valid);
    double squares = 0.0;
    forEachValid(
        map, [&](double height) { squares += (height - result.mean) * (height - result.mean); });
    result.rms = std::sqrt(squares / static_cast<double>(valid));
    return result;
}

}  // namespace asperity
