#include "tests/support/TestScenes.h"

#include "core/Units.h"

#include <cmath>
#include <numbers>

namespace asperity::test {

namespace {

constexpr int kPixels = 64;
constexpr double kPitch = 2.0_nm;

template <class Height>
HeightMap mapOf(const Height& height) {
    HeightMap map{.columns = kPixels, .rows = kPixels, .pitchX = kPitch, .pitchY = kPitch};
    for (int row = 0; row < kPixels; ++row) {
        for (int column = 0; column < kPixels; ++column) {
            map.heights.push_back(height((column + 0.5) * kPitch, (kPixels - row - 0.5) * kPitch));
        }
    }
    return map;
}

}  // namespace

HeightMap flatMap() {
    return mapOf([](double, double) { return 0.0; });
}

HeightMap slopedMap(double slope) {
    return mapOf([slope](double x, double) { return slope * x; });
}

HeightMap hillyMap() {
    return mapOf([](double x, double y) {
        constexpr double kWave = 2.0 * std::numbers::pi / 60.0_nm;
        return 6.0_nm * std::sin(kWave * x) * std::sin(kWave * y);
    });
}

HeightMap ridgedMap(double height) {
    return mapOf([height](double x, double) {
        constexpr double kWave = 2.0 * std::numbers::pi / 60.0_nm;
        return height * std::sin(kWave * x);
    });
}

SceneDescription plainScene() {
    SceneDescription scene = defaultScene();
    scene.sample.leveling = {};
    scene.sample.smoothingPixels = 0.0;
    return scene;
}

}  // namespace asperity::test
