#include "core/surface/fit/CoarserSurface.h"

#include "core/surface/HeightMap.h"
#include "core/surface/fit/BSplineFit.h"

#include <algorithm>
#include <utility>

namespace asperity {

BSplineSurface coarserSurface(const BSplineSurface& surface, int mostPixels) {
    const BSplineSurface::Grid& grid = surface.grid();
    if (std::max(grid.columns, grid.rows) <= mostPixels) {
        return surface;
    }
    HeightMap map;
    map.columns = std::min(grid.columns, mostPixels);
    map.rows = std::min(grid.rows, mostPixels);
    map.pitchX = surface.sizeX() / map.columns;
    map.pitchY = surface.sizeY() / map.rows;
    for (int row = 0; row < map.rows; ++row) {
        const double y = (map.rows - row - 0.5) * map.pitchY;
        for (int column = 0; column < map.columns; ++column) {
            const double x = (column + 0.5) * map.pitchX;
            map.heights.push_back(surface.at(x, y).height);
            map.invalid.push_back(!surface.isMeasured(x, y));
        }
    }
    return fitSurface(std::move(map));
}

}  // namespace asperity
