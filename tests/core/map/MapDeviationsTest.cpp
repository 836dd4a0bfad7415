#include "core/Error.h"
#include "core/map/MapPlan.h"
#include "core/map/PixelCycle.h"
#include "core/uncertainty/LandmarkBudgets.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace asperity {
namespace {

constexpr MapGrid kGrid{3, 2};

std::vector<double> channelOf(const MapPlan& plan, const std::vector<double>& row,
                              MapQuantity quantity) {
    const auto found = std::ranges::find(plan.quantities, quantity);
    EXPECT_NE(found, plan.quantities.end());
    const auto first = row.begin() + kGrid.columns * (found - plan.quantities.begin());
    return {first, first + kGrid.columns};
}

TEST(MapDeviations, AreThoseOfTheBudgetAtThePixelAndChangeNothingElse) {
    const Scene scene = buildScene(test::plainScene(), test::hillyMap());
    const MapInstrument instrument(scene, false);
    const MapPlan usual = planMap(scene, {.grid = kGrid});
    const MapPlan plan = planMap(scene, {.grid = kGrid, .deviations = true});
    EXPECT_EQ(plan.quantities.size(), usual.quantities.size() + 4);
    const std::vector<double> row = mapRow(instrument, plan, 1);
    const std::vector<double> before = mapRow(instrument, usual, 1);
    for (const MapQuantity quantity : usual.quantities) {
        const std::vector<double> now = channelOf(plan, row, quantity);
        const std::vector<double> then = channelOf(usual, before, quantity);
        for (std::size_t i = 0; i < now.size(); ++i) {
            EXPECT_TRUE(now[i] == then[i] || (std::isnan(now[i]) && std::isnan(then[i])));
        }
    }
    for (const auto& [quantity, deviation, landmark] :
         {std::tuple(MapQuantity::AdhesionForce, MapQuantity::AdhesionForceDeviation,
                     Landmark::AdhesionForce),
          std::tuple(MapQuantity::SeparationWork, MapQuantity::SeparationWorkDeviation,
                     Landmark::SeparationWork),
          std::tuple(MapQuantity::Indentation, MapQuantity::IndentationDeviation,
                     Landmark::Indentation),
          std::tuple(MapQuantity::Stiffness, MapQuantity::StiffnessDeviation,
                     Landmark::Stiffness)}) {
        SCOPED_TRACE(rowOf(deviation)->name);
        const std::vector<double> values = channelOf(plan, row, quantity);
        const std::vector<double> deviations = channelOf(plan, row, deviation);
        for (int column = 0; column < kGrid.columns; ++column) {
            const auto i = static_cast<std::size_t>(column);
            const LandmarkBudgets budgets =
                budgetsAt(scene, plan.position(1, column), plan.setpoint);
            const Budget ofLaw = budgetOf(budgets, landmark).of(values[i], 0.0);
            EXPECT_NEAR(deviations[i], ofLaw.model(), 0.1 * ofLaw.model()) << "pressed there";
        }
    }
    const std::vector<double> adhesion = channelOf(plan, row, MapQuantity::AdhesionForce);
    const std::vector<double> deviation = channelOf(plan, row, MapQuantity::AdhesionForceDeviation);
    for (std::size_t i = 0; i < adhesion.size(); ++i) {
        EXPECT_GT(deviation[i], 0.1 * adhesion[i])
            << "radius and adhesion are known to a tenth each";
    }
}

/// The budget is of one contact: none is better than that of the one that happens to be first.
TEST(MapDeviations, AreUnknownWhereSeveralContactsCarry) {
    const Scene scene = buildScene(test::plainScene(), test::ridgedMap(25e-9));
    const MapInstrument instrument(scene, false);
    // Crest at 15 nm, groove at 45 nm: both walls of it carry.
    const MapPlan plan = planMap(
        scene, {.grid = kGrid, .region = MapRegion{0.0, 50e-9, 90e-9, 90e-9}, .deviations = true});
    const std::vector<double> row = mapRow(instrument, plan, 0);
    for (const auto& [quantity, deviation] :
         {std::pair(MapQuantity::AdhesionForce, MapQuantity::AdhesionForceDeviation),
          std::pair(MapQuantity::Stiffness, MapQuantity::StiffnessDeviation)}) {
        const std::vector<double> values = channelOf(plan, row, quantity);
        const std::vector<double> deviations = channelOf(plan, row, deviation);
        EXPECT_GT(deviations[0], 0.0) << "one contact on the crest";
        EXPECT_TRUE(std::isfinite(values[1])) << "the quantity is there";
        EXPECT_TRUE(std::isnan(deviations[1])) << "two contacts in the groove";
    }
}

TEST(MapDeviations, AreMissingWhereTheyAreNotAskedForAndRefusedWhereThereAreNone) {
    SceneDescription description = test::plainScene();
    const Scene scene = buildScene(description, test::flatMap());
    EXPECT_FALSE(hasDeviations(planMap(scene, {})));
    EXPECT_TRUE(hasDeviations(planMap(scene, {.quantities = {"stiffness_deviation"}})));
    EXPECT_THROW((void)planMap(scene, {.deviations = true, .truth = true}), Error);
    description.uncertainty.enabled = false;
    const Scene certain = buildScene(description, test::flatMap());
    EXPECT_THROW((void)planMap(certain, {.deviations = true}), Error);
}

}  // namespace
}  // namespace asperity
