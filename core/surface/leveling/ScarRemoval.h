#pragma once

#include "core/Progress.h"
#include "core/surface/HeightMap.h"

#include <cstddef>
#include <vector>

namespace asperity {

/// Limits that define a scar: Gwyddion's defaults. Thresholds are in units of the root mean square
/// of the differences between pixels above each other.
struct ScarLimits {
    int maxWidth = 4;     ///< rows
    int minLength = 16;   ///< pixels along a row
    double hard = 0.666;  ///< a scar stands out by this much somewhere in each of its segments
    double soft = 0.25;   ///< and by this much everywhere
};

/// The scars of a map: pixels of at most `maxWidth` rows that all stand out, up or down, from the
/// rows on both sides, in segments of at least `minLength`. Pixels without data take part in none.
/// Empty where there is none.
/// @throw Error when the map is unusable; Canceled
template <class Heights>
[[nodiscard]] PixelMask scarsOf(const BasicHeightMap<Heights>& map, const ScarLimits& limits = {},
                                Progress* progress = nullptr);

/// Interpolates the scars linearly between the nearest good pixels above and below, and marks them
/// as holding no data: pictures hatch them, contact there is flagged.
/// @return how many pixels @throw as scarsOf(); Canceled with some of them done
template <class Heights>
std::size_t removeScars(BasicHeightMap<Heights>& map, const ScarLimits& limits = {},
                        Progress* progress = nullptr);

/// Shift of each row, row 0 at the top [m]; a row without data is not shifted by itself.
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
