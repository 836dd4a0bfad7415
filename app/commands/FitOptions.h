#pragma once

#include "app/commands/CurveFileOptions.h"
#include "core/identify/cycle/CycleIdentification.h"

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
    CurveFileOptions read;
    bool all = false;            ///< curves of each file, not one
    std::string probe;           ///< file of a probe, for Sader's method; empty: none
    std::string spectrum;        ///< file of a thermal spectrum; empty: none
    double temperature = 295.0;  ///< of the lever [K]
    std::string area;            ///< file of the tip's area function; empty: none
    CycleFitOptions fit;
};

/// A tip, or the file of its area function.
struct NamedTip {
    TipForm form;
    std::string area;  ///< empty: the form says all
};

/// "sphere:18.64um", "conesphere:10nm,20deg", "cone:20deg", "area:FILE": a tip with its lengths in
/// meters and angles in radians, or with units. @throw Error that says what was expected
[[nodiscard]] NamedTip parseTip(const std::string& text);

/// Adds the options that fill in a request.
void addFitOptions(CLI::App& command, FitRequest& request);

}  // namespace asperity
