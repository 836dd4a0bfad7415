#pragma once

#include "core/io/HeightMapWriter.h"

#include <filesystem>
#include <string>

namespace asperity {

/// The writers of single formats. Each takes a usable map (requireUsable) whose heights
/// are finite where it is valid, and writes straight to
/// `target`, which the caller puts in place afterwards. A further format is one source file, its
/// line here and its line in the table of HeightMapWriter.cpp. @throw Error

void writeGsf(const std::filesystem::path& target, const HeightMap& map, const HeightMapMeta& meta);
void writeGwy(const std::filesystem::path& target, const HeightMap& map, const HeightMapMeta& meta);
void writeText(const std::filesystem::path& target, const HeightMap& map,
               const HeightMapMeta& meta);
void writeExr(const std::filesystem::path& target, const HeightMap& map, const HeightMapMeta& meta);
void writeTiff(const std::filesystem::path& target, const HeightMap& map,
               const HeightMapMeta& meta);
void writePng(const std::filesystem::path& target, const HeightMap& map, const HeightMapMeta& meta);

/// Writes bytes to a file. @throw Error when not all could be written
void writeBytes(const std::filesystem::path& target, const std::string& bytes);

/// Lowest and highest of the pixels that hold data; both 0 when none does.
struct HeightRange {
    double lowest = 0.0;   ///< [m]
    double highest = 0.0;  ///< [m]
};
[[nodiscard]] HeightRange heightRange(const HeightMap& map);

/// The height of each pixel as float32, NaN where there are no data.
[[nodiscard]] std::vector<float> floatHeights(const HeightMap& map);

}  // namespace asperity
