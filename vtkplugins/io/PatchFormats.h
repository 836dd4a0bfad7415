#pragma once

#include "core/surface/deformation/SurfaceDeformation.h"

#include <filesystem>

namespace asperity {

// A deformed patch for other programs: points of the deformed surface in the world frame [m], with
// "rest" (the same points of the undeformed surface), "displacement" and "normal" as doubles.

/// As triangles, .vtp. Whole or not at all. @throw Error
void writePatchVtp(const std::filesystem::path& path, const SurfacePatch& patch);
/// As a grid, bottom row first, .vts. Whole or not at all. @throw Error
void writePatchVts(const std::filesystem::path& path, const SurfacePatch& patch);

}  // namespace asperity
