#pragma once

#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/SiFormat.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/scene/SceneDescription.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>

namespace asperity {

/// CLI11's own range check lets NaN through.
inline CLI::Validator finiteNumber() {
    return {[](const std::string& text) {
                const bool finite = std::isfinite(std::strtod(text.c_str(), nullptr));
                return finite ? std::string() : "expected a finite number, not " + text;
            },
            ""};
}

/// CLI11's own one names the largest number that there is.
inline CLI::Validator positiveNumber() {
    return {[](const std::string& text) {
                const double number = std::strtod(text.c_str(), nullptr);
                return std::isfinite(number) && number > 0.0
                           ? std::string()
                           : "expected a number above 0, not " + text;
            },
            ""};
}

/// A path must have a name.
inline CLI::Validator notEmpty() {
    return {[](const std::string& text) {
                return text.empty() ? std::string("expected a path") : std::string();
            },
            ""};
}

/// Accepts what a function throws no Error for.
template <class Parse>
CLI::Validator acceptedBy(Parse parse) {
    return {[parse](const std::string& text) {
                try {
                    (void)parse(text);
                } catch (const Error& error) {
                    return std::string(error.what());
                }
                return std::string();
            },
            ""};
}

/// The option every command has that leaves files.
inline void addOutputFolder(CLI::App& command, std::string& folder, const std::string& what) {
    command.add_option("--out", folder, what)->required()->check(notEmpty());
}

/// The option of every command that writes where a recording or another run may be.
inline void addForce(CLI::App& command, bool& force) {
    command.add_flag("--force", force,
                     "replace a recording, another run or files of the same names in that folder");
}

/// The option of a command that leaves a run.
/// @param format a RunFormat, or an optional one
template <class Format>
CLI::Option* addFormatOption(CLI::App& command, Format& format, const std::string& what) {
    return command
        .add_option_function<std::string>(
            "--format", [&format](const std::string& word) { format = *fromKey<RunFormat>(word); },
            what + ": csv (text), or h5 (HDF5, about a tenth of the size)")
        ->check(CLI::IsMember({keyOf(RunFormat::Csv), keyOf(RunFormat::Hdf5)}));
}

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
