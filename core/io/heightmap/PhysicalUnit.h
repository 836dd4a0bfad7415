#pragma once

#include <string>
#include <string_view>

namespace asperity {

/// A unit as a multiple of an SI base unit: "nm" is 1e-9 "m", "nm/V" is 1e-9 "m/V".
struct PhysicalUnit {
    double factor = 1.0;
    std::string base;  ///< empty: no unit
};

/// Reads a unit with an SI prefix. Micro may be written u, µ (both code points) or Bruker's ~;
/// ångström as Å, "Ang" or "Angstrom"; degrees as °, º or "deg"; names may be in full ("Volts",
/// "nanometer"). A unit that is not known is kept as it is written, with the factor 1.
/// @param text UTF-8
[[nodiscard]] PhysicalUnit parseUnit(std::string_view text);

/// Reads the unit of what is a length, where "A" is the ångström and no ampere; others as
/// parseUnit().
[[nodiscard]] PhysicalUnit parseLengthUnit(std::string_view text);

}  // namespace asperity
