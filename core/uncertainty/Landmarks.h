#pragma once

#include "core/EnumTable.h"
#include "core/contact/laws/ContactModel.h"
#include "core/scene/JudgedQuantity.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace asperity {

/// Quantity that a user reads off a force curve.
enum class Landmark : std::uint8_t {
    AdhesionForce,   ///< strongest pull of the retract, > 0
    PullOffForce,    ///< just before the tip comes off, > 0 pulls
    SeparationWork,  ///< area between the retract and zero force, where it pulls
    NormalForce,     ///< at the setpoint
    Indentation,     ///< there
    Stiffness,       ///< of the contact, there
    ContactRadius,   ///< there
    SnapInForce,     ///< just after snap-in, > 0 pulls
    SnapInDistance,  ///< gap that the undeflected tip has at snap-in
    Hysteresis,      ///< lost in both jumps
    ContactTravel,   ///< of the base from the setpoint to the pull-off
};

/// Names, unit and judged error of a landmark.
struct LandmarkRow {
    Landmark value;
    const char* key;   ///< in summaries
    const char* name;  ///< for people
    const char* unit;  ///< SI
    /// Quantity whose error by a left-out term it shows; none: that is not judged.
    std::optional<JudgedQuantity> judged;
};

template <>
inline constexpr auto kEnumTable<Landmark> = std::to_array<LandmarkRow>(
    {{Landmark::AdhesionForce, "adhesion_force_n", "adhesion force", "N",
      JudgedQuantity::PullOffForce},
     {Landmark::PullOffForce, "pull_off_force_n", "pull-off force", "N",
      JudgedQuantity::PullOffForce},
     {Landmark::SeparationWork, "adhesion_work_j", "work of separation", "J",
      JudgedQuantity::SeparationWork},
     {Landmark::NormalForce, "normal_force_n", "normal force", "N", std::nullopt},
     {Landmark::Indentation, "indentation_m", "indentation", "m", JudgedQuantity::Indentation},
     {Landmark::Stiffness, "contact_stiffness_n_m", "contact stiffness", "N/m",
      JudgedQuantity::Stiffness},
     {Landmark::ContactRadius, "contact_radius_m", "contact radius", "m",
      JudgedQuantity::Indentation},
     {Landmark::SnapInForce, "snap_in_force_n", "snap-in force", "N", JudgedQuantity::SnapInForce},
     {Landmark::SnapInDistance, "snap_in_distance_m", "snap-in distance", "m",
      JudgedQuantity::SnapInPosition},
     {Landmark::Hysteresis, "hysteresis_j", "hysteresis", "J", JudgedQuantity::SeparationWork},
     {Landmark::ContactTravel, "contact_travel_m", "travel from setpoint to pull-off", "m",
      JudgedQuantity::PullOffPosition}});
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
