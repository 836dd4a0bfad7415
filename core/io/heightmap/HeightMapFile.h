#pragma once

#include "core/io/heightmap/Gwyddion.h"
#include "core/surface/HeightMap.h"
#include "core/surface/Provenance.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace asperity {

/// One image of a scan file, whatever it shows; lengths are in meters.
struct ScanChannel {
    std::string name;
    std::string unit;         ///< of the values ("m", "V", "mV", "deg"); empty: none given
    std::string lateralUnit;  ///< SI base unit of the size, "m" for a scan; empty: none given
    std::string direction;    ///< "forward", "backward", or empty when the file does not say
    HeightMap map;  ///< values in `unit` (meters only when unit is "m"); pitch 0: not given
    bool isSurface = false;  ///< it shows the heights of the sample, whatever it is called
    bool isMask = false;   ///< the values mark a part of the scan (core/io/heightmap/SampleRows.h)
    double originX = 0.0;  ///< lower left corner of the image in the instrument's frame [m];
                           ///< core/io/heightmap/ScanImage.h
    double originY = 0.0;  ///< [m]
    std::map<std::string, std::string> metadata;
    std::vector<std::string> notes;      ///< decisions of the reader about it, a sentence each
    std::vector<Provenance> provenance;  ///< scale factors, orientation, ...

    [[nodiscard]] bool isHeight() const { return unit == "m"; }
    /// Returns whether the file states the size of the scan in meters.
    [[nodiscard]] bool hasSize() const {
        return lateralUnit == "m" && map.pitchX > 0.0 && map.pitchY > 0.0;
    }
};

/// All images of one file.
struct HeightMapFile {
    std::string format;  ///< for people: "Bruker NanoScope", "Gwyddion .gwy"
    std::vector<ScanChannel> channels;
    std::size_t defaultChannel = 0;  ///< the one that a lab user expects
    std::vector<std::string> notes;  ///< as those of a channel, on the whole file
    std::vector<Provenance> provenance;
};

/// The notes on a channel, each with its name.
[[nodiscard]] std::vector<std::string> ownNotes(const ScanChannel& channel);
/// Returns what a user of the channel should know: the notes on the file, and its own.
[[nodiscard]] std::vector<std::string> notesOn(const HeightMapFile& file,
                                               const ScanChannel& channel);

/// Returns what the channel's numbers depend on: the entries of the file, and its own.
[[nodiscard]] std::vector<Provenance> provenanceOf(const HeightMapFile& file,
                                                   const ScanChannel& channel);

/// A type of files that can be read.
struct ReadableFormat {
    std::string name;                     ///< for people
    std::vector<std::string> extensions;  ///< usual ones: ".gwy"; `*` in them matches any text
};
/// Returns the formats with usual extensions, as in the table of formats.
[[nodiscard]] std::vector<ReadableFormat> readableFormats();
/// All of their extensions, each once.
[[nodiscard]] std::vector<std::string> readableExtensions();

/// Reads any supported file; the type is found by content, never by extension.
/// @param gwyddion reads what no format here recognizes
/// @throw InputError when the file cannot be read whole, changes, is of an unknown type,
///        or holds a value that no instrument measures (a height beyond 1 km)
[[nodiscard]] HeightMapFile readHeightMapFile(const std::filesystem::path& path,
                                              const Gwyddion& gwyddion = installedGwyddion());

/// The channel of this name, whatever it shows; of several, one that is a height.
/// @throw InputError when there is none
[[nodiscard]] const ScanChannel&
channelNamed(const HeightMapFile& file, const std::filesystem::path& path, const std::string& name);

/// Names of the channels that heightChannel() accepts, each once.
[[nodiscard]] std::vector<std::string> heightChannels(const HeightMapFile& file);

/// The named channel (empty: the default one) as a height map.
/// @throw MissingScale when its lateral size is unknown, or its values are numbers without unit;
///        InputError when there is no such channel, when its unit is not a length, or when only a
///        deflection, amplitude or phase image could be the default
[[nodiscard]] const ScanChannel& heightChannel(const HeightMapFile& file,
                                               const std::filesystem::path& path,
                                               const std::string& name);

/// Refuses a map of a file where no pixel holds a height, before anything is computed of it.
/// @throw InputError
void requireHeights(const HeightMap& map, const std::filesystem::path& path);
void requireHeights(const ScanMap& map, const std::filesystem::path& path);

}  // namespace asperity
