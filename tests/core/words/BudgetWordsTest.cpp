#include "core/words/BudgetWords.h"

#include <gtest/gtest.h>

#include <limits>

namespace asperity {
namespace {

Budget pullOff() {
    Budget budget{.value = 16.87e-9, .noise = 0.222e-9};
    budget.shares[static_cast<std::size_t>(UncertaintyInput::HeightNoise)] = 3.2e-9;
    budget.shares[static_cast<std::size_t>(UncertaintyInput::Smoothing)] = 2.5e-9;
    budget.shares[static_cast<std::size_t>(UncertaintyInput::InvOls)] = 0.01e-9;
    return budget;
}

TEST(BudgetWords, StateNoiseAndModelApart) {
    EXPECT_EQ(budgetText(pullOff(), "N"), "16.9 nN ± 0.2 (noise) ± 4 (heights, smoothing)");
    Budget coarse = pullOff();
    coarse.noise = 0.0;
    coarse.shares[static_cast<std::size_t>(UncertaintyInput::HeightNoise)] = 12.3e-9;
    EXPECT_EQ(budgetText(coarse, "N"), "16.9 nN ± 13 (heights)");
    EXPECT_EQ(budgetText({.value = 2e-9}, "N"), "2 nN");
}

TEST(BudgetWords, StateAShiftThatMatters) {
    Budget budget = pullOff();
    budget.shift = 1.62e-9;
    EXPECT_EQ(budgetText(budget, "N"),
              "16.9 nN ± 0.2 (noise) ± 4 (heights, smoothing), too high by 1.6 (imaging tip)");
    budget.shift = -2.4e-9;
    EXPECT_EQ(budgetText(budget, "N"),
              "16.9 nN ± 0.2 (noise) ± 4 (heights, smoothing), too low by 2 (imaging tip)");
    budget.shift = 0.3e-9;
    EXPECT_EQ(budgetText(budget, "N"), "16.9 nN ± 0.2 (noise) ± 4 (heights, smoothing)");
}

TEST(BudgetWords, StateWhatTermsDoThatAreLeftOut) {
    Budget budget = pullOff();
    budget.leftOut = 19.6e-9;
    EXPECT_EQ(budgetText(budget, "N"),
              "16.9 nN ± 0.2 (noise) ± 4 (heights, smoothing) ± 20 (terms left out)");
    EXPECT_EQ(mostBy(budget), "terms left out");
    budget.leftOut = 0.5e-9;
    EXPECT_EQ(budgetText(budget, "N"), "16.9 nN ± 0.2 (noise) ± 4 (heights, smoothing)");
    EXPECT_EQ(mostBy(budget), "heights");
}

/// Rubber under a blunt tip: noise alone stood there like the whole, 2.17 nN ± 0.019.
TEST(BudgetWords, SayThatAPartIsNotKnown) {
    const Budget byNoise = budgetByNoise(2.17e-9, 0.019e-9, UnknownShares::SeveralContacts);
    EXPECT_EQ(budgetText(byNoise, "N"),
              "2.17 nN ± 0.019 (noise) ± ? (model and calibration: several contacts at once)");
    EXPECT_EQ(mostBy(byNoise), "not known");
    EXPECT_EQ(
        unknownText(byNoise, "pull-off force"),
        "the uncertainty of the pull-off force from model and calibration is not known: several "
        "contacts at once");
    EXPECT_EQ(unknownText(pullOff(), "pull-off force"), "");
}

TEST(BudgetWords, StateTermsLeftOutWhereTheInputsAreNotKnown) {
    Budget budget = pullOff();
    budget.leftOut = 52e-9;
    budget = budget.withoutShares(UnknownShares::MissingTicks);
    EXPECT_EQ(budgetText(budget, "N"),
              "16.9 nN ± 0.2 (noise) ± 50 (terms left out) ± ? (calibration, tip and material: "
              "ticks without a state of the model)");
}

TEST(BudgetWords, SayThatTermsLeftOutWereNotJudged) {
    Budget budget = pullOff();
    budget.isLeftOutJudged = false;
    EXPECT_EQ(budgetText(budget, "N"),
              "16.9 nN ± 0.2 (noise) ± 4 (heights, smoothing) ± ? (terms left out)");
    EXPECT_EQ(unknownText(budget, "work"),
              "the effect of the terms left out on the work is not known");
    budget.isLeftOutJudged = true;
    budget.leftOut = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(budgetText(budget, "N"),
              "16.9 nN ± 0.2 (noise) ± 4 (heights, smoothing) ± ? (terms left out)");
}

TEST(BudgetWords, NameSmoothingThatMattersMoreThanTheTolerance) {
    EXPECT_EQ(resolutionText(pullOff(), "pull-off force", 0.05),
              "smoothing and pixels move the pull-off force by 15 %, more than the tolerance of "
              "5 %");
    EXPECT_EQ(resolutionText(pullOff(), "pull-off force", 0.2), "");
}

TEST(BudgetWords, NameRoughnessThatNoiseMayHide) {
    Budget budget = pullOff();
    budget.hidden = 2e-9;
    EXPECT_EQ(resolutionText(budget, "pull-off force", 0.2), "");
    budget.hidden = 5e-9;
    EXPECT_EQ(resolutionText(budget, "pull-off force", 0.2),
              "noise of the heights hides roughness that may move the pull-off force by 30 %; the "
              "stated deviations do not include it");
}

TEST(BudgetWords, NameTheLargerOfWhatSmoothingMovesAndWhatNoiseHides) {
    Budget budget = pullOff();
    budget.hidden = 2e-9;
    EXPECT_EQ(resolutionText(budget, "work", 0.05),
              "smoothing and pixels move the work by 15 %, more than the tolerance of 5 %");
    budget.hidden = 5e-9;
    EXPECT_EQ(resolutionText(budget, "work", 0.05),
              "noise of the heights hides roughness that may move the work by 30 %; the stated "
              "deviations do not include it");
}

}  // namespace
}  // namespace asperity
