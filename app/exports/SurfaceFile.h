#pragma once

#include "app/exports/ExportView.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/surface/deformation/SurfaceDeformation.h"

#include <filesystem>

namespace asperity {

/// All formats that a surface is written in: height maps, and shapes for other programs.
[[nodiscard]] HeightMapFormats surfaceFormats();

/// Their extensions, each format's first: ".gwy", ...
[[nodiscard]] std::vector<std::string> surfaceExtensions();

/// Writes a deformed patch as a field, whole or not at all.
/// @param format Exr, Vtp, Vts or Csv
/// @throw Error when the file cannot be written
void writeField(const std::filesystem::path& path, const SurfacePatch& patch, ExportFormat format);

}  // namespace asperity
