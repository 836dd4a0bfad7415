#include "core/Error.h"
#include "core/io/TextLines.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/NumberRow.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/heightmap/SampleRows.h"
#include "core/io/heightmap/ScanImage.h"
#include "core/io/heightmap/nanoscope/NanoscopeHeader.h"
#include "core/io/heightmap/nanoscope/NanoscopeImage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <optional>
#include <utility>

// Images that NanoScope Analysis exports as text: perhaps the header in quotation marks, a line of
// titles with units, and a line for each pixel with a number for each channel.
// Source: docs/formats.md 3.

namespace asperity {

namespace {

constexpr std::uint64_t kHeaderGlance = std::uint64_t{1} << 12U;  // [bytes]
constexpr long long kMaxTextLines = 20000;
constexpr std::string_view kQuotedSection = "\"\\*";

/// "Height_Sensor(nm)"
struct ColumnTitle {
    std::string name;
    std::string unit;
};

/// Returns the separator of a line of titles.
char separatorOf(std::string_view titles) {
    for (const char separator : {'\t', ';', ','}) {
        if (titles.find(separator) != std::string_view::npos) {
            return separator;
        }
    }
    return '\t';
}

/// A cell whose unit is in brackets at its end. Lengths and other units may follow a blank.
std::optional<ColumnTitle> titleIn(std::string_view cell) {
    cell = trimmed(cell);
    if (cell.size() > 1 && cell.starts_with('"') && cell.ends_with('"')) {
        cell = trimmed(cell.substr(1, cell.size() - 2));
    }
    const std::size_t open = cell.rfind('(');
    const bool isNamed =
        !cell.empty() && ((cell[0] >= 'A' && cell[0] <= 'Z') || (cell[0] >= 'a' && cell[0] <= 'z'));
    if (!isNamed || open == std::string_view::npos || open == 0 || !cell.ends_with(')')) {
        return std::nullopt;
    }
    return ColumnTitle{toUtf8(trimmed(cell.substr(0, open))),
                       toUtf8(trimmed(cell.substr(open + 1, cell.size() - open - 2)))};
}

/// Empty where the line holds anything else.
std::vector<ColumnTitle> titlesIn(std::string_view line) {
    const char separator = separatorOf(line);
    std::vector<ColumnTitle> titles;
    line = trimmed(line);
    while (!line.empty()) {
        const std::size_t end = std::min(line.find(separator), line.size());
        const std::optional<ColumnTitle> title = titleIn(line.substr(0, end));
        if (!title) {
            return {};
        }
        titles.push_back(*title);
        line.remove_prefix(std::min(end + 1, line.size()));
    }
    return titles;
}

/// Columns called x, y and one more are points.
bool arePoints(const std::vector<ColumnTitle>& titles) {
    return titles.size() == 3 && lowerCase(titles[0].name) == "x" &&
           lowerCase(titles[1].name) == "y";
}

/// Curves as text have the quantity that the others are measured over in the first column.
bool areCurves(const std::vector<ColumnTitle>& titles) {
    constexpr std::array<std::string_view, 9> kAbscissas{"z",
                                                         "time",
                                                         "ramp",
                                                         "distance",
                                                         "separation",
                                                         "extension",
                                                         "tip-sample separation",
                                                         "sample bias",
                                                         "x"};
    return titles.size() > 1 && std::ranges::count(kAbscissas, lowerCase(titles[0].name)) > 0;
}

/// Returns the style of the numbers below a line of titles, which shows their separator.
NumberStyle styleBelow(std::string_view titles, std::size_t columns) {
    const char separator = separatorOf(titles);
    return columns == 1 ? NumberStyle{.separator = ' ', .decimalComma = true}
                        : NumberStyle{.separator = separator, .decimalComma = separator != ','};
}

/// The numbers of a line without the empty cell behind a last separator; empty: it is none of
/// these.
bool readsAs(std::string_view line, const NumberStyle& style, std::size_t columns, NumberRow& row) {
    readNumberRow(line, style, row);
    if (row.endsEmpty && row.numbers.size() == columns + 1) {
        row.numbers.pop_back();
    }
    return row.wrong.empty() && row.numbers.size() == columns;
}

/// Titles with units and, below them, a line with a number for each.
bool beginsWithTitles(const ByteSource& bytes) {
    const std::string start = bytes.start(kHeaderGlance);
    const MemoryBytes glance(start, bytes.name());
    TextLines lines(glance);
    const std::optional<std::string_view> first = lines.next();
    const std::string titleLine(first.value_or(""));
    const std::vector<ColumnTitle> titles = titlesIn(titleLine);
    const std::optional<std::string_view> second =
        titles.empty() || arePoints(titles) ? std::nullopt : lines.next();
    NumberRow row;
    return second && !trimmed(*second).empty() &&
           readsAs(*second, styleBelow(titleLine, titles.size()), titles.size(), row);
}

bool recognizesNanoscopeText(const ByteSource& bytes) {
    return bytes.startsWith(kQuotedSection) || beginsWithTitles(bytes);
}

class NanoscopeTextReader {
public:
    explicit NanoscopeTextReader(const ByteSource& bytes) : file_(bytes.name()), lines_(bytes) {}

    StoredScan read() {
        readHeader();
        readNumbers();
        NanoscopeLayout layout = sizeOfImages();
        StoredScan result;
        for (std::size_t i = 0; i < titles_.size(); ++i) {
            result.channels.push_back(channelOf(i, layout));
        }
        if (!images_.empty()) {
            takeSharedTexts(result.texts);
            noteRotation(result.notes, imageOf(0).rotation());
        }
        const std::string version = images_.empty() ? "" : imageOf(0).ofFile("Version");
        if (!version.empty()) {
            result.provenance.push_back({"format version", version, "File list, Version"});
        }
        return result;
    }

private:
    /// Up to the titles.
    void readHeader() {
        while (const std::optional<std::string_view> line = lines_.next()) {
            std::string_view text = trimmed(*line);
            if (text.size() > 1 && text.starts_with('"') && text.ends_with('"')) {
                text = trimmed(text.substr(1, text.size() - 2));
            }
            if (lines_.number() > kMaxTextLines) {
                break;
            }
            if (text.starts_with('\\')) {
                takeNanoscopeLine(withPoints(text.substr(1)), sections_);
            } else if (!text.empty()) {
                takeTitles(*line);
                collectImages();
                return;
            }
        }
        lines_.fail("expected a line of titles with units, such as 'Height_Sensor(nm)'");
    }

    /// With decimal points in place of decimal commas, of which a scan size may have two.
    static std::string withPoints(std::string_view line) {
        std::string text(line);
        const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
        for (std::size_t i = 1; i + 1 < text.size(); ++i) {
            if (text[i] == ',' && isDigit(text[i - 1]) && isDigit(text[i + 1])) {
                text[i] = '.';
            }
        }
        return text;
    }

    void takeTitles(std::string_view line) {
        titles_ = titlesIn(line);
        if (titles_.empty()) {
            lines_.fail("expected titles with units, such as 'Height_Sensor(nm)'");
        }
        requireImages(titles_.size(), file_, "line " + std::to_string(lines_.number()));
        titleLine_ = lines_.number();
        style_ = styleBelow(line, titles_.size());
        numbers_.resize(titles_.size());
    }

    void collectImages() {
        for (const NanoscopeSection& section : sections_) {
            if (isNanoscopeImageList(section)) {
                images_.push_back(&section);
            }
        }
        if (!sections_.empty() && images_.empty()) {
            throw InputError(file_, "header",
                             "this NanoScope text lists no image ('Ciao image list')");
        }
    }

    void readNumbers() {
        NumberRow row;
        while (const std::optional<std::string_view> line = lines_.next()) {
            if (trimmed(*line).empty()) {
                continue;
            }
            if (!readsAs(*line, style_, titles_.size(), row)) {
                lines_.fail(row.wrong.empty()
                                ? "found " + std::to_string(row.numbers.size()) +
                                      " numbers; the titles are " + std::to_string(titles_.size())
                                : "expected numbers, found '" +
                                      toUtf8(row.wrong.substr(0, kShown)) + "'");
            }
            for (std::size_t i = 0; i < row.numbers.size(); ++i) {
                numbers_[i].push_back(row.numbers[i]);
            }
        }
    }

    /// Returns a column's image; the lists are in the order of the columns where there are as many.
    [[nodiscard]] NanoscopeImage imageOf(std::size_t column) const {
        const std::size_t list = images_.size() == titles_.size() ? column : 0;
        return {sections_, *images_[list], file_, "image list " + std::to_string(list + 1)};
    }

    [[nodiscard]] NanoscopeLayout sizeOfImages() const {
        const std::size_t values = numbers_.front().size();
        if (!images_.empty()) {
            return imageOf(0).layoutOf(values);
        }
        if (areCurves(titles_)) {
            throw InputError(file_, "",
                             "this text holds curves over '" + titles_[0].name +
                                 "', such as force curves, and no image");
        }
        const auto side = static_cast<long long>(std::llround(std::sqrt(values)));
        if (values == 0 || static_cast<std::size_t>(side * side) != values) {
            throw InputError(file_, "",
                             "this NanoScope text has no header, so that its " +
                                 std::to_string(values) +
                                 " values a channel may have any shape, and they are no square; "
                                 "export it with its header");
        }
        NanoscopeLayout layout;
        layout.size = checkedImageSize(side, side, file_, "values");
        return layout;
    }

    [[nodiscard]] StoredChannel channelOf(std::size_t column, const NanoscopeLayout& layout) {
        const ColumnTitle& title = titles_[column];
        const PhysicalUnit unit = parseUnit(title.unit == "Deg" ? "deg" : title.unit);
        ScanChannel channel;
        channel.name = title.name;
        channel.unit = unit.base;
        channel.map = emptyMap(layout.size, layout.sizeX, layout.sizeY);
        if (images_.empty()) {
            channel.notes.push_back("the file has no header: its shape is not known, and " +
                                    std::to_string(numbers_[column].size()) +
                                    " values are taken as a square");
        } else {
            describe(channel, imageOf(column), layout);
        }
        const std::string line = "line " + std::to_string(titleLine_) + ", '" + title.name + "'";
        settleSize(channel, "Scan Size of the header");
        channel.provenance.push_back(scaleProvenance(unit.factor, unit.base, line));
        channel.provenance.push_back(
            {"orientation", "the first value is that of the top left pixel", "usual"});
        return {.channel = std::move(channel),
                .factor = unit.factor,
                .readRow = rowsOfNumbers(std::move(numbers_[column]), layout.size.columns)};
    }

    void describe(ScanChannel& channel, const NanoscopeImage& image,
                  const NanoscopeLayout& layout) const {
        channel.lateralUnit = "m";
        channel.direction = image.direction();
        if (const std::optional<NanoscopePosition> center = image.center(layout)) {
            setOrigin(channel, center->x, center->y, GivenPoint::Center);
        }
        if (std::string note = image.partNote(); !note.empty()) {
            channel.notes.push_back(std::move(note));
        }
    }

    void takeSharedTexts(BoundedTexts& texts) const {
        for (const NanoscopeSection& section : sections_) {
            if (!isNanoscopeImageList(section)) {
                for (const auto& [key, entry] : section.entries) {
                    texts.set(entry.key, entry.value);
                }
            }
        }
    }

    static constexpr std::size_t kShown = 32;

    std::string file_;
    TextLines lines_;
    std::vector<NanoscopeSection> sections_;
    std::vector<const NanoscopeSection*> images_;  ///< lists of images
    std::vector<ColumnTitle> titles_;
    long long titleLine_ = 0;
    NumberStyle style_;
    std::vector<std::deque<double>> numbers_;  ///< of each column
};

constexpr std::array<std::string_view, 1> kNanoscopeTextExtensions{".txt"};

}  // namespace

const HeightMapFormat kNanoscopeTextFormat = {
    .name = "NanoScope Analysis text",
    .extensions = kNanoscopeTextExtensions,
    .recognizes = recognizesNanoscopeText,
    .read = [](const ByteSource& bytes) { return NanoscopeTextReader(bytes).read(); }};

}  // namespace asperity
