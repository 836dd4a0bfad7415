#pragma once

#include "app/commands/OptionChecks.h"
#include "core/io/curves/StoredCurves.h"

#include <CLI/CLI.hpp>
#include <cstddef>
#include <optional>
#include <string>

namespace asperity {

/// Options of a command that reads force curves.
struct CurveFileOptions {
    CurveReadOptions read;
    std::optional<std::size_t> index;  ///< of the one curve that is meant; empty: not given
};

/// Adds `--index`, `--height`, `--columns` and `--skip`.
/// @param options must live as long as the command
inline void addCurveFileOptions(CLI::App& command, CurveFileOptions& options) {
    constexpr int kMaxSkipped = 1'000'000;
    command.add_option("--index", options.index,
                       "index of the curve in a file of many, the first is 0");
    command.add_option("--height", options.read.height,
                       "channel of the height that the base of the curve is taken from");
    command
        .add_option_function<std::string>(
            "--columns",
            [&options](const std::string& text) { options.read.columns = givenColumns(text); },
            "columns of a text table of a curve: base=1:um,deflection=2:nm,time=3:ms; also "
            "separation, indentation, force, signal, segment, and retract-force=4:nN")
        ->check(acceptedBy([](const std::string& text) { return givenColumns(text); }));
    command
        .add_option("--skip", options.read.skippedLines,
                    "lines to skip at the start of a text table of a curve")
        ->check(CLI::Range(0, kMaxSkipped));
}

/// Returns whether a user says how to read a text table, which then is one of a curve.
inline bool nameTable(const CurveFileOptions& options) {
    return !options.read.columns.empty() || options.read.skippedLines > 0;
}

}  // namespace asperity
