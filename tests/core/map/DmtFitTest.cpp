#include "core/map/RetractCurve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace asperity {
namespace {

constexpr double kRadius = 20e-9;
constexpr double kModulus = 3e9;
constexpr double kAdhesion = 4e-9;

/// A retract by the law itself, the tip highest at last.
std::vector<RetractPoint> dmtCurve(int points) {
    constexpr double kDepth = 2e-9;
    std::vector<RetractPoint> curve;
    for (int i = 0; i < points; ++i) {
        const double depth = kDepth * (points - 1 - i) / (points - 1);
        curve.push_back(
            {.height = 70e-9 - depth,
             .force = (4.0 / 3.0 * kModulus * std::sqrt(kRadius) * depth * std::sqrt(depth)) -
                      kAdhesion});
    }
    return curve;
}

TEST(DmtFit, FindsTheModulusOfItsOwnLaw) {
    EXPECT_NEAR(dmtModulus(dmtCurve(30), kAdhesion, kRadius), kModulus, 1e-9 * kModulus);
}

TEST(DmtFit, TakesTheGivenRadius) {
    EXPECT_NEAR(dmtModulus(dmtCurve(30), kAdhesion, 4.0 * kRadius), 0.5 * kModulus,
                1e-9 * kModulus);
}

TEST(DmtFit, OfTooFewPointsIsNone) {
    EXPECT_TRUE(std::isnan(dmtModulus(dmtCurve(3), kAdhesion, kRadius)));
    EXPECT_TRUE(std::isnan(dmtModulus({}, kAdhesion, kRadius)));
}

}  // namespace
}  // namespace asperity
