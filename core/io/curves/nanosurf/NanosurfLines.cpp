#include "core/io/curves/nanosurf/NanosurfLines.h"

#include "core/Error.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/PhysicalUnit.h"

#include <algorithm>
#include <cmath>

// Curves and spectra of Nanosurf .nid files: channels with a line each. Source: docs/formats.md 21.

namespace asperity {

bool isNanosurfScan(const HeaderFields& section) {
    return lowerCase(section.text("Frame")).find("scan") != std::string::npos &&
           section.integer("Lines") >= 2;
}

std::vector<NanosurfLines> nanosurfLines(const NanosurfHeader& header, const ByteSource& bytes) {
    constexpr long long kMax = 1LL << 24;
    std::vector<NanosurfLines> found;
    std::uint64_t offset = header.end;
    for (const HeaderFields* const section : nanosurfChannels(header.sections, bytes.name())) {
        const long long points = section->integer("Points");
        const long long lines = section->integer("Lines");
        if (!(points >= 0 && points <= kMax && lines >= 0 && lines <= kMax)) {
            section->fail("Points, Lines",
                          "found " + std::to_string(points) + " x " + std::to_string(lines));
        }
        const SampleType type = nanosurfSampleType(*section);
        const std::uint64_t length = static_cast<std::uint64_t>(points * lines) * sizeOf(type);
        if (!isNanosurfScan(*section)) {
            if (offset + length > bytes.size()) {
                throw InputError(bytes.name(), section->location(),
                                 "its samples end at byte " + std::to_string(offset + length) +
                                     ", but the file has " + std::to_string(bytes.size()) +
                                     "; it is truncated");
            }
            found.push_back({section, section->text("Frame"), section->text("Dim2Name"), type,
                             static_cast<std::size_t>(points), static_cast<std::size_t>(lines),
                             offset});
        }
        offset += length;
    }
    return found;
}

std::vector<double> nanosurfLine(const ByteSource& bytes, const NanosurfLines& channel,
                                 std::size_t line) {
    const std::uint64_t length = channel.points * sizeOf(channel.type);
    const std::string stored = bytesOf(bytes, {channel.offset + line * length, length});
    std::vector<double> values(channel.points);
    convertSamples(channel.type, ByteOrder::Little, stored.data(), values);
    const std::string key = "LineDim" + std::to_string(line) + "Points";
    if (channel.section->find(key) != nullptr) {
        const long long valid = channel.section->integer(key);
        values.resize(std::min(values.size(), static_cast<std::size_t>(std::max(valid, 0LL))));
    }
    const NanosurfScale scale = nanosurfScale(*channel.section, channel.type);
    const double factor = parseUnit(channel.section->text("Dim2Unit")).factor;
    std::ranges::transform(values, values.begin(),
                           [&](double count) { return factor * scale(count); });
    return values;
}

std::vector<double> nanosurfAxis(const NanosurfLines& channel, std::size_t points) {
    const double begin = channel.section->requiredNumber("Dim0Min");
    const double range = channel.section->requiredNumber("Dim0Range");
    const double factor = parseUnit(channel.section->text("Dim0Unit")).factor;
    if (!std::isfinite(begin) || !std::isfinite(range)) {
        channel.section->fail("Dim0Min, Dim0Range", "expected two finite numbers");
    }
    std::vector<double> axis(points);
    const double steps = std::max(1.0, static_cast<double>(channel.points) - 1.0);
    for (std::size_t i = 0; i < points; ++i) {
        axis[i] = factor * (begin + range * (static_cast<double>(i) / steps));
    }
    return axis;
}

}  // namespace asperity
