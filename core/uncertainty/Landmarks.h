#pragma once

#include "core/EnumTable.h"
#include "core/contact/laws/ContactModel.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace asperity {

/// What a user reads off a force curve.
enum class Landmark : std::uint8_t {
    AdhesionForce,   ///< strongest pull of the retract, > 0
    PullOffForce,    ///< just before the tip comes off, > 0 pulls
    SeparationWork,  ///< area between the retract and zero force, where it pulls
    NormalForce,     ///< at the setpoint
    Indentation,     ///< there
    Stiffness,       ///< of the contact, there
    ContactRadius,   ///< there
};

/// What there is to say of a landmark.
struct LandmarkRow {
    Landmark value;
    const char* key;   ///< in summaries
    const char* name;  ///< for people
    const char* unit;  ///< SI
};

template <>
inline constexpr auto kEnumTable<Landmark> = std::to_array<LandmarkRow>(
    {{Landmark::AdhesionForce, "adhesion_force_n", "adhesion force", "N"},
     {Landmark::PullOffForce, "pull_off_force_n", "pull-off force", "N"},
     {Landmark::SeparationWork, "adhesion_work_j", "work of separation", "J"},
     {Landmark::NormalForce, "normal_force_n", "normal force", "N"},
     {Landmark::Indentation, "indentation_m", "indentation", "m"},
     {Landmark::Stiffness, "contact_stiffness_n_m", "contact stiffness", "N/m"},
     {Landmark::ContactRadius, "contact_radius_m", "contact radius", "m"}});
static_assert(isComplete<Landmark>());

inline constexpr std::size_t kLandmarkCount = kEnumTable<Landmark>.size();

/// Landmarks in the order of their enum, SI; NaN: the curve has none.
using Landmarks = std::array<double, kLandmarkCount>;

/// Computes the landmarks of a law on a lever, without a cycle: folds, equilibrium and area of the
/// bonded branch are the law's own. The attraction of a tip that has come off is no part of the
/// work. Source: docs/theory.md 7.1.
/// @param compliance of the lever along the normal [m/N]
/// @param force normal force at the setpoint [N]; not above 0: there is none
[[nodiscard]] Landmarks landmarksOf(const ContactModel& model, double compliance, double force);

}  // namespace asperity
