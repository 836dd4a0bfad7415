#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/TextLines.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeaderFields.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/NumberRow.h"
#include "core/io/heightmap/SampleRows.h"
#include "core/io/heightmap/ScanImage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

// Surface data files of ISO 25178-71 and their forerunner BCR 1.0: a header, the points row after
// row from the top, a trailer; all as text, or header and points binary with the lowest byte first.
// Source: docs/formats.md 14.

namespace asperity {

namespace {

constexpr std::size_t kMagicLength = 8;
constexpr std::string_view kEndMark = "*";
constexpr double kSdfNoData = std::numeric_limits<double>::quiet_NaN();

bool isTextMagic(std::string_view magic) { return magic == "aISO-1.0" || magic == "aBCR-0.0"; }
bool isBinaryMagic(std::string_view magic) { return magic == "bISO-1.0" || magic == "bBCR-0.0"; }

/// By the number in the header.
constexpr std::array kSampleTypes = {SampleType::UInt8,   SampleType::UInt16, SampleType::UInt32,
                                     SampleType::Float32, SampleType::Int8,   SampleType::Int16,
                                     SampleType::Int32,   SampleType::Float64};

/// The number that means "no data"; no other type has one but NaN.
double noDataOf(SampleType type) {
    switch (type) {
    case SampleType::Int16:
        return std::numeric_limits<std::int16_t>::min();
    case SampleType::UInt16:
        return std::numeric_limits<std::uint16_t>::max();
    case SampleType::Int32:
        return std::numeric_limits<std::int32_t>::min();
    default:
        return kSdfNoData;
    }
}

class SdfReader {
public:
    explicit SdfReader(const ByteSource& bytes)
        : bytes_(bytes), magic_(bytes.start(kMagicLength)), fields_(bytes.name(), "") {}

    StoredScan read() {
        StoredChannel stored;
        if (isBinaryMagic(magic_)) {
            stored.readRow = readBinary();
        } else if (isTextMagic(magic_)) {
            stored.readRow = readText();
        } else {
            fail("byte 0", "expected aISO-1.0, bISO-1.0, aBCR-0.0 or bBCR-0.0");
        }
        setChannel(stored);
        StoredScan scan;
        scan.texts.add(fields_.texts());
        scan.channels.push_back(std::move(stored));
        return scan;
    }

private:
    ReadRow readBinary() {
        ByteReader reader(bytes_);
        (void)reader.take(kMagicLength, "version");
        takeText(reader, 10, "ManufacID");
        takeText(reader, 12, "CreateDate");
        takeText(reader, 12, "ModDate");
        const auto columns = reader.takeNumber<std::uint16_t>("NumPoints");
        const auto rows = reader.takeNumber<std::uint16_t>("NumProfiles");
        size_ = checkedImageSize(columns, rows, bytes_.name(), "NumPoints, NumProfiles");
        pitchX_ = reader.takeNumber<double>("Xscale");
        pitchY_ = reader.takeNumber<double>("Yscale");
        scale_ = reader.takeNumber<double>("Zscale");
        fields_.add("Zresolution", exactText(reader.takeNumber<double>("Zresolution")));
        requireNoCompression(reader.takeNumber<std::uint8_t>("Compression"));
        const auto type = reader.takeNumber<std::uint8_t>("DataType");
        (void)reader.takeNumber<std::uint8_t>("CheckType");
        if (type >= kSampleTypes.size()) {
            fail("DataType", "expected 0 to 7, found " + std::to_string(type));
        }
        const SampleLayout layout{
            .size = size_, .type = kSampleTypes[type], .offset = reader.offset()};
        requireSamples(bytes_, layout, "points");
        return replaced(rowsOf(bytes_, layout), size_.columns,
                        [noData = noDataOf(layout.type)](double number) {
                            return number == noData ? kSdfNoData : number;
                        });
    }

    void takeText(ByteReader& reader, std::uint64_t count, const char* key) {
        const std::string text = bytesOf(bytes_, reader.take(count, key));
        fields_.add(key, std::string_view(text).substr(0, text.find('\0')));
    }

    ReadRow readText() {
        TextLines lines(bytes_);
        readTextHeader(lines);
        size_ = checkedImageSize(fields_.integer("NumPoints"), fields_.integer("NumProfiles"),
                                 bytes_.name(), "NumPoints, NumProfiles");
        pitchX_ = fields_.requiredNumber("Xscale");
        pitchY_ = fields_.requiredNumber("Yscale");
        scale_ = fields_.requiredNumber("Zscale");
        requireNoCompression(
            fields_.find("Compression") == nullptr ? 0 : fields_.integer("Compression"));
        if (size_.pixels() > bytes_.size()) {
            fail("NumPoints, NumProfiles", "the file is too short for so many numbers");
        }
        return rowsOfNumbers(readNumbers(lines), size_.columns);
    }

    /// "Key = value" up to the mark that ends the header.
    void readTextHeader(TextLines& lines) {
        (void)lines.next();  // the version
        while (const std::optional<std::string_view> line = lines.next()) {
            const std::string_view text = trimmed(line->substr(0, line->find(';')));
            if (text == kEndMark) {
                return;
            }
            const std::size_t equals = text.find('=');
            if (equals != std::string_view::npos) {
                fields_.add(text.substr(0, equals), text.substr(equals + 1));
            } else if (!text.empty()) {
                lines.fail("expected 'name = value'");
            }
        }
        lines.fail("no '*' ends the header; the file is truncated or damaged");
    }

    /// Numbers in whatever lines up to the mark that ends them.
    std::deque<double> readNumbers(TextLines& lines) const {
        std::deque<double> numbers;
        NumberRow row;
        bool ends = false;
        while (!ends) {
            const std::optional<std::string_view> line = lines.next();
            if (!line) {
                lines.fail("no '*' ends the numbers; the file is truncated or damaged");
            }
            std::string_view text = trimmed(*line);
            ends = text.ends_with(kEndMark);
            text.remove_suffix(ends ? kEndMark.size() : 0);
            readNumberRow(text, {}, row);
            if (!row.wrong.empty()) {
                lines.fail("expected a number or 'BAD', found '" + toUtf8(row.wrong) + "'");
            }
            if (row.numbers.size() > size_.pixels() - numbers.size()) {
                lines.fail("more than " + std::to_string(size_.pixels()) + " numbers");
            }
            numbers.insert(numbers.end(), row.numbers.begin(), row.numbers.end());
        }
        if (numbers.size() != size_.pixels()) {
            lines.fail("expected " + std::to_string(size_.pixels()) + " numbers, found " +
                       std::to_string(numbers.size()));
        }
        return numbers;
    }

    void requireNoCompression(long long compression) const {
        if (compression != 0) {
            fail("Compression", "expected 0, found " + std::to_string(compression) +
                                    "; compressed files cannot be read");
        }
    }

    void setChannel(StoredChannel& stored) {
        ScanChannel& channel = stored.channel;
        channel.name = "Topography";
        channel.lateralUnit = "m";
        channel.map = emptyMap(size_, pitchX_ * size_.columns, pitchY_ * size_.rows);
        const bool hasScale = std::isfinite(scale_) && scale_ != 0.0;
        if (hasScale) {
            channel.unit = "m";
            stored.factor = scale_;
            channel.provenance.push_back(scaleProvenance(scale_, "m", "header, Zscale"));
        } else {
            channel.notes.emplace_back("the file gives no scale of its numbers (Zscale)");
        }
        channel.provenance.push_back({"format version", magic_, "header"});
        channel.provenance.push_back(
            {"orientation", "the first row is the top one", "usual; the file does not say"});
        settleSize(channel, "header, Xscale and Yscale");
    }

    [[noreturn]] void fail(const std::string& location, const std::string& what) const {
        throw InputError(bytes_.name(), location, what);
    }

    const ByteSource& bytes_;
    std::string magic_;
    HeaderFields fields_;
    ImageSize size_;
    double pitchX_ = 0.0;  // [m]
    double pitchY_ = 0.0;  // [m]
    double scale_ = 0.0;   // of a number [m]
};

constexpr std::array<std::string_view, 1> kSdfExtensions{".sdf"};

bool isSdf(const ByteSource& bytes) {
    const std::string magic = bytes.start(kMagicLength);
    return isTextMagic(magic) || isBinaryMagic(magic);
}

}  // namespace

const HeightMapFormat kSdfFormat = {
    .name = "Surface data file .sdf",
    .extensions = kSdfExtensions,
    .recognizes = isSdf,
    .read = [](const ByteSource& bytes) { return SdfReader(bytes).read(); }};

}  // namespace asperity
