#pragma once

#include "core/io/heightmap/HeightMapWriter.h"

#include <filesystem>
#include <iosfwd>
#include <string>

namespace asperity {

/// The writers of single formats. Each takes a usable map and writes straight to `target`, which
/// the caller puts in place afterwards. Heights are NaN where there are no data. A further format
/// is one source file, its line here and its line in the table of HeightMapWriter.cpp.
/// @throw Error; Cancelled

void writeGsf(const std::filesystem::path& target, const HeightRows& map, const HeightMapMeta& meta,
              Progress* progress);
void writeGwy(const std::filesystem::path& target, const HeightRows& map, const HeightMapMeta& meta,
              Progress* progress);
void writeText(const std::filesystem::path& target, const HeightRows& map,
               const HeightMapMeta& meta, Progress* progress);
void writeExr(const std::filesystem::path& target, const HeightRows& map, const HeightMapMeta& meta,
              Progress* progress);
void writeTiff(const std::filesystem::path& target, const HeightRows& map,
               const HeightMapMeta& meta, Progress* progress);
void writePng(const std::filesystem::path& target, const HeightRows& map, const HeightMapMeta& meta,
              Progress* progress);

/// Closes a stream. @throw Error when not all could be written
void finish(std::ofstream& stream);

/// What the pixels of a map hold.
struct HeightRange {
    double lowest = 0.0;      ///< of the pixels that hold data; 0 when none does [m]
    double highest = 0.0;     ///< as lowest [m]
    std::size_t missing = 0;  ///< pixels without data
};
/// @throw Cancelled
[[nodiscard]] HeightRange heightRange(const HeightRows& map, Progress* progress);

}  // namespace asperity
