#include "core/uncertainty/CycleBudgets.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity {

namespace {

/// A reading, and the landmark of the law that it reads.
struct CycleReading {
    const char* key;
    const char* name;
    Landmark landmark;
    std::optional<Reading> (*of)(const ContactCycle& cycle);
};

constexpr auto kReadings = std::to_array<CycleReading>(
    {{"pull_off_force_n", "pull-off force", Landmark::AdhesionForce,
      [](const ContactCycle& cycle) { return cycle.pullOff; }},
     {"adhesion_work_j", "work of adhesion", Landmark::SeparationWork,
      [](const ContactCycle& cycle) {
          return std::optional(Reading{cycle.adhesionWork, cycle.areaSigma});
      }},
     {"contact_stiffness_n_m", "contact stiffness", Landmark::Stiffness,
      [](const ContactCycle& cycle) { return cycle.stiffness; }},
     {"max_force_n", "largest force", Landmark::NormalForce,
      [](const ContactCycle& cycle) { return std::optional(cycle.maxForce); }},
     {"max_indentation_m", "largest indentation", Landmark::Indentation,
      [](const ContactCycle& cycle) {
          return std::optional(Reading{cycle.maxIndentation, 0.0});
      }}});

/// A reading of the signals, which goes as k and InvOLS, as the force at the setpoint does.
Budget withInstrument(Budget budget, const Budget& force) {
    for (const UncertaintyInput input : {UncertaintyInput::Stiffness, UncertaintyInput::InvOls}) {
        double& share = budget.shares[static_cast<std::size_t>(input)];
        const double more = force.share(input) / force.value * budget.value;
        share = std::hypot(share, std::isfinite(more) ? more : 0.0);
    }
    return budget;
}

}  // namespace

std::vector<CycleBudget> cycleBudgets(const PlaceBudgets& budgets, const ContactCycle& cycle) {
    std::vector<CycleBudget> list;
    const Budget& force = budgetOf(budgets, Landmark::NormalForce);
    for (const CycleReading& row : kReadings) {
        const std::optional<Reading> reading = row.of(cycle);
        const Budget& ofLaw = budgetOf(budgets, row.landmark);
        if (reading && std::isfinite(ofLaw.value)) {
            const bool isOfSignals =
                row.landmark == Landmark::AdhesionForce || row.landmark == Landmark::SeparationWork;
            const Budget budget = ofLaw.of(reading->value, reading->sigma);
            list.push_back({row.key, row.name, rowOf(row.landmark)->unit,
                            isOfSignals ? withInstrument(budget, force) : budget});
        }
    }
    return list;
}

std::optional<Budget> budgetNamed(const std::vector<CycleBudget>& budgets, std::string_view key) {
    const auto found = std::ranges::find(budgets, key, &CycleBudget::key);
    return found == budgets.end() ? std::nullopt : std::optional(found->budget);
}

std::vector<CycleBudget> cycleBudgets(const Scene& scene, const ContactCycle& cycle) {
    return cycleBudgets(budgetsAt(scene, cycle.place, cycle.maxForce.value), cycle);
}

}  // namespace asperity
