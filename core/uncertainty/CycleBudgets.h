#pragma once

#include "core/haptics/cycle/CurveBranch.h"
#include "core/uncertainty/Budget.h"
#include "core/uncertainty/LandmarkBudgets.h"

#include <optional>
#include <string_view>
#include <vector>

namespace asperity {

struct Scene;

/// A reading of a cycle, and the landmark of the law that it reads.
struct CycleReading {
    const char* key;   ///< in summaries
    const char* name;  ///< for people
    Landmark landmark;
    std::optional<Reading> (*of)(const ContactCycle& cycle);  ///< none: the cycle has none
    bool isOfSignals = false;  ///< it goes as k and InvOLS, as the force at the setpoint does

    [[nodiscard]] const char* unit() const noexcept { return rowOf(landmark)->unit; }  ///< SI
};

/// Returns the reading of a key that is one.
[[nodiscard]] const CycleReading& cycleReading(std::string_view key) noexcept;

/// A reading of a cycle with what is open in it.
struct CycleBudget {
    const char* key;   ///< of the reading in summaries
    const char* name;  ///< for people
    const char* unit;  ///< SI
    Budget budget;
};

/// Computes the deviations by model and calibration of the readings of a cycle, at its position and
/// its largest force; noise is the cycle's own. What a cycle does not show is left out. Where it
/// has several contacts, or a part without a state of the model, only the force's is known.
[[nodiscard]] std::vector<CycleBudget> cycleBudgets(const Scene& scene, const ContactCycle& cycle);

/// The same by budgets of the cycle's position that are known already.
[[nodiscard]] std::vector<CycleBudget> cycleBudgets(const LandmarkBudgets& budgets,
                                                    const ContactCycle& cycle);

/// Returns the budget of a reading; none: it has none. @param key of the reading
[[nodiscard]] std::optional<Budget> budgetNamed(const std::vector<CycleBudget>& budgets,
                                                std::string_view key);

/// Returns the relative deviation of the stiffness that is no matter of InvOLS: a stiffness from a
/// thermal spectrum goes as 1 / InvOLS^2. Source: docs/uncertainty.md 1.1.
[[nodiscard]] double ownStiffnessDeviation(const Uncertainty& given) noexcept;

/// Budget of a force as the signals of the lever show it: its scale is stiffness times InvOLS.
/// @param force [N] @param noise its standard deviation by noise [N]
[[nodiscard]] Budget forceBudget(const Uncertainty& given, double force, double noise) noexcept;

}  // namespace asperity
