#pragma once

#include "core/Progress.h"
#include "core/io/BufferedFile.h"
#include "core/io/heightmap/Gwyddion.h"
#include "core/io/heightmap/HeightMapFile.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/surface/PixelRectangle.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace asperity {

/// One height channel of a file on its way into a scene.
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
/// is written to meanwhile is refused; one that is put in its place changes nothing.
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
    /// As readHeightScan(), in the precision that a scene of it is built in.
    [[nodiscard]] SceneScan readSceneScan(const std::string& name,
                                          Progress* progress = nullptr) const;
    /// The same of a part of the channel, or of all of it. The origin is that of the part.
    /// @throw InputError when the part is not wholly in the image, too
    [[nodiscard]] SceneScan readSceneScan(const std::string& name,
                                          const std::optional<PixelRectangle>& part,
                                          Progress* progress = nullptr) const;
    /// As readHeightScan(), in double precision.
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
    /// Of the content that the heights come from, 64 hexadecimal digits.
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

}  // namespace asperity
