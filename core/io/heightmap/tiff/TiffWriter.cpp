#include "core/io/heightmap/tiff/TiffWriter.h"

#include "core/Error.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeightCounts.h"
#include "core/io/heightmap/HeightMapEncoders.h"

#include <algorithm>
#include <array>
#include <cstdarg>
#include <memory>
#include <tiffio.h>

// A TIFF of float32, heights in meters, or of counts whose scale stands in the description. The
// resolution tags are rounded fractions, so that the description repeats the size in full. Source:
// docs/formats.md 9.

namespace asperity {

namespace {

struct CloseTiffOutput {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
struct FreeOutputOptions {
    void operator()(TIFFOpenOptions* options) const { TIFFOpenOptionsFree(options); }
};

/// What failed is said once, in our words; the library would print its own.
int ignoreError(TIFF* /*tiff*/, void* /*data*/, const char* /*module*/, const char* /*format*/,
                va_list /*arguments*/) {
    return 1;
}

constexpr double kCentimeter = 0.01;
constexpr double kMaxRational = 4294967295.0;
/// Beyond this many bytes of samples the 32-bit offsets of a classic TIFF do not reach.
constexpr std::size_t kClassicLimit = 4'000'000'000U;

/// What our reader calls tags of other programs.
constexpr std::array<std::string_view, 3> kOwnNames = {"description", "software", "date"};

/// Our reader takes 65536 bytes of a description.
constexpr std::size_t kMaxTiffMetadata = 40000;

/// How a height is stored.
enum class Samples { Floats, Counts };

std::string description(const HeightRows& map, const HeightMapMeta& meta, const ImageKeys& scale) {
    std::string text =
        "Gwy::Title=" + oneLine(meta.title) + "\nGwy::XReal=" + exactText(map.sizeX()) +
        "\nGwy::YReal=" + exactText(map.sizeY()) + "\nGwy::XOffset=" + exactText(meta.originX) +
        "\nGwy::YOffset=" + exactText(meta.originY) + "\nGwy::XYUnit=m\n";
    for (const auto& [key, value] : scale) {
        text.append(key).append("=").append(value).append("\n");
    }
    return text + metadataLines(meta, "=", kOwnNames, kMaxTiffMetadata);
}

void setResolution(TIFF* tiff, const HeightRows& map) {
    const double perCentimeterX = kCentimeter / map.pitchX;
    const double perCentimeterY = kCentimeter / map.pitchY;
    if (std::max(perCentimeterX, perCentimeterY) < kMaxRational) {
        TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_CENTIMETER);
        TIFFSetField(tiff, TIFFTAG_XRESOLUTION, perCentimeterX);
        TIFFSetField(tiff, TIFFTAG_YRESOLUTION, perCentimeterY);
    }
}

void setTags(TIFF* tiff, const HeightRows& map, Samples samples) {
    const bool isFloat = samples == Samples::Floats;
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(map.columns));
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(map.rows));
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, isFloat ? 32 : 16);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, isFloat ? SAMPLEFORMAT_IEEEFP : SAMPLEFORMAT_UINT);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_NONE);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, TIFFDefaultStripSize(tiff, 0));
    setResolution(tiff, map);
}

using TiffOutput = std::unique_ptr<TIFF, CloseTiffOutput>;

/// @param sampleBytes of a pixel
TiffOutput created(const std::filesystem::path& target, const HeightRows& map,
                   std::size_t sampleBytes) {
    const std::size_t pixels =
        static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows);
    const bool big = pixels > kClassicLimit / sampleBytes;
    const std::unique_ptr<TIFFOpenOptions, FreeOutputOptions> options(TIFFOpenOptionsAlloc());
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), ignoreError, nullptr);
    TiffOutput tiff(TIFFOpenExt(target.c_str(), big ? "w8" : "w", options.get()));
    if (!tiff) {
        throw Error("the TIFF library cannot open the file");
    }
    return tiff;
}

/// @param sampleOf (height) -> stored number
template <class Sample, class SampleOf>
void writeSamples(TIFF* tiff, const HeightRows& map, Progress* progress, const SampleOf& sampleOf) {
    std::vector<Sample> line(static_cast<std::size_t>(map.columns));
    forEachRow(map, progress, [&](int row, const std::vector<double>& heights) {
        std::ranges::transform(heights, line.begin(), sampleOf);
        if (TIFFWriteScanline(tiff, line.data(), static_cast<std::uint32_t>(row), 0) != 1) {
            throw Error(kStoppedHalfWay);
        }
    });
    if (TIFFWriteDirectory(tiff) != 1) {
        throw Error(kStoppedHalfWay);
    }
}

}  // namespace

void writeTiff(const std::filesystem::path& target, const HeightRows& map,
               const HeightMapMeta& meta, Progress* progress) {
    const TiffOutput tiff = created(target, map, sizeof(float));
    setTags(tiff.get(), map, Samples::Floats);
    const std::string text = description(map, meta, {{"Gwy::ZUnit", oneLine(meta.unit)}});
    TIFFSetField(tiff.get(), TIFFTAG_IMAGEDESCRIPTION, text.c_str());
    writeSamples<float>(tiff.get(), map, progress,
                        [](double height) { return static_cast<float>(height); });
}

void writeTiffCounts(const std::filesystem::path& target, const HeightRows& map,
                     const HeightMapMeta& meta, Progress* progress) {
    ProgressPart ranging(progress, 0.0, 0.2);
    const HeightCounts counts(heightRange(map, &ranging));
    const TiffOutput tiff = created(target, map, sizeof(std::uint16_t));
    setTags(tiff.get(), map, Samples::Counts);
    const std::string text = description(map, meta, counts.keys(oneLine(meta.unit)));
    TIFFSetField(tiff.get(), TIFFTAG_IMAGEDESCRIPTION, text.c_str());
    ProgressPart writing(progress, 0.2, 1.0);
    writeSamples<std::uint16_t>(tiff.get(), map, &writing,
                                [&counts](double height) { return counts.countOf(height); });
}

}  // namespace asperity
