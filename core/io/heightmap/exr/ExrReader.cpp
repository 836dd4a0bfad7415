#include "core/Error.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/exr/ExrHeader.h"
#include "core/io/heightmap/exr/ExrImage.h"
#include "core/io/heightmap/exr/ExrWriter.h"

#include <algorithm>
#include <bit>
#include <utility>

// OpenEXR: each channel of numbers is one; Gwyddion's attributes belong to Y, or to the only one.
// Source: docs/formats.md 9.

namespace asperity {

namespace {

constexpr ByteOrder kExrNative =
    std::endian::native == std::endian::little ? ByteOrder::Little : ByteOrder::Big;

class ExrReader {
public:
    explicit ExrReader(const ByteSource& bytes)
        : bytes_(bytes), header_(readExrHeader(bytes)), channels_(exrChannels(bytes)) {}

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
        ImageScale scale = gwyScale(header_.texts, channel.type, bytes_.name(), "attributes");
        if (channels_.size() > 1 && channel.name != "Y") {
            scale.title.clear();
            scale.unit.clear();
            scale.factor = 1.0;
            scale.offset = 0.0;
            std::erase_if(scale.provenance,
                          [](const Provenance& entry) { return entry.what == "scale"; });
        }
        if (const auto unit = header_.texts.find(kExrUnitOf + channel.name);
            unit != header_.texts.end()) {
            scale.unit = unit->second;
        }
        if (channel.isHalf && scale.unit == "m" && !header_.texts.contains("Gwy::ZScale")) {
            scale.notes.emplace_back("it is stored as half floats of meters, which are too coarse "
                                     "for heights below 61 um");
        }
        StoredChannel stored = scaledChannel(
            scale, header_.size,
            rowsOfDecoded([bytes = &bytes_, channel] { return decodeExr(*bytes, channel); },
                          {.size = header_.size, .type = channel.type, .order = kExrNative},
                          bytes_.name()),
            channel.name, bytes_.name());
        if (affordsCopies(header_.texts, channels_.size())) {
            stored.channel.metadata = header_.texts;
        }
        result_.channels.push_back(std::move(stored));
    }

    const ByteSource& bytes_;
    ExrHeader header_;
    std::vector<ExrChannel> channels_;
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
