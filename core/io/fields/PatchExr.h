#pragma once

#include "core/surface/deformation/SurfaceDeformation.h"

#include <filesystem>

namespace asperity {

/// Writes a deformed patch as OpenEXR, all channels FLOAT, top row first: `height` (of the deformed
/// surface), `rest.height`, `displacement.x|y|z`, `normal.x|y|z` (of the deformed surface).
/// Attributes give the position and size in meters: originX, originY (lower-left sample), sizeX,
/// sizeY (first to last sample). @throw Error when the file cannot be written
void writePatchExr(const std::filesystem::path& path, const SurfacePatch& patch);

}  // namespace asperity
