#include "core/io/heightmap/nanosurf/NanosurfHeader.h"

#include "core/Error.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/ScanImage.h"

#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace asperity {

namespace {

constexpr std::string_view kNanosurfHeaderEnd = "\r\n#!";

/// One that [DataSet] lists, by group and index in it.
using ChannelKey = std::pair<long long, long long>;

/// "Gr1-Ch2" → 1, 2; empty for every other key.
std::optional<ChannelKey> parseChannelKey(std::string_view key) {
    const std::size_t dash = key.find("-Ch");
    if (!key.starts_with("Gr") || dash == std::string_view::npos) {
        return std::nullopt;
    }
    const std::optional<long long> group = parseInteger(key.substr(2, dash - 2));
    const std::optional<long long> channel = parseInteger(key.substr(dash + 3));
    return group && channel ? std::optional(ChannelKey{*group, *channel}) : std::nullopt;
}

void requireWord(const HeaderFields& section, const std::string& key, std::string_view expected) {
    const std::string word = section.text(key);
    if (word != expected) {
        section.fail(key, "expected " + std::string(expected) + ", found '" + word + "'");
    }
}

}  // namespace

NanosurfHeader readNanosurfHeader(const ByteSource& bytes) {
    if (bytes.startsWith("[DataSet]\n")) {
        throw InputError(bytes.name(), "line 1",
                         "it ends with a bare line feed: a transfer in text mode has damaged the "
                         "file");
    }
    const HeaderText header = headerText(bytes, kNanosurfHeaderEnd);
    return {sectionsOf(header.text, '=', bytes.name()), header.end};
}

std::vector<const HeaderFields*> nanosurfChannels(const HeaderSections& sections,
                                                  const std::string& file) {
    const auto list = sections.find("DataSet");
    if (list == sections.end()) {
        throw InputError(file, "header", "it has no section [DataSet]");
    }
    std::map<ChannelKey, const HeaderFields*> channels;
    for (const auto& [key, name] : list->second.all()) {
        const std::optional<ChannelKey> channel = parseChannelKey(key);
        if (!channel) {
            continue;
        }
        const auto section = sections.find(name);
        if (section == sections.end()) {
            list->second.fail(key, "there is no section [" + name + "]");
        }
        channels.emplace(*channel, &section->second);
    }
    requireImages(channels.size(), file, "[DataSet]");
    std::vector<const HeaderFields*> ordered;
    ordered.reserve(channels.size());
    for (const auto& [channel, section] : channels) {
        ordered.push_back(section);
    }
    return ordered;
}

SampleType nanosurfSampleType(const HeaderFields& section) {
    requireWord(section, "SaveMode", "Binary");
    requireWord(section, "SaveSign", "Signed");
    requireWord(section, "SaveOrder", "Intel");
    switch (section.integer("SaveBits")) {
    case 8:
        return SampleType::Int8;
    case 16:
        return SampleType::Int16;
    case 32:
        return SampleType::Int32;
    default:
        section.fail("SaveBits", "expected 8, 16 or 32, found '" + section.text("SaveBits") + "'");
    }
}

NanosurfScale nanosurfScale(const HeaderFields& section, SampleType type) {
    const std::optional<double> minimum = section.number("Dim2Min");
    const std::optional<double> range = section.number("Dim2Range");
    if (!minimum || !range || !std::isfinite(*minimum) || !std::isfinite(*range)) {
        section.fail("Dim2Min, Dim2Range", "expected two finite numbers");
    }
    const int bits = 8 * static_cast<int>(sizeOf(type));
    return {.minimum = *minimum,
            .perCount = std::ldexp(*range, -bits),
            .lowestCount = -std::ldexp(1.0, bits - 1)};
}

}  // namespace asperity
