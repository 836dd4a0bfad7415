#include "core/Error.h"
#include "core/io/MemoryLimit.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeaderFields.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/io/heightmap/HeightStatistics.h"
#include "core/io/heightmap/ImageScale.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/heightmap/WholeImages.h"
#include "core/io/heightmap/tiff/TiffDirectory.h"
#include "core/io/heightmap/tiff/TiffImage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <memory>
#include <tiffio.h>
#include <utility>

// TIFF of any program: each image of one 16-bit, 32-bit or floating-point number a pixel is a
// channel; pictures are none. Formats of instruments that are TIFFs, too, come first. Written are
// float32, heights in meters, or counts whose scale is in the description. The resolution tags are
// rounded fractions, so that the description repeats the size in full. Source: docs/formats.md 9.

namespace asperity {

namespace {

/// Lines "key=value".
ImageTexts lines(std::string_view text) {
    ImageTexts texts;
    for (const std::string_view line : linesOf(text)) {
        const std::size_t equals = line.find('=');
        if (equals != std::string_view::npos) {
            texts.emplace(trimmed(line.substr(0, equals)), trimmed(line.substr(equals + 1)));
        }
    }
    return texts;
}

/// Texts and numbers of `{"key": "text", "key": 1.5}`; nothing within them is looked at.
ImageTexts members(std::string_view text) {
    ImageTexts texts;
    std::size_t open = text.find('"');
    while (open != std::string_view::npos) {
        const std::size_t close = text.find('"', open + 1);
        const std::size_t start = text.find_first_not_of(" :\t\r\n", close + 1);
        if (close == std::string_view::npos || start == std::string_view::npos) {
            return texts;
        }
        const bool quoted = text[start] == '"';
        const std::size_t first = start + (quoted ? 1 : 0);
        const std::size_t end =
            std::min(text.find_first_of(quoted ? "\"" : ",}]", first), text.size());
        texts.emplace(text.substr(open + 1, close - open - 1),
                      trimmed(text.substr(first, end - first)));
        open = text.find('"', end + (quoted ? 1 : 0));
    }
    return texts;
}

std::string textIn(const ImageTexts& texts, const std::string& key) {
    const auto found = texts.find(key);
    return found == texts.end() ? std::string() : found->second;
}

std::optional<double> numberIn(const ImageTexts& texts, const std::string& key) {
    return parseNumber(textIn(texts, key));
}

bool isUnsigned(SampleType type) {
    return type == SampleType::UInt16 || type == SampleType::UInt32;
}

/// Reads what tifffile was given: `unit` and `quantity` of the values, or the heights of both ends.
ImageScale bracedScale(const ImageTexts& texts, SampleType type) {
    ImageScale scale;
    scale.title = textIn(texts, "quantity");
    const std::optional<double> lowest = numberIn(texts, "zmin_m");
    const std::optional<double> highest = numberIn(texts, "zmax_m");
    if (lowest && highest && isUnsigned(type)) {
        scale.unit = "m";
        setEnds(scale, type, *lowest, *highest, "description, zmin_m and zmax_m");
    } else if (!textIn(texts, "unit").empty()) {
        const PhysicalUnit unit = parseUnit(textIn(texts, "unit"));
        scale.unit = unit.base;
        scale.factor = unit.factor;
        scale.provenance.push_back(scaleProvenance(unit.factor, unit.base, "description, unit"));
    }
    return scale;
}

/// ImageJ's words for a unit, of which some are its own.
PhysicalUnit imageJUnit(const std::string& text) {
    if (lowerCase(text).starts_with("micron") || text == "\\u00B5m") {
        return parseUnit("um");
    }
    return parseUnit(text);
}

/// ImageJ calibrates values by a straight line (cf = 0): c0 + c1 * count.
ImageScale imageJScale(const ImageTexts& texts) {
    constexpr double kStraightLine = 0.0;
    ImageScale scale;
    const PhysicalUnit unit = imageJUnit(textIn(texts, "vunit"));
    const std::optional<double> offset = numberIn(texts, "c0");
    const std::optional<double> slope = numberIn(texts, "c1");
    const bool isNumber = unit.base.empty() || lowerCase(unit.base) == "gray value";
    if (!isNumber && numberIn(texts, "cf") == kStraightLine && offset && slope) {
        scale.unit = unit.base;
        scale.factor = *slope * unit.factor;
        scale.offset = *offset * unit.factor;
        scale.provenance.push_back({"scale",
                                    exactText(scale.factor) + " " + scale.unit + " per count, " +
                                        exactText(scale.offset) + " at 0",
                                    "ImageJ's c0, c1 and vunit"});
    }
    return scale;
}

/// Unit of the resolution [m]; empty when it is none.
PhysicalUnit resolutionUnit(const TiffDirectory& directory, const ImageTexts& imageJ) {
    constexpr std::int64_t kNone = 1;
    constexpr std::int64_t kInch = 2;
    constexpr std::int64_t kCentimeter = 3;
    const std::int64_t unit = directory.integer(number(TiffTag::ResolutionUnit)).value_or(kInch);
    const std::string named = textIn(imageJ, "unit");
    if (!named.empty() && unit != kCentimeter && (unit == kNone || named != "inch")) {
        return imageJUnit(named);
    }
    if (unit == kCentimeter) {
        return {0.01, "m"};
    }
    return unit == kInch ? PhysicalUnit{0.0254, "m"} : PhysicalUnit{1.0, ""};
}

void takeResolution(ImageScale& scale, const TiffDirectory& directory, const ImageTexts& imageJ,
                    ImageSize size) {
    // Printers have pixels of 10 um and more, and programs that know no size state such ones.
    constexpr double kMinPrintPitch = 10e-6;
    const std::optional<double> across = directory.number(number(TiffTag::XResolution));
    const std::optional<double> down = directory.number(number(TiffTag::YResolution));
    if (!across || !down) {
        return;
    }
    const PhysicalUnit unit = resolutionUnit(directory, imageJ);
    const double pitchX = unit.factor / *across;
    const double pitchY = unit.factor / *down;
    const bool stated = unit.base == "m" && pitchX > 0.0 && pitchY > 0.0;
    if (!stated || !std::isfinite(pitchX) || !std::isfinite(pitchY)) {
        return;
    }
    if (std::max(pitchX, pitchY) >= kMinPrintPitch && textIn(imageJ, "unit").empty()) {
        scale.notes.emplace_back("its resolution is that of a print and says nothing of the scan");
        return;
    }
    scale.lateralUnit = "m";
    scale.sizeX = pitchX * size.columns;
    scale.sizeY = pitchY * size.rows;
    scale.sizeSource = "XResolution, YResolution";
}

/// The metadata of our own files: the description's lines besides the scale.
ImageTexts tiffMetadata(const TiffDirectory& directory) {
    const std::string text = directory.text(number(TiffTag::ImageDescription));
    if (!text.starts_with("Gwy::")) {
        return {};
    }
    ImageTexts texts = lines(text);
    std::erase_if(texts, [](const auto& entry) {
        return entry.first.starts_with("Gwy::") || entry.first == kNoDataKey;
    });
    return texts;
}

/// Returns the scale that an image's description and resolution state: Gwyddion's keys, a line
/// each, as our own files have them; ImageJ's, or those of tifffile in braces. The resolution is
/// the lateral size, unless it is that of a print. Source: docs/formats.md 9.
/// @param type of the samples
/// @throw InputError when a number of Gwyddion's keys is none
ImageScale tiffScale(const TiffDirectory& directory, ImageSize size, SampleType type) {
    const std::string text = directory.text(number(TiffTag::ImageDescription));
    const ImageTexts texts = lines(text);
    const bool isImageJ = text.starts_with("ImageJ=");
    ImageScale scale;
    if (text.find("Gwy::") != std::string::npos) {
        scale = gwyScale(texts, type, directory.bytes().name(), "description,");
    } else if (isImageJ) {
        scale = imageJScale(texts);
    } else if (text.starts_with("{")) {
        scale = bracedScale(members(text), type);
    }
    const bool hasSize = scale.sizeX > 0.0 && scale.sizeY > 0.0;
    if (!hasSize) {
        takeResolution(scale, directory, isImageJ ? texts : ImageTexts(), size);
    }
    return scale;
}

struct CloseTiffOutput {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
struct FreeOutputOptions {
    void operator()(TIFFOpenOptions* options) const { TIFFOpenOptionsFree(options); }
};

/// A failure is reported once, in our words; the library would print its own.
int ignoreError(TIFF* /*tiff*/, void* /*data*/, const char* /*module*/, const char* /*format*/,
                va_list /*arguments*/) {
    return 1;
}

constexpr double kCentimeter = 0.01;
constexpr double kMaxRational = 4294967295.0;
/// Beyond this many bytes of samples the 32-bit offsets of a classic TIFF do not reach.
constexpr std::size_t kClassicLimit = 4'000'000'000U;

/// Names of our reader for tags of other programs.
constexpr std::array<std::string_view, 3> kOwnNames = {"description", "software", "date"};

/// Our reader accepts 65536 bytes of a description.
constexpr std::size_t kMaxTiffMetadata = 40000;

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

/// See HeightMapFormat::write.
void writeTiff(const std::filesystem::path& target, const HeightRows& map,
               const HeightMapMeta& meta, Progress* progress) {
    const TiffOutput tiff = created(target, map, sizeof(float));
    setTags(tiff.get(), map, Samples::Floats);
    const std::string text = description(map, meta, {{"Gwy::ZUnit", oneLine(meta.unit)}});
    TIFFSetField(tiff.get(), TIFFTAG_IMAGEDESCRIPTION, text.c_str());
    writeSamples<float>(tiff.get(), map, progress,
                        [](double height) { return static_cast<float>(height); });
}

/// The `write` of kTiffCountsFormat.
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

/// Describes a picture that is no height map.
std::string pictureWords(const TiffPixel& pixel) {
    constexpr std::int64_t kPalette = 3;
    constexpr std::int64_t kPictureBits = 8;
    if (pixel.photometric == kPalette) {
        return "a picture in false colors (palette)";
    }
    if (!pixel.isGray()) {
        return "a color picture";
    }
    if (pixel.bits <= kPictureBits) {
        return "a picture of " + std::to_string(pixel.bits) + "-bit gray";
    }
    return "an image of " + std::to_string(pixel.bits) + "-bit samples of format " +
           std::to_string(pixel.format);
}

/// Values of the tag Orientation, column 0 at the left.
constexpr std::int64_t kTopFirst = 1;
constexpr std::int64_t kBottomFirst = 4;

class TiffReader {
public:
    explicit TiffReader(const ByteSource& bytes)
        : bytes_(bytes), directories_(readTiffDirectories(bytes, &images_)) {}

    StoredScan read() {
        leaveOutCut(directories_, images_,
                    [](const TiffDirectory& directory) { return directory.name(); });
        requireBlocks(directories_);
        for (const TiffDirectory& directory : directories_) {
            if (!isReducedCopy(directory)) {
                addImage(directory);
            }
        }
        images_.finish(result_);
        if (result_.channels.empty()) {
            throw InputError(bytes_.name(), "image 1",
                             "this is " + pictureWords(tiffPixel(directories_.front())) +
                                 ", no height map: its pixels are no heights. One of 16-bit or "
                                 "32-bit integers, or of floats is expected");
        }
        result_.provenance.push_back({"format", "TIFF", "header"});
        return std::move(result_);
    }

private:
    /// A smaller copy of another image, for a quick look.
    static bool isReducedCopy(const TiffDirectory& directory) {
        return (directory.integer(number(TiffTag::NewSubfileType)).value_or(0) & 1) != 0;
    }

    void addImage(const TiffDirectory& directory) {
        const TiffPixel pixel = tiffPixel(directory);
        const std::optional<SampleType> type = sampleTypeOf(pixel);
        if (!pixel.isGray() || !type) {
            result_.notes.push_back(directory.name() + " is " + pictureWords(pixel) +
                                    " and was left out");
            return;
        }
        const TiffImage image = tiffImage(directory, *type);
        decoded_ += image.decodedBytes();
        requireUsualPacking(decoded_, bytes_.size(), bytes_.name(), directory.name());
        ImageScale scale = tiffScale(directory, image.size, *type);
        if (pixel.isInverted()) {
            invert(scale, *type);
        }
        const std::int64_t orientation =
            directory.integer(number(TiffTag::Orientation)).value_or(kTopFirst);
        StoredChannel stored =
            scaledChannel(scale, image.size, rowsOf(directory, image, orientation == kBottomFirst),
                          nameOf(directory, scale), bytes_.name());
        addOrientation(stored.channel, orientation);
        addMetadata(directory, stored.channel);
        result_.channels.push_back(std::move(stored));
    }

    static void addOrientation(ScanChannel& channel, std::int64_t orientation) {
        channel.provenance.push_back({"orientation",
                                      orientation == kBottomFirst ? "first stored row at the bottom"
                                                                  : "first stored row on top",
                                      "Orientation " + std::to_string(orientation)});
        if (orientation != kTopFirst && orientation != kBottomFirst) {
            channel.notes.push_back("its orientation " + std::to_string(orientation) +
                                    " is not applied: the image may be turned or mirrored");
        }
    }

    /// Returns the name of an image without a title.
    [[nodiscard]] std::string nameOf(const TiffDirectory& directory,
                                     const ImageScale& scale) const {
        const std::string what = scale.unit == "m" ? "height" : "gray";
        return directories_.size() == 1 ? what : what + ", " + directory.name();
    }

    void addMetadata(const TiffDirectory& directory, ScanChannel& channel) {
        BoundedTexts kept(TextQuota::ofEach(directories_.size()));
        kept.add(tiffMetadata(directory));
        const std::pair<const char*, TiffTag> texts[] = {{"description", TiffTag::ImageDescription},
                                                         {"software", TiffTag::Software},
                                                         {"date", TiffTag::DateTime}};
        for (const auto& [key, tag] : texts) {
            const std::string text(trimmed(directory.text(number(tag))));
            if (!text.empty()) {
                kept.add(key, text);
            }
        }
        channel.metadata = kept.all();
        result_.hasCutTexts = result_.hasCutTexts || kept.isCut();
    }

    const ByteSource& bytes_;
    WholeImages images_;
    std::vector<TiffDirectory> directories_;
    std::uint64_t decoded_ = 0;  ///< bytes of the images so far
    StoredScan result_;
};

constexpr std::array<std::string_view, 2> kTiffExtensions{".tiff", ".tif"};

}  // namespace

const HeightMapFormat kTiffFormat = {
    .name = "TIFF",
    .extensions = kTiffExtensions,
    .recognizes = isTiff,
    .read = [](const ByteSource& bytes) { return TiffReader(bytes).read(); },
    .write = writeTiff};

const HeightMapFormat kTiffCountsFormat = {
    .name = "TIFF, 16-bit", .extensions = kTiffExtensions, .write = writeTiffCounts};

}  // namespace asperity
