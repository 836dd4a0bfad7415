#include "core/surface/fit/BSplineFit.h"

#include "core/surface/InvalidPixels.h"
#include "core/surface/fit/SeparableFit.h"

#include <algorithm>
#include <utility>

namespace asperity {

namespace {

/// Turns the mask of a map upside down, in place: the surface counts its rows from the bottom.
PixelMask bottomRowFirst(PixelMask mask, int columns) {
    const auto width = static_cast<std::ptrdiff_t>(columns);
    for (std::ptrdiff_t top = 0, end = std::ssize(mask); end - top >= 2 * width;
         top += width, end -= width) {
        std::swap_ranges(mask.begin() + top, mask.begin() + top + width,
                         mask.begin() + end - width);
    }
    return mask;
}

}  // namespace

BSplineSurface fitSurface(ScanMap map, const Smoothing& smoothing, Progress* progress) {
    map = withInvalidPixelsFilled(std::move(map));
    reportTo(progress, 0.0);
    const LineFit alongX(map.columns, smoothing.x);
    const LineFit alongY(map.rows, smoothing.y);
    ProgressPart fitting(progress, 0.0, 0.5);
    BSplineSurface::Grid grid{.columns = map.columns,
                              .rows = map.rows,
                              .pitchX = map.pitchX,
                              .pitchY = map.pitchY,
                              .datum = map.datum,
                              .controlHeights = separableFit(map, alongX, alongY, &fitting),
                              .invalid = bottomRowFirst(std::move(map.invalid), map.columns)};
    // The surface's own bounds take the room that the map had.
    map.heights = PixelVector<float>();
    ProgressPart bounding(progress, 0.5, 1.0);
    return BSplineSurface(std::move(grid), &bounding);
}

BSplineSurface fitSurface(const HeightMap& map, const Smoothing& smoothing) {
    return fitSurface(singlePrecision(map), smoothing);
}

}  // namespace asperity
