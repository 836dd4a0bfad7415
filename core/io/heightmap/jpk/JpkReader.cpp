#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/io/MemoryLimit.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/ImageScale.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/heightmap/ScanImage.h"
#include "core/io/heightmap/WholeImages.h"
#include "core/io/heightmap/jpk/JpkSlot.h"
#include "core/io/heightmap/tiff/TiffImage.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

// Images of JPK instruments: a TIFF whose first image is a small picture with the tags of the whole
// scan, and whose further images are channels of counts. Source: docs/formats.md 5.

namespace asperity {

namespace {

// Tags of the whole scan.
constexpr std::uint16_t kJpkVersion = 0x8000;
constexpr std::uint16_t kJpkOriginX = 0x8040;
constexpr std::uint16_t kJpkOriginY = 0x8041;
constexpr std::uint16_t kJpkSizeX = 0x8042;
constexpr std::uint16_t kJpkSizeY = 0x8043;
constexpr std::uint16_t kRotation = 0x8044;
constexpr std::uint16_t kReflect = 0x8045;
constexpr std::array<std::pair<const char*, std::uint16_t>, 9> kTexts = {{{"version", kJpkVersion},
                                                                          {"start date", 0x8003},
                                                                          {"name", 0x8004},
                                                                          {"comment", 0x8005},
                                                                          {"end date", 0x8006},
                                                                          {"probe", 0x8007},
                                                                          {"user", 0x8009},
                                                                          {"instrument", 0x8016},
                                                                          {"mode", 0x8052}}};
// Tags of a channel.
constexpr std::uint16_t kChannel = 0x8050;
constexpr std::uint16_t kRetrace = 0x8051;
constexpr std::uint16_t kFancyName = 0x8052;

/// Limit of a text that is kept.
constexpr std::size_t kJpkMaxText = 4096;

class JpkReader {
public:
    explicit JpkReader(const ByteSource& bytes)
        : bytes_(bytes)
        , directories_(readTiffDirectories(bytes, &images_))
        , scan_(directories_.front()) {}

    StoredScan read() {
        requireImages(directories_.size(), bytes_.name(), "directories");
        // The first one is a picture; it stays where it is.
        std::vector<TiffDirectory> channels(directories_.begin() + 1, directories_.end());
        leaveOutCut(channels, images_, nameOf);
        requireBlocks(channels);
        isReflected_ = scan_.integer(kReflect).value_or(0) != 0;
        for (const auto& [key, tag] : kTexts) {
            if (const std::string text(trimmed(scan_.text(tag))); !text.empty()) {
                result_.texts.add(key, std::string(utf8Start(text, kJpkMaxText)));
            }
        }
        for (const TiffDirectory& directory : channels) {
            if (directory.has(kChannel)) {
                addChannel(directory);
            }
        }
        images_.finish(result_);
        if (result_.channels.empty()) {
            throw InputError(bytes_.name(), "", "this JPK file holds a picture, but no channel");
        }
        describeScan();
        return std::move(result_);
    }

private:
    void addChannel(const TiffDirectory& directory) {
        const TiffPixel pixel = tiffPixel(directory);
        const std::optional<SampleType> type = sampleTypeOf(pixel);
        if (!pixel.isGray() || !type) {
            directory.fail("expected one 16-bit or 32-bit count a pixel, found " +
                           std::to_string(pixel.samples) + " of " + std::to_string(pixel.bits) +
                           " bits");
        }
        const TiffImage image = tiffImage(directory, *type);
        decoded_ += image.decodedBytes();
        requireUsualPacking(decoded_, bytes_.size(), bytes_.name(), directory.name());
        const JpkSlot slot = defaultJpkSlot(directory);
        StoredChannel stored{.channel = channelOf(directory, image.size),
                             .readRow = rowsOf(directory, image, !isReflected_)};
        const PhysicalUnit unit = parseUnit(slot.unit);
        stored.channel.unit = unit.base;
        if (slot.noData) {
            stored.readRow = replaced(std::move(stored.readRow), image.size.columns,
                                      [marker = *slot.noData](double count) {
                                          return count == marker
                                                     ? std::numeric_limits<double>::quiet_NaN()
                                                     : count;
                                      });
        }
        setScale(stored, slot.multiplier * unit.factor, slot.offset * unit.factor, bytes_.name());
        describe(stored.channel, directory, slot);
        result_.channels.push_back(std::move(stored));
    }

    ScanChannel channelOf(const TiffDirectory& directory, ImageSize size) {
        ScanChannel channel;
        channel.direction = directory.integer(kRetrace).value_or(0) != 0 ? "backward" : "forward";
        channel.name = uniqueName(nameOf(directory), channel.direction);
        channel.lateralUnit = "m";
        channel.map = emptyMap(size, scan_.number(kJpkSizeX).value_or(0.0),
                               scan_.number(kJpkSizeY).value_or(0.0));
        setOrigin(channel, scan_.number(kJpkOriginX).value_or(0.0),
                  scan_.number(kJpkOriginY).value_or(0.0), GivenPoint::Corner);
        settleSize(channel, "tags 32834 and 32835");
        return channel;
    }

    static std::string nameOf(const TiffDirectory& directory) {
        const std::string fancy(trimmed(directory.text(kFancyName)));
        return fancy.empty() ? directory.text(kChannel) : fancy;
    }

    [[nodiscard]] bool isTaken(const std::string& name) const {
        return std::ranges::any_of(result_.channels, [&name](const StoredChannel& stored) {
            return stored.channel.name == name;
        });
    }

    /// Names repeat: trace and retrace have the same one, and so may two channels of a force map.
    [[nodiscard]] std::string uniqueName(const std::string& name,
                                         const std::string& direction) const {
        if (!isTaken(name)) {
            return name;
        }
        const std::string directed = name + " (" + direction + ")";
        std::string unique = direction == "backward" ? directed : name;
        for (int number = 2; isTaken(unique); ++number) {
            unique = name + " " + std::to_string(number);
        }
        return unique;
    }

    static void describe(ScanChannel& channel, const TiffDirectory& directory,
                         const JpkSlot& slot) {
        channel.metadata.emplace("channel", directory.text(kChannel));
        if (slot.name.empty()) {
            channel.notes.emplace_back("the file gives no scale of the values; they are counts");
            return;
        }
        channel.metadata.emplace("slot", slot.name);
        channel.provenance.push_back({"scale",
                                      exactText(slot.multiplier) + " " + slot.unit +
                                          " per count, " + exactText(slot.offset) + " " +
                                          slot.unit + " at 0",
                                      directory.name() + ", default slot '" + slot.name + "'"});
        if (slot.noData) {
            channel.provenance.push_back({"no data", "count " + exactText(*slot.noData),
                                          directory.name() + ", default slot '" + slot.name + "'"});
        }
    }

    void describeScan() {
        result_.provenance.push_back({"format version", scan_.text(kJpkVersion), "tag 32768"});
        result_.provenance.push_back(
            {"orientation",
             isReflected_ ? "first stored row on top" : "first stored row at the bottom",
             "tag 32837 (Reflect)"});
        noteRotation(result_.notes,
                     scan_.number(kRotation).value_or(0.0) * 180.0 / std::numbers::pi);
    }

    const ByteSource& bytes_;
    WholeImages images_;
    std::vector<TiffDirectory> directories_;
    const TiffDirectory& scan_;
    bool isReflected_ = false;
    std::uint64_t decoded_ = 0;  ///< bytes of the channels so far
    StoredScan result_;
};

constexpr std::array<std::string_view, 2> kJpkExtensions{".jpk", ".jpk-qi-image"};

}  // namespace

bool isJpkImage(const ByteSource& bytes) {
    return isTiffWithTag(bytes, kJpkVersion) && isTiffWithTag(bytes, kJpkSizeX);
}

StoredScan readJpkImage(const ByteSource& bytes) { return JpkReader(bytes).read(); }

const HeightMapFormat kJpkFormat = {.name = "JPK image",
                                    .extensions = kJpkExtensions,
                                    .recognizes = isJpkImage,
                                    .read = readJpkImage};

}  // namespace asperity
