#pragma once

#include "core/Error.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>
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

/// What a function throws no Error for.
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

}  // namespace asperity
