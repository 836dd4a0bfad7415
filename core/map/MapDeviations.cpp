#include "core/map/MapDeviations.h"

#include "core/uncertainty/PlaceBudgets.h"

#include <algorithm>
#include <array>

namespace asperity {

namespace {

/// A quantity, the landmark of the law that it reads, and where its deviation goes.
struct DeviationRow {
    MapQuantity quantity;
    Landmark landmark;
    MapQuantity deviation;
};

constexpr auto kDeviations = std::to_array<DeviationRow>(
    {{MapQuantity::AdhesionForce, Landmark::AdhesionForce, MapQuantity::AdhesionForceDeviation},
     {MapQuantity::SeparationWork, Landmark::SeparationWork, MapQuantity::SeparationWorkDeviation},
     {MapQuantity::Indentation, Landmark::Indentation, MapQuantity::IndentationDeviation},
     {MapQuantity::Stiffness, Landmark::Stiffness, MapQuantity::StiffnessDeviation}});

}  // namespace

bool isDeviation(MapQuantity quantity) noexcept {
    return std::ranges::find(kDeviations, quantity, &DeviationRow::deviation) != kDeviations.end();
}

bool hasDeviations(const MapPlan& plan) {
    return std::ranges::any_of(plan.quantities, isDeviation);
}

void takeDeviations(const Scene& scene, const TipState& setpoint, MapValues& values) {
    const PlaceBudgets budgets = budgetsAt(scene, setpoint, setpoint.normalForce);
    for (const DeviationRow& row : kDeviations) {
        // Not a number where the law has no such landmark or the tip has several contacts.
        values[row.deviation] =
            budgetOf(budgets, row.landmark).of(values[row.quantity], 0.0).modelAboutValue();
    }
}

}  // namespace asperity
