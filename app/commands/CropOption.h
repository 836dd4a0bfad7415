#pragma once

#include "core/surface/PixelRectangle.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace asperity {

/// "20,30,100,80" as column, row, columns and rows; empty where it is anything else.
[[nodiscard]] std::optional<PixelRectangle> parseCrop(const std::string& text);

/// The option --crop of a command that loads a height map. @param crop outlives the parse
void addCropOption(CLI::App& command, std::optional<PixelRectangle>& crop);

}  // namespace asperity
