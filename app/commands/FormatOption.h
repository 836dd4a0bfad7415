#pragma once

#include "app/runs/RunFormat.h"

#include <CLI/CLI.hpp>
#include <string>

namespace asperity {

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

}  // namespace asperity
