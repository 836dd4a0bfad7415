#include "core/surface/fit/BSplineFit.h"

#include "core/Error.h"
#include "core/surface/HeightMap.h"
#include "core/surface/fit/SeparableFit.h"

#include <algorithm>
#include <cmath>
#include <limits>
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

/// Returns whether control heights in single precision, each off by up to 2^-25 of the largest,
/// would show in second derivatives: four such errors over a pitch squared.
bool needsRests(const BSplineSurface::Grid& grid) {
    constexpr double kRounding = 0x1p-25;
    constexpr double kTolerated = 1e3;  // [1/m]: 1e-6 of the curvature of a tip of 1 nm
    const auto [low, high] = std::ranges::minmax(grid.controlHeights);
    const double largest = std::max(std::abs(low), std::abs(high));
    const double pitch = std::min(grid.pitchX, grid.pitchY);
    return 4.0 * kRounding * largest > kTolerated * pitch * pitch;
}

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

BSplineSurface fitSurface(HeightMap map, const Smoothing& smoothing, Progress* progress) {
    map = withInvalidPixelsFilled(std::move(map));
    reportTo(progress, 0.0);
    const double datum = middleHeight(map);
    for (double& height : map.heights) {
        height -= datum;
    }
    const FineLineFit alongX(map.columns, smoothing.x);
    const FineLineFit alongY(map.rows, smoothing.y);
    ProgressPart fitting(progress, 0.0, 0.5);
    const PixelVector<double> controls = separableFit(map, alongX, alongY, &fitting);
    BSplineSurface::Grid grid{.columns = map.columns,
                              .rows = map.rows,
                              .pitchX = map.pitchX,
                              .pitchY = map.pitchY,
                              .datum = datum,
                              .controlHeights = PixelVector<float>(controls.size()),
                              .invalid = bottomRowFirst(std::move(map.invalid), map.columns)};
    std::ranges::transform(controls, grid.controlHeights.begin(),
                           [](double height) { return static_cast<float>(height); });
    if (needsRests(grid)) {
        grid.controlRests.resize(controls.size());
        std::ranges::transform(controls, grid.controlHeights, grid.controlRests.begin(),
                               [](double height, float stored) {
                                   return static_cast<float>(height - static_cast<double>(stored));
                               });
    }
    ProgressPart bounding(progress, 0.5, 1.0);
    return BSplineSurface(std::move(grid), &bounding);
}

BSplineSurface coarserSurface(const BSplineSurface& surface, int mostPixels) {
    const BSplineSurface::Grid& grid = surface.grid();
    if (std::max(grid.columns, grid.rows) <= mostPixels) {
        return surface;
    }
    HeightMap map;
    map.columns = std::min(grid.columns, mostPixels);
    map.rows = std::min(grid.rows, mostPixels);
    map.pitchX = surface.sizeX() / map.columns;
    map.pitchY = surface.sizeY() / map.rows;
    for (int row = 0; row < map.rows; ++row) {
        const double y = (map.rows - row - 0.5) * map.pitchY;
        for (int column = 0; column < map.columns; ++column) {
            const double x = (column + 0.5) * map.pitchX;
            map.heights.push_back(surface.at(x, y).height);
            map.invalid.push_back(!surface.isMeasured(x, y));
        }
    }
    return fitSurface(std::move(map));
}

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
