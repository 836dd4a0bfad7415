#pragma once

#include "core/io/ByteReader.h"
#include "core/io/heightmap/Gwyddion.h"
#include "core/io/heightmap/HeaderFields.h"
#include "core/io/heightmap/HeightMapFile.h"
#include "core/surface/GivenScale.h"
#include "core/surface/HeightMap.h"

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// Memory for reading one row after another; each thread has its own. It keeps decoded samples
/// alive until the last room is deleted.
struct RowRoom {
    std::vector<char> bytes;  ///< of a row as it is stored, used again for the next one
    /// Decoded samples, by who decoded them.
    std::map<std::shared_ptr<const void>, std::shared_ptr<const ByteSource>> decoded;
};

/// An image that still lies in its source.
struct StoredChannel {
    ScanChannel channel;  ///< but for the heights and the mask of its map
    double factor = 1.0;  ///< value in the channel's unit per stored number
    /// Writes the stored numbers of a row, 0 at the top; what is not finite holds no data. Needs
    /// the source; any threads. @throw InputError when the bytes are not there any more
    std::function<void(int row, RowRoom& room, double* numbers)> readRow;
    int firstColumn = 0;  ///< of the file's image, of which this may be a part
    int firstRow = 0;     ///< the same
};

struct StoredScan {
    std::vector<StoredChannel> channels;
    std::vector<std::string> notes;
    std::vector<Provenance> provenance;  ///< of the whole file
    /// Direction that the vendor's program shows first, among equally good channels; empty: that of
    /// the channel that is stored first.
    std::string usualDirection = {};
    /// Channel that the file marks as its main one, among those that may be a topography; empty: it
    /// marks none.
    std::string markedChannel = {};
    /// Texts that all channels share, each of which has its own in its metadata; where both have
    /// one of the same name, its own counts.
    BoundedTexts texts = {};
    bool hasCutTexts = false;  ///< some of a channel's own texts were left out
};

/// Information in a written file about a height map, besides its heights.
struct HeightMapMeta {
    std::string title = "Height";  ///< UTF-8
    double originX = 0.0;          ///< lower left corner in the instrument's frame [m]
    double originY = 0.0;          ///< [m]
    std::string unit = "m";        ///< of the values; empty: they are numbers, no heights
    /// Further information by its name; UTF-8.
    std::map<std::string, std::string> metadata = {};
};

/// One of the images that a file gets together.
struct WrittenImage {
    HeightRows rows;  ///< values in the unit of `meta`; a pitch of 0: the size is not known
    HeightMapMeta meta;
    std::string lateralUnit = "m";  ///< of the size; empty: a number
};

/// A file type: who reads it, who writes it. A further format is a folder of its own that defines
/// such a constant, and its lines at the end of this table.
struct HeightMapFormat {
    std::string_view name;  ///< for people
    /// Extensions that its files usually have, in lower case with their dot; `*` matches any
    /// text. Writing uses them, reading does not.
    std::span<const std::string_view> extensions;
    /// Returns whether the content is of this type, damaged or not, by a look at few bytes; null:
    /// it is not read.
    bool (*recognizes)(const ByteSource& bytes);
    /// Checks the whole content, but leaves the values where they are; texts are read whole.
    /// @param bytes must outlive the result
    /// @throw InputError when anything is missing or does not fit together
    StoredScan (*read)(const ByteSource& bytes);
    /// Writes a usable map straight to `target`, which the caller puts in place afterwards; null:
    /// it is not written. Heights are NaN where there are no data. @throw Error; Canceled
    void (*write)(const std::filesystem::path& target, const HeightRows& map,
                  const HeightMapMeta& meta, Progress* progress);
    /// The same as `write`, of several images in the order given; null: its files hold one each.
    void (*writeAll)(const std::filesystem::path& target, std::span<const WrittenImage> images,
                     Progress* progress) = nullptr;
    /// Its files are recognized only to be refused in words: they hold nothing that can be read.
    bool isRefused = false;
    bool isShape = false;  ///< values are written as coordinates: it holds heights and nothing else
};

// Written, pixels without data are NaN where nothing else is said.
extern const HeightMapFormat kGwyFormat;  ///< doubles; pixels without data are in a mask
extern const HeightMapFormat kNanoscopeFormat;
extern const HeightMapFormat kGsfFormat;  ///< float32
extern const HeightMapFormat kParkFormat;
extern const HeightMapFormat kJpkFormat;
extern const HeightMapFormat kJpkArchiveFormat;
extern const HeightMapFormat kX3pFormat;
extern const HeightMapFormat kNanonisFormat;
extern const HeightMapFormat kNanosurfFormat;
extern const HeightMapFormat kWsxmFormat;
extern const HeightMapFormat kPicoviewFormat;
extern const HeightMapFormat kDigitalSurfFormat;
extern const HeightMapFormat kSdfFormat;
extern const HeightMapFormat kBcrFormat;
extern const HeightMapFormat kIgorFormat;
/// Format of force curves, which no reader of images accepts.
extern const HeightMapFormat kForceCurveFormat;
extern const HeightMapFormat kExrFormat;   ///< float32
extern const HeightMapFormat kTiffFormat;  ///< float32
/// Written where it is asked for, in place of kTiffFormat, which reads it: counts as those of
/// kPngFormat. It is no row of the table.
extern const HeightMapFormat kTiffCountsFormat;
/// 65536 steps between the lowest and the highest pixel, one fewer where pixels hold no data: those
/// have the count 0, and texts say so.
extern const HeightMapFormat kPngFormat;
/// Doubles at the pixel centers, bottom row first, called "height" [m], or by the title where they
/// are no heights; pixels without data are 0 in an array "valid" as well.
extern const HeightMapFormat kVtiFormat;
extern const HeightMapFormat kNanoscopeTextFormat;
extern const HeightMapFormat kNexusFormat;
extern const HeightMapFormat kXyzFormat;
extern const HeightMapFormat kTextFormat;  ///< doubles

/// The most specific beginnings first. Images of instruments that are TIFFs or zips come before
/// those of any kind, force curves before pictures and texts.
inline constexpr std::array kHeightMapFormats{
    &kGwyFormat,      &kNanoscopeFormat,     &kGsfFormat,      &kParkFormat,
    &kJpkFormat,      &kNanonisFormat,       &kNanosurfFormat, &kWsxmFormat,
    &kPicoviewFormat, &kDigitalSurfFormat,   &kSdfFormat,      &kBcrFormat,
    &kIgorFormat,     &kJpkArchiveFormat,    &kX3pFormat,      &kForceCurveFormat,
    &kExrFormat,      &kTiffFormat,          &kPngFormat,      &kVtiFormat,
    &kNexusFormat,    &kNanoscopeTextFormat, &kXyzFormat,      &kTextFormat};

using HeightMapFormats = std::span<const HeightMapFormat* const>;

/// Content of a file without the heights.
struct HeightMapContents {
    HeightMapFile file;
    /// One for each channel of the file, without its notes and metadata.
    std::vector<StoredChannel> stored;
};

/// @param bytes must outlive the result
/// @param gwyddion is asked about a content that no format here recognizes
/// @param given in place of what the file says or does not say
/// @throw InputError when its type is unknown, or anything is missing or does not fit together
[[nodiscard]] HeightMapContents contentsOf(const ByteSource& bytes, const Gwyddion& gwyddion,
                                           const GivenScale& given = {});

/// readHeightMapFile for a content that is in memory already.
/// @param file for messages
/// @param gwyddion as that of contentsOf(); none unless it is given
/// @throw InputError as readHeightMapFile
[[nodiscard]] HeightMapFile readHeightMapBytes(std::string_view bytes, const std::string& file,
                                               const Gwyddion& gwyddion = {});

}  // namespace asperity
