#include "core/haptics/DevicePath.h"

#include "core/Units.h"
#include "core/scene/Scene.h"
#include "core/surface/deformation/ContactHeight.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace asperity {
namespace {

TEST(DevicePath, MovesInStraightLinesAndRestsAtTheEnds) {
    const DevicePath path{{1.0, {0.0, 0.0, 0.0}}, {2.0, {4.0_nm, 0.0, -2.0_nm}}};
    EXPECT_EQ(positionAt(path, 0.0), path[0].position);
    EXPECT_LT((positionAt(path, 1.25) - Vector3(1.0_nm, 0.0, -0.5_nm)).norm(), 1e-24);
    EXPECT_EQ(positionAt(path, 9.0), path[1].position);
}

class PlannedPath : public ::testing::TestWithParam<DevicePath (*)(const Scene&, const PathPlan&)> {
};

TEST_P(PlannedPath, RisesInTimeStaysInTheScanAndLeavesTheSampleAtTheEnd) {
    const Scene scene = buildScene(test::plainScene(), test::hillyMap());
    const PathPlan plan{.duration = 3.0};
    const DevicePath path = GetParam()(scene, plan);
    for (std::size_t i = 1; i < path.size(); ++i) {
        ASSERT_GT(path[i].time, path[i - 1].time);
    }
    EXPECT_NEAR(path.back().time, plan.duration, 1e-9);
    double deepest = 0.0;
    for (const PathPoint& point : path) {
        const Vector3& p = point.position;
        ASSERT_TRUE(scene.surface.contains(p.x(), p.y()));
        const double touch = tipContactHeight(scene.surface, p.x(), p.y(), 15.0_nm) - 15.0_nm;
        deepest = std::max(deepest, touch - p.z());
    }
    EXPECT_GE(deepest, plan.indentation * (1.0 - 1e-9));
    EXPECT_LE(deepest, 2.0 * plan.indentation * (1.0 + 1e-9));
    EXPECT_GT(path.back().position.z(),
              scene.surface.at(path.back().position.x(), path.back().position.y()).height);
}

INSTANTIATE_TEST_SUITE_P(All, PlannedPath,
                         ::testing::Values(&slidePath, &rasterPath, &scratchPath));

TEST(DevicePath, AJourneyClearsTheHillsOnItsWay) {
    const Scene scene = buildScene(test::plainScene(), test::hillyMap());
    const Vector3 from = waitingPosition(scene, {15.0_nm, 15.0_nm});
    const DevicePath path = journey(scene, from, {110.0_nm, 80.0_nm}, 2.0);
    EXPECT_EQ(path.front().position, from);
    EXPECT_EQ(path.back().position, waitingPosition(scene, {110.0_nm, 80.0_nm}));
    EXPECT_NEAR(path.back().time, 2.0, 1e-12);
    for (int i = 0; i <= 200; ++i) {
        const Vector3 p = positionAt(path, 0.01 * i);
        const double touch = tipContactHeight(scene.surface, p.x(), p.y(), 15.0_nm) - 15.0_nm;
        ASSERT_GT(p.z(), touch + 1.0_nm) << i;
    }
}

TEST(DevicePath, ApproachesTheHighestFeature) {
    const Scene scene = buildScene(test::plainScene(), test::hillyMap());
    const DevicePath path = slidePath(scene, {});
    const Vector3& start = path.front().position;
    EXPECT_NEAR(scene.surface.at(start.x(), start.y()).height, 6.0_nm, 0.05_nm);
}

TEST(DevicePath, UnderABluntTipASlideHasFewSteps) {
    SceneDescription description = test::plainScene();
    description.tip.radius = 10.0_um;
    HeightMap map = test::flatMap();
    map.pitchX = map.pitchY = 2.0_um;
    const Scene scene = buildScene(description, map);
    const DevicePath path = slidePath(scene, {.slideLength = 20.0_um});
    EXPECT_GT(path.size(), 50U);
    EXPECT_LT(path.size(), 100U) << "steps of half a nanometer took minutes to lay out";
}

TEST(DevicePath, LinesGoToAndFroAtOneSpeedAndHeight) {
    const Vector3 from(40.0_nm, 50.0_nm, -2.0_nm);
    const DevicePath path = linesPath(from, {.length = 30.0_nm,
                                             .speed = 10e-9,
                                             .direction = std::numbers::pi / 2.0,
                                             .lines = 3,
                                             .pitch = 5.0_nm});
    EXPECT_EQ(path.front().position, from);
    EXPECT_NEAR(path.back().time, 3 * 6.0 + 2 * 0.5, 1e-12);
    EXPECT_LT((path.back().position - Vector3(30.0_nm, 50.0_nm, -2.0_nm)).norm(), 1e-20)
        << "left of a line along y is -x";
    EXPECT_LT((positionAt(path, 3.0) - Vector3(40.0_nm, 80.0_nm, -2.0_nm)).norm(), 1e-20);
    const DevicePath same = linesPath(from, {.length = 30.0_nm, .speed = 10e-9, .lines = 2});
    EXPECT_NEAR(same.back().time, 12.0, 1e-12);
    EXPECT_EQ(same.back().position, from);
}

}  // namespace
}  // namespace asperity
