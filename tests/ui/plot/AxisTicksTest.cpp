#include "ui/plot/PlotNavigation.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(AxisTicks, AreNeverOnlyOne) {
    EXPECT_EQ(axisTicks(0.0, 10.0, 5), (std::vector<double>{0.0, 2.0, 4.0, 6.0, 8.0, 10.0}));
    EXPECT_GE(axisTicks(-8.0, 8.0, 2).size(), 2U);
    EXPECT_GE(axisTicks(1.1, 13.9, 1).size(), 2U);
}

TEST(AxisTicks, AreTheOutermostWhereMoreHaveNoRoom) {
    EXPECT_EQ(axisTicks(-2.5, 4.5, 1), (std::vector<double>{-2.0, 4.0}));
    EXPECT_EQ(axisTicks(-0.6, 0.6, 1), (std::vector<double>{-0.5, 0.5}));
}

}  // namespace
}  // namespace asperity
