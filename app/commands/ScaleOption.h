#pragma once

#include "core/surface/GivenScale.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace asperity {

/// A length with its unit, "5um" or "5 nm", or a bare number of meters; empty where it is none, or
/// not above 0 [m].
[[nodiscard]] std::optional<double> parseLength(const std::string& text);

/// Sides of a scan: "5um" of a square, "5umx2um", or "5x2um" with one unit for both; empty where
/// they are none. Heights stay unknown.
[[nodiscard]] std::optional<GivenScale> parseScanSize(const std::string& text);

/// The options --size, --z-unit and --z-scale of a command that reads a height map.
/// @param scale outlives the parse
void addScaleOptions(CLI::App& command, GivenScale& scale);

}  // namespace asperity
