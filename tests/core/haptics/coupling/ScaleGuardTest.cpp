#include "core/haptics/coupling/CouplingDesign.h"
#include "core/words/DeviceWords.h"

#include <gtest/gtest.h>

#include <limits>

namespace asperity {
namespace {

constexpr DeviceScale kCommon{.positionGain = 1e-6, .forceGain = 1e8};  // 1 mm: 1 nm, 1 N: 10 nN
constexpr ScaleBounds kPhantomBounds{.stiffness = 800.0, .force = 3.0, .timeStep = 1e-3};
constexpr TipLoad kLever{.stiffness = 14.0};  // on a hard sample
const CouplingGains kSoft{.stiffness = 300.0, .damping = 2.0, .proxyDamping = 3.0};

TEST(ScaleGuard, RefusesTheUncoupledLeverWithTheNumber) {
    const ScaleJudgment judged = judgeScale(kLever, kCommon, {}, kPhantomBounds);
    EXPECT_NEAR(judged.felt, 1400.0, 1e-9);
    EXPECT_FALSE(judged.holds());
    EXPECT_NE(refusalOf(judged).find("1.4 kN/m"), std::string::npos) << refusalOf(judged);
    EXPECT_NE(refusalOf(judged).find("800 N/m"), std::string::npos) << refusalOf(judged);
}

TEST(ScaleGuard, TheDeviceFeelsContactAndCouplingInSeries) {
    const ScaleJudgment judged = judgeScale(kLever, kCommon, kSoft, kPhantomBounds);
    EXPECT_NEAR(judged.felt, 300.0 * 1400.0 / 1700.0, 1e-9);
    EXPECT_TRUE(judged.holds());
}

TEST(ScaleGuard, ASoftSampleLetsAStiffLeverPass) {
    const TipLoad onRubber{.stiffness = inSeries(kLever.stiffness, 0.1)};
    EXPECT_TRUE(judgeScale(onRubber, kCommon, {}, kPhantomBounds).holds());
}

TEST(ScaleGuard, ACouplingDoesNotMakeUpForAContactThatTheProxyCannotBear) {
    // bp > K T / 2: 6000 N/m at 1 kHz, 24000 N/m at 4 kHz.
    const DeviceScale magnified{.positionGain = 1e-6, .forceGain = 6e8};
    const ScaleJudgment slow = judgeScale(kLever, magnified, kSoft, kPhantomBounds);
    EXPECT_NEAR(slow.contactBound, 6000.0, 1e-9);
    EXPECT_FALSE(slow.holds());
    EXPECT_NE(refusalOf(slow).find("8.4 kN/m"), std::string::npos) << refusalOf(slow);
    EXPECT_NE(refusalOf(slow).find("(6 kN/m)"), std::string::npos) << refusalOf(slow);
    ScaleBounds fast = kPhantomBounds;
    fast.timeStep = 0.25e-3;
    EXPECT_TRUE(judgeScale(kLever, magnified, kSoft, fast).holds());
}

TEST(ScaleGuard, AnAdhesionStrongerThanTheMotorsIsRefusedWithBothForces) {
    const TipLoad sticky{.stiffness = 14.0, .adhesion = 29e-9};
    const ScaleJudgment held = judgeScale(sticky, kCommon, kSoft, kPhantomBounds);
    EXPECT_NEAR(held.adhesion, 2.9, 1e-12);
    EXPECT_TRUE(held.holds());
    const DeviceScale larger{.positionGain = 1e-7, .forceGain = 1.1e8};
    const ScaleJudgment judged = judgeScale(sticky, larger, kSoft, kPhantomBounds);
    EXPECT_FALSE(judged.holds());
    EXPECT_NE(refusalOf(judged).find("3.19 N"), std::string::npos) << refusalOf(judged);
    EXPECT_NE(refusalOf(judged).find("(3 N)"), std::string::npos) << refusalOf(judged);
}

TEST(ScaleGuard, AGuideTakesItsPartOfWhatTheProxyBears) {
    // (K + k) T/2 + b < bp: of 6000 N/m a damping of 0.5 N s/m takes 1000, a stiffness its own.
    const GuideLoad guide{.stiffness = 200.0, .damping = 0.5};
    const ScaleJudgment beside = judgeScale(kLever, kCommon, kSoft, kPhantomBounds, guide);
    EXPECT_NEAR(beside.contactBound, 4800.0, 1e-9);
    EXPECT_TRUE(beside.holds());
    const DeviceScale magnified{.positionGain = 1e-6, .forceGain = 4e8};
    EXPECT_TRUE(judgeScale(kLever, magnified, kSoft, kPhantomBounds).holds());
    const ScaleJudgment judged = judgeScale(kLever, magnified, kSoft, kPhantomBounds, guide);
    EXPECT_FALSE(judged.holds());
    EXPECT_NE(refusalOf(judged).find("beside the guide (4.8 kN/m)"), std::string::npos)
        << refusalOf(judged);
}

TEST(ScaleGuard, AGuideThatTheProxyCannotBearIsRefusedInTheAir) {
    const GuideLoad stiff{.stiffness = 7000.0, .damping = 0.0};
    const ScaleJudgment judged = judgeScale({}, kCommon, kSoft, kPhantomBounds, stiff);
    EXPECT_FALSE(judged.holds());
    EXPECT_NE(refusalOf(judged).find("softer guide"), std::string::npos) << refusalOf(judged);
}

TEST(ScaleGuard, ARefusedScaleHoldsWithTheRemedyThatIsNamed) {
    const DeviceScale magnified{.positionGain = 1e-6, .forceGain = 6e8};
    const ScaleJudgment judged = judgeScale(kLever, magnified, kSoft, kPhantomBounds);
    ASSERT_FALSE(judged.holds());
    EXPECT_NE(refusalOf(judged).find("reduce the force gain or the position gain"),
              std::string::npos)
        << refusalOf(judged);
    for (const DeviceScale& remedied : {DeviceScale{1e-6, 3e8}, DeviceScale{0.5e-6, 6e8}}) {
        EXPECT_TRUE(judgeScale(kLever, remedied, kSoft, kPhantomBounds).holds());
    }
}

TEST(ScaleGuard, WhatIsNoNumberDoesNotPass) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(judgeScale({.stiffness = kNan}, kCommon, kSoft, kPhantomBounds).holds());
    const TipLoad unknown{.stiffness = 14.0, .adhesion = kNan};
    EXPECT_FALSE(judgeScale(unknown, kCommon, kSoft, kPhantomBounds).holds());
    ScaleBounds noDevice = kPhantomBounds;
    noDevice.stiffness = kNan;
    EXPECT_FALSE(judgeScale(kLever, kCommon, kSoft, noDevice).holds());
}

}  // namespace
}  // namespace asperity
