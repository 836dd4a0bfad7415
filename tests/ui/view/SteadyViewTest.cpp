#include "core/Units.h"
#include "ui/view/ForceLayer.h"
#include "ui/view/TerrainLayer.h"

#include <gtest/gtest.h>

namespace asperity {

namespace {

constexpr double kRoom = 40.0_nm;

}  // namespace

TEST(ForceScale, ALargerForceHasALongerArrowThatFitsItsRoom) {
    double before = 0.0;
    for (const double force : {0.05e-9, 0.5e-9, 3e-9, 5e-9, 17e-9, 25e-9, 400e-9}) {
        const double length = arrowLength(force, 5e-9, kRoom);
        EXPECT_GT(length, before);
        EXPECT_LE(length, kRoom);
        before = length;
    }
    EXPECT_DOUBLE_EQ(arrowLength(5e-9, 5e-9, kRoom), 0.5 * kRoom);
    EXPECT_NEAR(arrowLength(1e-12, 5e-9, kRoom), kRoom * 2e-4, 1e-3 * kRoom * 2e-4);
}

TEST(DrapedGrid, LinesLieAtRoundPlacesBetweenTheEdges) {
    const double spacing = gridSpacing(80.0_nm);
    EXPECT_DOUBLE_EQ(spacing, 2.0_nm);
    const std::vector<double> positions = gridPositions(-4.0_nm, 5.0_nm, spacing);
    ASSERT_EQ(positions.size(), 4U);
    EXPECT_NEAR(positions.front(), -2.0_nm, 1e-20);
    EXPECT_NEAR(positions.back(), 4.0_nm, 1e-20);
}

}  // namespace asperity
