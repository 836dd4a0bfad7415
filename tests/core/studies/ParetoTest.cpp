#include "core/studies/TradeOffStudy.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

using Choices = std::vector<CostAndError>;
using Front = std::vector<bool>;

TEST(Pareto, TheFrontHasNoneThatAnotherBeats) {
    const Choices choices{{1.0, 9.0}, {2.0, 4.0}, {3.0, 5.0}, {4.0, 1.0}, {4.0, 2.0}};
    EXPECT_EQ(paretoFront(choices, {}), (Front{true, true, false, true, false}));
    EXPECT_TRUE(paretoFront({}, {}).empty());
}

TEST(Pareto, OfEqualsTheFirstIsOnTheFront) {
    EXPECT_EQ(paretoFront(Choices{{1.0, 1.0}, {1.0, 1.0}}, {}), (Front{true, false}));
}

TEST(Pareto, AsCheapAsCanBeToldTheNearestIsOnTheFront) {
    const Choices choices{{1.00, 5.0}, {1.04, 2.0}, {1.2, 1.0}};
    EXPECT_EQ(paretoFront(choices, {.cost = 0.05}), (Front{false, true, true}));
    EXPECT_EQ(paretoFront(choices, {.cost = 0.01}), (Front{true, true, true}));
}

TEST(Pareto, NoNeighborOnTheFrontIsAsCheapAndNearer) {
    const Resolution tenth{.cost = 0.1};
    EXPECT_EQ(paretoFront(Choices{{1.0, 5.0}, {1.08, 4.0}, {1.16, 3.0}, {1.5, 1.0}}, tenth),
              (Front{true, false, true, true}));
    EXPECT_EQ(paretoFront(Choices{{4.05, 1.09}, {4.30, 0.7}, {4.49, 0.66}}, tenth),
              (Front{true, false, true}))
        << "a tenth is 10.9 %";
    EXPECT_EQ(paretoFront(Choices{{4.10, 1.09}, {4.49, 0.66}}, tenth), (Front{false, true}));
}

TEST(Pareto, ErrorsThatCannotBeToldAreAllTheSame) {
    const Choices choices{{1.0, 0.3}, {2.0, 0.1}, {3.0, 0.0}};
    EXPECT_EQ(paretoFront(choices, {.error = 0.5}), (Front{true, false, false}));
    EXPECT_EQ(paretoFront(choices, {.error = 0.2}), (Front{true, true, false}));
}

TEST(Pareto, TheCheapestIsWithinTheTolerance) {
    const Choices choices{{1.0, 9.0}, {5.0, 0.0}, {2.0, 4.0}};
    EXPECT_EQ(cheapestWithin(choices, 10.0, {}), 0U);
    EXPECT_EQ(cheapestWithin(choices, 4.0, {}), 2U);
    EXPECT_EQ(cheapestWithin(choices, 1.0, {}), 1U);
    EXPECT_EQ(cheapestWithin(choices, -1.0, {}), choices.size()) << "none";
}

TEST(Pareto, OfTheEquallyCheapTheNearestIsNamed) {
    const Choices choices{{1.00, 4.0}, {1.04, 1.0}, {1.02, 9.0}};
    EXPECT_EQ(cheapestWithin(choices, 5.0, {.cost = 0.05}), 1U);
    EXPECT_EQ(cheapestWithin(choices, 5.0, {.cost = 0.01}), 0U);
}

TEST(Pareto, OfTheEquallyCheapAndNearTheCheapestIsNamed) {
    const Choices choices{{2.71, 0.40}, {2.50, 0.14}, {2.60, 0.2}};
    EXPECT_EQ(cheapestWithin(choices, 1.0, {.cost = 0.15, .error = 0.5}), 1U);
}

}  // namespace
}  // namespace asperity
