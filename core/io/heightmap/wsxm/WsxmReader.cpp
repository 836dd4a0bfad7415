#include "core/Error.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeaderFields.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/NumberRow.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/heightmap/SampleRows.h"
#include "core/io/heightmap/ScanImage.h"

#include <algorithm>
#include <array>
#include <cmath>

// WSxM: text sections of `key: value`, then the samples. Source: docs/formats.md 12.

namespace asperity {

namespace {

constexpr std::string_view kWsxmMagic = "WSxM file copyright";
constexpr std::string_view kImageLine = "SxM Image file";
constexpr std::string_view kPointsLine = "WSxM ASCII XYZ file";
constexpr std::string_view kMatrixLine = "WSxM ASCII Matrix file";
constexpr std::string_view kWsxmHeaderEnd = "[Header end]";

constexpr std::array<std::pair<std::string_view, SampleType>, 4> kTypes{
    {{"short", SampleType::Int16},
     {"integer", SampleType::Int32},
     {"float", SampleType::Float32},
     {"double", SampleType::Float64}}};

/// It says what the file holds.
std::string secondLine(const ByteSource& bytes) {
    const std::string start = bytes.start(256);
    const std::vector<std::string_view> lines = linesOf(start);
    return lines.size() > 1 ? std::string(lines[1]) : std::string();
}

/// Files as text have readers of their own.
bool recognizesWsxm(const ByteSource& bytes) {
    if (!bytes.startsWith(kWsxmMagic)) {
        return false;
    }
    const std::string kind = secondLine(bytes);
    return !kind.starts_with(kPointsLine) && !kind.starts_with(kMatrixLine);
}

class WsxmReader {
public:
    explicit WsxmReader(const ByteSource& bytes)
        : bytes_(bytes)
        , header_(imageHeader())
        , sections_(sectionsOf(header_.text, ':', bytes.name()))
        , general_(section("General Info"))
        , control_(section("Control")) {}

    StoredScan read() {
        const SampleLayout samples{.size = imageSize(),
                                   .type = sampleType(),
                                   .offset = dataStart(),
                                   .bottomFirst = true,
                                   .rightFirst = true};
        requireSamples(bytes_, samples, "image");
        StoredScan result;
        result.texts = texts();
        result.channels.push_back(channelOf(samples));
        const std::string turned = control_.text("Angle");
        const std::optional<LeadingNumber> angle = parseLeadingNumber(turned);
        noteRotation(result.notes, angle ? angle->value : 0.0);
        const std::string version = section("Miscellaneous").text("Version");
        if (!version.empty()) {
            result.provenance.push_back({"format version", version, "[Miscellaneous] Version"});
        }
        return result;
    }

private:
    [[nodiscard]] HeaderText imageHeader() const {
        const std::string kind = secondLine(bytes_);
        if (!kind.starts_with(kImageLine)) {
            const std::string lower = lowerCase(kind);
            const bool curves = lower.find("curve") != std::string::npos ||
                                lower.find("graph") != std::string::npos ||
                                lower.find("force") != std::string::npos;
            throw InputError(bytes_.name(), "line 2",
                             curves ? "this WSxM file holds curves, no image ('" + kind + "')"
                                    : "expected 'SxM Image file', found '" + kind + "'");
        }
        return headerText(bytes_, kWsxmHeaderEnd);
    }

    [[nodiscard]] HeaderFields section(const std::string& name) const {
        const auto found = sections_.find(name);
        return found == sections_.end() ? HeaderFields(bytes_.name(), "[" + name + "]")
                                        : found->second;
    }

    [[nodiscard]] BoundedTexts texts() const {
        BoundedTexts texts;
        for (const auto& [name, fields] : sections_) {
            for (const auto& [key, value] : fields.all()) {
                texts.add(std::string(name).append(": ").append(key), value);
            }
        }
        return texts;
    }

    [[nodiscard]] ImageSize imageSize() const {
        return checkedImageSize(general_.integer("Number of columns"),
                                general_.integer("Number of rows"), bytes_.name(),
                                "[General Info] Number of columns, Number of rows");
    }

    [[nodiscard]] SampleType sampleType() const {
        const std::string* const word = general_.find("Image Data Type");
        const auto* const type = std::ranges::find_if(kTypes, [word](const auto& each) {
            return each.first == (word == nullptr ? "short" : std::string_view(*word));
        });
        if (type == kTypes.end()) {
            general_.fail("Image Data Type",
                          "expected short, integer, float or double, found '" + *word + "'");
        }
        return type->second;
    }

    /// The size that line 3 gives the header is not always right; its last line end is.
    [[nodiscard]] std::uint64_t dataStart() const {
        std::string lineEnd(std::min<std::uint64_t>(2, bytes_.size() - header_.end), '\0');
        bytes_.read(header_.end, lineEnd);
        if (!lineEnd.starts_with('\n') && lineEnd != "\r\n") {
            throw InputError(bytes_.name(), "byte " + std::to_string(header_.end),
                             "expected a line end after '[Header end]'");
        }
        return header_.end + (lineEnd.starts_with('\n') ? 1 : 2);
    }

    [[nodiscard]] StoredChannel channelOf(const SampleLayout& samples) const {
        StoredChannel stored{.readRow = rowsOf(bytes_, samples)};
        ScanChannel& channel = stored.channel;
        channel.name = general_.text("Acquisition channel");
        if (channel.name.empty()) {
            channel.name = "Untitled";
        }
        channel.lateralUnit = "m";
        channel.direction = directionFromName(general_.text("X scanning direction"));
        channel.map = emptyMap(samples.size, parseLength(control_.text("X Amplitude")).value_or(0),
                               parseLength(control_.text("Y Amplitude")).value_or(0));
        const std::optional<double> x = parseLength(control_.text("X Offset"));
        const std::optional<double> y = parseLength(control_.text("Y Offset"));
        if (x || y) {
            setOrigin(channel, x.value_or(0.0), y.value_or(0.0), GivenPoint::Center);
        }
        settleSize(channel, "[Control] X Amplitude, Y Amplitude");
        channel.provenance.push_back({"orientation", "rows and columns are stored in reverse order",
                                      "the same in every WSxM file"});
        setScale(stored, samples.size);
        return stored;
    }

    /// The stored numbers span the amplitude, whatever they are; their level means nothing.
    void setScale(StoredChannel& stored, ImageSize size) const {
        const std::string text = general_.text("Z Amplitude");
        const std::optional<LeadingNumber> amplitude = parseLeadingNumber(text);
        if (!amplitude || !(std::isfinite(amplitude->value) && amplitude->value > 0.0)) {
            stored.channel.notes.emplace_back(
                "the file gives no amplitude in z; values are numbers");
            return;
        }
        const bool isCurrent = lowerCase(stored.channel.name).find("current") != std::string::npos;
        const PhysicalUnit unit =
            isCurrent ? parseUnit(amplitude->rest) : parseLengthUnit(amplitude->rest);
        stored.channel.unit = unit.base == "a.u." ? std::string() : unit.base;
        const NumberRange extent = numberRangeOf(stored.readRow, size);
        if (extent.isFlat()) {
            stored.readRow = replaced(std::move(stored.readRow), size.columns,
                                      [](double number) { return 0.0 * number; });
            return;
        }
        stored.factor = amplitude->value * unit.factor / (extent.highest - extent.lowest);
        stored.channel.provenance.push_back(scaleProvenance(stored.factor, unit.base,
                                                            "[General Info] Z Amplitude (" + text +
                                                                ") over the range of the samples"));
        stored.channel.provenance.push_back(
            {"height of zero", "arbitrary", "WSxM gives differences of height only"});
    }

    const ByteSource& bytes_;
    HeaderText header_;
    HeaderSections sections_;
    HeaderFields general_;
    HeaderFields control_;
};

constexpr std::array<std::string_view, 2> kWsxmExtensions{".stp", ".top"};

}  // namespace

const HeightMapFormat kWsxmFormat = {
    .name = "WSxM .stp/.top",
    .extensions = kWsxmExtensions,
    .recognizes = recognizesWsxm,
    .read = [](const ByteSource& bytes) { return WsxmReader(bytes).read(); }};

}  // namespace asperity
