#pragma once

#include "core/ShareOut.h"
#include "core/surface/HeightMap.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace asperity {

/// Returns whether a pixel takes part in leveling and measures: it holds data.
template <class Heights>
[[nodiscard]] bool counts(const BasicHeightMap<Heights>& map, int row, int column) {
    return map.isValid(row, column) && isFiniteHeight(map.at(row, column));
}

/// Subtracts removed(row, column) [m] from all pixels, so that filled ones stay beside their
/// neighbors; those without a height stay without one. @throw Canceled with some rows done
template <class Heights, class Removed>
void subtract(BasicHeightMap<Heights>& map, const Removed& removed, Progress* progress = nullptr) {
    using Height = typename Heights::value_type;
    shareOut(map.rows, progress, [&](int row, const CancelCheck& /*check*/) {
        for (int column = 0; column < map.columns; ++column) {
            Height& height = map.heights[map.index(row, column)];
            height = static_cast<Height>(height - removed(row, column));
        }
    });
}

/// Returns the results of makeRow(row), computed on all cores; in the rows' order, so that sums of
/// them are the same to the last bit on any number of cores. @throw Canceled
template <class MakeRow>
[[nodiscard]] auto ofEachRow(int rows, Progress* progress, const MakeRow& makeRow) {
    std::vector<decltype(makeRow(0))> made(static_cast<std::size_t>(rows));
    shareOut(rows, progress, [&](int row, const CancelCheck& /*check*/) {
        made[static_cast<std::size_t>(row)] = makeRow(row);
    });
    return made;
}

/// The mean of the two middle values when their number is even, as in statistics. Reorders them;
/// there must be one.
[[nodiscard]] inline double median(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) {
        return *middle;
    }
    return 0.5 * (*std::max_element(values.begin(), middle) + *middle);
}

}  // namespace asperity
