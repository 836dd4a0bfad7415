
#include "core/io/heightmap/exr/ExrWriter.h"

#include "core/io/heightmap/HeightMapEncoders.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <algorithm>

// OpenEXR with one float channel Y, heights in meters, and Gwyddion's attributes. Half floats would
// turn 20 nm into 0. Source: docs/formats.md 9.

namespace asperity {

namespace {

Imf::Header header(const HeightRows& map, const HeightMapMeta& meta) {
    Imf::Header header(map.columns, map.rows);
    header.compression() = Imf::ZIP_COMPRESSION;
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    header.insert("Gwy::XReal", Imf::DoubleAttribute(map.sizeX()));
    header.insert("Gwy::YReal", Imf::DoubleAttribute(map.sizeY()));
    header.insert("Gwy::XOffset", Imf::DoubleAttribute(meta.originX));
    header.insert("Gwy::YOffset", Imf::DoubleAttribute(meta.originY));
    header.insert("Gwy::ZScale", Imf::DoubleAttribute(1.0));
    header.insert("Gwy::XYUnit", Imf::StringAttribute("m"));
    header.insert("Gwy::ZUnit", Imf::StringAttribute(meta.unit));
    header.insert("Gwy::Title", Imf::StringAttribute(meta.title));
    constexpr std::size_t kMaxName = 255;
    for (const auto& [name, value] : writtenMetadata(meta)) {
        // Some names are the format's own.
        if (name.size() <= kMaxName && header.find(name) == header.end()) {
            header.insert(name, Imf::StringAttribute(value));
        }
    }
    return header;
}

}  // namespace

void writeExr(const std::filesystem::path& target, const HeightRows& map, const HeightMapMeta& meta,
              Progress* progress) {
    std::vector<float> line(static_cast<std::size_t>(map.columns));
    constexpr std::size_t kSameForAllRows = 0;
    Imf::FrameBuffer frame;
    frame.insert("Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(line.data()), sizeof(float),
                                 kSameForAllRows));
    Imf::OutputFile file(target.c_str(), header(map, meta));
    file.setFrameBuffer(frame);
    forEachRow(map, progress, [&](int, const std::vector<double>& heights) {
        std::ranges::transform(heights, line.begin(),
                               [](double height) { return static_cast<float>(height); });
        file.writePixels(1);
    });
}

}  // namespace asperity
