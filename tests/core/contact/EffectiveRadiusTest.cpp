#include "core/Units.h"
#include "core/contact/ContactState.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

constexpr double kRadius = 15.0_nm;

TEST(EffectiveRadius, IsTheTipsOnAFlatSample) {
    const EffectiveRadius flat = effectiveRadius(kRadius, 0.0, 0.0);
    EXPECT_DOUBLE_EQ(flat.radius, kRadius);
    EXPECT_TRUE(flat.tipFits);
    EXPECT_FALSE(flat.anisotropic);
}

TEST(EffectiveRadius, OnASphereAddsTheCurvatures) {
    EXPECT_NEAR(effectiveRadius(kRadius, 1.0 / 30.0_nm, 1.0 / 30.0_nm).radius, 10.0_nm, 1e-21);
    EXPECT_NEAR(effectiveRadius(kRadius, -1.0 / 30.0_nm, -1.0 / 30.0_nm).radius, 30.0_nm, 1e-21);
}

/// docs/theory.md 1: the geometric mean of the two, not the arithmetic one.
TEST(EffectiveRadius, OfTwoCurvaturesIsTheirGeometricMean) {
    const EffectiveRadius saddle = effectiveRadius(kRadius, 1.0 / 20.0_nm, -1.0 / 40.0_nm);
    const double first = 1.0 / kRadius + 1.0 / 20.0_nm;
    const double second = 1.0 / kRadius - 1.0 / 40.0_nm;
    EXPECT_NEAR(saddle.radius, 1.0 / std::sqrt(first * second), 1e-21);
    EXPECT_TRUE(saddle.anisotropic);
    EXPECT_FALSE(effectiveRadius(kRadius, 0.9 / kRadius, 0.0).anisotropic);
}

/// A blunt tip on a sharp asperity sees little more than the asperity, without any bound.
TEST(EffectiveRadius, OfABluntTipOnASharpAsperityIsTheAsperitys) {
    for (const double ratio : {9.0, 11.0, 100.0, 1e6}) {
        const double tip = 5.0_um;
        const double asperity = tip / ratio;
        const EffectiveRadius met = effectiveRadius(tip, 1.0 / asperity, 1.0 / asperity);
        EXPECT_NEAR(met.radius, tip / (1.0 + ratio), 1e-12 * tip) << ratio;
        EXPECT_TRUE(met.tipFits);
    }
    EXPECT_NEAR(effectiveRadius(5.0_um, 1.0 / 50.0_nm, 1.0 / 50.0_nm).radius, 49.5_nm, 0.01_nm);
}

TEST(EffectiveRadius, SaysThatTheTipDoesNotFitAndStaysFinite) {
    const EffectiveRadius valley = effectiveRadius(kRadius, 0.0, -1.0 / 14.0_nm);
    EXPECT_FALSE(valley.tipFits);
    EXPECT_NEAR(valley.radius, kRadius * std::sqrt(10.0), 1e-20);
    EXPECT_TRUE(effectiveRadius(kRadius, 0.0, -1.0 / 17.0_nm).tipFits);
}

}  // namespace
}  // namespace asperity
