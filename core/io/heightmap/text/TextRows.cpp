#include "core/io/heightmap/text/TextRows.h"

#include "core/Error.h"
#include "core/io/TextValue.h"

namespace asperity {

namespace {

constexpr std::size_t kMaxColumns = 65536;
constexpr std::size_t kPoint = 3;                           // columns: x, y, z
constexpr std::uint64_t kGlance = std::uint64_t{1} << 16U;  // [bytes]

/// The front of a cell that is quoted in a message.
std::string excerpt(std::string_view cell) {
    constexpr std::size_t kShown = 32;
    return toUtf8(cell.substr(0, kShown)) + (cell.size() > kShown ? "..." : "");
}

bool isComment(std::string_view text) {
    return text.starts_with('#') || text.starts_with('%') || text.starts_with("//");
}

}  // namespace

TextRows::TextRows(TextLines& lines, const TextHeader& header)
    : lines_(lines), header_(header), style_(numberStyleOf(header.firstLine)) {
    read(header_.firstLine);
    columns_ = row_.numbers.size();
}

std::span<const double> TextRows::next() {
    if (isFirst_) {
        isFirst_ = false;
        return row_.numbers;
    }
    while (const std::optional<std::string_view> line = lines_.next()) {
        const std::string_view text = trimmed(*line);
        if (text.empty() || isComment(text)) {
            isAfterComment_ = isAfterComment_ || !text.empty();
            continue;
        }
        if (isAfterComment_) {
            lines_.fail("numbers go on after a comment: a file of several images is not read; "
                        "split it");
        }
        read(*line);
        return row_.numbers;
    }
    return {};
}

std::vector<Provenance> TextRows::provenance() const {
    std::vector<Provenance> entries;
    if (style_.separator == ';' || style_.separator == ',') {
        entries.push_back({"separator", std::string(1, style_.separator), "first line of numbers"});
    }
    if (hasDecimalComma_) {
        entries.push_back({"decimal sign", "a comma", "the numbers"});
    }
    return entries;
}

void TextRows::read(std::string_view line) {
    readNumberRow(line, style_, row_);
    hasDecimalComma_ = hasDecimalComma_ || row_.hasDecimalComma;
    if (!row_.wrong.empty()) {
        lines_.fail("expected numbers, found '" + excerpt(row_.wrong) + "'");
    }
    const std::size_t expected = columns_ == 0 ? row_.numbers.size() - 1 : columns_;
    if (row_.endsEmpty && row_.numbers.size() == expected + 1) {
        row_.numbers.pop_back();  // a separator at the end of the line
    }
    const std::size_t found = row_.numbers.size();
    if (columns_ != 0 && found != columns_) {
        lines_.fail("found " + std::to_string(found) + " numbers; the lines before have " +
                    std::to_string(columns_));
    }
    if (found == 0 || found > kMaxColumns) {
        lines_.fail("found " + std::to_string(found) + " numbers; 1 to " +
                    std::to_string(kMaxColumns) + " are expected");
    }
}

bool holdsPoints(const TextHeader& header) {
    NumberRow row;
    readNumberRow(header.firstLine, numberStyleOf(header.firstLine), row);
    const std::size_t columns = row.numbers.size() - (row.endsEmpty ? 1 : 0);
    return !header.isMatrix && columns == kPoint;
}

std::optional<TextHeader> glanceAtText(const ByteSource& bytes) {
    const std::string start = bytes.start(kGlance);
    const MemoryBytes glance(start, bytes.name());
    TextLines lines(glance);
    try {
        return readTextHeader(lines);
    } catch (const InputError&) {
        return TextHeader{.isMatrix = true};  // it is one, and damaged
    }
}

TextHeader requireTextHeader(TextLines& lines) {
    std::optional<TextHeader> header = readTextHeader(lines);
    if (!header) {
        lines.fail("expected lines of numbers, or what a known program writes before them");
    }
    return std::move(*header);
}

}  // namespace asperity
