
#include "core/io/heightmap/exr/ExrWriter.h"

#include "core/Error.h"
#include "core/io/heightmap/HeightMapWriter.h"

#include <OpenEXR/IexErrnoExc.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStdIO.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

// OpenEXR with one float channel Y, heights in meters, and Gwyddion's attributes. Half floats would
// turn 20 nm into 0. Source: docs/formats.md 9.

namespace asperity {

namespace {

/// Returns the header, without the channels.
Imf::Header commonHeader(const HeightRows& map, const HeightMapMeta& meta) {
    Imf::Header header(map.columns, map.rows);
    header.compression() = Imf::ZIP_COMPRESSION;
    header.insert("Gwy::XReal", Imf::DoubleAttribute(map.sizeX()));
    header.insert("Gwy::YReal", Imf::DoubleAttribute(map.sizeY()));
    header.insert("Gwy::XOffset", Imf::DoubleAttribute(meta.originX));
    header.insert("Gwy::YOffset", Imf::DoubleAttribute(meta.originY));
    header.insert("Gwy::XYUnit", Imf::StringAttribute("m"));
    return header;
}

void insertMetadata(Imf::Header& header, const HeightMapMeta& meta) {
    constexpr std::size_t kMaxName = 255;
    for (const auto& [name, value] : writtenMetadata(meta)) {
        // Some names are the format's own.
        if (name.size() <= kMaxName && header.find(name) == header.end()) {
            header.insert(name, Imf::StringAttribute(value));
        }
    }
}

Imf::Header headerOfMap(const HeightRows& map, const HeightMapMeta& meta) {
    Imf::Header header = commonHeader(map, meta);
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    header.insert("Gwy::ZScale", Imf::DoubleAttribute(1.0));
    header.insert("Gwy::ZUnit", Imf::StringAttribute(oneLine(meta.unit)));
    header.insert("Gwy::Title", Imf::StringAttribute(oneLine(meta.title)));
    insertMetadata(header, meta);
    return header;
}

Imf::Header headerOfImages(std::span<const WrittenImage> images) {
    Imf::Header header = commonHeader(images.front().rows, images.front().meta);
    for (const WrittenImage& image : images) {
        const std::string name = oneLine(image.meta.title);
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        header.insert(kExrUnitOf + name, Imf::StringAttribute(oneLine(image.meta.unit)));
    }
    insertMetadata(header, images.front().meta);
    return header;
}

/// A row of a channel that is written next.
class ExrLine {
public:
    explicit ExrLine(int columns) : values_(static_cast<std::size_t>(columns)) {}

    void addTo(Imf::FrameBuffer& frame, const std::string& name) {
        constexpr std::size_t kSameForAllRows = 0;
        frame.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values_.data()),
                                      sizeof(float), kSameForAllRows));
    }
    void take(const std::vector<double>& values) {
        std::ranges::transform(values, values_.begin(),
                               [](double value) { return static_cast<float>(value); });
    }

private:
    std::vector<float> values_;
};

/// @param take (row, values of the first channel): fills the lines of `frame`
template <class Take>
void writeLines(const std::filesystem::path& target, const Imf::Header& header,
                const Imf::FrameBuffer& frame, const HeightRows& first, Progress* progress,
                const Take& take) {
    std::ofstream stream(target, std::ios::binary);
    Imf::StdOFStream output(stream, target.c_str());
    try {
        Imf::OutputFile file(output, header);
        file.setFrameBuffer(frame);
        forEachRow(first, progress, [&](int row, const std::vector<double>& values) {
            take(row, values);
            file.writePixels(1);
        });
    } catch (const Iex::ErrnoExc&) {
        throw Error(kStoppedHalfWay);  // its own words name the temporary file
    }
    finish(stream);  // the library writes the offsets of the lines last, and hides that it cannot
}

}  // namespace

void writeExr(const std::filesystem::path& target, const HeightRows& map, const HeightMapMeta& meta,
              Progress* progress) {
    ExrLine line(map.columns);
    Imf::FrameBuffer frame;
    line.addTo(frame, "Y");
    writeLines(target, headerOfMap(map, meta), frame, map, progress,
               [&line](int, const std::vector<double>& heights) { line.take(heights); });
}

void writeExrImages(const std::filesystem::path& target, std::span<const WrittenImage> images,
                    Progress* progress) {
    const HeightRows& first = images.front().rows;
    std::vector<ExrLine> lines(images.size(), ExrLine(first.columns));
    Imf::FrameBuffer frame;
    for (std::size_t i = 0; i < images.size(); ++i) {
        lines[i].addTo(frame, oneLine(images[i].meta.title));
    }
    std::vector<double> values(static_cast<std::size_t>(first.columns));
    writeLines(target, headerOfImages(images), frame, first, progress,
               [&](int row, const std::vector<double>& firstValues) {
                   lines.front().take(firstValues);
                   for (std::size_t i = 1; i < images.size(); ++i) {
                       images[i].rows.readRow(row, values.data());
                       lines[i].take(values);
                   }
               });
}

}  // namespace asperity
