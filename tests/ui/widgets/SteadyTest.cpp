#include "ui/widgets/Steady.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asperity {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(SteadyScale, TakesALargerPrefixAtOnceAndASmallerOneLate) {
    SteadyScale scale("N", 1e-12);
    EXPECT_EQ(scale.fit(500e-12).unit, "pN");
    EXPECT_EQ(scale.fit(1.1e-9).unit, "nN");
    EXPECT_EQ(scale.fit(0.7e-9).unit, "nN") << "still readable as 0.70";
    EXPECT_EQ(scale.fit(0.5e-9).unit, "pN");
    EXPECT_EQ(scale.fit(0.9e-9).unit, "pN");
}

TEST(SteadyScale, NoiseAroundAPrefixDoesNotFlicker) {
    SteadyScale scale("m", 1e-12);
    int changes = 0;
    std::string last;
    for (int i = 0; i < 1000; ++i) {
        const std::string unit = scale.fit(1e-6 * (1.0 + 0.2 * std::sin(1.7 * i))).unit;
        changes += unit == last ? 0 : 1;
        last = unit;
    }
    EXPECT_LE(changes, 2);
    EXPECT_EQ(last, "µm");
}

TEST(SteadyScale, KeepsItsPrefixForZeroAndForWhatIsNotFinite) {
    SteadyScale scale("m", 1e-9);
    EXPECT_EQ(scale.fit(0.0).unit, "nm") << "the smallest, not bare meters";
    scale.fit(3e-6);
    EXPECT_EQ(scale.fit(kNan).unit, "µm");
    EXPECT_EQ(scale.fit(INFINITY).unit, "µm");
}

TEST(SteadyRange, HoldsTheDataAndKeepsStillWhileTheyFillIt) {
    SteadyRange range(1.0);
    const AxisRange first = range.fit(0.0, 10.0);
    EXPECT_LE(first.low, 0.0);
    EXPECT_GE(first.high, 10.0);
    EXPECT_LT(first.high - first.low, 20.0) << "not much more than the data need";
    EXPECT_EQ(range.fit(1.0, 9.0).high, first.high);
    EXPECT_EQ(range.fit(0.0, first.high).high, first.high);
    EXPECT_GE(range.fit(0.0, first.high + 0.1).high, first.high + 0.1) << "widens at once";
}

TEST(SteadyRange, NarrowsWhenTheDataFillLittleOfIt) {
    SteadyRange range(1.0);
    range.fit(-100.0, 100.0);
    const AxisRange narrow = range.fit(-5.0, 5.0);
    EXPECT_LE(narrow.high, 10.0);
    EXPECT_GE(narrow.high, 5.0);
}

TEST(SteadyRange, DoesNotBlowUpSmallNoise) {
    SteadyRange range(1.0);
    const AxisRange around = range.fit(70.01, 70.02);
    EXPECT_GE(around.high - around.low, 1.0);
    EXPECT_LT(around.low, 70.01);
    EXPECT_GT(around.high, 70.02);
    EXPECT_EQ(range.fit(kNan, 3.0).low, around.low);
}

TEST(SteadyFactor, IsRoundAndStaysWhileTheDrawingFits) {
    SteadyFactor factor(1e-12);
    EXPECT_DOUBLE_EQ(factor.fit(3e-9, 20e-6), 5000.0);
    EXPECT_DOUBLE_EQ(factor.fit(2e-9, 20e-6), 5000.0) << "smaller, but plain to see";
    EXPECT_DOUBLE_EQ(factor.fit(4.1e-9, 20e-6), 2000.0) << "would not fit in";
    EXPECT_DOUBLE_EQ(factor.fit(0.1e-9, 20e-6), 200000.0) << "would hardly show";
    EXPECT_DOUBLE_EQ(factor.fit(kNan, 20e-6), 200000.0);
}

TEST(SteadyFactor, DoesNotBlowUpSmallNoise) {
    SteadyFactor factor(1e-9);
    EXPECT_DOUBLE_EQ(factor.fit(0.0, 1e-6), 1000.0);
}

TEST(ScaledText, IsPlainAndNeverMinusZeroOrNan) {
    const SiScale nano{1e9, "nN"};
    EXPECT_EQ(scaledText(-12.3e-9, nano, 2), "-12.30 nN");
    EXPECT_EQ(scaledText(12.3456e-9, nano, 4), "12.3456 nN");
    EXPECT_EQ(scaledText(-0.004e-9, nano, 2), "0.00 nN");
    EXPECT_EQ(scaledText(-0.006e-9, nano, 2), "-0.01 nN");
    EXPECT_EQ(scaledText(kNan, nano, 2), "– nN");
    EXPECT_EQ(scaledText(INFINITY, nano, 2), "– nN");
}

TEST(ThreeDigitText, ShowsNoMoreDigitsThanAnyoneReads) {
    const SiScale nano{1e9, "nN"};
    EXPECT_EQ(threeDigitText(-887.654e-9, nano), "-888 nN");
    EXPECT_EQ(threeDigitText(-12.345e-9, nano), "-12.3 nN");
    EXPECT_EQ(threeDigitText(1.2345e-9, nano), "1.23 nN");
    EXPECT_EQ(threeDigitText(9.996e-9, nano), "10.0 nN");
    EXPECT_EQ(threeDigitText(99.96e-9, nano), "100 nN");
    EXPECT_EQ(threeDigitText(0.0234e-9, nano), "0.02 nN");
    EXPECT_EQ(threeDigitText(-0.0051e-9, nano), "-0.01 nN");
    EXPECT_EQ(threeDigitText(0.000123e-9, nano), "0 nN");
    EXPECT_EQ(threeDigitText(-0.004e-9, nano), "0 nN");
    EXPECT_EQ(threeDigitText(kNan, nano), "– nN");
    EXPECT_EQ(threeDigitText(INFINITY, nano), "– nN");
}

TEST(SignificantText, HasThreeDigitsHoweverSmall) {
    const SiScale nano{1e9, "nN"};
    EXPECT_EQ(significantText(751e-12, nano), "0.751 nN");
    EXPECT_EQ(significantText(-40.5e-12, nano), "-0.0405 nN");
    EXPECT_EQ(significantText(9.996e-9, nano), "10.0 nN");
    EXPECT_EQ(significantText(99.96e-9, nano), "100 nN");
    EXPECT_EQ(significantText(16.83e-9, nano), "16.8 nN");
    EXPECT_EQ(significantText(2040e-9, nano), "2040 nN");
    EXPECT_EQ(significantText(0.0, nano), "0 nN");
    EXPECT_EQ(significantText(NAN, nano), "– nN");
}

}  // namespace
}  // namespace asperity
