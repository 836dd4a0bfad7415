#include "core/surface/imaging/TipErosion.h"

#include "core/surface/imaging/FootprintSearch.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace asperity {

namespace {

template <class Heights>
using Map = BasicHeightMap<Heights>;

template <class Heights>
TipFootprint::Grid gridOf(const Map<Heights>& map) {
    return {map.columns, map.rows, map.pitchX, map.pitchY};
}

template <class Heights>
SearchedHeights<Heights> heightsOf(const Map<Heights>& map) {
    return {.values = map.heights, .invalid = &map.invalid};
}

/// The map with new heights in the pixels that count.
template <class Heights>
void replaceHeights(Map<Heights>& map, Heights heights) {
    const SearchedHeights<Heights> before = heightsOf(map);
    for (std::size_t i = 0; i < heights.size(); ++i) {
        if (!before.counts(i)) {
            heights[i] = map.heights[i];
        }
    }
    map.heights = std::move(heights);
}

/// Below invalid pixels too, as far as the tip reaches; minus infinity elsewhere. The sign is
/// turned on the way: a minimum of sums is a maximum of differences.
template <class Heights>
Heights erosion(const Map<Heights>& image, double tipRadius, Progress* progress = nullptr,
                TouchedPoint point = TouchedPoint::Pixel) {
    SearchedHeights<Heights> turned = heightsOf(image);
    turned.isTurned = true;
    const FootprintSearch<Heights> search(gridOf(image), turned, tipRadius);
    Heights heights = point == TouchedPoint::Pixel ? search.highest(progress)
                                                   : search.highestBetweenPixels(progress);
    using Height = typename Heights::value_type;
    constexpr auto kNone = -std::numeric_limits<Height>::infinity();
    for (Height& height : heights) {
        height = height == kNone ? kNone : -height;
    }
    return heights;
}

/// The largest distance from zero of what is a height.
template <class Heights>
double scaleOf(const Heights& heights) {
    double scale = 0.0;
    for (const auto height : heights) {
        scale =
            isFiniteHeight(height) ? std::max(scale, std::abs(static_cast<double>(height))) : scale;
    }
    return scale;
}

/// By how much rounding can lower a touched pixel against the tip's surface [m]: its height may
/// come from a pixel of the image that was rounded down, the level from one that was rounded up.
template <class Heights>
double roundingOf(const Heights& image, const Heights& surface, double tipRadius) {
    constexpr double kStore = std::numeric_limits<typename Heights::value_type>::epsilon();
    constexpr double kComputed = std::numeric_limits<double>::epsilon();
    const double computed = 4.0 * kComputed * (scaleOf(image) + tipRadius);
    const double stored = kStore * (scaleOf(image) + 0.5 * scaleOf(surface));
    return kStore == kComputed ? computed : computed + stored;
}

/// Certainty of a surface that was eroded from an image.
template <class Heights>
std::vector<std::uint8_t> touched(const Map<Heights>& image, const Heights& surface,
                                  double tipRadius, Progress* progress) {
    const FootprintSearch<Heights> search(gridOf(image), {.values = surface}, tipRadius);
    return search.reachingAlone(heightsOf(image), roundingOf(image.heights, surface, tipRadius),
                                progress);
}

template <class AnyMap>
BasicTipReconstruction<AnyMap> reconstruction(AnyMap image, double tipRadius, Progress* progress,
                                              TouchedPoint point) {
    requireUsable(image);
    const double share = point == TouchedPoint::Pixel ? 0.5 : 0.4;  // of all, by each step
    ProgressPart eroding(progress, 0.0, share);
    auto surface = erosion(image, tipRadius, &eroding);
    ProgressPart telling(progress, share, 2.0 * share);
    std::vector<std::uint8_t> certain = touched(image, surface, tipRadius, &telling);
    if (point == TouchedPoint::BetweenPixels) {
        surface = decltype(surface)();  // of a large scan there is no memory for both; {} keeps it
        ProgressPart refining(progress, 2.0 * share, 1.0);
        surface = erosion(image, tipRadius, &refining, point);
    }
    replaceHeights(image, std::move(surface));
    return {std::move(image), std::move(certain)};
}

template <class AnyMap>
std::vector<std::uint8_t> certainOf(const AnyMap& image, double tipRadius, Progress* progress) {
    requireUsable(image);
    ProgressPart eroding(progress, 0.0, 0.5);
    const auto surface = erosion(image, tipRadius, &eroding);
    ProgressPart telling(progress, 0.5, 1.0);
    return touched(image, surface, tipRadius, &telling);
}

/// Returns the pixel of a line of `count` nearest to `position`; 0 for what is no number.
int pixelAt(double position, double pitch, int count) {
    const double pixel = position / pitch;
    if (!std::isgreater(pixel, 0.0)) {
        return 0;
    }
    return static_cast<int>(std::min(pixel, count - 1.0));
}

}  // namespace

HeightMap dilated(HeightMap surface, double tipRadius) {
    requireUsable(surface);
    const FootprintSearch search(gridOf(surface), heightsOf(surface), tipRadius);
    replaceHeights(surface, search.highest());
    return surface;
}

HeightMap eroded(HeightMap image, double tipRadius) {
    requireUsable(image);
    replaceHeights(image, erosion(image, tipRadius));
    return image;
}

TipReconstruction reconstructed(HeightMap image, double tipRadius, Progress* progress,
                                TouchedPoint point) {
    return reconstruction(std::move(image), tipRadius, progress, point);
}

ScanReconstruction reconstructed(ScanMap image, double tipRadius, Progress* progress,
                                 TouchedPoint point) {
    return reconstruction(std::move(image), tipRadius, progress, point);
}

std::vector<std::uint8_t> certainPixels(const HeightMap& image, double tipRadius,
                                        Progress* progress) {
    return certainOf(image, tipRadius, progress);
}

std::vector<std::uint8_t> certainPixels(const ScanMap& image, double tipRadius,
                                        Progress* progress) {
    return certainOf(image, tipRadius, progress);
}

bool CertaintyMap::isUncertain(double x, double y) const noexcept {
    if (!isKnown()) {
        return false;
    }
    const int row = rows_ - 1 - pixelAt(y, pitchY_, rows_);
    return !certain_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                     static_cast<std::size_t>(pixelAt(x, pitchX_, columns_))];
}

double CertaintyMap::certainShare() const noexcept {
    const auto certain = std::ranges::count(certain_, true);
    return isKnown() ? static_cast<double>(certain) / static_cast<double>(certain_.size()) : 0.0;
}

}  // namespace asperity
