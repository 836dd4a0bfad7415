#pragma once

#include "core/EnumTable.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace asperity {

/// Mode in which a map is measured.
enum class MapMode : std::uint8_t {
    Approach,  ///< approach to a setpoint and retract at each pixel
    Contact,   ///< a raster at constant force, trace and retrace of each row
};

template <>
inline constexpr auto kEnumTable<MapMode> = std::to_array<EnumRow<MapMode>>(
    {{MapMode::Approach, "approach"}, {MapMode::Contact, "contact"}});

/// Quantity of a map. Forces are those of the sample on the tip; "along z" is what a lever without
/// crosstalk shows.
enum class MapQuantity : std::uint8_t {
    PullOffForce,      ///< along z, just before the tip pulls off, > 0 pulls
    AdhesionForce,     ///< along z, the strongest pull of the retract, > 0
    SnapInDistance,    ///< of the undeflected tip from the undeformed surface, along the normal
    SeparationWork,    ///< area between the retract and zero force, where it pulls
    DissipatedEnergy,  ///< by adhesion, in snap-in and pull-off; not by friction
    Height,            ///< that the instrument records at the setpoint
    Indentation,       ///< at the setpoint, of the undeformed surface along the normal
    ContactRadius,     ///< at the setpoint; of a circle with the area of all contacts
    Stiffness,         ///< at the setpoint, d(force)/d(indentation) of the main contact
    ApparentModulus,   ///< reduced modulus of a DMT fit to the retract, see RetractCurve.h
    LateralForce,      ///< at the setpoint, across z
    NormalAngle,       ///< between the normal at the main contact point and z, at the setpoint
    // Deviations by model and calibration:
    AdhesionForceDeviation,
    SeparationWorkDeviation,
    IndentationDeviation,
    StiffnessDeviation,
    HeightTrace,
    HeightRetrace,
    LateralTrace,    ///< along x, the fast axis
    LateralRetrace,  ///< along x
    FrictionForce,   ///< half the difference of lateral force between retrace and trace
    ErrorTrace,      ///< deflection that the lever shows beyond that of the force along z
    ErrorRetrace,
    Validity,    ///< bits of ValidityFlags, of the whole cycle's states that quantities come from
    Iterations,  ///< equilibria of the tip that were solved
};

/// Names, unit and modes of a quantity.
struct MapQuantityRow {
    MapQuantity value;
    const char* key;   ///< in options, files and names of files
    const char* name;  ///< for people
    const char* unit;  ///< SI; empty: a number
    bool inApproach;   ///< whether the mode has it
    bool inContact;
    bool onRequest = false;  ///< whether a map has it only where it is asked for
};

template <>
inline constexpr auto kEnumTable<MapQuantity> = std::to_array<MapQuantityRow>(
    {{MapQuantity::PullOffForce, "pull_off_force", "pull-off force", "N", true, false},
     {MapQuantity::AdhesionForce, "adhesion_force", "adhesion force", "N", true, false},
     {MapQuantity::SnapInDistance, "snap_in_distance", "snap-in distance", "m", true, false},
     {MapQuantity::SeparationWork, "separation_work", "work of separation", "J", true, false},
     {MapQuantity::DissipatedEnergy, "dissipated_energy", "dissipated energy", "J", true, false},
     {MapQuantity::Height, "height", "height at the setpoint", "m", true, false},
     {MapQuantity::Indentation, "indentation", "indentation", "m", true, false},
     {MapQuantity::ContactRadius, "contact_radius", "contact radius", "m", true, false},
     {MapQuantity::Stiffness, "stiffness", "contact stiffness", "N/m", true, false},
     {MapQuantity::ApparentModulus, "apparent_modulus", "apparent modulus", "Pa", true, false},
     {MapQuantity::LateralForce, "lateral_force", "lateral force", "N", true, false},
     {MapQuantity::NormalAngle, "normal_angle", "angle of the normal", "rad", true, false},
     {MapQuantity::AdhesionForceDeviation, "adhesion_force_deviation",
      "adhesion force, standard deviation", "N", true, false, true},
     {MapQuantity::SeparationWorkDeviation, "separation_work_deviation",
      "work of separation, standard deviation", "J", true, false, true},
     {MapQuantity::IndentationDeviation, "indentation_deviation", "indentation, standard deviation",
      "m", true, false, true},
     {MapQuantity::StiffnessDeviation, "stiffness_deviation",
      "contact stiffness, standard deviation", "N/m", true, false, true},
     {MapQuantity::HeightTrace, "height_trace", "height, trace", "m", false, true},
     {MapQuantity::HeightRetrace, "height_retrace", "height, retrace", "m", false, true},
     {MapQuantity::LateralTrace, "lateral_trace", "lateral force, trace", "N", false, true},
     {MapQuantity::LateralRetrace, "lateral_retrace", "lateral force, retrace", "N", false, true},
     {MapQuantity::FrictionForce, "friction_force", "friction force", "N", false, true},
     {MapQuantity::ErrorTrace, "error_trace", "deflection error, trace", "m", false, true},
     {MapQuantity::ErrorRetrace, "error_retrace", "deflection error, retrace", "m", false, true},
     {MapQuantity::Validity, "validity", "validity flags", "", true, true},
     {MapQuantity::Iterations, "iterations", "iterations", "", true, true}});
static_assert(isComplete<MapQuantity>());

inline constexpr std::size_t kMapQuantityCount = kEnumTable<MapQuantity>.size();

/// Returns whether the mode has the quantity.
[[nodiscard]] constexpr bool hasQuantity(MapMode mode, const MapQuantityRow& quantity) noexcept {
    return mode == MapMode::Approach ? quantity.inApproach : quantity.inContact;
}

/// All quantities of one pixel, in the units of their table; what was not found is NaN.
class MapValues {
public:
    MapValues() noexcept { values_.fill(std::numeric_limits<double>::quiet_NaN()); }

    double& operator[](MapQuantity quantity) noexcept {
        return values_[static_cast<std::size_t>(quantity)];
    }
    double operator[](MapQuantity quantity) const noexcept {
        return values_[static_cast<std::size_t>(quantity)];
    }

private:
    std::array<double, kMapQuantityCount> values_{};
};

}  // namespace asperity
