#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/heightmap/SampleRows.h"
#include "core/io/heightmap/ScanImage.h"
#include "core/io/heightmap/ScanOrigin.h"

#include <array>
#include <cmath>
#include <limits>

// Digital Surf .sur (MountainsMap): a header of 512 bytes, a comment, a private zone, the samples.
// Source: docs/formats.md 15. No real file was at hand: what is read here is what the layout says.

namespace asperity {

namespace {

constexpr std::string_view kDigitalSurfMagic = "DIGITAL SURF";
constexpr std::string_view kCompressedMagic = "DSCOMPRESSED";
constexpr std::size_t kHeader = 512;

// Places in the header [bytes]
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

class DigitalSurfReader {
public:
    explicit DigitalSurfReader(const ByteSource& bytes)
        : bytes_(bytes), header_(bytes.start(kHeader)) {}

    StoredScan read() {
        refuseRelatives();
        const SampleLayout samples = samplesOf();
        ScanChannel channel;
        channel.name = text(kZAxis, kTextLength);
        if (channel.name.empty()) {
            channel.name = "Untitled";
        }
        setSize(channel, samples.size);
        channel.metadata = {{"object name", text(kObjectName, kDigitalSurfNameLength)}};
        const PhysicalUnit unit = parseUnit(text(kDigitalSurfUnits[2], kTextLength));
        channel.unit = unit.base;
        settleSize(channel, "bytes 120 and 124");
        requireScale();
        addProvenance(channel);
        StoredScan result;
        result.channels.push_back(
            {.channel = std::move(channel), .factor = unit.factor, .readRow = heightsOf(samples)});
        result.notes.emplace_back(
            "no real .sur file has proven this reader: compare the heights with MountainsMap");
        result.provenance.push_back({"format version",
                                     std::to_string(number<std::int16_t>(kDigitalSurfVersion)),
                                     "byte 16"});
        return result;
    }

private:
    void refuseRelatives() const {
        if (header_.starts_with(kCompressedMagic)) {
            fail("byte 0", "its samples are compressed (DSCOMPRESSED); save it uncompressed");
        }
        if (!header_.starts_with(kDigitalSurfMagic)) {
            fail("byte 0", "expected 'DIGITAL SURF'");
        }
        if (header_.size() < kHeader) {
            fail("header", "it has 512 bytes, but the file has fewer; it is truncated");
        }
        const int object = number<std::int16_t>(kObject);
        if (object != kSurface) {
            fail("byte 18", "it holds no surface (2), but an object of type " +
                                std::to_string(object) + " (a profile or a series, for example)");
        }
    }

    /// The samples are all that follows comment and private zone.
    [[nodiscard]] SampleLayout samplesOf() const {
        const int bits = number<std::int16_t>(kDigitalSurfBits);
        if (bits != 16 && bits != 32) {
            fail("byte 98", "expected samples of 16 or 32 bits, found " + std::to_string(bits));
        }
        const SampleLayout samples{.size =
                                       checkedImageSize(number<std::int32_t>(kDigitalSurfColumns),
                                                        number<std::int32_t>(kDigitalSurfRows),
                                                        bytes_.name(), "bytes 108 to 115"),
                                   .type = bits == 16 ? SampleType::Int16 : SampleType::Int32,
                                   .place = kHeader + number<std::uint16_t>(kCommentSize) +
                                            std::uint64_t{number<std::uint16_t>(kPrivateSize)}};
        requireSamples(bytes_, samples, "image");
        const std::uint64_t end = samples.place + samples.bytes();
        if (end != bytes_.size()) {
            fail("bytes 334 to 337",
                 "with the comment and the private zone that the header names, the samples end at "
                 "byte " +
                     std::to_string(end) + ", but the file has " + std::to_string(bytes_.size()));
        }
        return samples;
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
    [[nodiscard]] ReadRow heightsOf(const SampleLayout& samples) const {
        const double step = number<float>(kDigitalSurfSteps[2]);
        const double offset = number<float>(kOffsets[2]);
        const bool special = number<std::int16_t>(kSpecialPoints) != 0;
        const double missing = special ? number<std::int32_t>(kLowest) - 2.0
                                       : std::numeric_limits<double>::quiet_NaN();
        return replaced(rowsOf(bytes_, samples), samples.size.columns,
                        [step, offset, missing](double count) {
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
        const int inversion = number<std::int16_t>(kInversion);
        if (inversion != 0) {
            channel.notes.push_back("the header says that the surface was inverted (" +
                                    std::to_string(inversion) + "); it is shown as it is stored");
        }
    }

    template <typename Number>
    [[nodiscard]] Number number(std::size_t place) const {
        return littleEndian<Number>(header_.data() + place);
    }

    /// Filled up with NUL bytes or blanks.
    [[nodiscard]] std::string text(std::size_t place, std::size_t length) const {
        const std::string_view all = std::string_view(header_).substr(place, length);
        return toUtf8(trimmed(all.substr(0, all.find('\0'))));
    }

    [[noreturn]] void fail(const std::string& place, const std::string& what) const {
        throw InputError(bytes_.name(), place, what);
    }

    const ByteSource& bytes_;
    std::string header_;
};

constexpr std::array<std::string_view, 1> kDigitalSurfExtensions{".sur"};

}  // namespace

const HeightMapFormat kDigitalSurfFormat = {
    .name = "Digital Surf .sur",
    .extensions = kDigitalSurfExtensions,
    .recognizes =
        [](const ByteSource& bytes) {
            return bytes.startsWith(kDigitalSurfMagic) || bytes.startsWith(kCompressedMagic);
        },
    .read = [](const ByteSource& bytes) { return DigitalSurfReader(bytes).read(); }};

}  // namespace asperity
