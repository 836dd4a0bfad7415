#include "core/Error.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeaderFields.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/heightmap/SampleRows.h"
#include "core/io/heightmap/ScanImage.h"
#include "core/io/heightmap/WholeImages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

// Nanonis .sxm: lines `:TAG:` with the lines of their values, then float32 with the highest byte
// first. Source: docs/formats.md 7.

namespace asperity {

namespace {

constexpr std::string_view kNanonisMagic = ":NANONIS_VERSION:";
constexpr std::string_view kLastTag = "\n:SCANIT_END:";
constexpr std::string_view kDataMark = "\x1A\x04";

/// A row of the table DATA_INFO.
struct Signal {
    std::string name;
    std::string unit;
    std::string direction;
};

/// The cells of a row; rows of other tools have blanks in place of tabs.
std::vector<std::string> cellsOf(std::string_view line, bool hasTabs) {
    std::vector<std::string> cells;
    line = trimmed(line);
    while (!line.empty()) {
        const std::size_t end = std::min(line.find_first_of(hasTabs ? "\t" : " \t"), line.size());
        cells.push_back(toUtf8(trimmed(line.substr(0, end))));
        line.remove_prefix(std::min(end + 1, line.size()));
        if (!hasTabs) {
            line = trimmed(line);
        }
    }
    return cells;
}

class NanonisReader {
public:
    explicit NanonisReader(const ByteSource& bytes)
        : bytes_(bytes), file_(bytes.name()), tags_(bytes.name(), "") {}

    StoredScan read() {
        const HeaderText header = headerText(bytes_, kLastTag);
        parseTags(header.text);
        requireFloats();
        samples_ = {.size = imageSize(),
                    .order = ByteOrder::Big,
                    .offset = markAfter(header.end),
                    .bottomFirst = isUpward()};
        result_.texts.add(tags_.texts());
        const std::vector<Signal> signals = listedSignals();
        const bool single = holdsOneImageEach(signals);
        for (const Signal& signal : signals) {
            const bool both = signal.direction == "both";
            if (both && single) {
                addImage(signal, "");
                continue;
            }
            if (both || signal.direction == "forward") {
                addImage(signal, "forward");
            }
            if (both || signal.direction == "backward") {
                addImage(signal, "backward");
            }
        }
        addProvenance(single);
        images_.finish(result_);
        return std::move(result_);
    }

private:
    void parseTags(std::string_view header) {
        std::string_view tag;
        std::string value;
        for (const std::string_view line : linesOf(header)) {
            if (line.size() > 2 && line.starts_with(':') && line.ends_with(':')) {
                if (!tag.empty()) {
                    tags_.add(tag, value);
                }
                tag = line.substr(1, line.size() - 2);
                value.clear();
            } else {
                value.append(line).append("\n");
            }
        }
        tags_.add(tag, value);
    }

    /// Only line ends lie between the last tag and the mark of the samples.
    [[nodiscard]] std::uint64_t markAfter(std::uint64_t offset) const {
        constexpr std::uint64_t kMax = 64;
        std::string text(std::min(kMax, bytes_.size() - offset), '\0');
        bytes_.read(offset, text);
        const std::size_t found = text.find(kDataMark);
        if (found == std::string::npos) {
            throw InputError(file_, "byte " + std::to_string(offset),
                             "expected the bytes 1A 04 before the samples");
        }
        return offset + found + kDataMark.size();
    }

    /// "FLOAT MSBFIRST"; of files that say LSBFIRST the samples have the highest byte first, too.
    void requireFloats() const {
        const std::string type = tags_.text("SCANIT_TYPE");
        if (!type.starts_with("FLOAT")) {
            tags_.fail("SCANIT_TYPE", "expected FLOAT, found '" + type + "'");
        }
    }

    /// Two numbers; empty when the tag is missing.
    [[nodiscard]] std::optional<std::pair<double, double>> pair(const std::string& tag) const {
        const std::string text = tags_.text(tag);
        if (text.empty()) {
            return std::nullopt;
        }
        const std::optional<LeadingNumber> first = parseLeadingNumber(text);
        const std::optional<double> second =
            first ? parseNumber(first->rest) : std::optional<double>();
        if (!second) {
            tags_.fail(tag, "expected two numbers, found '" + text + "'");
        }
        return std::pair{first->value, *second};
    }

    [[nodiscard]] ImageSize imageSize() const {
        auto [columns, rows] = pair("SCAN_PIXELS").value_or(std::pair{0.0, 0.0});
        if (tags_.text("NANONIS_VERSION") == "1") {
            std::swap(columns, rows);
        }
        const auto whole = [this](double pixels) {
            if (!(std::abs(pixels) < 1e9 && pixels == std::floor(pixels))) {
                tags_.fail("SCAN_PIXELS", "expected two whole numbers");
            }
            return static_cast<long long>(pixels);
        };
        return checkedImageSize(whole(columns), whole(rows), file_, "SCAN_PIXELS");
    }

    [[nodiscard]] bool isUpward() const {
        const std::string direction = lowerCase(tags_.text("SCAN_DIR"));
        if (!direction.empty() && direction != "up" && direction != "down") {
            tags_.fail("SCAN_DIR", "expected up or down, found '" + direction + "'");
        }
        return direction == "up";
    }

    [[nodiscard]] std::vector<Signal> listedSignals() const {
        const std::string table = tags_.text("DATA_INFO");
        const std::vector<std::string_view> lines = linesOf(table);
        if (lines.size() < 2) {
            tags_.fail("DATA_INFO", "expected a table of the stored signals");
        }
        const bool hasTabs = lines.front().find('\t') != std::string_view::npos;
        const std::vector<std::string> titles = cellsOf(lines.front(), hasTabs);
        const auto column = [&](std::string_view title) {
            const auto found = std::ranges::find(titles, title);
            if (found == titles.end()) {
                tags_.fail("DATA_INFO", "it has no column '" + std::string(title) + "'");
            }
            return static_cast<std::size_t>(found - titles.begin());
        };
        const std::size_t name = column("Name");
        const std::size_t unit = column("Unit");
        const std::size_t direction = column("Direction");
        std::vector<Signal> signals;
        for (std::size_t i = 1; i < lines.size() && !trimmed(lines[i]).empty(); ++i) {
            const std::vector<std::string> cells = cellsOf(lines[i], hasTabs);
            if (cells.size() <= std::max({name, unit, direction})) {
                tags_.fail("DATA_INFO", "row " + std::to_string(i) + " is too short");
            }
            signals.push_back({cells[name], cells[unit], lowerCase(cells[direction])});
            requireDirection(signals.back(), i);
        }
        return signals;
    }

    void requireDirection(const Signal& signal, std::size_t row) const {
        constexpr std::array<std::string_view, 3> kDirections{"both", "forward", "backward"};
        if (std::ranges::count(kDirections, signal.direction) == 0) {
            tags_.fail("DATA_INFO", "row " + std::to_string(row) +
                                        ": expected both, forward or backward, found '" +
                                        signal.direction + "'");
        }
        requireImages(2 * row, bytes_.name(), "DATA_INFO");
    }

    /// Other tools write "both" for one image; their files have no times, and the size decides.
    [[nodiscard]] bool holdsOneImageEach(const std::vector<Signal>& signals) const {
        const bool foreign = tags_.text("ACQ_TIME") == "N/A" ||
                             lowerCase(tags_.text("SCAN_TIME")).starts_with("nan");
        return foreign && bytes_.size() - samples_.offset == signals.size() * samples_.bytes();
    }

    /// In degrees. Nanonis counts it clockwise; its size alone matters here.
    [[nodiscard]] double angle() const {
        const std::optional<LeadingNumber> angle = parseLeadingNumber(tags_.text("SCAN_ANGLE"));
        return angle ? angle->value : 0.0;
    }

    void addImage(const Signal& signal, const std::string& direction) {
        const PhysicalUnit unit = parseUnit(signal.unit);
        ScanChannel channel;
        channel.name = signal.name;
        if (!direction.empty()) {
            channel.name += direction == "forward" ? " (Forward)" : " (Backward)";
        }
        channel.unit = unit.base;
        channel.lateralUnit = "m";
        channel.direction = direction;
        const auto [width, height] = pair("SCAN_RANGE").value_or(std::pair{0.0, 0.0});
        const auto [x, y] = pair("SCAN_OFFSET").value_or(std::pair{0.0, 0.0});
        channel.map = emptyMap(samples_.size, width, height);
        setOrigin(channel, x, y, GivenPoint::Center);
        noteRotation(result_.notes, angle());
        settleSize(channel, "SCAN_RANGE");
        samples_.rightFirst = direction == "backward";
        if (samples_.rightFirst) {
            channel.provenance.push_back({"orientation of rows", "the right pixel is stored first",
                                          "the image is backward"});
        }
        const SampleLayout samples = samples_;
        samples_.offset += samples_.bytes();
        if (!images_.holds(bytes_, samples, "image '" + channel.name + "'", channel.name)) {
            return;
        }
        result_.channels.push_back({.channel = std::move(channel),
                                    .factor = unit.factor,
                                    .readRow = rowsOf(bytes_, samples)});
    }

    void addProvenance(bool single) {
        if (result_.channels.empty() && images_.areAll()) {
            tags_.fail("DATA_INFO", "it lists no signal");
        }
        if (single) {
            result_.notes.emplace_back(
                "the file names two directions, but holds one image of each signal");
        }
        result_.provenance.push_back(
            {"format version", tags_.text("NANONIS_VERSION"), "NANONIS_VERSION"});
        result_.provenance.push_back(
            {"scale", "1", "values are stored in the unit that DATA_INFO names"});
        result_.provenance.push_back({"orientation",
                                      samples_.bottomFirst ? "the bottom row is stored first"
                                                           : "the top row is stored first",
                                      tags_.find("SCAN_DIR") == nullptr
                                          ? "no SCAN_DIR in the file, taken as down"
                                          : "SCAN_DIR"});
    }

    const ByteSource& bytes_;
    const std::string& file_;
    HeaderFields tags_;
    SampleLayout samples_;  ///< of the next image
    WholeImages images_;
    StoredScan result_;
};

constexpr std::array<std::string_view, 1> kNanonisExtensions{".sxm"};

}  // namespace

const HeightMapFormat kNanonisFormat = {
    .name = "Nanonis .sxm",
    .extensions = kNanonisExtensions,
    .recognizes = [](const ByteSource& bytes) { return bytes.startsWith(kNanonisMagic); },
    .read = [](const ByteSource& bytes) { return NanonisReader(bytes).read(); }};

}  // namespace asperity
