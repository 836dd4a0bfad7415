#pragma once

#include "core/EnumTable.h"

#include <cstdint>

namespace asperity {

/// By what a surface can be colored.
enum class SurfaceQuantity : std::uint8_t {
    Height,               ///< of the surface at rest [m]
    Slope,                ///< its angle against the horizontal [rad]
    Gap,                  ///< between deformed sample and tip, along the contact's normal [m]
    Pressure,             ///< on the sample, > 0 compression [Pa]
    Displacement,         ///< into the sample, along the contact's normal [m]
    Residual,             ///< what smoothing and fit left out of the scan: data minus surface [m]
    Certainty,            ///< 1 where the imaging tip has certainly touched the surface, else 0
    YoungsModulus,        ///< of a sample that is not the same everywhere [Pa]
    WorkOfAdhesion,       ///< likewise [J/m^2]
    FrictionCoefficient,  ///< likewise
    Channel,              ///< another image of the file, in the file's unit
    ForceMap,             ///< a quantity of a force map, in its region
};

struct SurfaceQuantityRow {
    SurfaceQuantity value;
    const char* key;
    const char* name;
    const char* unit;  ///< SI; "1": a number; empty: the data say
    bool isLive;       ///< it changes with the tip, and is defined around it alone
    bool isSigned;     ///< values on both sides of zero mean different things
};

template <>
inline constexpr auto kEnumTable<SurfaceQuantity> = std::to_array<SurfaceQuantityRow>({
    {SurfaceQuantity::Height, "height", "height", "m", false, false},
    {SurfaceQuantity::Slope, "slope", "slope", "rad", false, false},
    {SurfaceQuantity::Gap, "gap", "gap to the tip", "m", true, false},
    {SurfaceQuantity::Pressure, "pressure", "contact pressure", "Pa", true, true},
    {SurfaceQuantity::Displacement, "displacement", "displacement", "m", true, true},
    {SurfaceQuantity::Residual, "residual", "residual", "m", false, true},
    {SurfaceQuantity::Certainty, "certainty", "certainty", "1", false, false},
    {SurfaceQuantity::YoungsModulus, "youngs_modulus", "Young's modulus", "Pa", false, false},
    {SurfaceQuantity::WorkOfAdhesion, "work_of_adhesion", "work of adhesion", "J/m^2", false,
     false},
    {SurfaceQuantity::FrictionCoefficient, "friction_coefficient", "friction coefficient", "1",
     false, false},
    {SurfaceQuantity::Channel, "channel", "channel", "", false, false},
    {SurfaceQuantity::ForceMap, "force_map", "force map", "", false, false},
});

}  // namespace asperity
