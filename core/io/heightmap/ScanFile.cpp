#include "core/io/heightmap/ScanFile.h"

#include "core/io/FileHash.h"
#include "core/io/heightmap/ChannelRows.h"
#include "core/io/heightmap/CroppedChannel.h"
#include "core/io/heightmap/StoredRows.h"

#include <memory>

namespace asperity {

ScanFile::ScanFile(const std::filesystem::path& path, const GivenScale& given,
                   const Gwyddion& gwyddion)
    : bytes_(path), contents_(contentsOf(bytes_, gwyddion, given)) {}

/// @param read (StoredChannel) -> Map
template <class Map, class Read>
BasicHeightScan<Map> ScanFile::readScan(const std::string& name,
                                        const std::optional<PixelRectangle>& part,
                                        const Read& read) const {
    const ScanChannel& channel = heightChannel(contents(), bytes_.name(), name);
    const StoredChannel& whole = storedOf(channel);
    std::optional<StoredChannel> cropped;
    if (part) {
        cropped = croppedChannel(whole, *part, bytes_.name());
    }
    const StoredChannel& stored = cropped ? *cropped : whole;
    return {.format = contents().format,
            .channel = channel.name,
            .map = read(stored),
            .originX = stored.channel.originX,
            .originY = stored.channel.originY,
            .notes = notesOn(contents(), channel),
            .provenance = provenanceOf(contents(), channel)};
}

HeightScan ScanFile::readHeightScan(const std::string& name, Progress* progress) const {
    return readScan<ScanMap>(name, std::nullopt, [&](const StoredChannel& stored) {
        return readScanMap(stored, bytes_, progress);
    });
}

SceneScan ScanFile::readSceneScan(const std::string& name, Progress* progress) const {
    return readSceneScan(name, std::nullopt, progress);
}

SceneScan ScanFile::readSceneScan(const std::string& name,
                                  const std::optional<PixelRectangle>& part,
                                  Progress* progress) const {
    using Map = std::variant<HeightMap, ScanMap>;
    const auto read = [&](const StoredChannel& stored) -> Map {
        const HeightMap& empty = stored.channel.map;
        if (empty.index(empty.rows, 0) > kLargeScan) {
            return readScanMap(stored, bytes_, progress);
        }
        return readHeightMap(stored, bytes_, progress);
    };
    return readScan<Map>(name, part, read);
}

HeightChannel ScanFile::readHeightChannel(const std::string& name, Progress* progress) const {
    const ScanChannel& channel = heightChannel(contents(), bytes_.name(), name);
    HeightChannel result{.channel = channel, .notes = notesOn(contents(), channel)};
    result.channel.map = readHeightMap(storedOf(channel), bytes_, progress);
    return result;
}

void ScanFile::forEachRow(
    const ScanChannel& channel,
    const std::function<void(int row, std::span<const double> values)>& visit) const {
    forEachStoredRow(storedOf(channel), bytes_, nullptr,
                     [&visit](int row, const std::vector<double>& values) { visit(row, values); });
}

HeightRows ScanFile::rowsOf(const ScanChannel& channel) const {
    const HeightMap& map = channel.map;
    const auto rows = std::make_shared<ChannelRows>(storedOf(channel), bytes_);
    const auto room = std::make_shared<RowRoom>();
    return {.columns = map.columns,
            .rows = map.rows,
            .pitchX = map.pitchX,
            .pitchY = map.pitchY,
            .readRow = [rows, room, last = map.rows - 1](int row, double* values) {
                (void)rows->read(row, *room, values);
                if (row == last) {
                    rows->finish();
                    *room = {};  // another image may be read before these rows are again
                }
            }};
}

std::string ScanFile::sha256(Progress* progress) const { return sha256Of(bytes_, progress); }

const StoredChannel& ScanFile::storedOf(const ScanChannel& channel) const {
    return contents_.stored[static_cast<std::size_t>(&channel - contents().channels.data())];
}

HeightScan readHeightScan(const std::filesystem::path& path, const std::string& name,
                          Progress* progress) {
    return ScanFile(path).readHeightScan(name, progress);
}

SceneScan readSceneScan(const std::filesystem::path& path, const std::string& name,
                        Progress* progress) {
    return ScanFile(path).readSceneScan(name, progress);
}

HeightChannel readHeightChannel(const std::filesystem::path& path, const std::string& name,
                                Progress* progress) {
    return ScanFile(path).readHeightChannel(name, progress);
}

}  // namespace asperity
