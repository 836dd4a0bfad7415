#include "core/surface/RoundTip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asperity {
namespace {

TEST(RoundTip, IsASphereUpToItsEquator) {
    const RoundTip tip{2.0};
    EXPECT_FALSE(tip.hasCone());
    EXPECT_EQ(tip.reach(), 2.0);
    EXPECT_EQ(tip.height(0.0), 0.0);
    EXPECT_DOUBLE_EQ(tip.height(1.0), 2.0 - std::sqrt(3.0));
    EXPECT_DOUBLE_EQ(tip.height(2.0), 2.0);
    EXPECT_EQ(tip.height(3.0), 2.0);
    EXPECT_EQ(tip.shankHalfAngle(), kShankHalfAngle);
}

/// Sphere and cone meet with the same height and slope.
TEST(RoundTip, GoesOnAsACone) {
    const RoundTip tip{2.0, 0.4};
    const double joint = 2.0 * std::cos(0.4);
    EXPECT_EQ(tip.reach(), std::numeric_limits<double>::infinity());
    EXPECT_EQ(tip.height(1.0), RoundTip{2.0}.height(1.0));
    EXPECT_NEAR(tip.height(std::nextafter(joint, 9.0)), tip.height(joint), 1e-14);
    const double slope = (tip.height(joint) - tip.height(joint - 1e-6)) / 1e-6;
    EXPECT_NEAR(slope, 1.0 / std::tan(0.4), 1e-4);
    EXPECT_NEAR(tip.height(9.0) - tip.height(8.0), 1.0 / std::tan(0.4), 1e-13);
    EXPECT_EQ(tip.shankHalfAngle(), 0.4);
}

}  // namespace
}  // namespace asperity
