#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/MemoryLimit.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/ImageScale.h"
#include "core/io/heightmap/SampleRows.h"
#include "core/io/heightmap/exr/ExrWriter.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// OpenEXR: each channel of numbers is one; Gwyddion's attributes belong to Y, or to the only one.
// Source: docs/formats.md 9.

namespace asperity {

namespace {

// Source: openexr.com, "OpenEXR File Layout", Attribute Layout.

/// Entries in the first header of an OpenEXR file.
struct ExrHeader {
    ImageSize size;                    ///< of the data window
    BoundedTexts texts{kHeaderQuota};  ///< attributes that are texts or numbers
    bool isMultiPart = false;
};

/// A channel of an OpenEXR image.
struct ExrChannel {
    std::string name;
    SampleType type = SampleType::Float32;  ///< as it is decoded
    bool isHalf = false;                    ///< stored with 11 bits
    bool isWhole = true;                    ///< it has a sample for each pixel
};

constexpr std::string_view kExrMagic("v/1\x01", 4);
constexpr std::uint32_t kMultiPart = 0x1000;
/// A scale is a short text.
constexpr std::uint64_t kExrMaxText = 65536;
constexpr int kMaxParts = 64;
/// Maximum in all parts: each costs the library some 400 bytes.
constexpr int kMaxAttributes = 1 << 16;
/// Pixels per byte: no data are packed better than this.
constexpr std::uint64_t kExrMaxRatio = 2000;

struct TypeSize {
    std::string_view type;
    std::uint64_t bytes;
};

constexpr std::array kFixed{TypeSize{"box2f", 16},
                            TypeSize{"box2i", 16},
                            TypeSize{"chromaticities", 32},
                            TypeSize{"compression", 1},
                            TypeSize{"deepImageState", 1},
                            TypeSize{"double", 8},
                            TypeSize{"envmap", 1},
                            TypeSize{"float", 4},
                            TypeSize{"int", 4},
                            TypeSize{"keycode", 28},
                            TypeSize{"lineOrder", 1},
                            TypeSize{"m33d", 72},
                            TypeSize{"m33f", 36},
                            TypeSize{"m44d", 128},
                            TypeSize{"m44f", 64},
                            TypeSize{"rational", 8},
                            TypeSize{"tiledesc", 9},
                            TypeSize{"timecode", 8},
                            TypeSize{"v2d", 16},
                            TypeSize{"v2f", 8},
                            TypeSize{"v2i", 8},
                            TypeSize{"v3d", 24},
                            TypeSize{"v3f", 12},
                            TypeSize{"v3i", 12}};

/// Takes a list of channels: names with 16 bytes after each, ended by an empty one.
/// @return how many there are @throw InputError when it does not end
std::size_t takeChannels(ByteReader& reader) {
    constexpr std::uint64_t kChannelBytes = 16;
    std::size_t count = 0;
    while (!reader.takeName("a channel's name").empty()) {
        (void)reader.take(kChannelBytes, "a channel");
        ++count;
    }
    return count;
}

bool isChannelList(const ByteSource& bytes, const ByteSpan& value) {
    try {
        ByteReader reader(bytes, value);
        (void)takeChannels(reader);
        return reader.atEnd();
    } catch (const InputError&) {
        return false;
    }
}

/// Columns, rows and four bytes for each pixel.
bool isPreview(const ByteSource& bytes, const ByteSpan& value) {
    constexpr std::uint64_t kSizeBytes = 8;
    constexpr std::uint64_t kPixelBytes = 4;
    if (value.count < kSizeBytes) {
        return false;
    }
    const std::uint64_t columns = numberIn<std::uint32_t>(bytes, {value.offset, 4});
    const std::uint64_t rows = numberIn<std::uint32_t>(bytes, {value.offset + 4, 4});
    const std::uint64_t pixels = (value.count - kSizeBytes) / kPixelBytes;
    const bool fits = rows == 0 || columns <= pixels / rows;
    return fits && value.count == kSizeBytes + columns * rows * kPixelBytes;
}

/// The file as the OpenEXR library reads it. Its exceptions pass through the library.
class ExrStream final : public Imf::IStream {
public:
    explicit ExrStream(const ByteSource& bytes)
        : Imf::IStream(bytes.name().c_str()), bytes_(bytes) {}

    bool read(char target[], int count) override {
        const auto length = static_cast<std::size_t>(count);
        if (offset_ > bytes_.size() || length > bytes_.size() - offset_) {
            throw InputError(bytes_.name(), "byte " + std::to_string(bytes_.size()),
                             "the content ends here; it is truncated or damaged");
        }
        bytes_.read(offset_, {target, length});
        offset_ += length;
        return offset_ < bytes_.size();
    }
    std::uint64_t tellg() override { return offset_; }
    void seekg(std::uint64_t offset) override { offset_ = offset; }
    void clear() override {}

private:
    const ByteSource& bytes_;
    std::uint64_t offset_ = 0;
};

constexpr int kNoThreads = 0;

/// Runs `step` on the open file. @throw InputError for whatever the library throws
template <typename Step>
auto withExr(const ByteSource& bytes, const Step& step) {
    try {
        ExrStream stream(bytes);
        Imf::InputFile file(stream, kNoThreads);
        return step(file);
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        throw InputError(bytes.name(), "",
                         std::string("the OpenEXR library cannot decode it: ") + error.what());
    }
}

std::vector<ExrChannel> listChannels(const Imf::InputFile& file) {
    std::vector<ExrChannel> channels;
    const Imf::ChannelList& list = file.header().channels();
    for (auto each = list.begin(); each != list.end(); ++each) {
        const Imf::Channel& channel = each.channel();
        channels.push_back(
            {.name = each.name(),
             .type = channel.type == Imf::UINT ? SampleType::UInt32 : SampleType::Float32,
             .isHalf = channel.type == Imf::HALF,
             .isWhole = channel.xSampling == 1 && channel.ySampling == 1});
    }
    return channels;
}

std::string decode(Imf::InputFile& file, const std::vector<ExrChannel>& channels) {
    const Imath::Box2i window = file.header().dataWindow();
    const auto columns = static_cast<std::size_t>(std::int64_t{window.max.x} - window.min.x + 1);
    const auto rows = static_cast<std::size_t>(std::int64_t{window.max.y} - window.min.y + 1);
    std::size_t bytes = 0;
    for (const ExrChannel& channel : channels) {
        bytes += columns * rows * sizeOf(channel.type);
    }
    std::string samples(bytes, '\0');
    char* target = samples.data();
    Imf::FrameBuffer frame;
    for (const ExrChannel& channel : channels) {
        frame.insert(channel.name,
                     Imf::Slice::Make(channel.type == SampleType::UInt32 ? Imf::UINT : Imf::FLOAT,
                                      target, window));
        target += columns * rows * sizeOf(channel.type);
    }
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    return samples;
}

bool isExr(const ByteSource& bytes) { return bytes.startsWith(kExrMagic); }

/// Returns whether the value of an attribute has the length of its type, if the OpenEXR library
/// knows that: the library reads that many bytes, and walks astray where the file lists others.
bool fitsExrType(const ByteSource& bytes, std::string_view type, const ByteSpan& value) {
    if (type == "chlist") {
        return isChannelList(bytes, value);
    }
    if (type == "preview") {
        return isPreview(bytes, value);
    }
    const auto* const fixed = std::ranges::find(kFixed, type, &TypeSize::type);
    return fixed == kFixed.end() || fixed->bytes == value.count;
}

/// The number of channels that a list of them holds. @param value of an attribute that fits its
/// type, chlist
std::size_t exrChannelCount(const ByteSource& bytes, const ByteSpan& value) {
    ByteReader reader(bytes, value);
    return takeChannels(reader);
}

class HeaderWalk {
public:
    explicit HeaderWalk(const ByteSource& bytes) : bytes_(bytes), reader_(bytes) {}

    ExrHeader read() {
        (void)reader_.take(kExrMagic.size(), "the signature");
        const auto version = reader_.takeNumber<std::uint32_t>("the version");
        header_.isMultiPart = (version & kMultiPart) != 0;
        takeAttributes();
        requireWindow();
        header_.size = window_;
        // Headers of further parts; an empty one ends them.
        isFirst_ = false;
        for (int part = 2; header_.isMultiPart && takeAttributes() > 0; ++part) {
            requireWindow();
            if (part > kMaxParts) {
                reader_.fail("expected at most " + std::to_string(kMaxParts) + " parts");
            }
        }
        return std::move(header_);
    }

private:
    /// @return how many there are in this header
    int takeAttributes() {
        int count = 0;
        window_ = {};
        tilePixels_ = 0;
        for (std::string name = reader_.takeName("an attribute's name"); !name.empty();
             name = reader_.takeName("an attribute's name")) {
            if (attributes_ + count == kMaxAttributes) {
                reader_.fail("expected at most " + std::to_string(kMaxAttributes) + " attributes");
            }
            const std::string type = reader_.takeName("an attribute's type");
            const auto size = reader_.takeNumber<std::int32_t>("an attribute's size");
            if (size < 0) {
                reader_.fail("expected the size of the attribute '" + name +
                             "'; the file is damaged");
            }
            const ByteSpan value = reader_.take(static_cast<std::uint64_t>(size), name);
            if (!fitsExrType(bytes_, type, value)) {
                failLength(name, type);
            }
            if (type == "chlist") {
                requireImages(exrChannelCount(bytes_, value), bytes_.name(), name);
            }
            if (type == "box2i" && name == "dataWindow") {
                takeWindow(value);
            } else if (type == "tiledesc") {
                takeTiles(value);
            } else if (isFirst_) {
                takeText(name, type, value);
            }
            ++count;
        }
        attributes_ += count;
        return count;
    }

    [[noreturn]] void failLength(const std::string& name, const std::string& type) const {
        reader_.fail("the attribute '" + name + "' is not as long as a " + type +
                     "; the file is damaged");
    }

    void takeWindow(const ByteSpan& value) {
        const auto at = [&](std::uint64_t index) -> long long {
            return numberIn<std::int32_t>(
                bytes_, {value.offset + index * sizeof(std::int32_t), sizeof(std::int32_t)});
        };
        window_ =
            checkedImageSize(at(2) - at(0) + 1, at(3) - at(1) + 1, bytes_.name(), "dataWindow");
    }

    void takeTiles(const ByteSpan& value) {
        const auto side = [&](std::uint64_t offset) {
            return numberIn<std::uint32_t>(bytes_, {offset, sizeof(std::uint32_t)});
        };
        const ImageSize tile = checkedImageSize(
            side(value.offset), side(value.offset + sizeof(std::uint32_t)), bytes_.name(), "tiles");
        tilePixels_ = tile.pixels();
    }

    /// The library makes room for all pixels and for the offset of each tile: the file must be
    /// large enough for them.
    void requireWindow() const {
        if (window_.rows == 0) {
            throw InputError(bytes_.name(), "header", "expected the attribute dataWindow");
        }
        if (window_.pixels() / kExrMaxRatio > bytes_.size()) {
            throw InputError(bytes_.name(), "dataWindow",
                             "the file cannot hold " + std::to_string(window_.columns) + " x " +
                                 std::to_string(window_.rows) + " pixels; it is damaged");
        }
        if (tilePixels_ > 0 &&
            window_.pixels() / tilePixels_ > bytes_.size() / sizeof(std::uint64_t)) {
            throw InputError(bytes_.name(), "tiles",
                             "the file is too small for its tiles; it is damaged");
        }
    }

    void takeText(const std::string& name, const std::string& type, const ByteSpan& value) {
        if (type == "string" && value.count <= kExrMaxText) {
            header_.texts.add(toUtf8(name), toUtf8(bytesOf(bytes_, value)));
        } else if (type == "double") {
            header_.texts.add(toUtf8(name), exactText(numberIn<double>(bytes_, value)));
        } else if (type == "float") {
            header_.texts.add(toUtf8(name),
                              exactText(static_cast<double>(numberIn<float>(bytes_, value))));
        }
    }

    const ByteSource& bytes_;
    ByteReader reader_;
    bool isFirst_ = true;           ///< header
    int attributes_ = 0;            ///< of the headers before the present one
    ImageSize window_;              ///< of the present header
    std::uint64_t tilePixels_ = 0;  ///< of the present header; 0: it has no tiles
    ExrHeader header_;
};

/// Walks through the attributes of all headers, so that the OpenEXR library, which believes their
/// sizes, sees none that the file does not hold. Source: "OpenEXR File Layout", openexr.com.
/// @throw InputError when one is not within the file, or the image has no possible size
ExrHeader readExrHeader(const ByteSource& bytes) {
    if (!isExr(bytes)) {
        throw InputError(bytes.name(), "", "this is no OpenEXR file");
    }
    return HeaderWalk(bytes).read();
}

/// Returns the channels of the first part, by name.
/// @param bytes whose headers have been checked
/// @throw InputError when the OpenEXR library refuses the file
std::vector<ExrChannel> exrChannels(const ByteSource& bytes) {
    return withExr(bytes, listChannels);
}

/// All samples of these channels, one channel after the other, row after row from the top, in the
/// processor's byte order. It unpacks all channels of the file, whichever are asked for. Any
/// threads. @throw InputError when the OpenEXR library cannot decode them
std::string decodeExr(const ByteSource& bytes, const std::vector<ExrChannel>& channels) {
    return withExr(bytes, [&channels](Imf::InputFile& file) { return decode(file, channels); });
}

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
        decoded_ += layout.bytes();
        requireUsualPacking(decoded_, bytes_.size(), bytes_.name(), "channels");
        layout.offset = batch_->bytes;
        batch_->channels.push_back(channel);
        batch_->bytes += layout.bytes();
        return rowsOfDecoded(samples_, layout, bytes_.name());
    }

    const ByteSource& bytes_;
    ExrHeader header_;
    std::vector<ExrChannel> channels_;
    std::uint64_t mostOfBatch_ = mostOfBatch();
    std::uint64_t decoded_ = 0;                ///< bytes of the channels so far
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
