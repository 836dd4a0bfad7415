#pragma once

#include "core/surface/HeightRows.h"

#include <filesystem>

namespace asperity {

/// Writes the triangles of a height map [m] as binary STL, a few rows of pixels at a time: VTK
/// wants the mesh that it writes in memory, and the mesh of a large scan is 20 times the scan.
/// @param target the caller puts it in place afterwards
/// @throw Error when no triangle is left, or the file cannot be written; Canceled
void writeStl(const std::filesystem::path& target, const HeightRows& map, Progress* progress);

}  // namespace asperity
