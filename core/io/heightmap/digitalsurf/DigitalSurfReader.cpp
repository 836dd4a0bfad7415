#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/MemoryLimit.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/heightmap/SampleRows.h"
#include "core/io/heightmap/ScanImage.h"
#include "core/io/heightmap/WholeImages.h"
#include "core/io/heightmap/ZlibStream.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

// Digital Surf .sur (MountainsMap): a header of 512 bytes, a comment, a private zone, the samples,
// perhaps packed by zlib. Source: docs/formats.md 15. No real file was available: what is read here
// is what the layout says.

namespace asperity {

namespace {

constexpr std::string_view kDigitalSurfMagic = "DIGITAL SURF";
constexpr std::string_view kCompressedMagic = "DSCOMPRESSED";
constexpr std::size_t kHeader = 512;

// Offsets in the header [bytes]
constexpr std::size_t kDigitalSurfVersion = 16;
constexpr std::size_t kObject = 18;
constexpr std::size_t kObjectName = 20;
constexpr std::size_t kSpecialPoints = 86;
constexpr std::size_t kDigitalSurfBits = 98;
constexpr std::size_t kLowest = 100;
constexpr std::size_t kDigitalSurfColumns = 108;
constexpr std::size_t kDigitalSurfRows = 112;
constexpr std::array<std::size_t, 3> kDigitalSurfSteps{120, 124, 128};
constexpr std::array<std::size_t, 3> kDigitalSurfUnits{180, 196, 212};
constexpr std::size_t kZAxis = 164;
constexpr std::size_t kInversion = 290;
constexpr std::size_t kCommentSize = 334;
constexpr std::size_t kPrivateSize = 336;
constexpr std::array<std::size_t, 3> kOffsets{466, 470, 474};

constexpr std::size_t kDigitalSurfNameLength = 30;
constexpr std::size_t kTextLength = 16;
constexpr int kSurface = 2;
constexpr std::array kForceCurves{14, 15};  ///< one, a series

/// A stream of a compressed object: where it lies, and how many bytes it holds.
struct PackedStream {
    ByteSpan packed;
    std::uint64_t size = 0;
};

/// One object of a file: header, comment, private zone and samples.
class DigitalSurfObject {
public:
    /// @param offset of its header, which begins with a mark [bytes]
    DigitalSurfObject(const ByteSource& bytes, std::uint64_t offset)
        : bytes_(bytes)
        , offset_(offset)
        , header_(static_cast<std::size_t>(std::min<std::uint64_t>(kHeader, bytes.size() - offset)),
                  '\0') {
        bytes_.read(offset, header_);
        refuseRelatives();
        findSamples();
    }

    [[nodiscard]] std::string name() const {
        const std::string name = text(kZAxis, kTextLength);
        return name.empty() ? "Untitled" : name;
    }
    /// Returns the offset of the next one; beyond the end of the file where that is truncated.
    [[nodiscard]] std::uint64_t end() const { return end_; }
    [[nodiscard]] std::string version() const {
        return std::to_string(number<std::int16_t>(kDigitalSurfVersion));
    }

    /// @throw InputError when the file does not hold all of it
    [[nodiscard]] StoredChannel read() const {
        requireWhole();
        ScanChannel channel;
        channel.name = name();
        setSize(channel, samples_.size);
        channel.metadata = {{"object name", text(kObjectName, kDigitalSurfNameLength)}};
        const PhysicalUnit unit = parseUnit(text(kDigitalSurfUnits[2], kTextLength));
        channel.unit = unit.base;
        settleSize(channel, "bytes 120 and 124");
        requireScale();
        addProvenance(channel);
        return {.channel = std::move(channel), .factor = unit.factor, .readRow = heights()};
    }

private:
    [[nodiscard]] bool isCompressed() const { return header_.starts_with(kCompressedMagic); }

    void refuseRelatives() const {
        if (!header_.starts_with(kDigitalSurfMagic) && !isCompressed()) {
            fail("byte " + std::to_string(offset_), "expected 'DIGITAL SURF' or 'DSCOMPRESSED'");
        }
        if (header_.size() < kHeader) {
            fail("header", "it has 512 bytes, but the file has fewer; it is truncated");
        }
        const int object = number<std::int16_t>(kObject);
        if (std::ranges::count(kForceCurves, object) > 0) {
            fail("byte 18", "this Digital Surf file holds force curves, no image");
        }
        if (object != kSurface && number<std::int32_t>(kDigitalSurfRows) == 1) {
            fail("byte 18", "it holds a profile, no surface (an object of type " +
                                std::to_string(object) + " with one row)");
        }
    }

    void findSamples() {
        const int bits = number<std::int16_t>(kDigitalSurfBits);
        if (bits != 16 && bits != 32) {
            fail("byte 98", "expected samples of 16 or 32 bits, found " + std::to_string(bits));
        }
        samples_ = {.size = checkedImageSize(number<std::int32_t>(kDigitalSurfColumns),
                                             number<std::int32_t>(kDigitalSurfRows), bytes_.name(),
                                             "bytes 108 to 115"),
                    .type = bits == 16 ? SampleType::Int16 : SampleType::Int32,
                    .offset = offset_ + kHeader + number<std::uint16_t>(kCommentSize) +
                              std::uint64_t{number<std::uint16_t>(kPrivateSize)}};
        if (isCompressed()) {
            findStreams();
        } else {
            end_ = samples_.offset + samples_.bytes();
        }
    }

    /// The number of the streams, of each the bytes that it holds and those that it has, and the
    /// streams.
    void findStreams() {
        constexpr std::uint32_t kMaxStreams = 65536;
        const auto count =
            numberIn<std::uint32_t>(bytes_, {samples_.offset, sizeof(std::uint32_t)});
        if (count < 1 || count > kMaxStreams) {
            fail("byte " + std::to_string(samples_.offset),
                 "expected 1 to " + std::to_string(kMaxStreams) + " compressed streams, found " +
                     std::to_string(count));
        }
        constexpr std::uint64_t kEntry = 2 * sizeof(std::uint32_t);
        const std::uint64_t list = samples_.offset + sizeof(count);
        const std::string entries = bytesOf(bytes_, {list, count * kEntry});
        end_ = list + entries.size();
        std::uint64_t held = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            const char* const entry = entries.data() + i * kEntry;
            const PackedStream stream{
                .packed = {end_, littleEndian<std::uint32_t>(entry + sizeof(std::uint32_t))},
                .size = littleEndian<std::uint32_t>(entry)};
            end_ += stream.packed.count;
            held += stream.size;
            streams_.push_back(stream);
        }
        if (held != samples_.bytes()) {
            fail("byte " + std::to_string(list),
                 "its compressed streams hold " + std::to_string(held) + " bytes, but " +
                     std::to_string(samples_.size.columns) + " x " +
                     std::to_string(samples_.size.rows) + " samples have " +
                     std::to_string(samples_.bytes()));
        }
    }

    void requireWhole() const {
        if (!isCompressed()) {
            requireSamples(bytes_, samples_, "image");
            return;
        }
        if (end_ > bytes_.size()) {
            fail("image", "its compressed data end at byte " + std::to_string(end_) +
                              ", but the file has " + std::to_string(bytes_.size()) +
                              "; it is truncated");
        }
        requireUsualPacking(samples_.bytes(), bytes_.size(), bytes_.name(), "image");
        for (const PackedStream& each : streams_) {
            if (!mayUnpackTo(each.packed.count, each.size)) {
                fail("byte " + std::to_string(each.packed.offset),
                     "no zlib stream of " + std::to_string(each.packed.count) + " bytes holds " +
                         std::to_string(each.size) + "; the file is damaged");
            }
        }
    }

    [[nodiscard]] ReadRow storedRows() const {
        if (!isCompressed()) {
            return rowsOf(bytes_, samples_);
        }
        SampleLayout layout = samples_;
        layout.offset = 0;
        return rowsOfDecoded(
            [&bytes = bytes_, streams = streams_] {
                std::string samples;
                for (const PackedStream& each : streams) {
                    appendUnpacked(samples, bytes, each.packed, each.size,
                                   "byte " + std::to_string(each.packed.offset));
                }
                return samples;
            },
            layout, bytes_.name());
    }

    void setSize(ScanChannel& channel, ImageSize size) const {
        const PhysicalUnit x = parseUnit(text(kDigitalSurfUnits[0], kTextLength));
        const PhysicalUnit y = parseUnit(text(kDigitalSurfUnits[1], kTextLength));
        channel.lateralUnit = x.base == y.base ? x.base : std::string();
        channel.map =
            emptyMap(size, double{number<float>(kDigitalSurfSteps[0])} * x.factor * size.columns,
                     double{number<float>(kDigitalSurfSteps[1])} * y.factor * size.rows);
        setOrigin(channel, double{number<float>(kOffsets[0])} * x.factor,
                  double{number<float>(kOffsets[1])} * y.factor, GivenPoint::Corner);
    }

    void requireScale() const {
        const double step = number<float>(kDigitalSurfSteps[2]);
        if (!std::isfinite(step) || step == 0.0 || !std::isfinite(number<float>(kOffsets[2]))) {
            throw InputError(bytes_.name(), "bytes 128 and 474",
                             "expected a step and an offset of the heights, found " +
                                 exactText(step) + " and " + exactText(number<float>(kOffsets[2])));
        }
    }

    /// In the unit of z; where the header announces special points, 2 below the lowest count is one
    /// that was not measured.
    [[nodiscard]] ReadRow heights() const {
        const double step = number<float>(kDigitalSurfSteps[2]);
        const double offset = number<float>(kOffsets[2]);
        const bool special = number<std::int16_t>(kSpecialPoints) != 0;
        const double missing = special ? number<std::int32_t>(kLowest) - 2.0
                                       : std::numeric_limits<double>::quiet_NaN();
        return replaced(storedRows(), samples_.size.columns, [step, offset, missing](double count) {
            return count == missing ? std::numeric_limits<double>::quiet_NaN()
                                    : count * step + offset;
        });
    }

    void addProvenance(ScanChannel& channel) const {
        const PhysicalUnit unit = parseUnit(text(kDigitalSurfUnits[2], kTextLength));
        channel.provenance.push_back(
            scaleProvenance(double{number<float>(kDigitalSurfSteps[2])} * unit.factor, unit.base,
                            "bytes 128 and 212"));
        channel.provenance.push_back(
            {"orientation", "the top row is stored first", "the same in every .sur file"});
        if (const int object = number<std::int16_t>(kObject); object != kSurface) {
            channel.notes.push_back("the header calls it an object of type " +
                                    std::to_string(object) +
                                    ", not a surface (2); its numbers are those of one");
        }
        const int inversion = number<std::int16_t>(kInversion);
        if (inversion != 0) {
            channel.notes.push_back("the header says that the surface was inverted (" +
                                    std::to_string(inversion) + "); it is shown as it is stored");
        }
    }

    template <typename Number>
    [[nodiscard]] Number number(std::size_t offset) const {
        return littleEndian<Number>(header_.data() + offset);
    }

    /// Filled up with NUL bytes or blanks.
    [[nodiscard]] std::string text(std::size_t offset, std::size_t length) const {
        const std::string_view all = std::string_view(header_).substr(offset, length);
        return toUtf8(trimmed(all.substr(0, all.find('\0'))));
    }

    [[noreturn]] void fail(const std::string& location, const std::string& what) const {
        throw InputError(bytes_.name(), location, what);
    }

    const ByteSource& bytes_;
    std::uint64_t offset_;
    std::string header_;
    SampleLayout samples_;               ///< in the file, or as they are unpacked
    std::vector<PackedStream> streams_;  ///< of a compressed object
    std::uint64_t end_ = 0;
};

bool hasMark(const ByteSource& bytes, std::uint64_t offset) {
    std::string mark(kDigitalSurfMagic.size(), '\0');
    if (offset > bytes.size() || mark.size() > bytes.size() - offset) {
        return false;
    }
    bytes.read(offset, mark);
    return mark == kDigitalSurfMagic || mark == kCompressedMagic;
}

/// A name that no channel has yet.
std::string uniqueName(const StoredScan& scan, const std::string& name) {
    std::string unique = name;
    const auto isTaken = [&] {
        return std::ranges::any_of(scan.channels, [&unique](const StoredChannel& each) {
            return each.channel.name == unique;
        });
    };
    for (int number = 2; isTaken(); ++number) {
        unique = name + " " + std::to_string(number);
    }
    return unique;
}

/// The objects of a file follow each other, each with a header of its own.
StoredScan readDigitalSurf(const ByteSource& bytes) {
    StoredScan result;
    WholeImages images;
    std::string version;
    std::uint64_t offset = 0;
    std::size_t count = 0;
    do {
        requireImages(++count, bytes.name(), "byte " + std::to_string(offset));
        const DigitalSurfObject object(bytes, offset);
        offset = object.end();
        version = object.version();
        try {
            StoredChannel image = object.read();
            image.channel.name = uniqueName(result, image.channel.name);
            result.channels.push_back(std::move(image));
        } catch (const InputError& error) {
            if (offset <= bytes.size()) {
                throw;
            }
            images.leaveOut(object.name(), error);
        }
    } while (hasMark(bytes, offset));
    images.finish(result);
    if (offset < bytes.size()) {
        throw InputError(bytes.name(), "bytes 334 to 337",
                         "with the comment and the private zone that the header names, the "
                         "samples end at byte " +
                             std::to_string(offset) + ", but the file has " +
                             std::to_string(bytes.size()));
    }
    result.notes.emplace_back(
        "no real .sur file has proven this reader: compare the heights with MountainsMap");
    result.provenance.push_back({"format version", version, "byte 16"});
    return result;
}

constexpr std::array<std::string_view, 1> kDigitalSurfExtensions{".sur"};

}  // namespace

const HeightMapFormat kDigitalSurfFormat = {.name = "Digital Surf .sur",
                                            .extensions = kDigitalSurfExtensions,
                                            .recognizes =
                                                [](const ByteSource& bytes) {
                                                    return bytes.startsWith(kDigitalSurfMagic) ||
                                                           bytes.startsWith(kCompressedMagic);
                                                },
                                            .read = readDigitalSurf};

}  // namespace asperity
