#pragma once

#include "core/Vector.h"
#include "core/uncertainty/Budget.h"
#include "core/uncertainty/Landmarks.h"

#include <array>

namespace asperity {

struct Scene;
struct SceneDescription;
struct TipState;

/// Budgets in the order of Landmark; the value is NaN where there is no such landmark.
using PlaceBudgets = std::array<Budget, kLandmarkCount>;

[[nodiscard]] inline const Budget& budgetOf(const PlaceBudgets& budgets,
                                            Landmark landmark) noexcept {
    return budgets[static_cast<std::size_t>(landmark)];
}

/// Computes by what each input of [uncertainty] moves the landmarks of the believed contact at one
/// place, from the contact law alone: no cycle is repeated. Noise is 0: it is of a reading. All
/// shares are 0 where the scene has `enabled = false`, and but for those of the setpoint's force
/// not known where the tip has several contacts: the law is of one. Nor are they where the scene
/// shows a landmark that the law without the imaging tip does not have. Some 40 evaluations of the
/// law, of fold, equilibrium and area each.
/// @param state of the believed tip at the place
/// @param force along the normal at the setpoint [N]; not above 0: there is none
/// Source: docs/uncertainty.md.
[[nodiscard]] PlaceBudgets budgetsAt(const Scene& scene, const TipState& state, double force);

/// The same where the tip first touches the sample as it comes down at a place: a blunt one beside
/// it. @param place of the apex, world x, y [m]
[[nodiscard]] PlaceBudgets budgetsAt(const Scene& scene, const Vector2& place, double force);

/// Computes the budgets of a contact law that has no place: of a flat sample and a lever whose
/// compliance along the normal is given. No heights and no normal move it.
/// @param scene whose deviations, tip and sample the law has @param compliance [m/N]
/// @param force as above
[[nodiscard]] PlaceBudgets budgetsOf(const SceneDescription& scene, const ContactModel& model,
                                     double compliance, double force);

/// White noise of the scan's heights as the budgets take it: the scene's, or the estimate [m].
[[nodiscard]] double usedHeightNoise(const Scene& scene) noexcept;

}  // namespace asperity
