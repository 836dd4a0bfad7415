#include "core/io/heightmap/tiff/TiffWriter.h"

#include "core/Error.h"
#include "core/io/TextValue.h"

#include <algorithm>
#include <memory>
#include <tiffio.h>

// A float32 TIFF, heights in meters. The resolution tags are rounded fractions, so that the
// description repeats the size in full. Source: docs/formats.md 9.

namespace asperity {

namespace {

struct CloseTiff {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};

constexpr double kCentimeter = 0.01;
constexpr double kMaxRational = 4294967295.0;
/// Beyond this many bytes of samples the 32-bit offsets of a classic TIFF do not reach.
constexpr std::size_t kClassicLimit = 4'000'000'000U;

std::string description(const HeightRows& map, const HeightMapMeta& meta) {
    return "Gwy::Title=" + meta.title + "\nGwy::XReal=" + exactText(map.sizeX()) +
           "\nGwy::YReal=" + exactText(map.sizeY()) + "\nGwy::XOffset=" + exactText(meta.originX) +
           "\nGwy::YOffset=" + exactText(meta.originY) +
           "\nGwy::XYUnit=m\nGwy::ZUnit=" + meta.unit + "\n";
}

void setTags(TIFF* tiff, const HeightRows& map, const HeightMapMeta& meta) {
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(map.columns));
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(map.rows));
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 32);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_NONE);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, TIFFDefaultStripSize(tiff, 0));
    const double perCentimeterX = kCentimeter / map.pitchX;
    const double perCentimeterY = kCentimeter / map.pitchY;
    if (std::max(perCentimeterX, perCentimeterY) < kMaxRational) {
        TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_CENTIMETER);
        TIFFSetField(tiff, TIFFTAG_XRESOLUTION, perCentimeterX);
        TIFFSetField(tiff, TIFFTAG_YRESOLUTION, perCentimeterY);
    }
    TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, description(map, meta).c_str());
}

}  // namespace

void writeTiff(const std::filesystem::path& target, const HeightRows& map,
               const HeightMapMeta& meta, Progress* progress) {
    const auto columns = static_cast<std::size_t>(map.columns);
    const bool big = columns * static_cast<std::size_t>(map.rows) > kClassicLimit / sizeof(float);
    const std::unique_ptr<TIFF, CloseTiff> tiff(TIFFOpen(target.c_str(), big ? "w8" : "w"));
    if (!tiff) {
        throw Error("the TIFF library cannot open the file");
    }
    setTags(tiff.get(), map, meta);
    std::vector<float> line(columns);
    forEachRow(map, progress, [&](int row, const std::vector<double>& heights) {
        std::ranges::transform(heights, line.begin(),
                               [](double height) { return static_cast<float>(height); });
        if (TIFFWriteScanline(tiff.get(), line.data(), static_cast<std::uint32_t>(row), 0) != 1) {
            throw Error("the TIFF library stopped at row " + std::to_string(row));
        }
    });
    if (TIFFWriteDirectory(tiff.get()) != 1) {
        throw Error("the TIFF library cannot finish the file");
    }
}

}  // namespace asperity
