#include "core/scene/ScanSmoothing.h"

#include <algorithm>

namespace asperity {

namespace {

/// The next wider low-pass [tenths of a pixel]. One below 4 leaves more than nine tenths of the
/// noise of curvatures: that is none.
int widerThan(int tenths) {
    constexpr int kNarrowest = 4;
    return std::max({kNarrowest, tenths + 1, ((11 * tenths) + 5) / 10});
}

Smoothing ofTenths(int tenths) { return {.x = tenths / 10.0, .y = tenths / 10.0}; }

ScanSmoothing smoothingBy(const CurvatureNoise& scan, const Smoothing& width,
                          const std::optional<SmoothingChoice>& choice) {
    const double noise = scan.noise(width);
    return {width, scan.heightNoise(width, noise), noise, choice};
}

template <class Map>
ScanSmoothing smoothingOn(const SceneDescription& scene, const Map& map) {
    const CurvatureNoise scan(map, scene.uncertainty.heightNoise);
    if (!leavesSmoothing(scene.sample)) {
        return smoothingBy(scan, smoothingOf(scene.sample, map), std::nullopt);
    }
    const SmoothingChoice choice = chooseSmoothing(scan, scene.tip.radius, scene.tolerance);
    return smoothingBy(scan, {.x = choice.pixels, .y = choice.pixels}, choice);
}

}  // namespace

SmoothingChoice chooseSmoothing(const CurvatureNoise& scan, double tipRadius, double tolerance) {
    constexpr double kFinest = 0.01;  // scanners leave more of curvatures: nothing is gained below
    constexpr int kWidest = 700;      // [tenths]: blur() looks at one wider by sqrt(2)
    const double enough = std::max(tolerance, kFinest);
    int tenths = 0;
    double noise = scan.noise({});
    for (int wider = widerThan(0); tipRadius * noise > enough && wider <= kWidest;
         wider = widerThan(tenths)) {
        const double left = scan.noise(ofTenths(wider));
        if (scan.blur(ofTenths(wider), left) > left) {
            return {.pixels = tenths / 10.0, .isBounded = true};
        }
        tenths = wider;
        noise = left;
    }
    return {.pixels = tenths / 10.0};
}

ScanSmoothing smoothingFor(const SceneDescription& scene, const HeightMap& map) {
    return smoothingOn(scene, map);
}

ScanSmoothing smoothingFor(const SceneDescription& scene, const ScanMap& map) {
    return smoothingOn(scene, map);
}

}  // namespace asperity
