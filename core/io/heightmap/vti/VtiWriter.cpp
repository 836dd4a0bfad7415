#include "core/io/heightmap/vti/VtiWriter.h"

#include "core/io/ByteReader.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeightMapWriter.h"

#include <fstream>
#include <string>
#include <vector>

// VTK's XML image: a head of text, then the values as they are in memory, so that readers need no
// copy. y is up: the bottom row is first. Source: VTK File Formats (4.2), "XML File Formats".

namespace asperity {

namespace {

/// Returns a name as a value of XML, in which most characters below the blank are not allowed.
std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : oneLine(std::string(text))) {
        switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '"':
            result += "&quot;";
            break;
        default:
            result += c;
        }
    }
    return result;
}

/// VTK writes a text as the numbers of its bytes and a zero.
std::string textArray(std::string_view name, std::string_view text) {
    std::string line = "      <Array type=\"String\" Name=\"" + escaped(name) +
                       "\" NumberOfTuples=\"1\" format=\"ascii\">";
    for (const char c : text) {
        line += std::to_string(static_cast<int>(static_cast<unsigned char>(c))) + " ";
    }
    return line + "0</Array>\n";
}

std::string metadata(const HeightMapMeta& meta) {
    std::string lines;
    for (const auto& [name, value] : writtenMetadata(meta)) {
        if (name != kVtiTitle && name != kVtiUnit && name != kVtiOrigin) {
            lines += textArray(name, value);
        }
    }
    return lines;
}

/// @param own lines of what the file's arrays are
std::string fieldData(const HeightMapMeta& meta, const std::string& own) {
    return "    <FieldData>\n" + own + "      <DataArray type=\"Float64\" Name=\"" + kVtiOrigin +
           "\" NumberOfTuples=\"2\" format=\"ascii\">" + exactText(meta.originX) + " " +
           exactText(meta.originY) + "</DataArray>\n" + metadata(meta) + "    </FieldData>\n";
}

std::uint64_t pixelsOf(const HeightRows& map) {
    return static_cast<std::uint64_t>(map.columns) * static_cast<std::uint64_t>(map.rows);
}

/// Values after the head.
struct AppendedArray {
    std::string_view type;  ///< VTK's name
    std::string name;
    std::uint64_t valueBytes = 0;
};

/// The first array is the one that is shown.
std::string pointData(const HeightRows& map, std::span<const AppendedArray> arrays) {
    std::string text = "      <PointData Scalars=\"" + escaped(arrays.front().name) + "\">\n";
    std::uint64_t offset = 0;
    for (const AppendedArray& array : arrays) {
        text += "        <DataArray type=\"" + std::string(array.type) + "\" Name=\"" +
                escaped(array.name) + "\" format=\"appended\" offset=\"" + std::to_string(offset) +
                "\"/>\n";
        offset += sizeof(std::uint64_t) + (pixelsOf(map) * array.valueBytes);
    }
    return text + "      </PointData>\n";
}

/// All before the values.
std::string head(const HeightRows& map, const std::string& fields,
                 std::span<const AppendedArray> arrays) {
    const std::string extent =
        "0 " + std::to_string(map.columns - 1) + " 0 " + std::to_string(map.rows - 1) + " 0 0";
    return "<?xml version=\"1.0\"?>\n"
           "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" "
           "header_type=\"UInt64\">\n"
           "  <ImageData WholeExtent=\"" +
           extent + "\" Origin=\"" + exactText(0.5 * map.pitchX) + " " +
           exactText(0.5 * map.pitchY) + " 0\" Spacing=\"" + exactText(map.pitchX) + " " +
           exactText(map.pitchY) + " 1\" Direction=\"1 0 0 0 1 0 0 0 1\">\n" + fields +
           "    <Piece Extent=\"" + extent + "\">\n" + pointData(map, arrays) +
           "    </Piece>\n  </ImageData>\n  <AppendedData encoding=\"raw\">\n   _";
}

/// The number of bytes, then valueOf(height) of each pixel, the bottom row first.
template <class ValueOf>
void writeBlock(std::ofstream& stream, const HeightRows& map, Progress* progress,
                const ValueOf& valueOf) {
    HeightRows upward = map;
    upward.readRow = [&map](int row, double* heights) { map.readRow(map.rows - 1 - row, heights); };
    std::string bytes;
    appendLittleEndian(bytes, pixelsOf(map) * sizeof(valueOf(0.0)));
    stream << bytes;
    forEachRow(upward, progress, [&](int, const std::vector<double>& heights) {
        bytes.clear();
        for (const double height : heights) {
            appendLittleEndian(bytes, valueOf(height));
        }
        stream << bytes;
    });
}

void end(std::ofstream& stream) {
    stream << "\n  </AppendedData>\n</VTKFile>\n";
    finish(stream);
}

double asItIs(double height) { return height; }

}  // namespace

void writeVti(const std::filesystem::path& target, const HeightRows& map, const HeightMapMeta& meta,
              Progress* progress) {
    ProgressPart ranging(progress, 0.0, 0.2);
    const bool hasMissing = heightRange(map, &ranging).missing > 0;
    std::vector<AppendedArray> arrays{
        {"Float64", meta.unit == "m" ? "height" : meta.title, sizeof(double)}};
    if (hasMissing) {
        arrays.push_back({"UInt8", kVtiValid, 1});
    }
    std::ofstream stream(target, std::ios::binary);
    stream << head(
        map, fieldData(meta, textArray(kVtiTitle, meta.title) + textArray(kVtiUnit, meta.unit)),
        arrays);
    ProgressPart writing(progress, 0.2, hasMissing ? 0.8 : 1.0);
    writeBlock(stream, map, &writing, asItIs);
    if (hasMissing) {
        ProgressPart marking(progress, 0.8, 1.0);
        writeBlock(stream, map, &marking, [](double height) {
            return static_cast<std::uint8_t>(isFiniteHeight(height) ? 1 : 0);
        });
    }
    reportTo(progress, 1.0);
    end(stream);
}

void writeVtiImages(const std::filesystem::path& target, std::span<const WrittenImage> images,
                    Progress* progress) {
    std::vector<AppendedArray> arrays;
    std::string units;
    for (const WrittenImage& image : images) {
        arrays.push_back({"Float64", image.meta.title, sizeof(double)});
        units += textArray(kVtiUnitOf + image.meta.title, image.meta.unit);
    }
    std::ofstream stream(target, std::ios::binary);
    stream << head(images.front().rows, fieldData(images.front().meta, units), arrays);
    const auto count = static_cast<double>(images.size());
    for (std::size_t i = 0; i < images.size(); ++i) {
        const auto number = static_cast<double>(i);
        ProgressPart part(progress, number / count, (number + 1.0) / count);
        writeBlock(stream, images[i].rows, &part, asItIs);
    }
    end(stream);
}

}  // namespace asperity
