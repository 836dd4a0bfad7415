#include "core/io/TextValue.h"
#include "core/io/heightmap/HeaderFields.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/NumberRow.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/heightmap/SampleRows.h"
#include "core/io/heightmap/ScanImage.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <utility>

// BCR and BCRF of Image Metrology (SPIP): a text header of 2048 characters, which may be UTF-16,
// then int16 or float32, the top row first. Source: docs/formats.md 14.

namespace asperity {

namespace {

constexpr std::string_view kFirstKey = "fileformat";
constexpr std::string_view kWideFirst{"f\0i\0l\0e\0", 8};
constexpr std::size_t kUsualHeader = 2048;       // [characters]
constexpr long long kMaxBcrHeader = 1LL << 20U;  // [characters]
constexpr double kBcrNoData = std::numeric_limits<double>::quiet_NaN();
constexpr double kInt16NoData = 32767.0;
constexpr double kFloatNoData = 1.7e38;  // and above

/// "key = value" lines, of several with the same key the last one; comments and blanks are left
/// out.
HeaderFields parseFields(std::string_view text, const std::string& file) {
    HeaderFields fields(file, "");
    std::vector<std::string_view> lines = linesOf(text);
    std::ranges::reverse(lines);
    for (const std::string_view whole : lines) {
        const std::string_view line = trimmed(whole.substr(0, whole.find('#')));
        const std::size_t equals = line.find('=');
        if (!line.starts_with('%') && equals != std::string_view::npos) {
            fields.add(lowerCase(line.substr(0, equals)), line.substr(equals + 1));
        }
    }
    return fields;
}

/// The same rows shifted so that the lowest number becomes this one. It is looked for when the
/// first row is asked for.
ReadRow liftedTo(double lowest, ReadRow rows, ImageSize size) {
    struct Shift {
        std::once_flag once;
        double value = 0.0;
    };
    return [lowest, rows = std::move(rows), size,
            shift = std::make_shared<Shift>()](int row, RowRoom& room, double* numbers) {
        std::call_once(shift->once, [&] {
            const double found = numberRangeOf(rows, size).lowest;
            shift->value = std::isfinite(found) ? lowest - found : 0.0;
        });
        rows(row, room, numbers);
        std::for_each_n(numbers, size.columns, [&](double& number) { number += shift->value; });
    };
}

class BcrReader {
public:
    explicit BcrReader(const ByteSource& bytes)
        : bytes_(bytes), isWide_(bytes.startsWith(kWideFirst)), fields_(fieldsOf(kUsualHeader)) {}

    StoredScan read() {
        readHeader();
        refuseForceCurve();
        const SampleLayout layout = samples();
        StoredScan scan;
        scan.texts.add(fields_.texts());
        scan.channels.push_back(channel(layout));
        return scan;
    }

private:
    void readHeader() {
        if (fields_.find("headersize") != nullptr) {
            const long long characters = fields_.integer("headersize");
            if (characters < 1 || characters > kMaxBcrHeader) {
                fields_.fail("headersize", "expected 1 to " + std::to_string(kMaxBcrHeader) +
                                               ", found " + std::to_string(characters));
            }
            headerSize_ = static_cast<std::size_t>(characters);
            fields_ = fieldsOf(headerSize_);
        }
    }

    [[nodiscard]] HeaderFields fieldsOf(std::size_t characters) const {
        const std::string start = bytes_.start(characters * bytesPerCharacter());
        return parseFields(isWide_ ? utf16ToUtf8(start, std::endian::little) : start,
                           bytes_.name());
    }

    void refuseForceCurve() const {
        if (parseNumber(fields_.text("forcecurve")).value_or(0.0) != 0.0) {
            fields_.fail("forcecurve", "this BCR file holds a force curve, no image");
        }
    }

    /// @throw InputError when the file does not hold them
    SampleLayout samples() {
        const std::string& type = fields_.required(std::string(kFirstKey));
        isFloat_ = type.starts_with("bcrf");
        if (!isFloat_ && !type.starts_with("bcrstm")) {
            fields_.fail("fileformat", "expected bcrstm or bcrf, found '" + type + "'");
        }
        const bool isLittle =
            fields_.find("intelmode") == nullptr || fields_.integer("intelmode") != 0;
        const auto columns = fields_.integer("xpixels");
        const auto rows = fields_.integer("ypixels");
        const SampleLayout layout{
            .size = checkedImageSize(columns, rows, bytes_.name(), "xpixels, ypixels"),
            .type = isFloat_ ? SampleType::Float32 : SampleType::Int16,
            .order = isLittle ? ByteOrder::Little : ByteOrder::Big,
            .offset = headerSize_ * bytesPerCharacter()};
        requireSamples(bytes_, layout, "heights");
        return layout;
    }

    StoredChannel channel(const SampleLayout& layout) {
        const PhysicalUnit xUnit = unitOf("xunit");
        const PhysicalUnit yUnit = unitOf("yunit");
        StoredChannel stored;
        ScanChannel& channel = stored.channel;
        channel.lateralUnit = xUnit.base == yUnit.base ? xUnit.base : "";
        channel.map = emptyMap(layout.size, number("xlength") * xUnit.factor,
                               number("ylength") * yUnit.factor);
        setOrigin(channel, number("xoffset") * xUnit.factor, number("yoffset") * yUnit.factor,
                  GivenPoint::Corner);
        setScale(stored);
        stored.readRow = rows(layout, channel);
        channel.name = channel.isHeight() ? "Topography" : "Image";
        channel.provenance.push_back(
            {"format version", isFloat_ ? "bcrf" : "bcrstm", "header, fileformat"});
        channel.provenance.push_back(
            {"byte order", layout.order == ByteOrder::Little ? "lowest first" : "highest first",
             fields_.find("intelmode") == nullptr ? "usual; the file does not say"
                                                  : "header, intelmode"});
        channel.provenance.push_back(
            {"orientation", "the first row is the top one", "usual; the file does not say"});
        settleSize(channel, "header, xlength and ylength");
        return stored;
    }

    void setScale(StoredChannel& stored) const {
        const PhysicalUnit unit = unitOf("zunit");
        const double perCount = isFloat_ ? 1.0 : number("bit2nm");
        ScanChannel& channel = stored.channel;
        if (!std::isfinite(perCount) || perCount == 0.0) {
            channel.notes.emplace_back("the file gives no scale of its counts (bit2nm)");
            return;
        }
        channel.unit = unit.base;
        stored.factor = perCount * unit.factor;
        channel.provenance.push_back(scaleProvenance(
            stored.factor, unit.base, isFloat_ ? "header, zunit" : "header, bit2nm and zunit"));
    }

    /// The numbers with those that mean "no data" left out, lifted to the lowest one where the
    /// header names that.
    ReadRow rows(const SampleLayout& layout, ScanChannel& channel) const {
        ReadRow plain = replaced(
            rowsOf(bytes_, layout), layout.size.columns, [isFloat = isFloat_](double stored) {
                const bool missing = isFloat ? stored >= kFloatNoData : stored == kInt16NoData;
                return missing ? kBcrNoData : stored;
            });
        const double lowest = number("zmin");
        const double perCount = isFloat_ ? 1.0 : number("bit2nm");
        const bool isLifted = std::isfinite(lowest) && lowest > 0.0 && perCount > 0.0;
        if (!isLifted) {
            return plain;
        }
        channel.provenance.push_back({"lowest value",
                                      fields_.required("zmin") + " in the unit of the values",
                                      "header, zmin"});
        return liftedTo(lowest / perCount, plain, layout.size);
    }

    /// Nanometers where the file does not say.
    [[nodiscard]] PhysicalUnit unitOf(const std::string& key) const {
        const std::string* const text = fields_.find(key);
        return parseUnit(text == nullptr ? "nm" : *text);
    }

    [[nodiscard]] std::size_t bytesPerCharacter() const { return isWide_ ? 2 : 1; }

    /// 0 when the key is missing.
    [[nodiscard]] double number(const std::string& key) const {
        return fields_.number(key).value_or(0.0);
    }

    const ByteSource& bytes_;
    bool isWide_;
    bool isFloat_ = false;
    std::size_t headerSize_ = kUsualHeader;  // [characters]
    HeaderFields fields_;
};

constexpr std::array<std::string_view, 2> kBcrExtensions{".bcr", ".bcrf"};

bool isBcr(const ByteSource& bytes) {
    constexpr std::size_t kLooked = 64;
    std::string start = bytes.start(kLooked);
    if (start.starts_with(kWideFirst)) {
        start = utf16ToUtf8(start, std::endian::little);
    }
    const std::string_view first = std::string_view(start).substr(0, start.find('\n'));
    const std::size_t equals = first.find('=');
    return equals != std::string_view::npos && trimmed(first.substr(0, equals)) == kFirstKey &&
           trimmed(first.substr(equals + 1)).starts_with("bcr");
}

}  // namespace

const HeightMapFormat kBcrFormat = {
    .name = "Image Metrology BCR",
    .extensions = kBcrExtensions,
    .recognizes = isBcr,
    .read = [](const ByteSource& bytes) { return BcrReader(bytes).read(); }};

}  // namespace asperity
