#include "core/Units.h"
#include "core/map/MapPlan.h"
#include "tests/core/map/MapCycle.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

using test::kSetpoint;

std::vector<MapValues> lineOn(const Scene& scene, int columns, int row = 0,
                              double setpoint = kSetpoint) {
    const MapPlan plan = planMap(
        scene, {.mode = MapMode::Contact, .grid = MapGrid{columns, 3}, .setpoint = setpoint});
    return rasterLine(MapInstrument(scene, false), plan, row, {});
}

/// Coulomb's friction, against the motion both ways; 1e-6 of it is the rest speed's. Friction along
/// a tilted lever also moves the tip along z, and the base makes up for it.
TEST(RasterLine, OnAFlatScanIsALoopOfFriction) {
    const Scene scene = buildScene(test::plainScene(), test::flatMap());
    const double friction = scene.belief.friction.coefficient * kSetpoint;
    const double crosstalk = 2.0 * friction * std::abs(scene.belief.cantilever.compliance()(2, 0));
    for (const MapValues& pixel : lineOn(scene, 8)) {
        EXPECT_NEAR(pixel[MapQuantity::LateralTrace], -friction, 1e-5 * friction);
        EXPECT_NEAR(pixel[MapQuantity::LateralRetrace], friction, 1e-5 * friction);
        EXPECT_NEAR(pixel[MapQuantity::FrictionForce], friction, 1e-5 * friction);
        EXPECT_NEAR(pixel[MapQuantity::HeightTrace] - pixel[MapQuantity::HeightRetrace], crosstalk,
                    1e-5 * crosstalk);
    }
}

/// Friction along the lever bends it, which looks like a deflection along z.
TEST(RasterLine, ShowsTheBendingOfFrictionAsADeflection) {
    SceneDescription description = test::plainScene();
    description.probe.mountTilt = 0.0;
    const Scene scene = buildScene(description, test::flatMap());
    const Cantilever& lever = scene.belief.cantilever;
    const double friction = scene.belief.friction.coefficient * kSetpoint;
    const double expected =
        friction * std::abs(lever.bendingPerFx() / lever.bendingPerFz()) / lever.stiffness();
    for (const MapValues& pixel : lineOn(scene, 4)) {
        EXPECT_NEAR(std::abs(pixel[MapQuantity::ErrorTrace]), expected, 1e-5 * expected);
        EXPECT_NEAR(pixel[MapQuantity::ErrorTrace], -pixel[MapQuantity::ErrorRetrace],
                    1e-5 * expected);
    }
}

/// Friction of an adhesive contact is many times a small setpoint, but only a wall jams the tip.
TEST(RasterLine, OnAFlatScanJamsNoTip) {
    constexpr double kSmall = 10e-12;
    SceneDescription description = test::plainScene();
    description.sample.material.friction.shearStrength = 2e7;
    const Scene scene = buildScene(description, test::flatMap());
    for (const MapValues& pixel : lineOn(scene, 4, 0, kSmall)) {
        EXPECT_GT(pixel[MapQuantity::FrictionForce], 20.0 * kSmall);
        EXPECT_FALSE(std::isnan(pixel[MapQuantity::HeightTrace]));
    }
}

/// The tip follows hills of 6 nm both ways, and only friction tells them apart.
TEST(RasterLine, FollowsHills) {
    const Scene scene = buildScene(test::plainScene(), test::hillyMap());
    double lowest = 1.0;
    double highest = -1.0;
    for (const MapValues& pixel : lineOn(scene, 32, 1)) {
        lowest = std::min(lowest, pixel[MapQuantity::HeightTrace]);
        highest = std::max(highest, pixel[MapQuantity::HeightTrace]);
        EXPECT_NEAR(pixel[MapQuantity::HeightTrace], pixel[MapQuantity::HeightRetrace], 1e-9);
        EXPECT_GT(pixel[MapQuantity::FrictionForce], 0.0);
    }
    EXPECT_GT(highest - lowest, 4e-9);
    EXPECT_LT(highest - lowest, 12.5e-9);
}

}  // namespace
}  // namespace asperity
