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

/// Writes a height map in the format of the path's extension. The file appears whole or not at all.
/// @throw Error writeRefusal(), or when writing fails; Canceled
void writeHeightMap(const std::filesystem::path& path, const HeightRows& map,
                    const HeightMapMeta& meta, Progress* progress = nullptr,
                    HeightMapFormats formats = kHeightMapFormats);
/// @throw Error when the map is not usable, too
void writeHeightMap(const std::filesystem::path& path, const HeightMap& map,
                    const HeightMapMeta& meta);

}  // namespace asperity
