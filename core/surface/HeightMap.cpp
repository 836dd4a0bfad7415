#include "core/surface/HeightMap.h"

#include "core/Error.h"

#include <cmath>
#include <string>

namespace asperity {

void requireUsable(const HeightMap& map) {
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

void requireFinite(const HeightMap& map) {
    requireUsable(map);
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            if (!isFiniteHeight(map.at(row, column))) {
                throw Error("the height at row " + std::to_string(row) + ", column " +
                            std::to_string(column) + " is not a finite number");
            }
        }
    }
}

}  // namespace asperity
