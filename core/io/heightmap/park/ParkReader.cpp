#include "core/Error.h"
#include "core/Units.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/ImageScale.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/heightmap/ScanImage.h"
#include "core/io/heightmap/tiff/TiffImage.h"

#include <bit>
#include <utility>

// Park Systems (PSIA): a TIFF whose image is a small picture; a private tag holds the samples, and
// another one a header of numbers at fixed offsets, both with the lowest byte first.
// Source: docs/formats.md 8.

namespace asperity {

namespace {

constexpr std::uint16_t kMagicTag = 50432;
constexpr std::uint16_t kVersionTag = 50433;
constexpr std::uint16_t kSamplesTag = 50434;
constexpr std::uint16_t kHeaderTag = 50435;
constexpr std::uint16_t kCommentTag = 50436;
constexpr std::int64_t kParkMagic = 0x0E031301;
constexpr std::int64_t kVersion1 = 0x01000001;
constexpr std::int64_t kVersion2 = 0x01000002;

// Offsets in the header [bytes].
constexpr std::size_t kImageType = 0;
constexpr std::size_t kSource = 4;
constexpr std::size_t kMode = 68;
constexpr std::size_t kParkColumns = 100;
constexpr std::size_t kParkRows = 104;
constexpr std::size_t kParkAngle = 108;  // [deg]
constexpr std::size_t kIsForward = 128;
constexpr std::size_t kIsSwapped = 136;
constexpr std::size_t kParkSizeX = 140;    // [um]
constexpr std::size_t kParkSizeY = 148;    // [um]
constexpr std::size_t kParkOriginX = 156;  // [um]
constexpr std::size_t kParkOriginY = 164;  // [um]
constexpr std::size_t kGain = 220;
constexpr std::size_t kScale = 228;
constexpr std::size_t kParkOffset = 236;
constexpr std::size_t kParkUnit = 244;
constexpr std::size_t kDataType = 348;
constexpr std::uint64_t kHeaderBytes1 = 356;
constexpr std::uint64_t kHeaderBytes2 = 580;

constexpr std::size_t kSourceLength = 32;  // [characters]
constexpr std::size_t kShortLength = 8;    // [characters]

class ParkReader {
public:
    explicit ParkReader(const ByteSource& bytes)
        : bytes_(bytes)
        , directories_(readTiffDirectories(bytes))
        , tags_(directories_.front())
        , header_(headerOf(tags_))
        , samples_(tags_.requireSpan(kSamplesTag)) {}

    StoredScan read() {
        requireBlocks(directories_);
        requireMap();
        const SampleLayout layout = layoutOf();
        StoredChannel stored{.channel = channelOf(layout.size), .readRow = rowsOf(bytes_, layout)};
        takeScale(stored);
        StoredScan result;
        noteRotation(result.notes, at<double>(kParkAngle));
        result.provenance = {{"format version", std::to_string(version_), "tag 50433"},
                             {"orientation", "first stored row at the bottom", "as Park's own"}};
        result.channels.push_back(std::move(stored));
        return result;
    }

private:
    /// @throw InputError when it is of an unknown version, or shorter than that has it
    static std::string headerOf(const TiffDirectory& tags) {
        const std::int64_t version = tags.requireInteger(kVersionTag);
        if (tags.requireInteger(kMagicTag) != kParkMagic ||
            (version != kVersion1 && version != kVersion2)) {
            tags.fail("expected the tags of a Park file of version 1 or 2, found version " +
                      std::to_string(version));
        }
        const std::uint64_t expected = version == kVersion1 ? kHeaderBytes1 : kHeaderBytes2;
        const ByteSpan span = tags.requireSpan(kHeaderTag);
        if (span.count < expected) {
            tags.fail("the header in tag 50435 has " + std::to_string(span.count) +
                      " bytes, expected " + std::to_string(expected));
        }
        return bytesOf(tags.bytes(), {span.offset, expected});
    }

    void requireMap() {
        constexpr std::int32_t kMap = 0;
        constexpr std::int32_t kLine = 1;
        version_ = header_.size() == kHeaderBytes1 ? 1 : 2;
        const auto type = at<std::int32_t>(kImageType);
        if (type != kMap) {
            fail(type == kLine ? "this Park file holds a line profile, no image"
                               : "this Park file holds force curves or other spectra, no image");
        }
    }

    [[nodiscard]] SampleLayout layoutOf() const {
        SampleLayout layout{.size = checkedImageSize(at<std::int32_t>(kParkColumns),
                                                     at<std::int32_t>(kParkRows), bytes_.name(),
                                                     "Park header"),
                            .type = sampleType(),
                            .offset = samples_.offset,
                            .bottomFirst = true};
        if (samples_.count != layout.bytes()) {
            fail("expected " + std::to_string(layout.bytes()) + " bytes for " +
                 std::to_string(layout.size.columns) + " x " + std::to_string(layout.size.rows) +
                 " pixels in tag 50434, found " + std::to_string(samples_.count));
        }
        return layout;
    }

    [[nodiscard]] SampleType sampleType() const {
        constexpr std::array kTypes = {SampleType::Int16, SampleType::Int32, SampleType::Float32};
        const auto type = version_ == 1 ? 0 : at<std::int32_t>(kDataType);
        if (type < 0 || type >= static_cast<std::int32_t>(kTypes.size())) {
            fail("its data are of type " + std::to_string(type) +
                 "; expected 0 (16 bits), 1 (32 bits) or 2 (floats)");
        }
        return kTypes.at(static_cast<std::size_t>(type));
    }

    [[nodiscard]] ScanChannel channelOf(ImageSize size) const {
        ScanChannel channel;
        channel.name = text(kSource, kSourceLength);
        if (channel.name.empty()) {
            channel.name = "Untitled";
        }
        channel.lateralUnit = "m";
        channel.direction = at<std::int32_t>(kIsForward) != 0 ? "forward" : "backward";
        channel.map =
            emptyMap(size, at<double>(kParkSizeX) * 1.0_um, at<double>(kParkSizeY) * 1.0_um);
        setOrigin(channel, at<double>(kParkOriginX) * 1.0_um, at<double>(kParkOriginY) * 1.0_um,
                  GivenPoint::Center);
        channel.metadata = {{"mode", text(kMode, kShortLength)},
                            {"software", tags_.text(number(TiffTag::Software))},
                            {"date", tags_.text(number(TiffTag::DateTime))},
                            {"comment", tags_.text(kCommentTag)}};
        std::erase_if(channel.metadata, [](const auto& entry) { return entry.second.empty(); });
        if (at<std::int32_t>(kIsSwapped) != 0) {
            channel.notes.emplace_back(
                "the instrument scanned with x and y exchanged; the image is as it is stored");
        }
        settleSize(channel, "Park header, bytes 140 and 148");
        return channel;
    }

    /// value = unit * gain * (count * scale + offset); the gain may be negative.
    void takeScale(StoredChannel& stored) const {
        const std::string written = text(kParkUnit, kShortLength);
        const PhysicalUnit unit = parseUnit(written.empty() ? "um" : written);
        const auto gain = at<double>(kGain);
        const double scale = at<double>(kScale) == 0.0 ? 1.0 : at<double>(kScale);
        stored.channel.unit = unit.base;
        setScale(stored, gain * scale * unit.factor, gain * at<double>(kParkOffset) * unit.factor,
                 bytes_.name());
        stored.channel.provenance.push_back(
            {"scale",
             exactText(gain) + " x (" + exactText(scale) + " x count + " +
                 exactText(at<double>(kParkOffset)) + ") " + (written.empty() ? "um" : written),
             written.empty() ? "Park header, bytes 220 to 244; it has no unit: um as usual"
                             : "Park header, bytes 220 to 260"});
    }

    template <typename Number>
    [[nodiscard]] Number at(std::size_t offset) const {
        return littleEndian<Number>(header_.data() + offset);
    }

    /// @param length [characters]
    [[nodiscard]] std::string text(std::size_t offset, std::size_t length) const {
        const std::string all =
            utf16ToUtf8(std::string_view(header_).substr(offset, 2 * length), std::endian::little);
        return std::string(trimmed(std::string_view(all).substr(0, all.find('\0'))));
    }

    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(bytes_.name(), "Park header", what);
    }

    const ByteSource& bytes_;
    std::vector<TiffDirectory> directories_;
    const TiffDirectory& tags_;
    std::string header_;
    ByteSpan samples_;
    int version_ = 2;
};

constexpr std::array<std::string_view, 2> kParkExtensions{".tiff", ".tif"};

}  // namespace

const HeightMapFormat kParkFormat = {
    .name = "Park Systems TIFF",
    .extensions = kParkExtensions,
    .recognizes = [](const ByteSource& bytes) { return isTiffWithTag(bytes, kMagicTag); },
    .read = [](const ByteSource& bytes) { return ParkReader(bytes).read(); }};

}  // namespace asperity
