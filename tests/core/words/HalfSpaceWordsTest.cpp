#include "core/words/HalfSpaceWords.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(HalfSpaceWords, TellBothForcesWhereTheAnswerIsUsed) {
    EXPECT_EQ(sentenceOf({HalfSpaceVerdict::Valid, 1.5e-9, 1.25e-9}),
              "half-space: normal force 1.5 nN, the contact law 1.25 nN");
}

TEST(HalfSpaceWords, TellWhyTheClosedFormIsShown) {
    EXPECT_EQ(sentenceOf({.verdict = HalfSpaceVerdict::NoZone}),
              "half-space not valid (the contact law's adhesion has no cohesive zone): closed form "
              "shown");
    EXPECT_EQ(sentenceOf({.verdict = HalfSpaceVerdict::LargeContact}),
              "half-space not valid (contact radius above 0.3 tip radii): closed form shown");
}

}  // namespace
}  // namespace asperity
