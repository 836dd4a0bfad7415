#include "core/io/heightmap/gsf/GsfWriter.h"

#include "core/io/ByteReader.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeightMapEncoders.h"

#include <array>
#include <fstream>

// Gwyddion Simple Field; see GsfReader.cpp.

namespace asperity {

namespace {

/// Of the format itself.
constexpr std::array<std::string_view, 9> kFields = {
    "XRes", "YRes", "XReal", "YReal", "XOffset", "YOffset", "XYUnits", "ZUnits", "Title"};

std::string header(const HeightRows& map, const HeightMapMeta& meta) {
    return "Gwyddion Simple Field 1.0\nXRes = " + std::to_string(map.columns) +
           "\nYRes = " + std::to_string(map.rows) + "\nXReal = " + exactText(map.sizeX()) +
           "\nYReal = " + exactText(map.sizeY()) + "\nXOffset = " + exactText(meta.originX) +
           "\nYOffset = " + exactText(meta.originY) + "\nXYUnits = m" +
           (meta.unit.empty() ? "" : "\nZUnits = " + oneLine(meta.unit)) +
           "\nTitle = " + oneLine(meta.title) + "\n" + metadataLines(meta, " = ", kFields);
}

}  // namespace

void writeGsf(const std::filesystem::path& target, const HeightRows& map, const HeightMapMeta& meta,
              Progress* progress) {
    std::string bytes = header(map, meta);
    bytes.append(kGsfAlignment - bytes.size() % kGsfAlignment, '\0');
    std::ofstream stream(target, std::ios::binary);
    stream << bytes;
    forEachRow(map, progress, [&](int, const std::vector<double>& heights) {
        bytes.clear();
        for (const double height : heights) {
            appendLittleEndian(bytes, static_cast<float>(height));
        }
        stream << bytes;
    });
    finish(stream);
}

}  // namespace asperity
