#include "core/surface/Residual.h"

#include "core/Error.h"

#include <limits>
#include <utility>

namespace asperity {

HeightMap residualOf(HeightMap map, const BSplineSurface& surface) {
    requireUsable(map);
    if (surface.grid().columns != map.columns || surface.grid().rows != map.rows) {
        throw Error("the surface was not fitted to this map: it has another size");
    }
    for (int row = 0; row < map.rows; ++row) {
        const double y = (map.rows - row - 0.5) * map.pitchY;
        for (int column = 0; column < map.columns; ++column) {
            const double x = (column + 0.5) * map.pitchX;
            double& height = map.heights[map.index(row, column)];
            height = map.isValid(row, column) ? height - surface.at(x, y).height
                                              : std::numeric_limits<double>::quiet_NaN();
        }
    }
    return map;
}

}  // namespace asperity
