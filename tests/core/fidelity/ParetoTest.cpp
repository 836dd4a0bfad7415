#include "core/fidelity/Pareto.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

using Choices = std::vector<CostAndError>;

TEST(Pareto, TheFrontHasNoneThatAnotherBeats) {
    const Choices choices{{1.0, 9.0}, {2.0, 4.0}, {3.0, 5.0}, {4.0, 1.0}, {4.0, 2.0}};
    EXPECT_EQ(paretoFront(choices), (std::vector<bool>{true, true, false, true, false}));
}

TEST(Pareto, EqualsAreBothOnTheFront) {
    EXPECT_EQ(paretoFront(Choices{{1.0, 1.0}, {1.0, 1.0}}), (std::vector<bool>{true, true}));
    EXPECT_TRUE(paretoFront({}).empty());
}

TEST(Pareto, TheCheapestIsWithinTheTolerance) {
    const Choices choices{{1.0, 9.0}, {5.0, 0.0}, {2.0, 4.0}};
    EXPECT_EQ(cheapestWithin(choices, 10.0), 0U);
    EXPECT_EQ(cheapestWithin(choices, 4.0), 2U);
    EXPECT_EQ(cheapestWithin(choices, 1.0), 1U);
    EXPECT_EQ(cheapestWithin(choices, -1.0), choices.size()) << "none";
}

}  // namespace
}  // namespace asperity
