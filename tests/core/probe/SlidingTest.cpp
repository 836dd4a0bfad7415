#include "core/probe/Sliding.h"

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace asperity
