#pragma once

#include "core/scene/SceneDescription.h"
#include "core/surface/fit/GaussianFilter.h"
#include "core/surface/measure/CurvatureNoise.h"

#include <optional>

namespace asperity {

/// A low-pass that a scene leaves to the program.
struct SmoothingChoice {
    double pixels = 0.0;  ///< standard deviation along both axes [pixel]; 0: none
    /// True where a wider one would take more from the curvature than from the noise; false: noise
    /// moves the effective radius by less than the tolerance.
    bool isBounded = false;

    bool operator==(const SmoothingChoice&) const = default;
};

/// Returns the smallest low-pass after which noise moves the effective radius by less than the
/// tolerance on a flat sample, or, where it comes first, the widest that takes less from the
/// curvature than noise leaves; in tenths of a pixel, and steps of a tenth of the width.
/// Source: docs/uncertainty.md 1.4.
/// @param tipRadius [m]
/// @param tolerance of the effective radius, relative
[[nodiscard]] SmoothingChoice chooseSmoothing(const CurvatureNoise& scan, double tipRadius,
                                              double tolerance);

/// Smoothing of a scan, and the noise that it leaves.
struct ScanSmoothing {
    Smoothing width;
    double heightNoise = 0.0;     ///< white noise of the heights that curvatures show after it [m]
    double curvatureNoise = 0.0;  ///< what it leaves of noise in the mean curvature [1/m]
    std::optional<SmoothingChoice> choice;  ///< none: the scene states it
};

/// Returns what the description says for a leveled scan, or chooses it.
[[nodiscard]] ScanSmoothing smoothingFor(const SceneDescription& scene, const HeightMap& map);
[[nodiscard]] ScanSmoothing smoothingFor(const SceneDescription& scene, const ScanMap& map);

/// The low-pass of a description that states it, on a map, or a grid, of this pitch.
template <class Map>
[[nodiscard]] Smoothing smoothingOf(const SampleDescription& sample, const Map& map) {
    if (sample.smoothingLength != 0.0) {
        return smoothingByLength(sample.smoothingLength, map);
    }
    const double pixels = sample.smoothingPixels.value_or(0.0);
    return {.x = pixels, .y = pixels};
}

/// Returns whether it leaves the low-pass to the program.
[[nodiscard]] inline bool leavesSmoothing(const SampleDescription& sample) noexcept {
    return !sample.smoothingPixels && sample.smoothingLength == 0.0;
}

}  // namespace asperity
