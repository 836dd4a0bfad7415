#include "core/io/heightmap/ScanFile.h"

#include "core/Error.h"
#include "core/io/FileBytes.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/ChannelRows.h"
#include "core/io/heightmap/SampleRows.h"

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <utility>

namespace asperity {

namespace {

std::string pixels(int columns, int rows) {
    return std::to_string(columns) + " x " + std::to_string(rows) + " pixels";
}

bool containsAny(std::string_view text, std::initializer_list<std::string_view> words) {
    return std::any_of(words.begin(), words.end(), [text](std::string_view word) {
        return text.find(word) != std::string_view::npos;
    });
}

/// Some instruments and programs give these as lengths, too. The feedback of an STM may keep a
/// current constant while it measures a topography.
bool namesOtherThanHeight(const ScanChannel& channel) {
    if (channel.isSurface) {
        return false;
    }
    const std::string name = lowerCase(channel.name);
    const bool isCurrent =
        containsAny(name, {"current"}) && !containsAny(name, {"height", "topograph"});
    return isCurrent || containsAny(name, {"deflection", "amplitude", "phase", "error", "friction",
                                           "deformation", "indentation"});
}

/// Smaller is better.
int rankOfName(const ScanChannel& channel) {
    const std::string name = lowerCase(channel.name);
    if (channel.isSurface || containsAny(name, {"sensor", "measured"})) {
        return 0;
    }
    const bool piezo =
        containsAny(name, {"height", "topograph"}) || name == "z" || name.starts_with("z ");
    return piezo ? 1 : 2;
}

int rank(const ScanChannel& channel) {
    constexpr int kNames = 3;
    if (isTopography(channel)) {
        return rankOfName(channel);
    }
    if (!mayBeTopography(channel)) {
        return 3 * kNames;
    }
    return (channel.isMask ? 2 : 1) * kNames + rankOfName(channel);
}

}  // namespace

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

std::string cropRefusal(const ScanChannel& channel, const PixelRectangle& part) {
    const HeightMap& whole = channel.map;
    return part.liesIn(whole.columns, whole.rows)
               ? std::string()
               : "a crop of " + pixels(part.columns, part.rows) + " from column " +
                     std::to_string(part.column) + ", row " + std::to_string(part.row) +
                     " is not within its " + pixels(whole.columns, whole.rows);
}

StoredChannel croppedChannel(const StoredChannel& stored, const PixelRectangle& part,
                             const std::string& file) {
    if (const std::string refusal = cropRefusal(stored.channel, part); !refusal.empty()) {
        throw InputError(file, "channel '" + stored.channel.name + "'", refusal);
    }
    StoredChannel cropped{.channel = stored.channel,
                          .factor = stored.factor,
                          .readRow = {},
                          .firstColumn = stored.firstColumn + part.column,
                          .firstRow = stored.firstRow + part.row};
    const HeightMap& all = stored.channel.map;
    cropped.channel.originX += part.column * all.pitchX;
    cropped.channel.originY += (all.rows - part.row - part.rows) * all.pitchY;
    cropped.channel.map.columns = part.columns;
    cropped.channel.map.rows = part.rows;
    cropped.readRow = [&stored, part](int row, RowRoom& room, double* numbers) {
        std::vector<double> whole(static_cast<std::size_t>(stored.channel.map.columns));
        stored.readRow(part.row + row, room, whole.data());
        std::copy_n(whole.begin() + part.column, part.columns, numbers);
    };
    return cropped;
}

bool isTopography(const ScanChannel& channel) {
    return channel.isHeight() && !namesOtherThanHeight(channel);
}

bool mayBeTopography(const ScanChannel& channel) {
    return channel.unit.empty() && !namesOtherThanHeight(channel);
}

std::size_t suggestDefaultChannel(const std::vector<ScanChannel>& channels,
                                  std::string_view usualDirection) {
    const auto order = [usualDirection](const ScanChannel& channel) {
        return std::pair{rank(channel),
                         !usualDirection.empty() && channel.direction != usualDirection};
    };
    const auto best = std::min_element(
        channels.begin(), channels.end(),
        [&](const ScanChannel& a, const ScanChannel& b) { return order(a) < order(b); });
    return best == channels.end() ? 0 : static_cast<std::size_t>(best - channels.begin());
}

}  // namespace asperity
