#include "core/io/heightmap/HeightMapFile.h"

#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/io/FileBytes.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/GwyddionScan.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/ImageScale.h"
#include "core/io/heightmap/SampleRows.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/io/heightmap/UnreadFormats.h"

#include <algorithm>
#include <iterator>

namespace asperity {

namespace {

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : ", ") + word;
    }
    return text;
}

std::string formatNames() {
    std::vector<std::string> names;
    for (const HeightMapFormat* format : kHeightMapFormats) {
        if (format->read != nullptr && !format->isRefused) {
            names.emplace_back(format->name);
        }
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

/// Returns the first channel of this name; of several, one that is a height is preferred.
/// @param given in the encoding of a terminal or of the file
const ScanChannel* findChannel(const HeightMapFile& file, const std::string& given) {
    const std::string name = toUtf8(given);
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
    if (!isTopography(channel) && !mayBeTopography(channel)) {
        throw InputError(path, "", "no channel is a height map; there are " + channelNames(file));
    }
    return channel;
}

/// Start of a refusal of an unknown content: the location of the missing marks, too.
/// @throw InputError when it is a picture, which no other program makes heights of
std::string unknownContent(const ByteSource& bytes) {
    const std::optional<UnreadFormat> format = unreadFormat(bytes);
    if (!format) {
        return "byte 0: this is no height map that can be read; known are " + formatNames();
    }
    if (format->isPicture) {
        throw InputError(bytes.name(), "byte 0", pictureRefusal(format->name));
    }
    return "byte 0: this is " + std::string(format->name) + ", which is not read natively";
}

/// Names Gwyddion where it may read the content; of a format that it does not read, nothing.
std::string gwyddionHint(const ByteSource& bytes) {
    const std::optional<UnreadFormat> format = unreadFormat(bytes);
    if (!format) {
        return "; with the Debian package gwyddion many more formats are read";
    }
    return format->byGwyddion ? "; with the Debian package gwyddion it is read" : "";
}

/// Returns what is needed to read its values.
ScanChannel essentialsOf(const ScanChannel& channel) {
    return {.name = channel.name,
            .unit = channel.unit,
            .lateralUnit = channel.lateralUnit,
            .map = channel.map,
            .isSurface = channel.isSurface,
            .originX = channel.originX,
            .originY = channel.originY};
}

/// Returns the default channel, whatever scale is given.
std::size_t defaultOf(const StoredScan& scan) {
    std::vector<ScanChannel> channels;
    for (const StoredChannel& stored : scan.channels) {
        const ScanChannel& channel = stored.channel;
        channels.push_back({.name = channel.name,
                            .unit = channel.unit,
                            .direction = channel.direction,
                            .map = {},
                            .isMask = channel.isMask});
    }
    const auto marked = std::ranges::find_if(channels, [&scan](const ScanChannel& channel) {
        return channel.name == scan.markedChannel && !channel.isMask &&
               (isTopography(channel) || mayBeTopography(channel));
    });
    return scan.markedChannel.empty() || marked == channels.end()
               ? suggestDefaultChannel(channels, scan.usualDirection)
               : static_cast<std::size_t>(marked - channels.begin());
}

/// Cuts what no instrument writes: many channels may be named by one location.
void cut(std::string& words) {
    constexpr std::size_t kMax = 4096;
    if (words.size() > kMax) {
        words = std::string(utf8Start(words, kMax));  // the long one is freed
    }
}

void cut(std::vector<std::string>& notes) {
    for (std::string& note : notes) {
        cut(note);
    }
}

void cut(std::vector<Provenance>& entries) {
    for (Provenance& entry : entries) {
        cut(entry.value);
        cut(entry.source);
    }
}

void cutLongWords(StoredChannel& stored) {
    ScanChannel& channel = stored.channel;
    cut(channel.name);
    cut(channel.unit);
    cut(channel.lateralUnit);
    cut(channel.notes);
    cut(channel.provenance);
}

void cutLongWords(StoredScan& scan) {
    for (StoredChannel& stored : scan.channels) {
        cutLongWords(stored);
    }
    cut(scan.notes);
    cut(scan.provenance);
}

/// Gives each channel the texts that all share.
void shareTexts(StoredScan& scan) {
    const TextQuota quota = TextQuota::ofEach(scan.channels.size());
    bool isCut = scan.hasCutTexts || scan.texts.isCut();
    for (StoredChannel& stored : scan.channels) {
        BoundedTexts texts(quota);
        texts.add(stored.channel.metadata);
        texts.add(scan.texts.all());
        isCut = isCut || texts.isCut();
        stored.channel.metadata = texts.all();
    }
    if (isCut) {
        scan.notes.emplace_back("the file holds more metadata than an instrument writes; some of "
                                "them are left out");
    }
}

HeightMapContents contentsOf(std::string format, StoredScan scan, const GivenScale& given,
                             const std::string& file) {
    HeightMapContents contents;
    contents.file.format = std::move(format);
    cutLongWords(scan);
    shareTexts(scan);
    std::ranges::for_each(scan.channels, noteMask);
    contents.file.defaultChannel = defaultOf(scan);
    applyScale(scan, given, file);
    contents.file.notes = std::move(scan.notes);
    contents.file.provenance = std::move(scan.provenance);
    for (StoredChannel& stored : scan.channels) {
        contents.file.channels.push_back(std::move(stored.channel));
        stored.channel = essentialsOf(contents.file.channels.back());
    }
    contents.stored = std::move(scan.channels);
    return contents;
}

HeightMapFile readWhole(const ByteSource& bytes, const Gwyddion& gwyddion) {
    HeightMapContents contents = contentsOf(bytes, gwyddion);
    for (std::size_t i = 0; i < contents.stored.size(); ++i) {
        contents.file.channels[i].map = readHeightMap(contents.stored[i], bytes);
    }
    return std::move(contents.file);
}

}  // namespace

HeightMapContents contentsOf(const ByteSource& bytes, const Gwyddion& gwyddion,
                             const GivenScale& given) {
    if (bytes.size() == 0) {
        throw InputError(bytes.name(), "", "the file is empty");
    }
    const auto* const format =
        std::ranges::find_if(kHeightMapFormats, [&](const HeightMapFormat* each) {
            return each->read != nullptr && each->recognizes(bytes);
        });
    if (format != kHeightMapFormats.end()) {
        return contentsOf(std::string((*format)->name), (*format)->read(bytes), given,
                          bytes.name());
    }
    const std::string unknown = unknownContent(bytes);
    if (gwyddion.program.empty()) {
        throw InputError(bytes.name(), "", unknown + gwyddionHint(bytes));
    }
    GwyddionScan converted = readThroughGwyddion(bytes, gwyddion, unknown);
    return contentsOf(std::move(converted.format), std::move(converted.scan), given, bytes.name());
}

std::vector<ReadableFormat> readableFormats() {
    std::vector<ReadableFormat> formats;
    for (const HeightMapFormat* format : kHeightMapFormats) {
        if (format->read != nullptr && !format->extensions.empty()) {
            formats.push_back({std::string(format->name),
                               {format->extensions.begin(), format->extensions.end()}});
        }
    }
    return formats;
}

std::vector<std::string> readableExtensions() {
    std::vector<std::string> extensions;
    for (const ReadableFormat& format : readableFormats()) {
        for (const std::string& extension : format.extensions) {
            // Some formats share theirs.
            if (std::ranges::count(extensions, extension) == 0) {
                extensions.push_back(extension);
            }
        }
    }
    return extensions;
}

HeightMapFile readHeightMapBytes(std::string_view bytes, const std::string& file,
                                 const Gwyddion& gwyddion) {
    return readWhole(MemoryBytes(bytes, file), gwyddion);
}

HeightMapFile readHeightMapFile(const std::filesystem::path& path, const Gwyddion& gwyddion) {
    return readWhole(BufferedFile(path), gwyddion);
}

std::vector<std::string> ownNotes(const ScanChannel& channel) {
    std::vector<std::string> notes;
    for (const std::string& note : channel.notes) {
        notes.push_back("'" + channel.name + "': " + note);
    }
    return notes;
}

std::vector<std::string> notesOn(const HeightMapFile& file, const ScanChannel& channel) {
    std::vector<std::string> notes = file.notes;
    std::ranges::move(ownNotes(channel), std::back_inserter(notes));
    return notes;
}

std::vector<Provenance> provenanceOf(const HeightMapFile& file, const ScanChannel& channel) {
    std::vector<Provenance> entries = file.provenance;
    std::ranges::copy(channel.provenance, std::back_inserter(entries));
    return entries;
}

const ScanChannel& channelNamed(const HeightMapFile& file, const std::filesystem::path& path,
                                const std::string& name) {
    const ScanChannel* const channel = findChannel(file, name);
    if (channel == nullptr) {
        throw InputError(path.string(), "",
                         "there is no channel '" + name + "'; there are " + channelNames(file));
    }
    return *channel;
}

std::vector<std::string> heightChannels(const HeightMapFile& file) {
    std::vector<std::string> names;
    for (const ScanChannel& channel : file.channels) {
        if (channel.isHeight() && channel.hasSize() &&
            std::ranges::count(names, channel.name) == 0) {
            names.push_back(channel.name);
        }
    }
    return names;
}

const ScanChannel& heightChannel(const HeightMapFile& file, const std::filesystem::path& path,
                                 const std::string& name) {
    const ScanChannel& channel =
        name.empty() ? defaultHeight(file, path.string()) : channelNamed(file, path, name);
    if (!channel.isHeight() && !channel.unit.empty()) {
        throw InputError(path.string(), "channel '" + channel.name + "'",
                         "it has the unit " + channel.unit + "; a height map is a length");
    }
    requireScale(channel, path);
    return channel;
}

namespace {

template <class Map>
void requireAnyHeight(const Map& map, const std::filesystem::path& path) {
    if (std::ranges::none_of(map.heights, [](auto height) { return isFiniteHeight(height); })) {
        throw InputError(path.string(), "", "the height map holds no valid pixel");
    }
}

}  // namespace

void requireHeights(const HeightMap& map, const std::filesystem::path& path) {
    requireAnyHeight(map, path);
}

void requireHeights(const ScanMap& map, const std::filesystem::path& path) {
    requireAnyHeight(map, path);
}

}  // namespace asperity
