#include "core/uncertainty/FitResponse.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asperity {
namespace {

/// @param tolerance of slopes, and of curvatures in units of the imaging tip's
void expectNear(const Relief& found, const Relief& expected, double tolerance) {
    for (int i = 0; i < found.size(); ++i) {
        EXPECT_NEAR(found[i], expected[i], tolerance * (i < 2 ? 1.0 : 1e8)) << i;
    }
}

constexpr double kImaging = 10e-9;  // [m]

SceneDescription imagedScene(bool erode) {
    SceneDescription description = test::plainScene();
    description.sample.imagingTipRadius = kImaging;
    description.sample.erode = erode;
    return description;
}

/// Hills that the tip fits, the first crest at 15 nm, 15 nm.
HeightMap fineHills() {
    constexpr int kPixels = 192;
    constexpr double kPitch = 0.25e-9;
    HeightMap map{.columns = kPixels, .rows = kPixels, .pitchX = kPitch, .pitchY = kPitch};
    for (int row = 0; row < kPixels; ++row) {
        for (int column = 0; column < kPixels; ++column) {
            constexpr double kWave = 2.0 * std::numbers::pi / 60e-9;
            const double x = (column + 0.5) * kPitch;
            const double y = (kPixels - row - 0.5) * kPitch;
            map.heights.push_back(1.8e-9 * std::sin(kWave * x) * std::sin(kWave * y));
        }
    }
    return map;
}

/// A pixel's paraboloid leaves 0.064 pitch^3 of the third derivative of the tip, 3 slope / R^2;
/// curvatures are off by six times that over the pitch squared: 0.55e6 / m at 0.19. Erosion changes
/// them by several times as much.
TEST(RecordedScan, IsWhatWasThereBeforeTheErosion) {
    const HeightMap map = fineHills();
    const Scene eroded = buildScene(imagedScene(true), map);
    const Scene whole = buildScene(imagedScene(false), map);
    for (const Vector2& position :
         {Vector2(16e-9, 14e-9), Vector2(31.3e-9, 20.1e-9), Vector2(25e-9, 25e-9)}) {
        const Relief expected = reliefOf(whole.surface.at(position.x(), position.y()));
        const Relief itself = reliefOf(eroded.surface.at(position.x(), position.y()));
        expectNear(RecordedScan(whole).reliefAt(position.x(), position.y()), expected, 1e-12);
        expectNear(RecordedScan(eroded).reliefAt(position.x(), position.y()), expected, 0.0055);
        EXPECT_GT((itself - expected).cwiseAbs().maxCoeff(), 1.1e6) << "of curvatures [1/m]";
    }
}

/// The recorded surface is parallel to the one under it: the same normal, further along it.
TEST(RecordedScan, LiesAlongTheNormal) {
    TipState state;
    state.closest.point = Vector3(50e-9, 60e-9, 0.0);
    state.closest.normal = Vector3(-0.6, 0.0, 0.8);
    const Scene eroded = buildScene(imagedScene(true), test::slopedMap(0.1));
    const RecordedPositions positions = recordedPositions(eroded, state);
    EXPECT_NEAR(positions.touched.x(), 44e-9, 1e-15);
    EXPECT_NEAR(positions.touched.y(), 60e-9, 1e-15);
    EXPECT_EQ(positions.shown, positions.touched);
}

/// A tip of 15 nm on the surface is one of 5 nm on what a tip of 10 nm recorded of it.
TEST(RecordedScan, ShowsWhereATipTouchesTheSurfaceUnderIt) {
    const Scene whole = buildScene(imagedScene(false), test::hillyMap());
    TipState state;
    const Vector2 position(37e-9, 90e-9);
    const HeightSample sample = whole.surface.at(position.x(), position.y());
    state.closest.point = Vector3(position.x(), position.y(), sample.height);
    state.closest.normal = sample.normal();
    const RecordedPositions positions = recordedPositions(whole, state);
    EXPECT_EQ(positions.shown, position);
    const Vector3 there = whole.surface.at(positions.touched.x(), positions.touched.y()).normal();
    const Vector2 center = position + (15e-9 * sample.normal().head<2>());
    EXPECT_LT((positions.touched + (5e-9 * there.head<2>()) - center).norm(), 1e-14);
    EXPECT_GT((positions.touched - position).norm(), 1e-9);
}

}  // namespace
}  // namespace asperity
