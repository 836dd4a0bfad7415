#include "core/surface/Residual.h"

#include "core/Error.h"

#include <limits>
#include <utility>

namespace asperity {

namespace {

/// Takes the surface from heights that are relative to a datum.
template <class Heights>
void subtract(BasicHeightMap<Heights>& map, double datum, const BSplineSurface& surface) {
    using Height = typename Heights::value_type;
    requireUsable(map);
    if (surface.grid().columns != map.columns || surface.grid().rows != map.rows) {
        throw Error("the surface was not fitted to this map: it has another size");
    }
    for (int row = 0; row < map.rows; ++row) {
        const double y = (map.rows - row - 0.5) * map.pitchY;
        for (int column = 0; column < map.columns; ++column) {
            const double x = (column + 0.5) * map.pitchX;
            const double residual = map.at(row, column) + datum - surface.at(x, y).height;
            map.heights[map.index(row, column)] = map.isValid(row, column)
                                                      ? static_cast<Height>(residual)
                                                      : std::numeric_limits<Height>::quiet_NaN();
        }
    }
}

}  // namespace

HeightMap residualOf(HeightMap map, const BSplineSurface& surface) {
    subtract(map, 0.0, surface);
    return map;
}

ScanMap residualOf(ScanMap map, const BSplineSurface& surface) {
    subtract(map, map.datum, surface);
    map.datum = 0.0;
    return map;
}

}  // namespace asperity
