#include "core/io/HeightMapEncoders.h"
#include "core/io/TextValue.h"

#include <algorithm>

// A matrix of heights as Gwyddion exports it: four comment lines, then the rows from the top.
// Source: docs/formats.md 4.

namespace asperity {

namespace {

std::string oneLine(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return text;
}

}  // namespace

void writeText(const std::filesystem::path& target, const HeightMap& map,
               const HeightMapMeta& meta) {
    std::string text = "# Channel: " + oneLine(meta.title) +
                       "\n# Width: " + exactText(map.sizeX()) +
                       " m\n# Height: " + exactText(map.sizeY()) + " m\n# Value units: m\n";
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            if (column > 0) {
                text += '\t';
            }
            text += map.isValid(row, column) ? exactText(map.at(row, column)) : "nan";
        }
        text += '\n';
    }
    writeBytes(target, text);
}

}  // namespace asperity
