#include "core/Units.h"
#include "tests/vtkplugins/Fakes.h"
#include "vtkplugins/pictures/RestingPatch.h"
#include "vtkplugins/pictures/SceneParts.h"
#include "vtkplugins/pictures/Ticks.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace asperity {

TEST(Ticks, AreRoundAndInsideTheRange) {
    EXPECT_EQ(niceTicks(0.0, 10.0, 5), (std::vector<double>{0.0, 2.0, 4.0, 6.0, 8.0, 10.0}));
    const std::vector<double> ticks = niceTicks(-4.2, 9.1, 8);
    EXPECT_GE(ticks.front(), -4.2);
    EXPECT_LE(ticks.back(), 9.1);
    EXPECT_NE(std::find(ticks.begin(), ticks.end(), 0.0), ticks.end());
    EXPECT_EQ(niceTicks(3.0, 3.0, 5), std::vector<double>{3.0});
    for (const double tick : niceTicks(0.31, 0.37, 1)) {
        EXPECT_GE(tick, 0.31);
        EXPECT_LE(tick, 0.37);
    }
    EXPECT_DOUBLE_EQ(niceBelow(0.3e-9), 0.2e-9);
    EXPECT_DOUBLE_EQ(niceBelow(5.0), 5.0);
}

TEST(Ticks, LabelsShareTheirDecimals) {
    EXPECT_EQ(tickLabels({0.0, 0.5, 1.0}), (std::vector<std::string>{"0.0", "0.5", "1.0"}));
    EXPECT_EQ(tickLabels({-20.0, 0.0, 20.0}), (std::vector<std::string>{"-20", "0", "20"}));
}

namespace {

/// The plane at rest z = 0.3 x.
SurfacePatch slope() {
    SurfacePatch patch;
    patch.columns = 5;
    patch.rows = 4;
    for (int row = 0; row < patch.rows; ++row) {
        for (int column = 0; column < patch.columns; ++column) {
            patch.rest.emplace_back(column * 1.0_nm, row * 1.0_nm, 0.3 * column * 1.0_nm);
        }
    }
    return patch;
}

}  // namespace

// It drew displacements a hundred times as large on a surface that was not, and the tip a spindle.
TEST(Stretch, MultipliesAllHeightsAlike) {
    const Stretch stretch(10.0);
    const Vector3 drawn = stretch.point(Vector3(500.0_nm, 400.0_nm, 4.4_nm));
    EXPECT_LT((drawn - Vector3(500.0_nm, 400.0_nm, 44.0_nm)).norm(), 1e-20);
    EXPECT_EQ(Stretch(1.0).point(drawn), drawn);
}

TEST(Stretch, TurnsNormalsWithTheSurface) {
    // A plane of slope 0.1 becomes one of slope 0.4.
    const Vector3 normal = Stretch(4.0).normal(Vector3(-0.1, 0.0, 1.0).normalized());
    EXPECT_LT((normal - Vector3(-0.4, 0.0, 1.0).normalized()).norm(), 1e-12);
}

TEST(RestingPatch, FindsTheClosestPointAndWhatMovedWithIt) {
    const SurfacePatch patch = test::hertzDent().patch;
    const RestingPatch resting(patch);
    const Vector3 closest = resting.closest(Vector3(500.0_nm, 400.0_nm, 9.0_nm), Vector3::UnitZ());
    EXPECT_LT((closest - Vector3(500.0_nm, 400.0_nm, 5.0_nm)).norm(), 1e-20);
    EXPECT_NEAR(resting.at(patch.points, closest.x(), closest.y()).z(), 5.0_nm - 0.6_nm, 1e-18);
}

TEST(RestingPatch, KeepsItsBordersNormalBeyondThem) {
    const RestingPatch resting(slope());
    const Vector3 normal = Vector3(-0.3, 0.0, 1.0).normalized();
    for (const double x : {-30.0_nm, 0.0, 2.0_nm, 4.0_nm, 30.0_nm}) {
        for (const double y : {-30.0_nm, 0.0, 1.0_nm, 3.0_nm, 30.0_nm}) {
            EXPECT_LT((resting.normal(x, y) - normal).norm(), 1e-12) << x << ' ' << y;
        }
    }
}

}  // namespace asperity
