#include "ui/measure/ProfilePlot.h"

#include "ui/panels/CopyablePlot.h"

#include <gtest/gtest.h>

#include <limits>

namespace asperity {
namespace {

TEST(ProfilePlot, CopiesDistancesAndHeights) {
    ProfilePlot plot;
    plot.setProfile({{0.0, 1e-9}, {2e-9, std::numeric_limits<double>::quiet_NaN()}, {4e-9, 3e-9}});
    ASSERT_NE(CopyablePlot::of(&plot.canvas()), nullptr);
    EXPECT_EQ(CopyablePlot::of(&plot.canvas())->data(), QStringLiteral("distance [m]\theight [m]\n"
                                                                       "0\t1e-09\n"
                                                                       "2e-09\t\n"
                                                                       "4e-09\t3e-09\n"));
}

}  // namespace
}  // namespace asperity
