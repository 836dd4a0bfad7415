#include "core/SiFormat.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asperity {

TEST(SiFormat, ChoosesThePrefixThatLeavesThreeDigits) {
    EXPECT_EQ(formatSi(12.34e-9, "N"), "12.3 nN");
    EXPECT_EQ(formatSi(4.5678e-9, "m"), "4.57 nm");
    EXPECT_EQ(formatSi(2.5e-6, "m"), "2.5 µm");
    EXPECT_EQ(formatSi(70.0e9, "Pa"), "70 GPa");
    EXPECT_EQ(formatSi(13.5e-18, "J"), "13.5 aJ");
    EXPECT_EQ(formatSi(0.04, "N/m"), "40 mN/m");
    EXPECT_EQ(formatSi(1.0, "s"), "1 s");
}

TEST(SiFormat, RoundingCarriesIntoTheNextPrefix) {
    EXPECT_EQ(formatSi(999.4e-9, "N"), "999 nN");
    EXPECT_EQ(formatSi(999.6e-9, "N"), "1 µN");
    EXPECT_EQ(formatSi(1000.0e-12, "m"), "1 nm");
}

TEST(SiFormat, SignsZeroAndNumbersBeyondThePrefixes) {
    EXPECT_EQ(formatSi(-3.0e-12, "N"), "-3 pN");
    EXPECT_EQ(formatSi(0.0, "N"), "0 N");
    EXPECT_EQ(formatSi(-0.0, "N"), "0 N");
    EXPECT_EQ(formatSi(2.0e-21, "N"), "0.002 aN");
    EXPECT_EQ(formatSi(std::numeric_limits<double>::infinity(), "N"), "inf N");
}

TEST(SiFormat, ScaleTakesAnSiValueToTheShownOne) {
    for (const double value : {2.0e-17, 3.0e-14, 5.0e-10, 0.02, 7.0, 8.0e4, 9.0e11}) {
        const SiScale scale = siScaleFor(value, "m");
        EXPECT_GE(value * scale.factor, 1.0 - 1e-12);
        EXPECT_LT(value * scale.factor, 1000.0);
    }
}

}  // namespace asperity
