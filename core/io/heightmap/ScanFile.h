#pragma once

#include "core/Progress.h"
#include "core/io/FileBytes.h"
#include "core/io/heightmap/Gwyddion.h"
#include "core/io/heightmap/HeightMapFile.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/surface/HeightMap.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace asperity {

/// One height channel of a file for a scene.
template <class Map>
struct BasicHeightScan {
    std::string format;   ///< for people
    std::string channel;  ///< its name
    Map map;
    double originX = 0.0;            ///< lower left corner in the instrument's frame [m]
    double originY = 0.0;            ///< [m]
    std::vector<std::string> notes;  ///< on the file and this channel
    std::vector<Provenance> provenance;
};
using HeightScan = BasicHeightScan<ScanMap>;
/// In double precision, so that the curvature of fine pixels is no rounding error; a large one in
/// single precision, so that it fits into memory.
using SceneScan = BasicHeightScan<std::variant<HeightMap, ScanMap>>;

/// Scans of more pixels than this are large.
inline constexpr std::size_t kLargeScan = std::size_t{1} << 22U;

/// One height channel of a file, as exactly as the file gives it.
struct HeightChannel {
    ScanChannel channel;
    std::vector<std::string> notes;  ///< on the file and this channel
};

/// A height-map file that stays open: what it holds is known, and its heights are read when they
/// are asked for, a few rows at a time, all from the same content. A file that becomes shorter or
/// is written to while this lives is refused; one that is put in its place changes nothing.
class ScanFile {
public:
    /// @param given in place of what the file says or does not say
    /// @param gwyddion reads what no format here recognizes
    /// @throw InputError as readHeightMapFile()
    explicit ScanFile(const std::filesystem::path& path, const GivenScale& given = {},
                      const Gwyddion& gwyddion = installedGwyddion());

    /// All channels, without heights.
    [[nodiscard]] const HeightMapFile& contents() const { return contents_.file; }
    /// The named channel alone (empty: the default one), in single precision.
    /// @throw InputError as readHeightMapFile() and heightChannel(); Canceled
    [[nodiscard]] HeightScan readHeightScan(const std::string& name,
                                            Progress* progress = nullptr) const;
    /// The same as readHeightScan(), in the precision that a scene of it is built in.
    [[nodiscard]] SceneScan readSceneScan(const std::string& name,
                                          Progress* progress = nullptr) const;
    /// The same of a part of the channel, or of all of it. The origin is that of the part.
    /// @throw InputError when the part is not wholly in the image, too
    [[nodiscard]] SceneScan readSceneScan(const std::string& name,
                                          const std::optional<PixelRectangle>& part,
                                          Progress* progress = nullptr) const;
    /// The same as readHeightScan(), in double precision.
    [[nodiscard]] HeightChannel readHeightChannel(const std::string& name,
                                                  Progress* progress = nullptr) const;
    /// Calls visit(row, values) with each row of a channel of contents(), from the top, in the
    /// channel's unit; what is not finite holds no data.
    /// @throw InputError as readHeightMapFile()
    void
    forEachRow(const ScanChannel& channel,
               const std::function<void(int row, std::span<const double> values)>& visit) const;
    /// The rows of a channel of contents(), in its unit, each read when it is asked for, from one
    /// thread; its pitch is 0 where the size is not known. Needs this.
    /// @throw InputError as readHeightMapFile()
    [[nodiscard]] HeightRows rowsOf(const ScanChannel& channel) const;
    /// Returns the hash of the content that the heights come from, 64 hexadecimal digits.
    /// @throw InputError as readHeightMapFile(); Canceled
    [[nodiscard]] std::string sha256(Progress* progress = nullptr) const;

private:
    template <class Map, class Read>
    [[nodiscard]] BasicHeightScan<Map> readScan(const std::string& name,
                                                const std::optional<PixelRectangle>& part,
                                                const Read& read) const;
    [[nodiscard]] const StoredChannel& storedOf(const ScanChannel& channel) const;

    BufferedFile bytes_;
    HeightMapContents contents_;
};

/// ScanFile(path).readHeightScan(name, progress)
[[nodiscard]] HeightScan readHeightScan(const std::filesystem::path& path, const std::string& name,
                                        Progress* progress = nullptr);

/// ScanFile(path).readSceneScan(name, progress)
[[nodiscard]] SceneScan readSceneScan(const std::filesystem::path& path, const std::string& name,
                                      Progress* progress = nullptr);

/// ScanFile(path).readHeightChannel(name, progress)
[[nodiscard]] HeightChannel readHeightChannel(const std::filesystem::path& path,
                                              const std::string& name,
                                              Progress* progress = nullptr);

/// Returns why a channel has no such part; empty: it has.
[[nodiscard]] std::string cropRefusal(const ScanChannel& channel, const PixelRectangle& part);

/// A part of an image that still lies in its source: as if the file held no more than that.
/// @param stored outlives the result
/// @param file   for messages
/// @throw InputError when the part is not wholly in the image
[[nodiscard]] StoredChannel croppedChannel(const StoredChannel& stored, const PixelRectangle& part,
                                           const std::string& file);

/// Returns whether the channel shows the height of the sample: a length, and not a deflection, an
/// amplitude or a phase, which some instruments store as lengths too.
[[nodiscard]] bool isTopography(const ScanChannel& channel);

/// Returns whether it may show that: its values are numbers without unit, and its name does not say
/// that they are something else.
[[nodiscard]] bool mayBeTopography(const ScanChannel& channel);

/// Index of the channel that a lab user expects: the height sensor, else the piezo height, else the
/// first other length, else, by the same names, one that may be a height, masks last; of equals,
/// the vendor's first. 0 when there is none of them.
/// @param usualDirection of equals, those of this direction first; empty: there is none
[[nodiscard]] std::size_t suggestDefaultChannel(const std::vector<ScanChannel>& channels,
                                                std::string_view usualDirection = {});

}  // namespace asperity
