#include "core/io/heightmap/exr/ExrHeader.h"

#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/exr/ExrAttribute.h"

namespace asperity {

namespace {

constexpr std::string_view kExrMagic("v/1\x01", 4);
constexpr std::uint32_t kMultiPart = 0x1000;
/// A scale is a short text.
constexpr std::uint64_t kExrMaxText = 65536;
constexpr int kMaxParts = 64;
/// Of all parts: each takes the library some 400 bytes.
constexpr int kMaxAttributes = 1 << 16;
/// Pixels per byte: no data are packed better than this.
constexpr std::uint64_t kExrMaxRatio = 2000;

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
                bytes_, {value.place + index * sizeof(std::int32_t), sizeof(std::int32_t)});
        };
        window_ =
            checkedImageSize(at(2) - at(0) + 1, at(3) - at(1) + 1, bytes_.name(), "dataWindow");
    }

    void takeTiles(const ByteSpan& value) {
        const auto side = [&](std::uint64_t place) {
            return numberIn<std::uint32_t>(bytes_, {place, sizeof(std::uint32_t)});
        };
        const ImageSize tile = checkedImageSize(
            side(value.place), side(value.place + sizeof(std::uint32_t)), bytes_.name(), "tiles");
        tilePixels_ = tile.pixels();
    }

    /// The library makes room for all pixels and for the place of each tile: the file must be large
    /// enough for them.
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

}  // namespace

bool isExr(const ByteSource& bytes) { return bytes.startsWith(kExrMagic); }

ExrHeader readExrHeader(const ByteSource& bytes) {
    if (!isExr(bytes)) {
        throw InputError(bytes.name(), "", "this is no OpenEXR file");
    }
    return HeaderWalk(bytes).read();
}

}  // namespace asperity
