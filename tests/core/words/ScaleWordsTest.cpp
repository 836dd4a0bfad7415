#include "core/words/ScaleWords.h"

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
              "1 mm : 1 nm, 1 N : 10 nN; the hand feels 247 N/m of 1.4 kN/m");
}

TEST(ScaleWords, TellWhatIsTooMuchAndTheRemedy) {
    EXPECT_EQ(refusalOf(kHolding), "");
    ScaleJudgment judgment = kHolding;
    judgment.adhesion = 3.19;
    EXPECT_EQ(refusalOf(judgment), "the sample would hold the hand with 3.19 N, more than the "
                                   "motors may give (3 N): a smaller force gain is needed");
    judgment.contact = 8400.0;
    EXPECT_EQ(refusalOf(judgment), "the contact is 8.4 kN/m at the hand, more than the coupling "
                                   "bears at this rate (6 kN/m): a smaller force gain or a smaller "
                                   "position gain is needed");
    judgment.felt = 1400.0;
    EXPECT_EQ(refusalOf(judgment), "the hand would feel 1.4 kN/m, more than the device renders "
                                   "(800 N/m): a smaller force gain or a smaller position gain is "
                                   "needed");
}

TEST(ScaleWords, TellOfTheGuideBesideTheContact) {
    ScaleJudgment judgment = kHolding;
    judgment.guided = true;
    judgment.contactBound = 1000.0;
    EXPECT_EQ(refusalOf(judgment), "the contact is 1.4 kN/m at the hand, more than the coupling "
                                   "bears at this rate beside the guide (1 kN/m): a smaller force "
                                   "gain or a smaller position gain is needed");
    judgment.contactBound = -1000.0;
    EXPECT_EQ(refusalOf(judgment), "the guide alone is stiffer or more damped than the coupling "
                                   "bears at this rate: a softer guide is needed");
}

TEST(ScaleWords, GiveTheDesignsOwnWordsWhereThereIsNoCoupling) {
    EXPECT_EQ(refusalOf(CoupledDevice{.gains = {}, .judgment = {}, .noCoupling = "too late"}),
              "too late");
}

}  // namespace
}  // namespace asperity
