#include "core/surface/HeightMap.h"

#include "core/Error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace asperity {

template <class Heights>
void requireUsable(const BasicHeightMap<Heights>& map) {
    if (map.columns < 1 || map.rows < 1) {
        throw Error("a height map needs at least one pixel");
    }
    if (!(std::isfinite(map.pitchX) && std::isfinite(map.pitchY)) || map.pitchX <= 0.0 ||
        map.pitchY <= 0.0) {
        throw Error("the pixel size of a height map must be a positive length");
    }
    const std::size_t pixels = map.index(map.rows, 0);
    if (map.heights.size() != pixels || (!map.invalid.empty() && map.invalid.size() != pixels)) {
        throw Error("a height map of " + std::to_string(map.columns) + " x " +
                    std::to_string(map.rows) + " pixels holds " +
                    std::to_string(map.heights.size()) + " heights");
    }
}

template void requireUsable(const BasicHeightMap<std::vector<double>>&);
template void requireUsable(const BasicHeightMap<PixelVector<float>>&);

double middleHeight(const HeightMap& map) {
    double lowest = std::numeric_limits<double>::max();
    double highest = -lowest;
    for (const double height : map.heights) {
        if (isFiniteHeight(height)) {
            lowest = std::min(lowest, height);
            highest = std::max(highest, height);
        }
    }
    if (lowest > highest) {
        return 0.0;
    }
    const double middle = 0.5 * lowest + 0.5 * highest;
    if (highest - middle > std::numeric_limits<float>::max()) {
        throw Error("the heights of the map lie too far apart for single precision");
    }
    return middle;
}

}  // namespace asperity
