#include "core/probe/ProbeSystem.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asperity {
namespace {

TEST(Sliding, OpposesTheTangentialVelocityAndVanishesAtRest) {
    const Vector3 slip = slidingOf(Vector3::UnitZ(), {1e-6, 0.0, 5e-6}).slip();
    EXPECT_NEAR(slip.x(), -1.0, 1e-6);
    EXPECT_NEAR(slip.z(), 0.0, 1e-12);
    EXPECT_EQ(slidingOf(Vector3::UnitZ(), Vector3::Zero()).slip(), Vector3::Zero());
    EXPECT_EQ(slidingOf(Vector3::UnitZ(), {0.0, 0.0, 1.0}).slip(), Vector3::Zero());
    EXPECT_NEAR(slidingOf(Vector3::UnitZ(), {1e-9, 0.0, 0.0}).certainty, std::sqrt(0.5), 1e-12);
}

/// Denormal speeds, the largest double and what is no number: a direction of length one or rest.
TEST(Sliding, IsRestOrADirectionForAnyNumber) {
    using Limits = std::numeric_limits<double>;
    for (const double odd :
         {Limits::denorm_min(), 1e-310, Limits::min(), 1e-200, 1e-154, 1e-31, 1e150, 1e200,
          Limits::max(), Limits::infinity(), Limits::quiet_NaN(), 0.0}) {
        SCOPED_TRACE(odd);
        for (const Vector3& velocity : {Vector3(odd, 0.0, 0.0), Vector3(0.0, -odd, odd),
                                        Vector3(odd, odd, odd), Vector3(1e-6, odd, 0.0)}) {
            const Vector3 normal = Vector3(0.1, -0.2, 1.0).normalized();
            const Sliding sliding = slidingOf(normal, velocity);
            EXPECT_NEAR(sliding.friction.norm(), 1.0, 1e-15);
            EXPECT_NEAR(sliding.friction.dot(normal), 0.0, 1e-15);
            EXPECT_TRUE(sliding.certainty >= 0.0 && sliding.certainty <= 1.0);
            EXPECT_TRUE(sliding.slip().allFinite());
        }
    }
}

TEST(Sliding, SlowerThanAnyMotionIsRest) {
    EXPECT_EQ(slidingOf(Vector3::UnitZ(), {0.9e-30, 0.0, 0.0}).slip(), Vector3::Zero());
    EXPECT_LT(slidingOf(Vector3::UnitZ(), {1.1e-30, 0.0, 0.0}).slip().x(), 0.0);
}

}  // namespace
}  // namespace asperity
