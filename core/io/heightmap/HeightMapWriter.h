#pragma once

#include "core/io/heightmap/HeightMapFormat.h"
#include "core/surface/HeightMap.h"

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// Extensions of the formats that are written, in lower case with their dot.
[[nodiscard]] std::vector<std::string>
heightMapExtensions(HeightMapFormats formats = kHeightMapFormats);

/// Returns why no height map can be written to this file: no format has the path's extension (in
/// any case). Empty: it can.
[[nodiscard]] std::string writeRefusal(const std::filesystem::path& path,
                                       HeightMapFormats formats = kHeightMapFormats);

/// The same as writeRefusal(), of several images: "--all" of a command.
[[nodiscard]] std::string writeAllRefusal(const std::filesystem::path& path);

/// Writes a height map in the format of the path's extension. The file appears whole or not at all.
/// @throw Error writeRefusal(), or when writing fails; Canceled
void writeHeightMap(const std::filesystem::path& path, const HeightRows& map,
                    const HeightMapMeta& meta, Progress* progress = nullptr,
                    HeightMapFormats formats = kHeightMapFormats);
/// The same as writeHeightMap() of rows, of several images.
/// @throw Error when no format with the path's extension holds several images, too
void writeHeightMaps(const std::filesystem::path& path, std::span<const WrittenImage> images,
                     Progress* progress = nullptr);
/// @throw Error when the map is not usable, too
void writeHeightMap(const std::filesystem::path& path, const HeightMap& map,
                    const HeightMapMeta& meta);

// Functions that the writers of single formats share.

/// The error of an encoder that could not write its file to the end.
inline constexpr const char* kStoppedHalfWay = "writing stopped half-way (disk full?)";

/// Closes a stream. @throw Error when not all could be written
void finish(std::ofstream& stream);

/// Range of the heights in a map.
struct HeightRange {
    double lowest = 0.0;      ///< of the pixels that hold data; 0 when none does [m]
    double highest = 0.0;     ///< as lowest [m]
    std::size_t missing = 0;  ///< pixels without data
};
/// @throw Canceled
[[nodiscard]] HeightRange heightRange(const HeightRows& map, Progress* progress);

/// A text as one line that a terminal does not obey: line ends, tabs and NUL are blanks, the rest
/// is printable().
[[nodiscard]] std::string oneLine(std::string text);

/// All metadata of a file together has at most this many bytes.
inline constexpr std::size_t kMaxMetadata = 500000;

/// Entries of the metadata that a format can hold: names and values of 1 to 60000 bytes, on one
/// line each, as many as fit, but for the names of Gwyddion's and our own keys.
/// @param most bytes of names and values
[[nodiscard]] std::map<std::string, std::string> writtenMetadata(const HeightMapMeta& meta,
                                                                 std::size_t most = kMaxMetadata);

/// The same as lines "name" `between` "value", but for names that hold `between` or are reserved.
[[nodiscard]] std::string metadataLines(const HeightMapMeta& meta, std::string_view between,
                                        std::span<const std::string_view> reserved,
                                        std::size_t most = kMaxMetadata);

}  // namespace asperity
