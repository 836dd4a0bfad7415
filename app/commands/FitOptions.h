#pragma once

#include "core/identify/CurveIdentification.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// What `asperity fit` is asked for.
struct FitRequest {
    std::vector<std::string> curves;
    std::string out;
    bool force = false;
    std::string probe;  ///< file of a probe, for Sader's method; empty: none
    CurveFitOptions fit;
};

/// "sphere:18.64um", "conesphere:10nm,20deg", "cone:20deg": a tip with its lengths in meters and
/// angles in radians, or with units. @throw Error that says what was expected
[[nodiscard]] TipForm parseTip(const std::string& text);

/// Adds the options that fill in a request.
void addFitOptions(CLI::App& command, FitRequest& request);

}  // namespace asperity
