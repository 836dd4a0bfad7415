#pragma once

#include "core/io/heightmap/HeightMapFormat.h"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

/// Extensions of the formats that are written, in lower case with their dot.
[[nodiscard]] std::vector<std::string>
heightMapExtensions(HeightMapFormats formats = kHeightMapFormats);

/// Why no height map can be written to this file: no format has the path's extension (in any
/// case). Empty: it can.
[[nodiscard]] std::string writeRefusal(const std::filesystem::path& path,
                                       HeightMapFormats formats = kHeightMapFormats);

/// As writeRefusal(), of several images: "--all" of a command.
[[nodiscard]] std::string writeAllRefusal(const std::filesystem::path& path);

/// Writes a height map in the format of the path's extension. The file appears whole or not at all.
/// @throw Error writeRefusal(), or when writing fails; Canceled
void writeHeightMap(const std::filesystem::path& path, const HeightRows& map,
                    const HeightMapMeta& meta, Progress* progress = nullptr,
                    HeightMapFormats formats = kHeightMapFormats);
/// As writeHeightMap() of rows, of several images.
/// @throw Error when no format with the path's extension holds several images, too
void writeHeightMaps(const std::filesystem::path& path, std::span<const WrittenImage> images,
                     Progress* progress = nullptr);
/// @throw Error when the map is not usable, too
void writeHeightMap(const std::filesystem::path& path, const HeightMap& map,
                    const HeightMapMeta& meta);

}  // namespace asperity
