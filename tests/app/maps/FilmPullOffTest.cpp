#include "app/loading/SceneLoader.h"
#include "core/io/scene/SceneFile.h"
#include "core/map/MapPlan.h"
#include "core/map/PixelCycle.h"
#include "tests/core/map/HeldTrace.h"
#include "tests/core/map/SlowRetract.h"
#include "tests/support/ShippedScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace asperity {
namespace {

/// Relative, of the pull-off force at each pixel against the trace of a held tip, in rising order.
std::vector<double> errorsOn(const LoadedScene& loaded, const MapPlan& plan) {
    const MapInstrument instrument(loaded.scene, false);
    std::vector<double> errors;
    for (int row = 0; row < plan.grid.rows; ++row) {
        for (int column = 0; column < plan.grid.columns; ++column) {
            VerticalPath path(instrument, plan.position(row, column));
            const CycleStates states = runCycle(path, plan.setpoint);
            if (!states.retracted) {
                errors.push_back(std::numeric_limits<double>::infinity());
                continue;
            }
            const double expected = test::HeldTrace(path, states.engaged->atSetpoint).forceAtTurn();
            const double error = std::abs(states.retracted->pullOff.forceBefore() / expected - 1.0);
            errors.push_back(std::isfinite(error) ? error
                                                  : std::numeric_limits<double>::infinity());
        }
    }
    std::ranges::sort(errors);
    return errors;
}

/// Levers that bend to the side, and tips that several walls hold, some of which let go before the
/// others.
TEST(FilmPullOff, IsWhereTheLeverLosesItsEquilibrium) {
    const LoadedScene loaded =
        loadScene(test::shippedScene("granular_film"), {}, nullptr, ModelFit::Later);
    const MapPlan plan = planMap(loaded.scene, {.grid = MapGrid{.columns = 16, .rows = 16}});
    const std::vector<double> errors = errorsOn(loaded, plan);
    const auto shareBelow = [&errors](double limit) {
        return static_cast<double>(std::ranges::lower_bound(errors, limit) - errors.begin()) /
               static_cast<double>(errors.size());
    };
    EXPECT_LT(errors[errors.size() / 2], 1e-3);
    EXPECT_GT(shareBelow(5e-3), 0.9);
}

/// Long steps lose the equilibrium of many points that short ones follow: then the pull ended
/// before it began.
TEST(FilmPullOff, IsFoundInAValleyOfFourPoints) {
    const LoadedScene loaded =
        loadScene(test::shippedScene("granular_film"), {}, nullptr, ModelFit::Later);
    const MapPlan plan = planMap(loaded.scene, {.grid = MapGrid{.columns = 96, .rows = 96}});
    const MapInstrument instrument(loaded.scene, false);
    VerticalPath path(instrument, plan.position(21, 61));
    const CycleStates states = runCycle(path, plan.setpoint);
    ASSERT_TRUE(states.retracted);
    EXPECT_EQ(states.engaged->atSetpoint.state.points, 4);
    const double slow = test::slowRetractPull(path, states.engaged->atSetpoint, 5e-12);
    EXPECT_NEAR(strongestPull(path, *states.retracted), slow, 0.02 * slow);
}

/// Two points press and pull with six times the setpoint, two more attract, and so does the sample
/// beside them: each sweep of the search must take over what the points before it did to the tip.
TEST(FilmPullOff, IsFoundWhereFourPointsPullAgainstEachOther) {
    SceneDescription scene = readScene(test::shippedScene("granular_film"));
    scene.sample.material.elastic = {.youngsModulus = 72e9, .poissonRatio = 0.17};
    scene.sample.material.workOfAdhesion = 0.25;
    scene.probe = defaultScene().probe;
    scene.choices.bodyAttraction = true;
    const LoadedScene loaded = loadScene(scene);
    const MapInstrument instrument(loaded.scene, false);
    VerticalPath path(instrument, Vector2(175e-9, 125e-9));
    const CycleStates states = runCycle(path, scene.setpoint);
    ASSERT_TRUE(states.engaged);
    EXPECT_EQ(states.engaged->atSetpoint.state.points, 4);
    EXPECT_TRUE(states.engaged->atSetpoint.state.converged);
    EXPECT_TRUE(states.retracted);
}

/// A map of the shipped film under a tip of 2 um, which touches it at several grains.
class BluntTipOnFilm : public ::testing::Test {
protected:
    static SceneDescription blunt() {
        SceneDescription scene = readScene(test::shippedScene("granular_film"));
        scene.tip.radius = 2e-6;
        return scene;
    }

    LoadedScene loaded = loadScene(blunt());
    MapInstrument instrument{loaded.scene, false};
};

/// A wide look finds more points than it can separate; the ones that bear must be among them. The
/// grain at (37, 435) nm was missed, and the tip went 1.9 nm through it.
TEST_F(BluntTipOnFilm, MeetsTheSameContactsWhateverItKnew) {
    VerticalPath path(instrument, Vector2(102.4e-9, 397.1e-9));
    path.goDown();
    const TipAtHeight far = path.at(11e-9, {});
    TipAtHeight slow = far;
    for (const double base : {8.2e-9, 7.9e-9}) {
        while (slow.base > base + 1e-12) {
            slow = path.at(slow.base - 0.02e-9, slow.memory);
        }
        const TipAtHeight atOnce = path.at(slow.base, far.memory);
        EXPECT_NEAR(atOnce.force(), slow.force(), 0.01 * std::abs(slow.force())) << base;
        EXPECT_LT((atOnce.state.closest.point - slow.state.closest.point).norm(), 1e-9) << base;
    }
}

/// One of two grains 53 nm apart snapped in alone, or both did, from pixel to pixel: 30 or 57 nN.
TEST_F(BluntTipOnFilm, PullsOffAsItsNeighborsDo) {
    std::vector<double> pulls;
    for (const double x : {102.36e-9, 102.42e-9, 102.48e-9, 102.54e-9}) {
        for (const double y : {396.96e-9, 397.05e-9, 397.14e-9}) {
            VerticalPath path(instrument, Vector2(x, y));
            const CycleStates states = runCycle(path, loaded.scene.description.setpoint);
            ASSERT_TRUE(states.retracted) << x << ", " << y;
            pulls.push_back(strongestPull(path, *states.retracted));
        }
    }
    const auto [weakest, strongest] = std::ranges::minmax(pulls);
    EXPECT_LT(strongest, 1.005 * weakest);
}

}  // namespace
}  // namespace asperity
