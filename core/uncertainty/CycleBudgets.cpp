#include "core/uncertainty/CycleBudgets.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity {

namespace {

constexpr auto kReadings = std::to_array<CycleReading>(
    {{"snap_in_force_n", "snap-in force", Landmark::SnapInForce,
      [](const ContactCycle& cycle) { return cycle.snapIn; }, true},
     {"snap_in_distance_m", "snap-in distance", Landmark::SnapInDistance,
      [](const ContactCycle& cycle) {
          return cycle.snapIn ? std::optional(cycle.snapInBaseDistance) : std::nullopt;
      }},
     {"pull_off_force_n", "pull-off force", Landmark::AdhesionForce,
      [](const ContactCycle& cycle) { return cycle.pullOffForce(); }, true},
     {"adhesion_work_j", "work of adhesion", Landmark::SeparationWork,
      [](const ContactCycle& cycle) { return cycle.workOfAdhesion(); }, true},
     {"hysteresis_j", "hysteresis", Landmark::Hysteresis,
      [](const ContactCycle& cycle) { return cycle.closedHysteresis(); }, true},
     {"contact_stiffness_n_m", "contact stiffness", Landmark::Stiffness,
      [](const ContactCycle& cycle) { return cycle.stiffness; }},
     {"max_force_n", "largest force", Landmark::NormalForce,
      [](const ContactCycle& cycle) { return cycle.maxForce; }},
     {"max_indentation_m", "largest indentation", Landmark::Indentation,
      [](const ContactCycle& cycle) { return cycle.maxIndentation; }}});

/// With what k and InvOLS move the signals by.
Budget withInstrument(Budget budget, const Budget& force) {
    for (const UncertaintyInput input : {UncertaintyInput::Stiffness, UncertaintyInput::InvOls}) {
        double& share = budget.shares[static_cast<std::size_t>(input)];
        const double more = force.share(input) / force.value * budget.value;
        share = std::hypot(share, std::isfinite(more) ? more : 0.0);
    }
    return budget;
}

/// The budgets are of one contact, of which nothing is missing.
UnknownShares unknownIn(const ContactCycle& cycle) {
    if (cycle.contacts > 1) {
        return UnknownShares::SeveralContacts;
    }
    return cycle.interrupted ? UnknownShares::MissingTicks : UnknownShares::None;
}

Budget budgetOf(const CycleReading& row, const Reading& reading, const LandmarkBudgets& budgets,
                UnknownShares unknown) {
    const Budget& ofPosition = budgetOf(budgets, row.landmark);
    const bool isOfLever = row.landmark == Landmark::NormalForce;
    const Budget budget = ofPosition.of(reading.value, reading.sigma);
    if (unknown != UnknownShares::None && !isOfLever) {
        return budget.withoutShares(unknown);
    }
    return row.isOfSignals ? withInstrument(budget, budgetOf(budgets, Landmark::NormalForce))
                           : budget;
}

}  // namespace

std::vector<CycleBudget> cycleBudgets(const LandmarkBudgets& budgets, const ContactCycle& cycle) {
    std::vector<CycleBudget> list;
    // Where the law has nothing like it either, noise makes cycles that are none.
    const bool pushes = cycle.maxForce && cycle.maxForce->value > cycle.maxForce->sigma;
    for (const CycleReading& row : kReadings) {
        const std::optional<Reading> reading = row.of(cycle);
        if (reading && (pushes || std::isfinite(budgetOf(budgets, row.landmark).value))) {
            list.push_back({row.key, row.name, row.unit(),
                            budgetOf(row, *reading, budgets, unknownIn(cycle))});
        }
    }
    return list;
}

const CycleReading& cycleReading(std::string_view key) noexcept {
    return *std::ranges::find(kReadings, key, &CycleReading::key);
}

std::optional<Budget> budgetNamed(const std::vector<CycleBudget>& budgets, std::string_view key) {
    const auto found = std::ranges::find(budgets, key, &CycleBudget::key);
    return found == budgets.end() ? std::nullopt : std::optional(found->budget);
}

std::vector<CycleBudget> cycleBudgets(const Scene& scene, const ContactCycle& cycle) {
    return cycleBudgets(budgetsAt(scene, cycle.position, cycle.maxForce.value_or(Reading{}).value),
                        cycle);
}

double ownStiffnessDeviation(const Uncertainty& given) noexcept {
    const double common = given.thermalStiffness ? 2.0 * given.invOls : 0.0;
    return std::sqrt(std::max(0.0, (given.stiffness * given.stiffness) - (common * common)));
}

Budget forceBudget(const Uncertainty& given, double force, double noise) noexcept {
    Budget budget{.value = force, .noise = noise};
    if (given.enabled) {
        const auto set = [&](UncertaintyInput input, double deviation) {
            budget.shares[static_cast<std::size_t>(input)] = std::abs(force) * deviation;
        };
        set(UncertaintyInput::Stiffness, ownStiffnessDeviation(given));
        set(UncertaintyInput::InvOls, given.invOls);
    }
    return budget;
}

}  // namespace asperity
