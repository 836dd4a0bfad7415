#include "core/Error.h"
#include "core/io/MemoryLimit.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/exr/ExrHeader.h"
#include "core/io/heightmap/exr/ExrImage.h"
#include "core/io/heightmap/exr/ExrWriter.h"

#include <algorithm>
#include <bit>
#include <memory>
#include <utility>

// OpenEXR: each channel of numbers is one; Gwyddion's attributes belong to Y, or to the only one.
// Source: docs/formats.md 9.

namespace asperity {

namespace {

constexpr ByteOrder kExrNative =
    std::endian::native == std::endian::little ? ByteOrder::Little : ByteOrder::Big;

/// Channels that are decoded together.
struct ExrBatch {
    std::vector<ExrChannel> channels;
    std::uint64_t bytes = 0;  ///< of all samples
};

/// Returns how many bytes a batch has at most unless it is of one channel: all that an image of
/// usual size has, so that its pixels are decoded once.
std::uint64_t mostOfBatch() {
    constexpr std::uint64_t kPart = 4;  // of the memory: the heights need some, too
    return memoryForInput() / kPart;
}

class ExrReader {
public:
    explicit ExrReader(const ByteSource& bytes)
        : bytes_(bytes), header_(readExrHeader(bytes)), channels_(exrChannels(bytes)) {
        if (channels_.size() > 1) {
            latest_ = std::make_shared<LatestSamples>();
        }
    }

    StoredScan read() {
        requireImages(channels_.size(), bytes_.name(), "channels");
        const bool isColor = has("R") && has("G") && has("B");
        for (const ExrChannel& channel : channels_) {
            const bool isPicture =
                isColor && (channel.name == "R" || channel.name == "G" || channel.name == "B");
            if (!isPicture && channel.name != "A") {
                addChannel(channel);
            }
        }
        if (result_.channels.empty()) {
            throw InputError(bytes_.name(), "channels",
                             std::string("this is ") + (isColor ? "a color picture" : "a picture") +
                                 ", no height map: its pixels are no heights. A channel Y is "
                                 "expected");
        }
        result_.texts.add(header_.texts);
        if (header_.isMultiPart) {
            result_.notes.emplace_back("only the first part of the file is read");
        }
        result_.provenance.push_back({"format", "OpenEXR", "header"});
        result_.provenance.push_back({"orientation", "row of the smallest y on top", "OpenEXR"});
        return std::move(result_);
    }

private:
    [[nodiscard]] bool has(std::string_view name) const {
        return std::ranges::any_of(
            channels_, [name](const ExrChannel& channel) { return channel.name == name; });
    }

    void addChannel(const ExrChannel& channel) {
        if (!channel.isWhole) {
            result_.notes.push_back("channel '" + channel.name +
                                    "' has no sample for each pixel and was left out");
            return;
        }
        ImageScale scale = gwyScale(header_.texts.all(), channel.type, bytes_.name(), "attributes");
        if (channels_.size() > 1 && channel.name != "Y") {
            scale.title.clear();
            scale.unit.clear();
            scale.factor = 1.0;
            scale.offset = 0.0;
            std::erase_if(scale.provenance,
                          [](const Provenance& entry) { return entry.what == "scale"; });
        }
        const std::map<std::string, std::string>& texts = header_.texts.all();
        if (const auto unit = texts.find(kExrUnitOf + channel.name); unit != texts.end()) {
            scale.unit = unit->second;
        }
        if (channel.isHalf && scale.unit == "m" && !texts.contains("Gwy::ZScale")) {
            scale.notes.emplace_back("it is stored as half floats of meters, which are too coarse "
                                     "for heights below 61 um");
        }
        result_.channels.push_back(
            scaledChannel(scale, header_.size, rows(channel), channel.name, bytes_.name()));
    }

    /// To decode one channel costs as much as to decode all.
    [[nodiscard]] ReadRow rows(const ExrChannel& channel) {
        SampleLayout layout{.size = header_.size, .type = channel.type, .order = kExrNative};
        if (!batch_ || batch_->bytes + layout.bytes() > mostOfBatch_) {
            batch_ = std::make_shared<ExrBatch>();
            samples_ = std::make_shared<DecodedSamples>(
                [bytes = &bytes_, batch = batch_] { return decodeExr(*bytes, batch->channels); },
                layout.bytes() > mostOfBatch_ ? nullptr : latest_);
        }
        layout.place = batch_->bytes;
        batch_->channels.push_back(channel);
        batch_->bytes += layout.bytes();
        return rowsOfDecoded(samples_, layout, bytes_.name());
    }

    const ByteSource& bytes_;
    ExrHeader header_;
    std::vector<ExrChannel> channels_;
    std::uint64_t mostOfBatch_ = mostOfBatch();
    std::shared_ptr<LatestSamples> latest_;    ///< null: there is one channel
    std::shared_ptr<ExrBatch> batch_;          ///< that the next channel belongs to if it fits
    std::shared_ptr<DecodedSamples> samples_;  ///< of that batch
    StoredScan result_;
};

constexpr std::array<std::string_view, 1> kExrExtensions{".exr"};

}  // namespace

const HeightMapFormat kExrFormat = {
    .name = "OpenEXR .exr",
    .extensions = kExrExtensions,
    .recognizes = isExr,
    .read = [](const ByteSource& bytes) { return ExrReader(bytes).read(); },
    .write = writeExr};

}  // namespace asperity
