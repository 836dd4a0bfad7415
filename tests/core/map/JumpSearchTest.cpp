#include "core/map/JumpSearch.h"

#include "core/Units.h"
#include "tests/core/map/HeldTrace.h"
#include "tests/core/map/MapCycle.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace asperity {
namespace {

using test::kSetpoint;

constexpr double kForceTolerance = 1e-3;  // of the force

/// On a slope a lever that pulls bends to the side, and lets go before the law at the position
/// does.
TEST(JumpSearch, PullsOffWhereTheLeverLosesItsEquilibrium) {
    SceneDescription description = test::plainScene();
    description.sample.material.elastic = {.youngsModulus = 70.0_GPa, .poissonRatio = 0.17};
    description.sample.material.workOfAdhesion = 0.2;
    description.tip.radius = 30.0_nm;
    description.sample.material.friction = {};
    const Scene scene = buildScene(description, test::hillyMap());
    const MapInstrument instrument(scene, false);
    for (const double x : {50.0_nm, 53.0_nm, 56.0_nm, 59.0_nm, 62.0_nm, 65.0_nm, 68.0_nm}) {
        SCOPED_TRACE(x);
        VerticalPath path(instrument, Vector2(x, 64.0_nm));
        const auto engaged = engage(path, kSetpoint);
        ASSERT_TRUE(engaged);
        const double expected = test::HeldTrace(path, engaged->atSetpoint).forceAtTurn();
        std::vector<TipAtHeight> passed;
        const auto pullOff = findPullOff(path, engaged->atSetpoint, 0.3_nm, passed);
        ASSERT_TRUE(pullOff);
        EXPECT_NEAR(pullOff->forceBefore(), expected, kForceTolerance * std::abs(expected));
        EXPECT_TRUE(pullOff->before.state.converged);
    }
}

}  // namespace
}  // namespace asperity
