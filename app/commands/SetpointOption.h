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

/// Returns a number with a unit of this base, "5nm" or "5 nm", or a bare number in the base unit,
/// in SI; empty where the text is neither.
inline std::optional<double> parseQuantity(const std::string& text, const std::string& base) {
    const std::optional<LeadingNumber> number = parseLeadingNumber(text);
    if (!number || number->rest.empty()) {
        return number ? std::optional(number->value) : std::nullopt;
    }
    const PhysicalUnit unit = parseUnit(number->rest);
    if (unit.base != base) {
        return std::nullopt;
    }
    // A power of ten below 1 is no exact double, its inverse is: 12nN is the very number 12e-9.
    return unit.factor < 1.0 ? number->value / std::round(1.0 / unit.factor)
                             : number->value * unit.factor;
}

/// A force that a scene may have, with its unit or in newtons; empty where the text is none.
inline std::optional<double> parseSetpoint(const std::string& text) {
    const std::optional<double> force = parseQuantity(text, "N");
    return force && isSetpoint(*force) ? force : std::nullopt;
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
