#pragma once

#include "core/uncertainty/Budget.h"

namespace asperity {

/// Returns the relative deviation of the stiffness that is no matter of InvOLS: a stiffness from a
/// thermal spectrum goes as 1 / InvOLS^2. Source: docs/uncertainty.md 1.1.
[[nodiscard]] double ownStiffnessDeviation(const Uncertainty& given) noexcept;

/// Budget of a force as the signals of the lever show it: its scale is stiffness times InvOLS.
/// @param force [N] @param noise its standard deviation by noise [N]
[[nodiscard]] Budget forceBudget(const Uncertainty& given, double force, double noise) noexcept;

}  // namespace asperity
