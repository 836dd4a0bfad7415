#include "core/io/heightmap/igor/IgorWave.h"

#include "core/io/ByteReader.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeaderFields.h"

#include <algorithm>
#include <string_view>
#include <utility>

// Igor binary wave: a header of 64 bytes, one of 320 for the wave, the numbers, then formula, note,
// units and labels; of version 2, 16 and 110 bytes, the numbers and the note. Source:
// docs/formats.md 6. Channels of Asylum Research instruments. Source: docs/formats.md 6.

namespace asperity {

namespace {

constexpr std::size_t kFileHeader = 64;
constexpr std::size_t kWaveHeader = 320;
constexpr std::size_t kHeaders = kFileHeader + kWaveHeader;
constexpr std::size_t kLabel = 32;
constexpr std::uint64_t kWaveMaxText = std::uint64_t{1} << 18U;
constexpr std::uint64_t kFooter = 1024;
constexpr int kImageVersion = 5;
constexpr int kCurveVersion = 2;

// Offsets in the first header and, from 64 on, in that of the wave.
constexpr std::size_t kWaveSize = 4;
constexpr std::size_t kFormulaSize = 8;
constexpr std::size_t kNoteSize = 12;
constexpr std::size_t kUnitSize = 16;
constexpr std::size_t kDimensionUnitSizes = 20;
constexpr std::size_t kLabelSizes = 36;
constexpr std::size_t kNumbers = kFileHeader + 12;
constexpr std::size_t kType = kFileHeader + 16;
constexpr std::size_t kWaveName = kFileHeader + 28;
constexpr std::size_t kCounts = kFileHeader + 68;
constexpr std::size_t kWaveSteps = kFileHeader + 84;
constexpr std::size_t kStarts = kFileHeader + 116;
constexpr std::size_t kWaveUnit = kFileHeader + 148;
constexpr std::size_t kDimensionUnits = kFileHeader + 152;
constexpr std::size_t kShortUnit = 4;
constexpr std::size_t kWaveNameLength = 32;

// Offsets in a file of version 2: its headers have 16 and 110 bytes.
constexpr std::size_t kOldFileHeader = 16;
constexpr std::size_t kOldHeaders = kOldFileHeader + 110;
constexpr std::size_t kOldWaveSize = 2;
constexpr std::size_t kOldNoteSize = 6;
constexpr std::size_t kOldType = kOldFileHeader;
constexpr std::size_t kOldName = kOldFileHeader + 6;
constexpr std::size_t kOldNameLength = 20;
constexpr std::size_t kOldUnit = kOldFileHeader + 34;
constexpr std::size_t kOldNumbers = kOldFileHeader + 42;
constexpr std::size_t kOldStep = kOldFileHeader + 48;
constexpr std::size_t kOldPadding = 16;  ///< behind the numbers

constexpr int kComplex = 1;

/// The first bytes of a file in its own byte order; the version's low byte is never 0.
class WaveHeader {
public:
    explicit WaveHeader(const ByteSource& bytes)
        : bytes_(bytes.start(kHeaders))
        , order_(bytes_.empty() || bytes_[0] != '\0' ? ByteOrder::Little : ByteOrder::Big) {}

    [[nodiscard]] ByteOrder order() const { return order_; }
    [[nodiscard]] bool isWhole() const {
        return bytes_.size() >= (version() == kCurveVersion ? kOldHeaders : kHeaders);
    }

    template <typename Number>
    [[nodiscard]] Number at(std::size_t offset) const {
        const char* const from = bytes_.data() + offset;
        return order_ == ByteOrder::Little ? littleEndian<Number>(from) : bigEndian<Number>(from);
    }

    /// Text up to its first NUL.
    [[nodiscard]] std::string text(std::size_t offset, std::size_t length) const {
        const std::string_view all = std::string_view(bytes_).substr(offset, length);
        return toUtf8(all.substr(0, all.find('\0')));
    }

    /// Returns whether the numbers of 16 bits in the first bytes add up to 0.
    [[nodiscard]] bool sumsToZero(std::size_t length) const {
        if (bytes_.size() < length) {
            return false;
        }
        unsigned sum = 0;
        for (std::size_t offset = 0; offset < length; offset += 2) {
            sum += at<std::uint16_t>(offset);
        }
        return (sum & 0xFFFFU) == 0;
    }

    [[nodiscard]] int version() const { return bytes_.size() < 2 ? 0 : at<std::int16_t>(0); }

private:
    std::string bytes_;
    ByteOrder order_;
};

std::optional<SampleType> sampleType(int code) {
    constexpr std::array<std::pair<int, SampleType>, 10> kTypes{{{0x02, SampleType::Float32},
                                                                 {0x04, SampleType::Float64},
                                                                 {0x08, SampleType::Int8},
                                                                 {0x10, SampleType::Int16},
                                                                 {0x20, SampleType::Int32},
                                                                 {0x48, SampleType::UInt8},
                                                                 {0x50, SampleType::UInt16},
                                                                 {0x60, SampleType::UInt32},
                                                                 {0x80, SampleType::Int64},
                                                                 {0xc0, SampleType::UInt64}}};
    const auto* const found =
        std::ranges::find(kTypes, code, [](const auto& type) { return type.first; });
    return found == kTypes.end() ? std::nullopt : std::optional(found->second);
}

class WaveReader {
public:
    explicit WaveReader(const ByteSource& bytes) : bytes_(bytes), header_(bytes) {}

    IgorWave read() {
        requireSound();
        wave_.order = header_.order();
        if (header_.version() == kCurveVersion) {
            readCurve();
            return std::move(wave_);
        }
        wave_.name = header_.text(kWaveName, kWaveNameLength);
        readDimensions();
        readNumbers();
        readTexts();
        return std::move(wave_);
    }

private:
    void requireSound() const {
        const int version = header_.version();
        if (version == 1 || version == 3) {
            fail("byte 0", "this Igor wave has version " + std::to_string(version) +
                               ": a curve or other numbers in one dimension, no image");
        }
        if (version != kImageVersion && version != kCurveVersion) {
            fail("byte 0", "expected an Igor binary wave of version 5 or 2");
        }
        const std::size_t headers = version == kCurveVersion ? kOldHeaders : kHeaders;
        if (!header_.isWhole()) {
            fail("header", "it has " + std::to_string(headers) +
                               " bytes, but the file has fewer; it is truncated");
        }
        if (!header_.sumsToZero(headers)) {
            fail("header", "its checksum is wrong; the file is damaged");
        }
    }

    /// Version 2 holds one dimension.
    void readCurve() {
        wave_.name = header_.text(kOldName, kOldNameLength);
        wave_.unit = header_.text(kOldUnit, kShortUnit);
        wave_.steps[0] = header_.at<double>(kOldStep);
        wave_.starts[0] = header_.at<double>(kOldStep + sizeof(double));
        wave_.type = typeOf(header_.at<std::int16_t>(kOldType));
        wave_.offset = kOldHeaders;
        const auto count = header_.at<std::int32_t>(kOldNumbers);
        const std::uint64_t numbers = count < 0 ? 0 : static_cast<std::uint64_t>(count);
        const std::uint64_t expected = kOldHeaders - kOldFileHeader + numbers * sizeOf(wave_.type);
        if (count < 0 || size(kOldWaveSize) < expected) {
            fail("header", "the wave has " + std::to_string(size(kOldWaveSize)) +
                               " bytes, but its " + std::to_string(count) + " numbers need " +
                               std::to_string(expected));
        }
        wave_.counts[0] = count;
        end_ = kOldFileHeader;
        skip(std::max(size(kOldWaveSize), expected + kOldPadding), "the wave");
        wave_.note = textIn(skip(size(kOldNoteSize), "the note"));
    }

    [[nodiscard]] SampleType typeOf(int code) const {
        if (code == 0) {
            fail("type", "this Igor wave holds texts, no numbers");
        }
        if ((code & kComplex) != 0) {
            fail("type", "this Igor wave holds complex numbers; only real ones can be heights");
        }
        const std::optional<SampleType> type = sampleType(code);
        if (!type) {
            fail("type", "no type of numbers has the code " + std::to_string(code));
        }
        return *type;
    }

    void readDimensions() {
        for (std::size_t i = 0; i < IgorWave::kDimensions; ++i) {
            wave_.counts[i] = header_.at<std::int32_t>(kCounts + i * sizeof(std::int32_t));
            wave_.steps[i] = header_.at<double>(kWaveSteps + i * sizeof(double));
            wave_.starts[i] = header_.at<double>(kStarts + i * sizeof(double));
            wave_.dimensionUnits[i] = header_.text(kDimensionUnits + i * kShortUnit, kShortUnit);
        }
        wave_.unit = header_.text(kWaveUnit, kShortUnit);
    }

    void readNumbers() {
        wave_.type = typeOf(header_.at<std::int16_t>(kType));
        wave_.offset = kHeaders;
        const std::uint64_t expected = kWaveHeader + countOfNumbers() * sizeOf(wave_.type);
        const std::uint64_t stated = size(kWaveSize);
        if (stated < expected) {
            fail("header", "the wave has " + std::to_string(stated) +
                               " bytes, but its numbers need " + std::to_string(expected));
        }
        end_ = kFileHeader;
        skip(stated, "the wave");
    }

    /// The product of all dimensions in use, which the header states, too.
    [[nodiscard]] std::uint64_t countOfNumbers() const {
        const auto stated = header_.at<std::int32_t>(kNumbers);
        std::uint64_t product = 1;
        for (const std::int32_t count : wave_.counts) {
            if (count == 0) {
                break;
            }
            const bool fits =
                count > 0 && stated > 0 &&
                product * static_cast<std::uint64_t>(count) <= static_cast<std::uint64_t>(stated);
            if (!fits) {
                failDimensions();
            }
            product *= static_cast<std::uint64_t>(count);
        }
        if (stated < 0 || product != static_cast<std::uint64_t>(stated)) {
            failDimensions();
        }
        return product;
    }

    [[noreturn]] void failDimensions() const {
        std::string text;
        for (const std::int32_t count : wave_.counts) {
            text += (text.empty() ? "" : " x ") + std::to_string(count);
        }
        fail("header", "its dimensions (" + text + ") are not those of " +
                           std::to_string(header_.at<std::int32_t>(kNumbers)) + " numbers");
    }

    void readTexts() {
        (void)skip(size(kFormulaSize), "the formula");
        wave_.note = textIn(skip(size(kNoteSize), "the note"));
        const std::string unit = toUtf8(textIn(skip(size(kUnitSize), "the unit")));
        if (!unit.empty()) {
            wave_.unit = unit;
        }
        for (std::size_t i = 0; i < IgorWave::kDimensions; ++i) {
            const std::uint64_t length = size(kDimensionUnitSizes + i * sizeof(std::int32_t));
            const std::string longUnit = toUtf8(textIn(skip(length, "the units of dimensions")));
            if (!longUnit.empty()) {
                wave_.dimensionUnits[i] = longUnit;
            }
        }
        for (std::size_t i = 0; i < IgorWave::kDimensions; ++i) {
            const std::uint64_t length = size(kLabelSizes + i * sizeof(std::int32_t));
            wave_.labels[i] = labelsIn(textIn(skip(length, "the labels of dimensions")));
        }
        const std::uint64_t left = std::min(bytes_.size() - end_, kFooter);
        wave_.footer = bytesOf(bytes_, {bytes_.size() - left, left});
    }

    static std::vector<std::string> labelsIn(std::string_view text) {
        std::vector<std::string> labels;
        for (; text.size() >= kLabel; text.remove_prefix(kLabel)) {
            const std::string_view label = text.substr(0, kLabel);
            labels.push_back(toUtf8(trimmed(label.substr(0, label.find('\0')))));
        }
        return labels;
    }

    /// No note of an instrument comes near the limit; what is beyond is left out.
    [[nodiscard]] std::string textIn(const ByteSpan& span) const {
        return bytesOf(bytes_, {span.offset, std::min(span.count, kWaveMaxText)});
    }

    [[nodiscard]] std::uint64_t size(std::size_t offset) const {
        const auto stated = header_.at<std::int32_t>(offset);
        if (stated < 0) {
            fail("byte " + std::to_string(offset), "a size of " + std::to_string(stated));
        }
        return static_cast<std::uint64_t>(stated);
    }

    /// @return an empty span at the end where the file is truncated
    ByteSpan skip(std::uint64_t count, const std::string& what) {
        const ByteSpan span{end_, count};
        if (count > bytes_.size() - end_) {
            if (!wave_.cut) {
                wave_.cut = InputError(bytes_.name(), "byte " + std::to_string(end_),
                                       what + " ends at byte " + std::to_string(span.end()) +
                                           ", but the file has " + std::to_string(bytes_.size()) +
                                           "; it is truncated");
            }
            end_ = bytes_.size();
            return {end_, 0};
        }
        end_ = span.end();
        return span;
    }

    [[noreturn]] void fail(const std::string& location, const std::string& what) const {
        throw InputError(bytes_.name(), location, what);
    }

    const ByteSource& bytes_;
    WaveHeader header_;
    std::uint64_t end_ = 0;  ///< of what is read so far
    IgorWave wave_;
};

constexpr std::array<std::pair<std::string_view, const char*>, 8> kAsylumUnits{
    {{"Height", "m"},
     {"ZSensor", "m"},
     {"Deflection", "m"},
     {"Amplitude", "m"},
     {"Phase", "deg"},
     {"Current", "A"},
     {"Frequency", "Hz"},
     {"Potential", "V"}}};

/// "HeightTraceMod1" → "HeightTrace": images that were changed after the scan.
std::string_view withoutChanges(std::string_view label) {
    const std::size_t mark = label.rfind("Mod");
    const bool numbered = mark != std::string_view::npos && mark > 0 && mark + 3 < label.size() &&
                          label.find_first_not_of("0123456789", mark + 3) == std::string_view::npos;
    return numbered ? label.substr(0, mark) : label;
}

/// "NapPotentialRetrace" → "Potential"
std::string signalOf(std::string_view label) {
    label = withoutChanges(label);
    for (const std::string_view direction : {"Retrace", "Trace"}) {
        if (label.ends_with(direction)) {
            label.remove_suffix(direction.size());
            break;
        }
    }
    if (label.starts_with("Nap")) {
        label.remove_prefix(3);
    }
    return std::string(label);
}

}  // namespace

bool startsAsIgorWave(const ByteSource& bytes) {
    // Version and, by it, the length that the checksum is over.
    constexpr std::array<std::pair<int, std::size_t>, 4> kSums{
        {{1, 118}, {kCurveVersion, kOldHeaders}, {3, 130}, {kImageVersion, kHeaders}}};
    const WaveHeader header(bytes);
    const auto* const sum =
        std::ranges::find(kSums, header.version(), [](const auto& each) { return each.first; });
    if (sum == kSums.end()) {
        return false;
    }
    const bool plausible = header.isWhole() && sum->first == kImageVersion &&
                           sampleType(header.at<std::int16_t>(kType)).has_value() &&
                           header.at<std::int32_t>(kWaveSize) >= static_cast<int>(kWaveHeader);
    return plausible || header.sumsToZero(sum->second);
}

IgorWave readIgorWave(const ByteSource& bytes) { return WaveReader(bytes).read(); }

std::map<std::string, std::string> parseAsylumNote(const std::string& note) {
    std::map<std::string, std::string> fields;
    for (const std::string_view line : linesOf(note)) {
        const std::size_t colon = line.find(':');
        if (colon != std::string_view::npos && colon > 0) {
            fields.emplace(toUtf8(trimmed(line.substr(0, colon))),
                           toUtf8(trimmed(line.substr(colon + 1))));
        }
    }
    return fields;
}

bool isAsylumCurve(const IgorWave& wave) {
    constexpr std::string_view kForceFooter = "Force";
    constexpr std::array<std::string_view, 4> kSignals{"Raw", "Defl", "ZSnsr", "LVDT"};
    return wave.footer.ends_with(kForceFooter) ||
           std::ranges::any_of(wave.labels[1], [&](const std::string& column) {
               return std::ranges::count(kSignals, column) != 0;
           });
}

bool isAsylumLabel(const std::string& label) {
    const std::string_view image = withoutChanges(label);
    return image.ends_with("Trace") || image.ends_with("Retrace");
}

std::string asylumUnit(const std::string& label, const std::map<std::string, std::string>& note) {
    const std::string signal = signalOf(label);
    const auto said = note.find(signal + "Unit");
    if (said != note.end()) {
        return said->second;
    }
    for (const auto& [name, unit] : kAsylumUnits) {
        if (signal.starts_with(name)) {
            return unit;
        }
    }
    return {};
}

}  // namespace asperity
