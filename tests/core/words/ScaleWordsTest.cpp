#include "core/words/DeviceWords.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

constexpr ScaleJudgment kHolding{.contact = 1400.0,
                                 .contactBound = 6000.0,
                                 .felt = 247.0,
                                 .feltBound = 800.0,
                                 .adhesion = 2.9,
                                 .forceBound = 3.0};

TEST(ScaleWords, TellTheScaleAndWhatIsFelt) {
    EXPECT_EQ(feltWords({.positionGain = 1e-6, .forceGain = 1e8}, kHolding),
              "1 mm : 1 nm, 1 N : 10 nN; stiffness at the device 247 N/m of 1.4 kN/m");
}

TEST(ScaleWords, TellWhatIsTooMuchAndTheRemedy) {
    EXPECT_EQ(refusalOf(kHolding), "");
    ScaleJudgment judgment = kHolding;
    judgment.adhesion = 3.19;
    EXPECT_EQ(refusalOf(judgment),
              "adhesion at the device of 3.19 N exceeds its force limit (3 N): "
              "reduce the force gain");
    judgment.contact = 8400.0;
    EXPECT_EQ(refusalOf(judgment),
              "contact stiffness at the device of 8.4 kN/m exceeds the stability "
              "limit of the coupling at this rate (6 kN/m): reduce the force "
              "gain or the position gain");
    judgment.felt = 1400.0;
    EXPECT_EQ(refusalOf(judgment), "rendered stiffness of 1.4 kN/m exceeds the limit of the device "
                                   "(800 N/m): reduce the force gain or the position gain");
}

TEST(ScaleWords, TellOfTheGuideBesideTheContact) {
    ScaleJudgment judgment = kHolding;
    judgment.guided = true;
    judgment.contactBound = 1000.0;
    EXPECT_EQ(refusalOf(judgment),
              "contact stiffness at the device of 1.4 kN/m exceeds the stability "
              "limit of the coupling at this rate beside the guide (1 kN/m): "
              "reduce the force gain or the position gain");
    judgment.contactBound = -1000.0;
    EXPECT_EQ(refusalOf(judgment), "the guide alone exceeds the stability limit of the coupling at "
                                   "this rate: a softer guide is needed");
}

TEST(ScaleWords, GiveTheDesignsOwnWordsWhereThereIsNoCoupling) {
    EXPECT_EQ(refusalOf(CoupledDevice{.gains = {}, .judgment = {}, .noCoupling = "too late"}),
              "too late");
}

}  // namespace
}  // namespace asperity
