#include "core/surface/HeightRows.h"

#include <cstddef>
#include <limits>

namespace asperity {

namespace {

template <class Heights>
HeightRows rowsAbove(const BasicHeightMap<Heights>& map, double datum) {
    requireUsable(map);
    return {.columns = map.columns,
            .rows = map.rows,
            .pitchX = map.pitchX,
            .pitchY = map.pitchY,
            .readRow = [&map, datum](int row, double* heights) {
                for (int column = 0; column < map.columns; ++column) {
                    const double height = map.at(row, column);
                    const bool holdsData = map.isValid(row, column) && isFiniteHeight(height);
                    heights[column] =
                        holdsData ? datum + height : std::numeric_limits<double>::quiet_NaN();
                }
            }};
}

}  // namespace

HeightRows rowsOf(const HeightMap& map) { return rowsAbove(map, 0.0); }
HeightRows rowsOf(const ScanMap& map) { return rowsAbove(map, map.datum); }

}  // namespace asperity
