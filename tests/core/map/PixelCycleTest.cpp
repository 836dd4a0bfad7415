#include "core/map/PixelCycle.h"

#include "core/Units.h"
#include "core/contact/laws/ForceCurve.h"
#include "tests/core/map/MapCycle.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asperity {
namespace {

using test::cycleOn;
using test::kSetpoint;

const Vector2 kMiddle(61.0_nm, 67.0_nm);

/// A frictionless scene with the law of Johnson, Kendall and Roberts on a soft sample and lever.
SceneDescription jkrScene(double lever = 0.5) {
    SceneDescription scene = test::plainScene();
    scene.choices.law = ContactLaw::Jkr;
    scene.sample.material.elastic.youngsModulus = 20e6;
    scene.sample.material.friction = {};
    scene.truth.material = scene.sample.material;
    scene.probe.thickness = thicknessForStiffness(scene.probe, lever);
    scene.truth.stiffness = lever;
    return scene;
}

SceneDescription shapeScene(const ShapeDescription& shape, double lever = 0.5) {
    SceneDescription scene = jkrScene(lever);
    scene.sample.shape = shape;
    return scene;
}

void expectRelative(double value, double expected, double tolerance, const char* what) {
    EXPECT_NEAR(value, expected, tolerance * std::abs(expected)) << what;
}

/// Everything that `asperity curve` shows of a scene's law and lever.
void expectCurve(const Scene& scene, const MapValues& values) {
    constexpr double kTolerance = 1e-9;
    const ContactModel& law = scene.belief.contact;
    const double compliance = scene.belief.cantilever.compliance()(2, 2);
    ForceCurvePlan plan = curvePlan(law, compliance);
    plan.deepest = values[MapQuantity::Indentation] + (compliance * kSetpoint);
    const ForceCurve curve = forceCurve(law, compliance, plan);
    ASSERT_TRUE(curve.snapIn);
    ASSERT_TRUE(curve.pullOff);
    expectRelative(values[MapQuantity::SnapInDistance], -curve.snapIn->basePosition, kTolerance,
                   "snap-in");
    expectRelative(values[MapQuantity::PullOffForce], -curve.pullOff->before.force, kTolerance,
                   "pull-off");
    expectRelative(values[MapQuantity::DissipatedEnergy],
                   curve.snapIn->after.energyLost + curve.pullOff->after.energyLost, kTolerance,
                   "energy");
    const ContactState& turn = curve.approach.back().state;
    expectRelative(kSetpoint, turn.force, kTolerance, "force");
    expectRelative(values[MapQuantity::Indentation], turn.indentation, kTolerance, "indentation");
    expectRelative(values[MapQuantity::ContactRadius], turn.contactRadius, kTolerance, "radius");
    expectRelative(values[MapQuantity::Stiffness], turn.stiffness, kTolerance, "stiffness");
    expectRelative(values[MapQuantity::Height], -turn.indentation, kTolerance, "height");
    EXPECT_GE(values[MapQuantity::AdhesionForce],
              values[MapQuantity::PullOffForce] * (1.0 - kTolerance));
}

TEST(PixelCycle, OnAFlatScanIsTheCurveOfTheLaw) {
    const Scene scene = buildScene(test::plainScene(), test::flatMap());
    expectCurve(scene, cycleOn(scene, kMiddle));
}

TEST(PixelCycle, OnAFlatScanIsTheCurveOfASoftLever) {
    const Scene scene = buildScene(jkrScene(), test::flatMap());
    expectCurve(scene, cycleOn(scene, kMiddle));
}

TEST(PixelCycle, OfTheTruthHasItsMaterial) {
    SceneDescription description = test::plainScene();
    description.truth.material.workOfAdhesion *= 0.5;
    const Scene scene = buildScene(description, test::flatMap());
    const double compliance = scene.truth.cantilever.compliance()(2, 2);
    const auto pullOff = pullOffOf(scene.truth.contact, compliance);
    ASSERT_TRUE(pullOff);
    expectRelative(cycleOn(scene, kMiddle, true)[MapQuantity::PullOffForce], -pullOff->before.force,
                   1e-9, "true pull-off");
    EXPECT_GT(cycleOn(scene, kMiddle)[MapQuantity::PullOffForce],
              1.5 * cycleOn(scene, kMiddle, true)[MapQuantity::PullOffForce]);
}

/// 3/2 pi w R_eff, 1 / R_eff = 1 / R + 1 / R_sphere: the strongest pull whatever the lever, and the
/// pull-off of a lever that is soft beside the contact. Source: docs/theory.md 2.1.
TEST(PixelCycle, OnASphereHasThePullOffOfBothRadii) {
    constexpr double kSoft = 0.05;  // [N/m]
    const ShapeDescription sphere{.kind = ShapeKind::Sphere, .radius = 300e-9, .size = 40e-9};
    SceneDescription description = shapeScene(sphere, kSoft);
    description.probe.mountTilt = 0.0;  // the less a bent lever moves the tip along x
    const Scene scene = buildScene(description);
    const double tip = scene.description.tip.radius;
    const double radius = 1.0 / (1.0 / tip + 1.0 / sphere.radius);
    const double expected =
        1.5 * std::numbers::pi * scene.description.sample.material.workOfAdhesion * radius;
    const Vector2 apex(20e-9, 20e-9);
    for (const Vector2& aside : {Vector2(0.0, 0.0), Vector2(3e-9, 0.0), Vector2(-2e-9, 4e-9)}) {
        const MapValues values = pixelCycle(MapInstrument(scene, false), apex + aside, 0.5e-9);
        expectRelative(values[MapQuantity::AdhesionForce], expected, 5e-3, "adhesion");
        expectRelative(values[MapQuantity::PullOffForce], expected, 5e-3, "pull-off");
    }
}

/// The contact pulls along the normal, and the instrument sees its part along z.
TEST(PixelCycle, OnATiltedPlaneSeesTheCosine) {
    const auto onSlope = [](double slope) {
        const Scene scene =
            buildScene(shapeScene({.kind = ShapeKind::Plane, .slope = slope, .size = 100e-9}));
        return cycleOn(scene, Vector2(50e-9, 50e-9));
    };
    const MapValues flat = onSlope(0.0);
    for (const double slope : {0.1, -0.3, 0.6}) {
        const MapValues tilted = onSlope(slope);
        expectRelative(tilted[MapQuantity::AdhesionForce],
                       flat[MapQuantity::AdhesionForce] * std::cos(slope), 1e-9, "adhesion");
        EXPECT_NEAR(tilted[MapQuantity::NormalAngle], std::abs(slope), 1e-9);
        expectRelative(tilted[MapQuantity::LateralForce], kSetpoint * std::abs(std::tan(slope)),
                       1e-9, "lateral force");
    }
}

TEST(PixelCycle, WithoutAdhesionHasNoPull) {
    SceneDescription description = test::plainScene();
    description.choices.law = ContactLaw::Hertz;
    const Scene scene = buildScene(description, test::flatMap());
    const MapValues values = cycleOn(scene, kMiddle);
    EXPECT_EQ(values[MapQuantity::AdhesionForce], 0.0);
    EXPECT_TRUE(std::isnan(values[MapQuantity::PullOffForce]));
    EXPECT_TRUE(std::isnan(values[MapQuantity::SnapInDistance]));
    EXPECT_EQ(values[MapQuantity::SeparationWork], 0.0);
    expectRelative(values[MapQuantity::ApparentModulus], scene.belief.contact.pair().reducedModulus,
                   1e-3, "Hertz has no error here");
}

/// The same position twice, and after other positions: to the bit.
TEST(PixelCycle, DependsOnItsPlaceAlone) {
    const Scene scene = buildScene(test::plainScene(), test::hillyMap());
    const MapValues first = cycleOn(scene, kMiddle);
    (void)cycleOn(scene, Vector2(20.0_nm, 30.0_nm));
    const MapValues second = cycleOn(scene, kMiddle);
    for (const MapQuantity quantity : kValues<MapQuantity>) {
        EXPECT_TRUE(first[quantity] == second[quantity] ||
                    (std::isnan(first[quantity]) && std::isnan(second[quantity])));
    }
}

TEST(PixelCycle, BesideTheScanSaysSo) {
    const Scene scene = buildScene(test::plainScene(), test::hillyMap());
    ValidityFlags outside;
    outside.set(Validity::OutsideScan, true);
    const auto bits =
        static_cast<unsigned>(cycleOn(scene, Vector2(-30.0_nm, 60.0_nm))[MapQuantity::Validity]);
    EXPECT_NE(bits & outside.bits(), 0U);
}

}  // namespace
}  // namespace asperity
