#include "core/surface/HeightRows.h"

#include <cstddef>
#include <limits>

namespace asperity {

namespace {

template <class Heights>
HeightRows rowsAbove(const BasicHeightMap<Heights>& map, double datum) {
    requireUsable(map);
    const auto read = [&map, datum](int row, double* heights, const auto& holdsHeight) {
        for (int column = 0; column < map.columns; ++column) {
            const double height = map.at(row, column);
            heights[column] = holdsHeight(column, height)
                                  ? datum + height
                                  : std::numeric_limits<double>::quiet_NaN();
        }
    };
    HeightRows rows{.columns = map.columns,
                    .rows = map.rows,
                    .pitchX = map.pitchX,
                    .pitchY = map.pitchY,
                    .readRow = [&map, read](int row, double* heights) {
                        read(row, heights, [&map, row](int column, double height) {
                            return map.isValid(row, column) && isFiniteHeight(height);
                        });
                    }};
    if (!map.invalid.empty()) {
        rows.readFilledRow = [read](int row, double* heights) {
            read(row, heights, [](int, double height) { return isFiniteHeight(height); });
        };
    }
    return rows;
}

}  // namespace

HeightRows rowsOf(const HeightMap& map) { return rowsAbove(map, 0.0); }
HeightRows rowsOf(const ScanMap& map) { return rowsAbove(map, map.datum); }

}  // namespace asperity
