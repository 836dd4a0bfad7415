#pragma once

#include "core/surface/HeightRows.h"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

/// Extensions that writeHeightMapWithVtk() knows, in lower case with their dot.
[[nodiscard]] std::vector<std::string> vtkExtensions();

/// Whether writeHeightMapWithVtk() knows the path's extension.
[[nodiscard]] bool canWriteHeightMapWithVtk(const std::filesystem::path& path);

/// Writes a height map for other programs, by the path's extension (in any case):
/// - `.vti`: image of point values "height" [m] at the pixel centers, bottom row first; pixels that
///   hold no data are 0 in the array "valid", which is there when any is
/// - `.vtp`: triangles through the pixel centers with "height" [m]; none touches an invalid pixel
/// - `.stl`: the same triangles, binary. STL knows no unit: coordinates are METERS, as in the other
///   files, and the file's header says so
/// Coordinates are those of the world frame.
/// @return false, and nothing is written, for any other extension
/// `.vti` and `.vtp` need VTK's whole data set in memory, `.stl` a few rows.
/// @throw Error when no triangle is left, or the file cannot be written; Canceled
bool writeHeightMapWithVtk(const std::filesystem::path& path, const HeightRows& map,
                           Progress* progress = nullptr);
/// @throw Error when the map is unusable, too
bool writeHeightMapWithVtk(const std::filesystem::path& path, const HeightMap& map);

}  // namespace asperity
