#pragma once

#include "core/surface/GivenScale.h"
#include "core/surface/HeightMap.h"

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

/// "20,30,100,80" as column, row, columns and rows; empty where it is anything else.
[[nodiscard]] std::optional<PixelRectangle> parseCrop(const std::string& text);

/// The option --crop of a command that loads a height map. @param crop outlives the parse
void addCropOption(CLI::App& command, std::optional<PixelRectangle>& crop);

}  // namespace asperity
