#include "core/Units.h"
#include "core/contact/laws/ForceCurve.h"
#include "core/map/MapPlan.h"
#include "tests/core/map/MapCycle.h"
#include "tests/support/HeldLine.h"
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

/// Force along z whose friction along +x or -x leaves the bending at the setpoint [N].
double heldForce(const Scene& scene, double direction) {
    const double shown = bendingAxis(scene.belief.cantilever).x();
    return kSetpoint / (1.0 - direction * shown * scene.belief.friction.coefficient);
}

/// Coulomb's friction, against the motion both ways; 1e-6 of it is the rest speed's. Friction along
/// the lever bends it, so that the force along z is not the setpoint, and moves the tip along z;
/// the base makes up for both.
TEST(RasterLine, OnAFlatScanIsALoopOfFriction) {
    const Scene scene = buildScene(test::plainScene(), test::flatMap());
    const Cantilever& lever = scene.belief.cantilever;
    const double forward = heldForce(scene, 1.0);
    const double backward = heldForce(scene, -1.0);
    const double friction = scene.belief.friction.coefficient;
    const ContactModel law = scene.belief.contact;
    const double compliance = lever.compliance()(2, 2);
    const double crosstalk = *basePositionAt(law, compliance, backward) -
                             *basePositionAt(law, compliance, forward) +
                             lever.compliance()(2, 0) * friction * (forward + backward);
    for (const MapValues& pixel : lineOn(scene, 8)) {
        EXPECT_NEAR(pixel[MapQuantity::LateralTrace], -friction * forward,
                    1e-5 * friction * forward);
        EXPECT_NEAR(pixel[MapQuantity::LateralRetrace], friction * backward,
                    1e-5 * friction * backward);
        EXPECT_NEAR(pixel[MapQuantity::FrictionForce], 0.5 * friction * (forward + backward),
                    1e-5 * friction * forward);
        EXPECT_NEAR(pixel[MapQuantity::HeightTrace] - pixel[MapQuantity::HeightRetrace], crosstalk,
                    1e-5 * std::abs(crosstalk));
    }
}

/// Friction along the lever bends it, which looks like a deflection along z.
TEST(RasterLine, ShowsTheBendingOfFrictionAsADeflection) {
    for (const double tilt : {0.0, 0.2}) {
        SceneDescription description = test::plainScene();
        description.probe.mountTilt = tilt;
        const Scene scene = buildScene(description, test::flatMap());
        const double stiffness = scene.belief.cantilever.stiffness();
        for (const MapValues& pixel : lineOn(scene, 4)) {
            EXPECT_NEAR(pixel[MapQuantity::ErrorTrace],
                        (kSetpoint - heldForce(scene, 1.0)) / stiffness,
                        1e-6 * kSetpoint / stiffness);
            EXPECT_NEAR(pixel[MapQuantity::ErrorRetrace],
                        (kSetpoint - heldForce(scene, -1.0)) / stiffness,
                        1e-6 * kSetpoint / stiffness);
        }
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

/// Both hold the bending: the live loop with the delay of a tick, the map without any.
TEST(RasterLine, IsTheLineOfTheLiveFeedback) {
    SceneDescription description = test::plainScene();
    description.signalSigma = 1e-12;
    description.truth.signalNoise = 0.0;
    const Scene scene = buildScene(description, test::hillyMap());
    const MapPlan plan =
        planMap(scene, {.mode = MapMode::Contact, .grid = MapGrid{64, 3}, .setpoint = kSetpoint});
    const std::vector<MapValues> row = rasterLine(MapInstrument(scene, false), plan, 1, {});
    const Vector2 first = plan.position(1, 0);
    const Vector2 last = plan.position(1, 63);
    const double pitch = (last.x() - first.x()) / 63.0;
    constexpr double kSpeed = 50e-9;  // [m/s]
    const test::HeldLine live =
        test::heldLine(scene, first, {.length = last.x() - first.x(), .speed = kSpeed}, kSetpoint);
    const double step = kSpeed * scene.timeStep();
    // At a number of ticks since the line began, and at the force that the map gives its height
    // for.
    const double deflection = kSetpoint * scene.belief.cantilever.compliance()(2, 2);
    const auto heightAt = [&](double ticks) {
        const auto before = static_cast<std::size_t>(ticks);
        const double height = live.samples.at(before).output.base.position.z();
        const double next = live.samples.at(before + 1).output.base.position.z();
        return deflection + std::lerp(height, next, ticks - static_cast<double>(before));
    };
    for (std::size_t i = 1; i < 63; ++i) {
        const double there = static_cast<double>(i) * pitch / step;
        const double back = 2.0 * (last.x() - first.x()) / step - there;
        EXPECT_NEAR(heightAt(there), row[i][MapQuantity::HeightTrace], 20e-12) << i;
        EXPECT_NEAR(heightAt(back), row[i][MapQuantity::HeightRetrace], 20e-12) << i;
    }
}

}  // namespace
}  // namespace asperity
