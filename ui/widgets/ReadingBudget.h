#pragma once

#include "core/scene/TickOutput.h"
#include "core/uncertainty/CycleBudgets.h"

#include <QString>

#include <vector>

namespace asperity {

struct Scene;

/// Returns a force of the signals with what is open in it. @param scene null: the noise alone
/// @param force, sigma [N]
[[nodiscard]] Budget shownForce(const Scene* scene, double force, double sigma) noexcept;

/// "Fz: 4.99 nN ± 0.27 (noise) ± 0.5 (k)". @param unit SI
[[nodiscard]] QString namedBudget(const QString& name, const Budget& budget, const char* unit);

/// Computes indentation, contact radius and stiffness of a contact with what is open in them, a
/// line each; empty where nothing presses. Takes some ten milliseconds: for tool tips.
[[nodiscard]] QString contactDetails(const Scene& scene, const TickOutput& output);

/// Returns a reading of a cycle with what is open in it. @param key of the reading
/// @param otherwise where there is no budget of it
[[nodiscard]] QString budgetedReading(const std::vector<CycleBudget>& budgets, const char* key,
                                      const QString& otherwise);

}  // namespace asperity
