
#include "core/Units.h"
#include "core/map/PixelCycle.h"
#include "tests/core/map/MapCycle.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <numbers>

namespace asperity {
namespace {

using test::kSetpoint;

SceneDescription frictionless(double stiffness) {
    SceneDescription description = test::plainScene();
    description.sample.material.friction = {};
    description.probe.thickness = thicknessForStiffness(description.probe, stiffness);
    return description;
}

/// On one point the law knows what its jumps dissipate.
void expectEnergyOfTheLaw(double stiffness, const HeightMap& map) {
    SCOPED_TRACE(stiffness);
    const Scene scene = buildScene(frictionless(stiffness), map);
    const MapInstrument instrument(scene, false);
    VerticalPath path(instrument, Vector2(61.0_nm, 67.0_nm));
    const CycleStates states = runCycle(path, kSetpoint);
    ASSERT_TRUE(states.retracted);
    const FoundJump& snapIn = states.engaged->snapIn;
    ASSERT_TRUE(snapIn.exact && states.retracted->pullOff.exact);
    const std::optional<double> found = loopEnergy(path, *states.engaged);
    ASSERT_TRUE(found && states.dissipated);
    EXPECT_NEAR(*found, *states.dissipated, 0.01 * *states.dissipated);
}

TEST(LoopEnergy, IsThatOfTheLawsJumps) {
    expectEnergyOfTheLaw(0.5, test::flatMap());
    expectEnergyOfTheLaw(3.0, test::flatMap());
    expectEnergyOfTheLaw(14.0, test::hillyMap());
}

/// Two flanks lose what both of their contacts held.
TEST(LoopEnergy, OfAGrooveIsThatOfBothFlanks) {
    SceneDescription description = frictionless(0.5);
    description.probe.azimuth = std::numbers::pi / 2.0;  // the tip stays in the middle
    const Scene scene = buildScene(description, test::ridgedMap(25.0_nm));
    const MapInstrument instrument(scene, false);
    VerticalPath path(instrument, Vector2(45.0_nm, 64.0_nm));
    const CycleStates states = runCycle(path, kSetpoint);
    ASSERT_TRUE(states.retracted && states.dissipated);
    EXPECT_EQ(states.retracted->pullOff.before.state.points, 2);
    // The lever lets go with what it stores, and the flanks with their work of adhesion.
    const double pull = states.retracted->pullOff.forceBefore();
    const double stored = 0.5 * path.complianceZ() * pull * pull;
    EXPECT_GT(*states.dissipated, 0.9 * stored);
    EXPECT_LT(*states.dissipated, separationWork(*states.retracted));
}

}  // namespace
}  // namespace asperity
