#include "core/uncertainty/Budget.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

Budget someBudget() {
    Budget budget{.value = 10.0, .noise = 1.2};
    budget.shares[static_cast<std::size_t>(UncertaintyInput::TipRadius)] = 3.0;
    budget.shares[static_cast<std::size_t>(UncertaintyInput::Smoothing)] = 4.0;
    budget.shares[static_cast<std::size_t>(UncertaintyInput::Modulus)] = 0.1;
    return budget;
}

TEST(Budget, AddsSharesAsIndependentOnes) {
    const Budget budget = someBudget();
    EXPECT_NEAR(budget.model(), 5.001, 1e-5);
    EXPECT_NEAR(budget.total(), std::hypot(1.2, budget.model()), 1e-12);
    EXPECT_NEAR(budget.resolutionShare(), 0.4, 1e-12);
}

TEST(Budget, NamesTheInputsThatMatter) {
    const Budget budget = someBudget();
    EXPECT_EQ(budget.dominant(), UncertaintyInput::Smoothing);
    const std::vector<UncertaintyInput> expected{UncertaintyInput::Smoothing,
                                                 UncertaintyInput::TipRadius};
    EXPECT_EQ(budget.mainInputs(), expected);
    EXPECT_FALSE(Budget{}.dominant());
    EXPECT_TRUE(Budget{}.mainInputs().empty());
}

TEST(Budget, CountsTermsThatAreLeftOut) {
    Budget budget = someBudget();
    budget.leftOut = 12.0;
    EXPECT_NEAR(budget.inputs(), 5.001, 1e-5);
    EXPECT_NEAR(budget.model(), std::hypot(5.001, 12.0), 1e-5);
    EXPECT_NEAR(budget.of(5.0, 0.0).leftOut, 6.0, 1e-12);
    const std::vector<UncertaintyInput> expected{UncertaintyInput::Smoothing,
                                                 UncertaintyInput::TipRadius};
    EXPECT_EQ(budget.mainInputs(), expected) << "of the inputs";
}

TEST(Budget, SaysWhereNoMoreIsKnownThanTheNoise) {
    const Budget budget = budgetByNoise(10.0, 1.2, UnknownShares::SeveralContacts);
    EXPECT_FALSE(budget.isModelKnown());
    EXPECT_FALSE(budget.isLeftOutKnown());
    EXPECT_EQ(budget.of(5.0, 1.0).unknown, UnknownShares::SeveralContacts);
    EXPECT_TRUE(someBudget().isModelKnown());
    EXPECT_FALSE(budget.of(5.0, 1.0).isModelKnown());
    EXPECT_FALSE(budget.dominant());
    EXPECT_TRUE(budget.mainInputs().empty());
}

/// JKR snaps in at a distance of 0: a share of that, 0, was stated of a distance of 9 nm.
TEST(Budget, KnowsNoShareOfAReadingThatTheLawDoesNotHave) {
    Budget none = someBudget();
    none.value = 0.0;
    EXPECT_EQ(none.of(9e-9, 1e-9).unknown, UnknownShares::NoLandmark);
    EXPECT_FALSE(none.of(9e-9, 1e-9).isModelKnown());
    EXPECT_TRUE(none.of(0.0, 1e-9).isModelKnown());
}

TEST(Budget, KeepsRelativeSharesForAnotherReading) {
    const Budget reading = someBudget().of(-20.0, 0.5);
    EXPECT_EQ(reading.value, -20.0);
    EXPECT_EQ(reading.noise, 0.5);
    EXPECT_NEAR(reading.share(UncertaintyInput::Smoothing), 8.0, 1e-12);
}

}  // namespace
}  // namespace asperity
