#pragma once

#include "core/SiFormat.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/scene/SceneDescription.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <optional>
#include <string>

namespace asperity {

/// A force with its unit, "5nN" or "5 nN", or a bare number of newtons; empty where it is none, or
/// none that a scene may have.
inline std::optional<double> parseSetpoint(const std::string& text) {
    const std::optional<LeadingNumber> number = parseLeadingNumber(text);
    const PhysicalUnit unit = number ? parseUnit(number->rest) : PhysicalUnit{};
    if (!number || !(unit.base == "N" || number->rest.empty())) {
        return std::nullopt;
    }
    // A power of ten below 1 is no exact double, its inverse is: 12nN is the very number 12e-9.
    const double force = unit.factor < 1.0 ? number->value / std::round(1.0 / unit.factor)
                                           : number->value * unit.factor;
    return isSetpoint(force) ? std::optional(force) : std::nullopt;
}

/// The option of a command that approaches.
inline void addSetpointOption(CLI::App& command, std::optional<double>& setpoint) {
    command
        .add_option_function<std::string>(
            "--setpoint", [&setpoint](const std::string& text) { setpoint = parseSetpoint(text); },
            "force that ends the approach, such as 5nN; default: as in the scene")
        ->check(CLI::Validator(
            [](const std::string& text) {
                return parseSetpoint(text)
                           ? std::string()
                           : "expected a force from " + formatSi(kMinSetpoint, "N") + " to " +
                                 formatSi(kMaxSetpoint, "N") + ", such as 5nN, not '" + text + "'";
            },
            "FORCE"));
}

}  // namespace asperity
