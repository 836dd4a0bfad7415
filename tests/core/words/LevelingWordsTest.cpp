#include "core/words/SceneWords.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity {
namespace {

using testing::ElementsAre;

TEST(LevelingWords, SayThatNothingWasDone) {
    EXPECT_THAT(levelingNotes({}), ElementsAre("leveling: none, heights as the file gives them"));
}

TEST(LevelingWords, CountSeveralStepsAndSayWhatEachRemoved) {
    const PlaneFit plane{.slopeX = 0.5, .slopeY = -0.25, .mean = 3e-9};
    EXPECT_THAT(
        levelingNotes({{.step = LevelingStep::ThreePoint, .plane = plane},
                       {.step = LevelingStep::Facet, .plane = plane},
                       {.step = LevelingStep::Quadratic,
                        .plane = plane,
                        .bendX = 100.0,
                        .bendY = -2e4,
                        .twist = 1.5},
                       {.step = LevelingStep::MedianOfDifferences, .shiftSpread = 2e-9},
                       {.step = LevelingStep::Scars, .pixels = 1234},
                       {.step = LevelingStep::Scars},
                       {.step = LevelingStep::Zero, .plane = {.mean = -12e-9}}}),
        ElementsAre("leveling, step 1 of 7: plane through three points with slopes +0.5 along x "
                    "and -0.25 along y removed; they lie at height 0",
                    "leveling, step 2 of 7: plane of the prevailing facets with slopes +0.5 along "
                    "x and -0.25 along y and the mean removed",
                    "leveling, step 3 of 7: polynomial of second degree removed: slopes +0.5 along "
                    "x and -0.25 along y at the center, second derivatives +100 along x, -2e+04 "
                    "along y, +1.5 mixed [1/m]",
                    "leveling, step 4 of 7: rows shifted by the median of differences, trend along "
                    "y kept (shifts spread by 2 nm)",
                    "leveling, step 5 of 7: 1234 pixels of scars interpolated and marked as filled",
                    "leveling, step 6 of 7: no scars found",
                    "leveling, step 7 of 7: lowest height, -12 nm, set to 0"));
}

}  // namespace
}  // namespace asperity
