#include "core/io/HeightMapFile.h"

#include "core/Error.h"
#include "core/io/DefaultChannel.h"
#include "core/io/FileBytes.h"
#include "core/io/HeightMapFormat.h"
#include "core/io/StoredRows.h"

#include <algorithm>
#include <array>

namespace asperity {

namespace {

/// The most telling beginnings first.
const std::array<const HeightMapFormat*, 3>& formats() {
    static const std::array<const HeightMapFormat*, 3> kFormats = {
        &kGwyFormat,
        &kNanoscopeFormat,
        &kGsfFormat,
    };
    return kFormats;
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : ", ") + word;
    }
    return text;
}

std::string formatNames() {
    std::vector<std::string> names;
    for (const HeightMapFormat* format : formats()) {
        names.emplace_back(format->name);
    }
    return joined(names);
}

std::string channelNames(const HeightMapFile& file) {
    std::vector<std::string> names;
    for (const ScanChannel& channel : file.channels) {
        const std::string unit = channel.unit.empty() ? "no unit" : channel.unit;
        names.push_back("'" + channel.name + "' (" + unit + ")");
    }
    return joined(names);
}

/// The first channel of this name; of several, one that is a height goes first.
const ScanChannel* findChannel(const HeightMapFile& file, const std::string& name) {
    const ScanChannel* found = nullptr;
    for (const ScanChannel& channel : file.channels) {
        if (channel.name != name) {
            continue;
        }
        if (channel.isHeight()) {
            return &channel;
        }
        if (found == nullptr) {
            found = &channel;
        }
    }
    return found;
}

const ScanChannel& defaultHeight(const HeightMapFile& file, const std::string& path) {
    const ScanChannel& channel = file.channels.at(file.defaultChannel);
    if (!isTopography(channel)) {
        throw InputError(path, "", "no channel is a height map; there are " + channelNames(file));
    }
    return channel;
}

/// What the file holds, without the heights.
struct Contents {
    HeightMapFile file;
    std::vector<StoredChannel> stored;  ///< as many as the file has channels

    [[nodiscard]] const StoredChannel& storedOf(const ScanChannel& channel) const {
        return stored[static_cast<std::size_t>(&channel - file.channels.data())];
    }
};

Contents contentsOf(std::string_view bytes, const std::string& file) {
    if (bytes.empty()) {
        throw InputError(file, "", "the file is empty");
    }
    const auto& known = formats();
    const auto format = std::find_if(known.begin(), known.end(), [&](const HeightMapFormat* each) {
        return each->recognises(bytes);
    });
    if (format == known.end()) {
        throw InputError(file, "",
                         "this is no height map that can be read; known are " + formatNames());
    }
    StoredScan scan = (*format)->read(bytes, file);
    Contents contents;
    contents.file.format = (*format)->name;
    contents.file.notes = std::move(scan.notes);
    for (const StoredChannel& stored : scan.channels) {
        contents.file.channels.push_back(stored.channel);
    }
    contents.file.defaultChannel = suggestDefaultChannel(contents.file.channels);
    contents.stored = std::move(scan.channels);
    return contents;
}

}  // namespace

HeightMapFile readHeightMapBytes(std::string_view bytes, const std::string& file) {
    Contents contents = contentsOf(bytes, file);
    for (ScanChannel& channel : contents.file.channels) {
        readHeights(contents.storedOf(channel), channel.map);
    }
    return std::move(contents.file);
}

HeightMapFile readHeightMapFile(const std::filesystem::path& path) {
    const MappedFile file(path);
    return readHeightMapBytes(file.bytes(), path.string());
}

HeightScan readHeightScan(const std::filesystem::path& path, const std::string& name,
                          Progress* progress) {
    const MappedFile file(path);
    Contents contents = contentsOf(file.bytes(), path.string());
    const ScanChannel& channel = heightChannel(contents.file, path, name);
    HeightScan scan{.format = contents.file.format,
                    .channel = channel.name,
                    .originX = channel.originX,
                    .originY = channel.originY,
                    .notes = {}};
    scan.map = readScanMap(contents.storedOf(channel), file, progress);
    scan.notes = std::move(contents.file.notes);
    return scan;
}

HeightChannel readHeightChannel(const std::filesystem::path& path, const std::string& name,
                                Progress* progress) {
    const MappedFile file(path);
    Contents contents = contentsOf(file.bytes(), path.string());
    const ScanChannel& channel = heightChannel(contents.file, path, name);
    HeightChannel result{.channel = channel, .notes = {}};
    result.channel.map = readHeightMap(contents.storedOf(channel), file, progress);
    result.notes = std::move(contents.file.notes);
    return result;
}

const ScanChannel& heightChannel(const HeightMapFile& file, const std::filesystem::path& path,
                                 const std::string& name) {
    const ScanChannel* channel =
        name.empty() ? &defaultHeight(file, path.string()) : findChannel(file, name);
    if (channel == nullptr) {
        throw InputError(path.string(), "",
                         "there is no channel '" + name + "'; there are " + channelNames(file));
    }
    const std::string place = "channel '" + channel->name + "'";
    if (!channel->isHeight()) {
        const std::string unit = channel->unit.empty() ? "no unit" : "the unit " + channel->unit;
        throw InputError(path.string(), place, "it has " + unit + "; a height map is a length");
    }
    if (!channel->hasSize()) {
        throw InputError(path.string(), place, "the file does not say how large the scan is");
    }
    return *channel;
}

}  // namespace asperity
