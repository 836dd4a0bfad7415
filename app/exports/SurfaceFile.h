#pragma once

#include "core/io/heightmap/HeightMapFormat.h"

namespace asperity {

/// All formats that a surface is written in: height maps, and shapes for other programs.
[[nodiscard]] HeightMapFormats surfaceFormats();

/// Their extensions, each format's first: ".gwy", ...
[[nodiscard]] std::vector<std::string> surfaceExtensions();

}  // namespace asperity
