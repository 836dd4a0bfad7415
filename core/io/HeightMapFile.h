#pragma once

#include "core/surface/HeightMap.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace asperity {

/// One image of a scan file, in SI base units, whatever it shows.
struct ScanChannel {
    std::string name;
    std::string unit;       ///< SI base unit of the values ("m", "V", "deg"); empty: none given
    std::string direction;  ///< "forward", "backward", or empty when the file does not say
    HeightMap map;          ///< values in `unit` (metres only when unit is "m")
    double originX = 0.0;   ///< offset of the scan in the instrument's frame [m]
    double originY = 0.0;   ///< [m]
    std::map<std::string, std::string> metadata;

    [[nodiscard]] bool isHeight() const { return unit == "m"; }
};

/// All images of one file.
struct HeightMapFile {
    std::string format;  ///< for people: "Bruker NanoScope", "Gwyddion .gwy"
    std::vector<ScanChannel> channels;
    std::size_t defaultChannel = 0;  ///< the one that a lab user expects
    std::vector<std::string> notes;  ///< what the reader had to decide, one sentence each
};

/// Reads any supported file; the type is found by content, never by extension.
/// @throw InputError when the file cannot be read whole, or its type is unknown
[[nodiscard]] HeightMapFile readHeightMapFile(const std::filesystem::path& path);

/// The named channel (empty: the default one) as a height map.
/// @throw InputError when there is no such channel or its unit is not a length
[[nodiscard]] const ScanChannel& heightChannel(const HeightMapFile& file,
                                               const std::filesystem::path& path,
                                               const std::string& name);

}  // namespace asperity
