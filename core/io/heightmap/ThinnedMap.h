#pragma once

#include "core/Progress.h"
#include "core/io/heightmap/HeightStatistics.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/surface/HeightMap.h"

#include <cstddef>

namespace asperity {

/// A part of a channel with one pixel of each step only, so that a large one is there soon.
struct ThinnedMap {
    HeightMap map;  ///< its pitch is that of the pixels that are left; 0: not known
    int step = 1;   ///< of this many pixels along each axis, one is left
};

/// Pixels of a thinned map, at most.
inline constexpr std::size_t kThinnedPixels = std::size_t{1} << 20U;

/// Reads a part of a channel; rows that are left out are not read at all where the format allows.
/// @param channel of file.contents(); @param part lies in it
/// @param most pixels, at least 1
/// @throw InputError as ScanFile::rowsOf(); Canceled
[[nodiscard]] ThinnedMap thinnedMap(const ScanFile& file, const ScanChannel& channel,
                                    const PixelRectangle& part, Progress* progress = nullptr,
                                    std::size_t most = kThinnedPixels);

/// Statistics of the pixels that are left.
[[nodiscard]] HeightStatistics heightStatistics(const HeightMap& map);

}  // namespace asperity
