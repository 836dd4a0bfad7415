#pragma once

#include "core/Progress.h"
#include "core/surface/HeightMap.h"

#include <vector>

namespace asperity {

/// What each row is shifted by, row 0 at the top [m]; a row without data is not shifted by itself.
using RowShifts = std::vector<double>;

/// The median of each row. Here and below: @throw Canceled
template <class Heights>
[[nodiscard]] RowShifts rowMedians(const BasicHeightMap<Heights>& map,
                                   Progress* progress = nullptr);

/// Sums, from the top down, of the median difference of each row to the last one above it that
/// holds data; 0 where both share no column.
template <class Heights>
[[nodiscard]] RowShifts differenceShifts(const BasicHeightMap<Heights>& map,
                                         Progress* progress = nullptr);

/// The same without the least-squares line through the shifts of rows with data: the scan's trend
/// along y stays in the heights, as Gwyddion has it.
template <class Heights>
[[nodiscard]] RowShifts detrendedDifferenceShifts(const BasicHeightMap<Heights>& map,
                                                  Progress* progress = nullptr);

template <class Heights>
void subtractRows(BasicHeightMap<Heights>& map, const RowShifts& shifts,
                  Progress* progress = nullptr);

/// Standard deviation of the shifts of rows with data [m].
template <class Heights>
[[nodiscard]] double spreadOf(const RowShifts& shifts, const BasicHeightMap<Heights>& map);

}  // namespace asperity
