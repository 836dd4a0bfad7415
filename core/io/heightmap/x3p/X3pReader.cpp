#include "core/Error.h"
#include "core/io/FileBytes.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/NumberRow.h"
#include "core/io/heightmap/SampleRows.h"
#include "core/io/heightmap/ScanImage.h"
#include "core/io/heightmap/x3p/X3pDescription.h"
#include "core/io/zip/ZipArchive.h"

#include <algorithm>
#include <memory>

// X3P: a zip archive with main.xml, which describes the surface, and its heights in a binary file
// beside it. Source: ISO 25178-72; docs/formats.md 11.

namespace asperity {

namespace {

constexpr std::string_view kMain = "main.xml";
/// A million heights listed as text.
constexpr std::uint64_t kMaxXml = std::uint64_t{1} << 26U;
constexpr std::uint64_t kMaxChecksumFile = 4096;
/// The MD5 of more would take longer than to decode it, and damage shows in its CRC.
constexpr std::uint64_t kMaxChecked = std::uint64_t{1} << 26U;
/// Behind the last bit of the valid points.
constexpr std::uint64_t kMaxPadding = 4096;
/// Lengths between which the meters of X3P are believed.
constexpr double kMaxSize = 0.1;
constexpr double kMinRange = 1e-12;
/// Heights over the longer side.
constexpr double kMaxSteepness = 10.0;

const ZipEntry& mainEntry(const ZipArchive& archive, const std::string& file) {
    const auto found = std::ranges::find_if(archive.entries(), [](const ZipEntry& entry) {
        return entry.baseName() == kMain && !entry.name.starts_with("__MACOSX/");
    });
    if (found == archive.entries().end()) {
        throw InputError(file, "", "the zip archive holds no main.xml");
    }
    return *found;
}

class X3pReader {
public:
    explicit X3pReader(const ByteSource& bytes)
        : file_(bytes.name()), archive_(bytes), main_(mainEntry(archive_, file_)) {}

    StoredScan read() {
        std::string xml = archive_.decoded(main_, kMaxXml);
        checkMain(xml);
        description_ = describeX3p(std::move(xml), file_, main_.name);
        openPoints();
        openValidPoints();
        noteOrigin();
        result_.texts = description_.texts;
        for (int layer = 0; layer < description_.layers; ++layer) {
            result_.channels.push_back(channel(layer));
        }
        return std::move(result_);
    }

private:
    /// md5checksum.hex begins with the MD5 of main.xml.
    void checkMain(const std::string& xml) {
        const ZipEntry* const entry = archive_.find(beside("md5checksum.hex"));
        if (entry == nullptr || entry->size > kMaxChecksumFile) {
            return;
        }
        const std::string text = archive_.decoded(*entry, kMaxChecksumFile);
        const std::string_view line = trimmed(text);
        check(MemoryBytes(xml, main_.name), lowerCase(line.substr(0, line.find_first_of(" \t*"))),
              entry->name);
    }

    void openPoints() {
        if (description_.listed) {
            description_.type = SampleType::Float64;
            points_ = std::make_shared<OwnedBytes>(std::move(*description_.listed), file_);
            return;
        }
        const std::uint64_t expected = description_.numbers() * sizeOf(*description_.type);
        const ZipEntry& entry = linked(description_.points.entry);
        if (entry.size != expected) {
            fail(entry.name, "expected " + std::to_string(expected) + " bytes for " +
                                 std::to_string(description_.size.columns) + " x " +
                                 std::to_string(description_.size.rows) + " pixels, found " +
                                 std::to_string(entry.size));
        }
        points_ = archive_.source(entry, expected);
        check(*points_, description_.points.md5, main_.name + ", MD5ChecksumPointData");
    }

    /// A bit a number, the lowest of a byte first; 1: valid.
    void openValidPoints() {
        if (description_.validPoints.entry.empty()) {
            return;
        }
        const std::uint64_t expected = (description_.numbers() + 7) / 8;
        const ZipEntry& entry = linked(description_.validPoints.entry);
        if (entry.size < expected) {
            fail(entry.name, "expected " + std::to_string(expected) + " bytes, found " +
                                 std::to_string(entry.size));
        }
        validPoints_ = archive_.source(entry, expected + kMaxPadding);
        check(*validPoints_, description_.validPoints.md5, main_.name + ", MD5ChecksumValidPoints");
    }

    void noteOrigin() {
        result_.provenance = {
            {"format version", description_.revision, main_.name + ", Record1/Revision"},
            {"orientation", "the first stored row is the top one",
             "as Gwyddion and SurfaceTopography show it"}};
        if (description_.isRotated) {
            result_.notes.emplace_back("the rotation of the axes in main.xml is not applied");
        }
        const double size = std::max(description_.x.increment * description_.size.columns,
                                     description_.y.increment * description_.size.rows);
        if (size > kMaxSize) {
            result_.notes.push_back("a side of " + exactText(size) +
                                    " m is implausible: X3P prescribes meters, but some programs "
                                    "write millimeters or micrometers");
        }
    }

    [[nodiscard]] StoredChannel channel(int layer) const {
        const X3pAxis& z = description_.z;
        const ImageSize size = description_.size;
        ScanChannel channel;
        channel.name =
            description_.layers == 1 ? "Topography" : "Topography " + std::to_string(layer + 1);
        channel.unit = "m";
        channel.lateralUnit = "m";
        channel.map = emptyMap(size, description_.x.increment * size.columns,
                               description_.y.increment * size.rows);
        setOrigin(channel, description_.x.offset, description_.y.offset, GivenPoint::Corner);
        channel.provenance = {{"scale",
                               exactText(z.increment) + " m per stored number" +
                                   (z.offset == 0.0 ? "" : ", plus " + exactText(z.offset) + " m"),
                               main_.name + ", Record1/Axes/CZ"}};
        const ReadRow rows = meters(layer);
        noteRange(channel, numberRangeOf(rows, size));
        settleSize(channel, main_.name + ", Record1/Axes/CX and CY");
        return {.channel = std::move(channel), .readRow = rows};
    }

    [[nodiscard]] ReadRow meters(int layer) const {
        const ImageSize size = description_.size;
        const std::uint64_t first = static_cast<std::uint64_t>(layer) * size.pixels();
        const X3pAxis z = description_.z;
        ReadRow rows = keeping(rowsOf(*points_, {.size = size,
                                                 .type = *description_.type,
                                                 .offset = first * sizeOf(*description_.type)}),
                               points_);
        if (validPoints_ != nullptr) {
            rows = masked(std::move(rows), size.columns, invalidBits(first));
        }
        return replaced(std::move(rows), size.columns,
                        [z](double number) { return number * z.increment + z.offset; });
    }

    /// 1 where the bit of a number is 0.
    [[nodiscard]] ReadRow invalidBits(std::uint64_t first) const {
        return [bytes = validPoints_, first,
                columns = description_.size.columns](int row, RowRoom& room, double* marks) {
            const auto count = static_cast<std::uint64_t>(columns);
            const std::uint64_t begin = first + static_cast<std::uint64_t>(row) * count;
            room.bytes.resize((begin + count - 1) / 8 - begin / 8 + 1);
            bytes->read(begin / 8, room.bytes);
            for (std::uint64_t i = 0; i < count; ++i) {
                const std::uint64_t bit = begin % 8 + i;
                const bool valid =
                    (static_cast<unsigned char>(room.bytes[bit / 8]) >> (bit % 8) & 1U) != 0;
                marks[i] = valid ? 0.0 : 1.0;
            }
        };
    }

    void noteRange(ScanChannel& channel, const NumberRange& range) const {
        const double height = range.highest - range.lowest;
        const double side = std::max(channel.map.sizeX(), channel.map.sizeY());
        if (height > kMaxSize || (side > 0.0 && height > kMaxSteepness * side) ||
            (height > 0.0 && height < kMinRange)) {
            channel.notes.push_back("heights from " + exactText(range.lowest) + " m to " +
                                    exactText(range.highest) +
                                    " m are implausible: X3P prescribes meters, but some programs "
                                    "write other units");
        }
    }

    void check(const ByteSource& content, const std::string& given, const std::string& location) {
        if (given.empty() || content.size() > kMaxChecked) {
            return;
        }
        if (const std::string found = md5Of(content); !found.empty() && found != given) {
            result_.notes.push_back("the checksum in " + location +
                                    " is that of another content: the file was changed after it "
                                    "was written, or is damaged");
        }
    }

    /// @param link as main.xml writes it
    [[nodiscard]] const ZipEntry& linked(std::string link) const {
        std::ranges::replace(link, '\\', '/');
        const ZipEntry* entry = archive_.find(beside(link));
        entry = entry != nullptr ? entry : archive_.find(link);
        if (entry == nullptr) {
            fail(main_.name, "the zip archive does not hold '" + link + "', which it names");
        }
        return *entry;
    }

    /// A name in the folder of main.xml.
    [[nodiscard]] std::string beside(std::string_view name) const {
        return main_.name.substr(0, main_.name.size() - kMain.size()) + std::string(name);
    }

    [[noreturn]] void fail(const std::string& location, const std::string& what) const {
        throw InputError(file_, location, what);
    }

    const std::string& file_;
    ZipArchive archive_;
    const ZipEntry& main_;
    X3pDescription description_;
    std::shared_ptr<const ByteSource> points_;
    std::shared_ptr<const ByteSource> validPoints_;  ///< null: all that are finite
    StoredScan result_;
};

constexpr std::array<std::string_view, 1> kX3pExtensions{".x3p"};

/// A damaged archive comes here, too: opening it names the damage.
bool recognizesX3p(const ByteSource& bytes) {
    if (!isZip(bytes)) {
        return false;
    }
    const std::optional<std::string> directory = zipDirectory(bytes);
    return !directory || directory->find(kMain) != std::string::npos;
}

}  // namespace

const HeightMapFormat kX3pFormat = {
    .name = "X3P (ISO 25178-72)",
    .extensions = kX3pExtensions,
    .recognizes = recognizesX3p,
    .read = [](const ByteSource& bytes) { return X3pReader(bytes).read(); }};

}  // namespace asperity
