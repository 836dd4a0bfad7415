#include "core/map/RetractCurve.h"

#include "core/Units.h"
#include "core/map/JumpSearch.h"
#include "tests/core/map/MapCycle.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace asperity {
namespace {

using test::kSetpoint;

/// The same area of the law's own curve in small steps.
double areaOfLaw(const Scene& scene) {
    const double compliance = scene.belief.cantilever.compliance()(2, 2);
    const ForceCurve curve = forceCurve(scene.belief.contact, compliance,
                                        {.farthest = -200e-9, .deepest = 3e-9, .points = 400000});
    double area = 0.0;
    for (std::size_t i = 1; i < curve.retract.size(); ++i) {
        const ContactState& from = curve.retract[i - 1].state;
        const ContactState& to = curve.retract[i].state;
        area += 0.5 * (std::max(0.0, -from.force) + std::max(0.0, -to.force)) *
                (from.indentation - to.indentation);
    }
    return area;
}

void expectAreaOfLaw(const SceneDescription& description) {
    const Scene scene = buildScene(description, test::flatMap());
    const MapInstrument instrument(scene, false);
    VerticalPath path(instrument, Vector2(61.0_nm, 67.0_nm));
    const auto engaged = engage(path, kSetpoint);
    ASSERT_TRUE(engaged);
    const auto curve = retract(path, engaged->atSetpoint);
    ASSERT_TRUE(curve);
    const double expected = areaOfLaw(scene);
    EXPECT_NEAR(separationWork(*curve), expected, 2e-3 * expected);
}

TEST(RetractCurve, HasTheAreaOfTheLaw) { expectAreaOfLaw(test::plainScene()); }

TEST(RetractCurve, HasTheAreaOfTheLawOnASoftLever) {
    SceneDescription description = test::plainScene();
    description.probe.thickness = thicknessForStiffness(description.probe, 0.2);
    expectAreaOfLaw(description);
}

/// The strongest pull of a retract in steps of 2 pm [N].
double pullInSmallSteps(VerticalPath& path, const TipAtHeight& atSetpoint) {
    constexpr double kStep = 2e-12;  // [m]
    path.goUp();
    TipAtHeight tip = path.at(atSetpoint.base, atSetpoint.memory);
    double pull = 0.0;
    while (tip.isBonded()) {
        pull = tip.state.converged ? std::max(pull, -tip.force()) : pull;
        tip = path.at(tip.base + kStep, tip.memory);
    }
    return pull;
}

/// A bent lever moves the tip up the flank until it pulls off, where the ridge is curved otherwise.
TEST(RetractCurve, HasTheStrongestPullOfAFlankWhereItIs) {
    SceneDescription description = test::plainScene();
    description.probe.thickness = thicknessForStiffness(description.probe, 2.0);
    const Scene scene = buildScene(description, test::ridgedMap(4.0_nm));
    const MapInstrument instrument(scene, false);
    for (const double x : {50.0_nm, 55.0_nm, 60.0_nm, 65.0_nm, 70.0_nm, 80.0_nm, 85.0_nm}) {
        VerticalPath path(instrument, Vector2(x, 67.0_nm));
        const auto engaged = engage(path, kSetpoint);
        ASSERT_TRUE(engaged) << x;
        const double expected = pullInSmallSteps(path, engaged->atSetpoint);
        const auto curve = retract(path, engaged->atSetpoint);
        ASSERT_TRUE(curve) << x;
        EXPECT_NEAR(strongestPull(path, *curve), expected, 1e-3 * expected) << x;
    }
}

}  // namespace
}  // namespace asperity
