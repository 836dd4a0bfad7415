#include "core/Error.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/WholeImages.h"
#include "core/io/heightmap/tiff/TiffDescription.h"
#include "core/io/heightmap/tiff/TiffImage.h"
#include "core/io/heightmap/tiff/TiffWriter.h"

#include <utility>

// TIFF of any program: each image of one 16-bit, 32-bit or floating-point number a pixel is a
// channel; pictures are none. Formats of instruments that are TIFFs, too, go first.
// Source: docs/formats.md 9.

namespace asperity {

namespace {

/// What a picture is that is no height map.
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

    /// Of an image without a title.
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
