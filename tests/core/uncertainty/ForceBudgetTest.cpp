#include "core/uncertainty/CycleBudgets.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

TEST(ForceBudget, GoesWithStiffnessAndInvOls) {
    Uncertainty given;
    const Budget budget = forceBudget(given, -5e-9, 0.2e-9);
    EXPECT_EQ(budget.value, -5e-9);
    EXPECT_EQ(budget.noise, 0.2e-9);
    EXPECT_NEAR(budget.model(), 5e-9 * std::hypot(0.1, 0.03), 1e-20);
    given.enabled = false;
    EXPECT_EQ(forceBudget(given, -5e-9, 0.2e-9).model(), 0.0);
}

/// k ~ 1 / InvOLS^2: a force goes as 1 / InvOLS, and of the deviation of k the rest is its own.
TEST(ForceBudget, OfAThermalStiffnessKnowsTheInvOlsOnce) {
    const Uncertainty given{.stiffness = 0.1, .invOls = 0.03, .thermalStiffness = true};
    EXPECT_NEAR(ownStiffnessDeviation(given), 0.08, 1e-12);
    EXPECT_NEAR(forceBudget(given, 1e-9, 0.0).model(), 1e-9 * std::hypot(0.08, 0.03), 1e-20);
    const Uncertainty certain{.stiffness = 0.01, .invOls = 0.03, .thermalStiffness = true};
    EXPECT_EQ(ownStiffnessDeviation(certain), 0.0);
}

}  // namespace
}  // namespace asperity
