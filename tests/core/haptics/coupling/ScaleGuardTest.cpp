#include "core/haptics/coupling/ScaleGuard.h"

#include <gtest/gtest.h>

#include <limits>

namespace asperity {
namespace {

constexpr HandScale kCommon{.positionGain = 1e-6, .forceGain = 1e8};  // 1 mm: 1 nm, 1 N: 10 nN
constexpr StiffnessBounds kPhantom{.device = 800.0, .timeStep = 1e-3};
constexpr double kLever = 14.0;  // [N/m], on a hard sample
const CouplingGains kSoft{.stiffness = 300.0, .damping = 2.0, .proxyDamping = 3.0};

TEST(ScaleGuard, RefusesTheUncoupledLeverWithTheNumber) {
    const ScaleJudgement judged = judgeScale(kLever, kCommon, {}, kPhantom);
    EXPECT_NEAR(judged.felt, 1400.0, 1e-9);
    EXPECT_FALSE(judged.holds());
    EXPECT_NE(judged.sentence.find("1.4 kN/m"), std::string::npos) << judged.sentence;
    EXPECT_NE(judged.sentence.find("800 N/m"), std::string::npos) << judged.sentence;
}

TEST(ScaleGuard, TheHandFeelsContactAndCouplingInSeries) {
    const ScaleJudgement judged = judgeScale(kLever, kCommon, kSoft, kPhantom);
    EXPECT_NEAR(judged.felt, 300.0 * 1400.0 / 1700.0, 1e-9);
    EXPECT_TRUE(judged.holds());
    EXPECT_NE(judged.sentence.find("247 N/m"), std::string::npos) << judged.sentence;
}

TEST(ScaleGuard, ASoftSampleLetsAStiffLeverPass) {
    const double onRubber = inSeries(kLever, 0.1);
    EXPECT_TRUE(judgeScale(onRubber, kCommon, {}, kPhantom).holds());
}

TEST(ScaleGuard, ACouplingDoesNotMakeUpForAContactThatTheProxyCannotBear) {
    // bp > K T / 2: 6000 N/m at 1 kHz, 24000 N/m at 4 kHz.
    const HandScale magnified{.positionGain = 1e-6, .forceGain = 6e8};
    const ScaleJudgement slow = judgeScale(kLever, magnified, kSoft, kPhantom);
    EXPECT_NEAR(slow.contactBound, 6000.0, 1e-9);
    EXPECT_FALSE(slow.holds());
    EXPECT_NE(slow.sentence.find("8.4 kN/m"), std::string::npos) << slow.sentence;
    EXPECT_NE(slow.sentence.find("(6 kN/m)"), std::string::npos) << slow.sentence;
    EXPECT_TRUE(
        judgeScale(kLever, magnified, kSoft, {.device = 800.0, .timeStep = 0.25e-3}).holds());
}

TEST(ScaleGuard, WhatIsNoNumberDoesNotPass) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(judgeScale(kNan, kCommon, kSoft, kPhantom).holds());
    EXPECT_FALSE(judgeScale(kLever, kCommon, kSoft, {.device = kNan, .timeStep = 1e-3}).holds());
}

}  // namespace
}  // namespace asperity
