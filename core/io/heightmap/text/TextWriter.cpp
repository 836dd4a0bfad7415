#include "core/io/heightmap/text/TextWriter.h"

#include "core/io/TextValue.h"
#include "core/io/heightmap/HeightMapEncoders.h"

#include <algorithm>
#include <fstream>

// A matrix of heights as Gwyddion exports it: comment lines, then the rows from the top.
// Source: docs/formats.md 4.

namespace asperity {

namespace {

std::string oneLine(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return text;
}

}  // namespace

void writeText(const std::filesystem::path& target, const HeightRows& map,
               const HeightMapMeta& meta, Progress* progress) {
    std::ofstream stream(target, std::ios::binary);
    stream << "# Channel: " << oneLine(meta.title) << "\n# Width: " << exactText(map.sizeX())
           << " m\n# Height: " << exactText(map.sizeY()) << " m\n"
           << (meta.unit.empty() ? "" : "# Value units: " + meta.unit + "\n");
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
