#pragma once

#include "app/exports/ExportFormat.h"
#include "core/surface/deformation/SurfaceDeformation.h"

#include <filesystem>

namespace asperity {

/// Writes a deformed patch as a field, whole or not at all.
/// @param format Exr, Vtp, Vts or Csv
/// @throw Error when the file cannot be written
void writeField(const std::filesystem::path& path, const SurfacePatch& patch, ExportFormat format);

}  // namespace asperity
