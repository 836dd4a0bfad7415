#include "core/io/heightmap/text/TextWriter.h"

#include "core/io/TextValue.h"
#include "core/io/heightmap/HeightMapEncoders.h"
#include "core/io/heightmap/text/TextComments.h"

#include <fstream>
#include <set>

// A matrix of heights, the rows from the top, after the comment lines of two programs: those of
// Gwyddion's export, and those of SPIP, which Gwyddion recognizes.
// Source: docs/formats.md 4.

namespace asperity {

namespace {

/// The header of SPIP's ASCII files, by which Gwyddion reads size, unit and values; it takes
/// lengths in nanometers.
std::string spipHeader(const HeightRows& map, const HeightMapMeta& meta) {
    constexpr double kPerMeter = 1e9;
    return "# File Format = ASCII\n# Created by Asperity\n# x-pixels = " +
           std::to_string(map.columns) + "\n# y-pixels = " + std::to_string(map.rows) +
           "\n# x-length = " + exactText(kPerMeter * map.sizeX()) +
           "\n# y-length = " + exactText(kPerMeter * map.sizeY()) +
           "\n# x-offset = " + exactText(kPerMeter * meta.originX) +
           "\n# y-offset = " + exactText(kPerMeter * meta.originY) +
           "\n# z-unit = " + oneLine(meta.unit) + "\n";
}

std::string lengthLine(std::string_view key, double length) {
    return "# " + std::string(key) + ": " + exactText(length) + " m\n";
}

/// As Gwyddion exports a matrix, which is what our reader goes by.
std::string gwyddionHeader(const HeightRows& map, const HeightMapMeta& meta) {
    return "# Channel: " + oneLine(meta.title) + "\n" + lengthLine("Width", map.sizeX()) +
           lengthLine("Height", map.sizeY()) +
           (meta.unit.empty() ? "" : "# Value units: " + oneLine(meta.unit) + "\n") +
           lengthLine(kOriginXComment, meta.originX) + lengthLine(kOriginYComment, meta.originY);
}

/// As further comments; a reader looks for the numbers in the first lines alone.
std::string metadataComments(const HeightMapMeta& meta) {
    constexpr std::size_t kMostBytes = 40000;
    constexpr int kMostLines = 800;
    const std::set<std::string_view> own = {kOriginXComment, kOriginYComment, "Start of Data"};
    std::string lines;
    int count = 0;
    for (const auto& [name, value] : writtenMetadata(meta, kMostBytes)) {
        const bool isKey = name.find_first_of(":=#%") == std::string::npos && !own.contains(name);
        if (isKey && ++count <= kMostLines) {
            lines.append("# ").append(name).append(": ").append(value).append("\n");
        }
    }
    return lines;
}

}  // namespace

void writeText(const std::filesystem::path& target, const HeightRows& map,
               const HeightMapMeta& meta, Progress* progress) {
    std::ofstream stream(target, std::ios::binary);
    stream << spipHeader(map, meta) << gwyddionHeader(map, meta) << metadataComments(meta)
           << "# Start of Data:\n";
    forEachRow(map, progress, [&](int, const std::vector<double>& heights) {
        std::string line;
        for (const double height : heights) {
            line += line.empty() ? "" : "\t";
            line += isFiniteHeight(height) ? exactText(height) : "nan";
        }
        stream << line << '\n';
    });
    finish(stream);
}

}  // namespace asperity
