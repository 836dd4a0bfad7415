#pragma once

#include "core/surface/HeightRows.h"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

/// What a written file says about a height map besides its heights.
struct HeightMapMeta {
    std::string title = "Height";  ///< UTF-8
    double originX = 0.0;          ///< offset of the scan in the instrument's frame [m]
    double originY = 0.0;          ///< [m]
};

/// Extensions that writeHeightMap knows, in lower case with their dot.
[[nodiscard]] const std::vector<std::string>& heightMapExtensions();

/// Whether writeHeightMap knows the path's extension (upper or lower case).
[[nodiscard]] bool canWriteHeightMap(const std::filesystem::path& path);

/// Writes a height map in the format of the path's extension. The file appears whole or not at all.
///
/// .gwy keeps doubles; .txt too; .gsf, .exr and .tiff round to float32; .png to 65536 steps between
/// the lowest and the highest pixel. Pixels without data are marked by a mask in .gwy, are NaN in
/// .txt, .gsf, .exr and .tiff, and take the lowest height in .png, whose comment says how many.
/// Takes little memory beside the map.
/// @throw Error when the extension is not known or writing fails; Canceled
void writeHeightMap(const std::filesystem::path& path, const HeightRows& map,
                    const HeightMapMeta& meta, Progress* progress = nullptr);
/// @throw Error when the map is not usable, too
void writeHeightMap(const std::filesystem::path& path, const HeightMap& map,
                    const HeightMapMeta& meta);

}  // namespace asperity
