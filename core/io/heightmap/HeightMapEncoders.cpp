#include "core/io/heightmap/HeightMapEncoders.h"

#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/io/TextValue.h"

#include <algorithm>
#include <fstream>
#include <limits>

namespace asperity {

void finish(std::ofstream& stream) {
    stream.close();
    if (!stream) {
        throw Error(kStoppedHalfWay);
    }
}

HeightRange heightRange(const HeightRows& map, Progress* progress) {
    HeightRange range{std::numeric_limits<double>::infinity(),
                      -std::numeric_limits<double>::infinity(), 0};
    bool isEmpty = true;
    forEachRow(map, progress, [&](int, const std::vector<double>& heights) {
        for (const double height : heights) {
            if (isFiniteHeight(height)) {
                range.lowest = std::min(range.lowest, height);
                range.highest = std::max(range.highest, height);
                isEmpty = false;
            } else {
                ++range.missing;
            }
        }
    });
    if (isEmpty) {
        range.lowest = range.highest = 0.0;
    }
    return range;
}

std::string oneLine(std::string text) {
    static constexpr std::string_view kBlanks("\n\r\t\0", 4);
    std::ranges::replace_if(
        text, [](char c) { return kBlanks.find(c) != std::string_view::npos; }, ' ');
    return printable(text);
}

std::map<std::string, std::string> writtenMetadata(const HeightMapMeta& meta, std::size_t most) {
    constexpr std::size_t kMaxBytes = 60000;
    std::size_t total = 0;
    std::map<std::string, std::string> written;
    for (const auto& [given, text] : meta.metadata) {
        const std::string name(trimmed(oneLine(given)));
        const std::string value(trimmed(oneLine(text)));
        const std::size_t bytes = name.size() + value.size();
        const bool fits = !name.empty() && !value.empty() && name.size() <= kMaxBytes &&
                          value.size() <= kMaxBytes && total + bytes <= most;
        if (fits && !name.starts_with("Gwy::") && !name.starts_with("Asperity::")) {
            written.emplace(name, value);
            total += bytes;
        }
    }
    return written;
}

std::string metadataLines(const HeightMapMeta& meta, std::string_view between,
                          std::span<const std::string_view> reserved, std::size_t most) {
    std::string lines;
    for (const auto& [name, value] : writtenMetadata(meta, most)) {
        if (name.find(trimmed(between)) == std::string::npos &&
            std::ranges::count(reserved, name) == 0) {
            lines.append(name).append(between).append(value).append("\n");
        }
    }
    return lines;
}

}  // namespace asperity
