#include "core/surface/imaging/TipErosion.h"

#include "core/surface/imaging/FootprintSearch.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace asperity {

namespace {

constexpr double kNone = -std::numeric_limits<double>::infinity();

FootprintSearch::Grid gridOf(const HeightMap& map) {
    return {map.columns, map.rows, map.pitchX, map.pitchY};
}

bool counts(const HeightMap& map, std::size_t pixel) {
    return (map.invalid.empty() || map.invalid[pixel] == 0) && isFiniteHeight(map.heights[pixel]);
}

/// value(height) of the pixels that count; of the others, what takes no part in a search.
template <class Value>
std::vector<double> valuesOf(const HeightMap& map, const Value& value) {
    std::vector<double> values(map.heights.size(), kNone);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (counts(map, i)) {
            values[i] = value(map.heights[i]);
        }
    }
    return values;
}

/// The map with the heights of the pixels that count replaced.
template <class Value>
HeightMap withHeights(HeightMap map, const Value& value) {
    for (std::size_t i = 0; i < map.heights.size(); ++i) {
        if (counts(map, i)) {
            map.heights[i] = value(i);
        }
    }
    return map;
}

/// The erosion with its sign turned: a minimum of sums is a maximum of differences. Below invalid
/// pixels too, as far as the tip reaches; minus infinity elsewhere.
std::vector<double> turnedErosion(const HeightMap& image, double tipRadius,
                                  Progress* progress = nullptr) {
    const auto turned = valuesOf(image, [](double height) { return -height; });
    return FootprintSearch(gridOf(image), turned, tipRadius).highest(progress);
}

/// Below the image by what its heights were rounded by on the way through the erosion.
std::vector<double> touchLevels(const HeightMap& image, double tipRadius) {
    double scale = 0.0;
    for (std::size_t i = 0; i < image.heights.size(); ++i) {
        scale = counts(image, i) ? std::max(scale, std::abs(image.heights[i])) : scale;
    }
    const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * (scale + tipRadius);
    return valuesOf(image, [=](double height) { return height - rounding; });
}

}  // namespace

HeightMap dilated(const HeightMap& surface, double tipRadius) {
    requireUsable(surface);
    const auto heights = valuesOf(surface, [](double height) { return height; });
    const std::vector<double> image =
        FootprintSearch(gridOf(surface), heights, tipRadius).highest();
    return withHeights(surface, [&](std::size_t i) { return image[i]; });
}

HeightMap eroded(const HeightMap& image, double tipRadius) {
    requireUsable(image);
    const std::vector<double> turned = turnedErosion(image, tipRadius);
    return withHeights(image, [&](std::size_t i) { return -turned[i]; });
}

TipReconstruction reconstructed(const HeightMap& image, double tipRadius, Progress* progress) {
    requireUsable(image);
    ProgressPart eroding(progress, 0.0, 0.5);
    std::vector<double> surface = turnedErosion(image, tipRadius, &eroding);
    for (double& height : surface) {
        height = height == kNone ? kNone : -height;
    }
    const FootprintSearch search(gridOf(image), surface, tipRadius);
    ProgressPart telling(progress, 0.5, 1.0);
    return {withHeights(image, [&](std::size_t i) { return surface[i]; }),
            search.reachingAlone(touchLevels(image, tipRadius), &telling)};
}

}  // namespace asperity
