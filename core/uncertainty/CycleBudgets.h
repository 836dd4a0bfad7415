#pragma once

#include "core/haptics/cycle/ContactCycle.h"
#include "core/uncertainty/PlaceBudgets.h"

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

/// Computes what model and calibration leave open in the readings of a cycle, at its place and its
/// largest force; noise is the cycle's own. What a cycle does not show is left out. Where it has
/// several contacts, or a part without a state of the model, only the force's is known.
[[nodiscard]] std::vector<CycleBudget> cycleBudgets(const Scene& scene, const ContactCycle& cycle);

/// The same by budgets of the cycle's place that are known already.
[[nodiscard]] std::vector<CycleBudget> cycleBudgets(const PlaceBudgets& budgets,
                                                    const ContactCycle& cycle);

/// Returns the budget of a reading; none: it has none. @param key of the reading
[[nodiscard]] std::optional<Budget> budgetNamed(const std::vector<CycleBudget>& budgets,
                                                std::string_view key);

}  // namespace asperity
