#pragma once

#include "core/Progress.h"
#include "core/surface/HeightMap.h"

#include <utility>
#include <vector>

namespace asperity {

/// Widest low-pass that is offered [pixel]: what is left of a scan beyond it is no surface.
inline constexpr double kMaxSmoothing = 100.0;

/// Standard deviation of a Gaussian low-pass along each axis; 0: none.
struct Smoothing {
    double x = 0.0;  ///< [pixel]
    double y = 0.0;  ///< [pixel]
};

/// The same length along both axes, whatever the shape of the pixels.
/// @param sigma [m]
template <class Map>
[[nodiscard]] Smoothing smoothingByLength(double sigma, const Map& map) {
    return {.x = sigma / map.pitchX, .y = sigma / map.pitchY};
}

/// Weights of the middle and of the pixels on one side of it, cut off at 5 standard deviations; the
/// whole kernel sums to 1. Only the middle where all others would round to nothing.
/// @param sigma standard deviation [pixel]
/// @throw Error when it is not in 0..kMaxSmoothing
[[nodiscard]] std::vector<double> halfGaussian(double sigma);

/// A sample beyond the ends of a line, which is continued by point reflection about its end
/// samples, as often as needed: own line[index] + first line[0] + last line[samples - 1].
struct ReflectedSample {
    int index = 0;
    double own = 1.0;
    double first = 0.0;
    double last = 0.0;
};

[[nodiscard]] ReflectedSample reflectedSample(int samples, int index);

/// The map after a Gaussian low-pass, the map being continued by point reflection, so that a plane
/// comes back unchanged. Works in place. A scan on its way into a scene is smoothed by
/// fitSurface(), far faster.
/// @throw Error when the map is unusable, a height is not finite, or a width is not in
///        0..kMaxSmoothing; Canceled
[[nodiscard]] HeightMap smoothed(HeightMap map, const Smoothing& smoothing,
                                 Progress* progress = nullptr);
[[nodiscard]] ScanMap smoothed(ScanMap map, const Smoothing& smoothing,
                               Progress* progress = nullptr);

/// The same width along both axes. @param sigma [pixel]
[[nodiscard]] inline HeightMap smoothed(HeightMap map, double sigma) {
    return smoothed(std::move(map), Smoothing{.x = sigma, .y = sigma});
}

}  // namespace asperity
