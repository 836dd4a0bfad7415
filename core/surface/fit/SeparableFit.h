#pragma once

#include "core/Progress.h"
#include "core/surface/HeightMap.h"
#include "core/surface/fit/LineFit.h"

#include <cstdint>

namespace asperity {

/// The instructions that a fit may use.
enum class VectorUnit : std::uint8_t {
    Baseline,  ///< what every processor of the architecture has
    Avx2,
};

/// The widest that this processor has.
[[nodiscard]] VectorUnit widestVectorUnit();

struct FitResources {
    VectorUnit unit = widestVectorUnit();
    int threads = 2;  ///< at most
};

/// Control heights of a map whose heights are all finite: both line fits in one pass over it.
/// Strip by strip of columns each row is fitted along x into a few rows that stay in the cache, and
/// those along y. In the map's own precision throughout, but for the borders, whose sums are
/// double. The result depends neither on the instructions nor on the number of threads.
/// @return (rows + 2) x (columns + 2), bottom row first, relative to the map's datum [m]
/// @throw Canceled
[[nodiscard]] PixelVector<float> separableFit(const ScanMap& map, const LineFit& alongX,
                                              const LineFit& alongY, Progress* progress = nullptr,
                                              const FitResources& resources = {});
/// The same in double precision; relative to what the map's heights are relative to.
[[nodiscard]] PixelVector<double> separableFit(const HeightMap& map, const FineLineFit& alongX,
                                               const FineLineFit& alongY,
                                               Progress* progress = nullptr,
                                               const FitResources& resources = {});

}  // namespace asperity
