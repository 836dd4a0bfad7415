#include "core/Error.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/ImageScale.h"
#include "core/io/heightmap/png/PngDecoder.h"
#include "core/io/heightmap/png/PngWriter.h"

#include <algorithm>

// A PNG of 16-bit gray, whose texts may give size and heights as Gwyddion writes them. Gamma and
// color profiles are for screens and change no height. Source: docs/formats.md 9.

namespace asperity {

namespace {

constexpr int kGray = 0;
constexpr int kPalette = 3;
constexpr int kTransparentGray = 4;
constexpr int kPngBits = 16;

void requireHeights(const ByteSource& bytes, const PngHeader& header) {
    const bool isGray = header.color == kGray || header.color == kTransparentGray;
    if (isGray && header.bits == kPngBits) {
        return;
    }
    const std::string what = header.color == kPalette ? "a picture in false colors (palette)"
                             : !isGray
                                 ? "a color picture"
                                 : "a picture of " + std::to_string(header.bits) + "-bit gray";
    throw InputError(bytes.name(), "IHDR",
                     "this is " + what +
                         ", no height map: its pixels are no heights. One of 16-bit gray is "
                         "expected");
}

/// No data are packed better than this.
void requirePlausible(const ByteSource& bytes, const PngHeader& header) {
    constexpr std::uint64_t kPngMaxRatio = 1100;
    if (header.size.pixels() * sizeof(std::uint16_t) / kPngMaxRatio > header.packedBytes) {
        throw InputError(bytes.name(), "IDAT",
                         "its " + std::to_string(header.packedBytes) + " bytes cannot hold " +
                             std::to_string(header.size.columns) + " x " +
                             std::to_string(header.size.rows) + " pixels; the file is damaged");
    }
}

StoredScan readPng(const ByteSource& bytes) {
    const PngHeader header = readPngChunks(bytes);
    requireHeights(bytes, header);
    requirePlausible(bytes, header);
    const ImageScale scale = gwyScale(header.texts.all(), SampleType::UInt16, bytes.name(), "text");
    StoredChannel stored = scaledChannel(
        scale, header.size,
        rowsOfDecoded([&bytes, header] { return decodePng(bytes, header); },
                      {.size = header.size, .type = SampleType::UInt16, .order = ByteOrder::Big},
                      bytes.name()),
        "gray", bytes.name());
    if (header.color == kTransparentGray) {
        stored.channel.notes.emplace_back("its transparency is not used");
    }
    StoredScan result;
    result.texts.add(header.texts);
    result.channels.push_back(std::move(stored));
    result.provenance = {{"format", "PNG, 16-bit gray", "IHDR"},
                         {"orientation", "first stored row on top", "order of rows in PNG"}};
    return result;
}

constexpr std::array<std::string_view, 1> kPngExtensions{".png"};

}  // namespace

const HeightMapFormat kPngFormat = {.name = "PNG",
                                    .extensions = kPngExtensions,
                                    .recognizes = isPng,
                                    .read = readPng,
                                    .write = writePng};

}  // namespace asperity
