#include "core/io/fields/PatchExr.h"

#include "core/Error.h"
#include "core/TemporaryFile.h"

#include <OpenEXR/IexErrnoExc.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStdIO.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <array>
#include <exception>
#include <fstream>
#include <vector>

namespace asperity {

namespace {

/// Channel names in the order in which samplesOf() fills them.
constexpr std::array<const char*, 8> kChannels{"height",         "rest.height",    "displacement.x",
                                               "displacement.y", "displacement.z", "normal.x",
                                               "normal.y",       "normal.z"};

std::array<double, kChannels.size()> samplesOf(const SurfacePatch& patch, std::size_t i) {
    const Vector3 displacement = patch.points[i] - patch.rest[i];
    const Vector3& normal = patch.normals[i];
    return {patch.points[i].z(), patch.rest[i].z(), displacement.x(), displacement.y(),
            displacement.z(),    normal.x(),        normal.y(),       normal.z()};
}

/// One plane a channel, top row first.
std::array<std::vector<float>, kChannels.size()> planesOf(const SurfacePatch& patch) {
    std::array<std::vector<float>, kChannels.size()> planes;
    for (std::vector<float>& plane : planes) {
        plane.resize(patch.points.size());
    }
    for (int row = 0; row < patch.rows; ++row) {
        for (int column = 0; column < patch.columns; ++column) {
            const auto values = samplesOf(patch, patch.index(patch.rows - 1 - row, column));
            for (std::size_t c = 0; c < planes.size(); ++c) {
                planes[c][patch.index(row, column)] = static_cast<float>(values[c]);
            }
        }
    }
    return planes;
}

Imf::Header headerOf(const SurfacePatch& patch) {
    Imf::Header header(patch.columns, patch.rows);
    const Vector3& first = patch.rest.front();
    const Vector3& last = patch.rest.back();
    for (const char* name : kChannels) {
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    }
    header.insert("originX", Imf::DoubleAttribute(first.x()));
    header.insert("originY", Imf::DoubleAttribute(first.y()));
    header.insert("sizeX", Imf::DoubleAttribute(last.x() - first.x()));
    header.insert("sizeY", Imf::DoubleAttribute(last.y() - first.y()));
    header.insert("units", Imf::StringAttribute("m"));
    return header;
}

void write(const std::filesystem::path& path, const Imf::Header& header,
           const Imf::FrameBuffer& frame, int rows) {
    constexpr const char* kStopped = "writing stopped half-way (disk full?)";
    std::ofstream stream(path, std::ios::binary);
    Imf::StdOFStream output(stream, path.c_str());
    try {
        Imf::OutputFile file(output, header);
        file.setFrameBuffer(frame);
        file.writePixels(rows);
    } catch (const Iex::ErrnoExc&) {
        throw Error(kStopped);  // its own words name the temporary file
    }
    stream.close();
    if (!stream) {
        throw Error(kStopped);
    }
}

}  // namespace

void writePatchExr(const std::filesystem::path& path, const SurfacePatch& patch) {
    auto planes = planesOf(patch);
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < planes.size(); ++c) {
        frame.insert(kChannels[c],
                     Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(planes[c].data()),
                                sizeof(float),
                                sizeof(float) * static_cast<std::size_t>(patch.columns)));
    }
    const TemporaryFile temporary(path);
    try {
        write(temporary.path(), headerOf(patch), frame, patch.rows);
    } catch (const std::exception& error) {
        throw Error(path.string() + ": cannot be written: " + error.what());
    }
    temporary.commit();
}

}  // namespace asperity
