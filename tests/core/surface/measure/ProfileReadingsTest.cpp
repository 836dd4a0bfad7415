#include "core/surface/measure/Profile.h"
#include "tests/support/DoubleLimits.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

using test::kNan;

/// 10 m long, a sample each meter.
Profile profile(std::vector<double> heights) {
    return {.from = Vector2(0.0, 3.0), .to = Vector2(10.0, 3.0), .heights = std::move(heights)};
}

Profile rampProfile() { return profile({0, 1, 2, 3, 4, 5, 5, 5, 5, 5, 5}); }

TEST(ProfileReadings, HeightIsLinearBetweenSamples) {
    EXPECT_EQ(heightAt(rampProfile(), 2.5), 2.5);
    EXPECT_EQ(heightAt(rampProfile(), 10.0), 5.0);
    EXPECT_TRUE(std::isnan(heightAt(rampProfile(), 10.1)));
    EXPECT_TRUE(std::isnan(heightAt(rampProfile(), -0.1)));
    const Profile holey = profile({0, 1, kNan, 3, 4, 5, 6, 7, 8, 9, kNan});
    EXPECT_EQ(heightAt(holey, 1.0), 1.0);
    EXPECT_TRUE(std::isnan(heightAt(holey, 1.5)));
    EXPECT_EQ(heightAt(holey, 9.0), 9.0);
}

TEST(ProfileReadings, BetweenTwoPointsAreDistanceRiseAndAngle) {
    const auto reading = readingBetween(rampProfile(), 8.0, 1.0);
    ASSERT_TRUE(reading);
    EXPECT_EQ(reading->distance, 7.0);
    EXPECT_EQ(reading->rise, 4.0);
    EXPECT_NEAR(reading->angle, std::atan(4.0 / 7.0), 1e-15);
    EXPECT_FALSE(readingBetween(rampProfile(), 3.0, 3.0));
    EXPECT_FALSE(readingBetween(rampProfile(), 3.0, 30.0));
}

TEST(ProfileReadings, FittedAngleIsThatOfTheLeastSquaresLine) {
    EXPECT_NEAR(*fittedAngle(rampProfile(), {0.0, 5.0}), std::atan(1.0), 1e-15);
    EXPECT_EQ(*fittedAngle(rampProfile(), {10.0, 6.0}), 0.0);
    // 0, 1, 1 at 0, 1, 2: slope 1/2.
    EXPECT_NEAR(*fittedAngle(profile({0, 1, 1, 9, 9, 9, 9, 9, 9, 9, 9}), {0.0, 2.0}),
                std::atan(0.5), 1e-15);
    Profile high = rampProfile();
    for (double& height : high.heights) {
        height = 1e6 - height;
    }
    EXPECT_NEAR(*fittedAngle(high, {0.0, 5.0}), std::atan(-1.0), 1e-9);
    EXPECT_FALSE(fittedAngle(rampProfile(), {2.1, 3.9}));
    EXPECT_FALSE(fittedAngle(rampProfile(), {2.1, 2.9}));
    EXPECT_NEAR(*fittedAngle(profile({0, kNan, 4, 9, 9, 9, 9, 9, 9, 9, 9}), {0.0, 2.0}),
                std::atan(2.0), 1e-15);
}

}  // namespace
}  // namespace asperity
