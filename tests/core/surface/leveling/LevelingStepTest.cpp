#include "core/surface/leveling/LevelingStep.h"

#include <gtest/gtest.h>

#include <limits>

namespace asperity {
namespace {

TEST(LevelingStep, TextsReadBackToTheSteps) {
    LevelingSteps all(kValues<LevelingStep>.begin(), kValues<LevelingStep>.end());
    EXPECT_EQ(levelingSteps(textOf(all)), all);
    EXPECT_EQ(textOf({}), "none");
    EXPECT_EQ(levelingSteps("none"), LevelingSteps());
    EXPECT_EQ(levelingSteps(" plane,zero , scars"),
              (LevelingSteps{LevelingStep::Plane, LevelingStep::Zero, LevelingStep::Scars}));
}

TEST(LevelingStep, WordsThatAreNoStepAreNone) {
    for (const char* const text : {"", "flat", "plane,", ",plane", "plane,none", "plane zero"}) {
        EXPECT_EQ(levelingSteps(text), std::nullopt) << text;
    }
}

TEST(LevelingStep, PositionsMustSpanATriangle) {
    const Vector2 a(1e-6, 2e-6);
    const Vector2 b(3e-6, 2e-6);
    EXPECT_EQ(refusalOf({a, b, Vector2(2e-6, 2.1e-6)}), "");
    EXPECT_NE(refusalOf({a, b, Vector2(2e-6, 2e-6)}), "");
    EXPECT_NE(refusalOf({a, a, b}), "");
    EXPECT_NE(refusalOf({a, a, a}), "");
    EXPECT_NE(refusalOf({a, b, Vector2(std::numeric_limits<double>::infinity(), 0.0)}), "");
}

}  // namespace
}  // namespace asperity
