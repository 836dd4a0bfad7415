#include "core/io/heightmap/NumberRow.h"

#include "core/io/TextValue.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>

namespace asperity {

namespace {

constexpr double kRowNoData = std::numeric_limits<double>::quiet_NaN();
constexpr std::string_view kBlanks = " \t";

/// In lower case. Those of std::from_chars ("nan", "inf") are none of them.
constexpr std::array<std::string_view, 10> kMissingWords = {
    "bad", "n/a", "na", "null", "1.#qnan", "-1.#qnan", "1.#ind", "-1.#ind", "1.#inf", "-1.#inf"};

bool isBlank(char c) { return c == ' ' || c == '\t'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

bool consistsOf(std::string_view text, char c) {
    return !text.empty() && text.find_first_not_of(c) == std::string_view::npos;
}

/// A comma between digits, with blanks or tabs between the numbers: "1,5 2,5".
bool hasDecimalCommas(std::string_view line) {
    if (line.find_first_of(kBlanks) == std::string_view::npos) {
        return false;
    }
    for (std::size_t i = line.find(','); i != std::string_view::npos; i = line.find(',', i + 1)) {
        if (i + 1 == line.size() || !isDigit(line[i + 1])) {
            return false;
        }
    }
    return true;
}

std::optional<double> withDecimalComma(std::string_view cell) {
    std::string text(cell);
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos) {
        return std::nullopt;
    }
    text[comma] = '.';
    return parseNumber(text);
}

/// @param cell without blanks around it
std::optional<double> valueOf(std::string_view cell, const NumberStyle& style, NumberRow& row) {
    std::optional<double> number = parseNumber(cell);
    if (!number && style.decimalComma) {
        number = withDecimalComma(cell);
        row.hasDecimalComma = row.hasDecimalComma || number.has_value();
    }
    if (!number && isMissingWord(cell)) {
        number = kRowNoData;
    }
    return number;
}

void readBlankSeparated(std::string_view line, const NumberStyle& style, NumberRow& row) {
    const char* at = line.data();
    const char* const end = at + line.size();
    while (true) {
        at = std::find_if_not(at, end, isBlank);
        if (at == end) {
            return;
        }
        double number = 0.0;
        const std::from_chars_result result = std::from_chars(at, end, number);
        if (result.ec == std::errc() && (result.ptr == end || isBlank(*result.ptr))) {
            row.numbers.push_back(number);
            at = result.ptr;
            continue;
        }
        const char* const cellEnd = std::find_if(at, end, isBlank);
        const std::string_view cell(at, static_cast<std::size_t>(cellEnd - at));
        const std::optional<double> value = valueOf(cell, style, row);
        if (!value) {
            row.wrong = cell;
            return;
        }
        row.numbers.push_back(*value);
        at = cellEnd;
    }
}

void readCells(std::string_view line, const NumberStyle& style, NumberRow& row) {
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = std::min(line.find(style.separator, begin), line.size());
        const std::string_view cell = trimmed(line.substr(begin, end - begin));
        begin = end + 1;
        row.endsEmpty = cell.empty();
        const std::optional<double> value = cell.empty() ? kRowNoData : valueOf(cell, style, row);
        if (!value) {
            row.wrong = cell;
            return;
        }
        row.numbers.push_back(*value);
    }
}

/// One tab between two cells, as a spreadsheet writes them: two mean that a cell is empty.
bool isTabbed(std::string_view line) {
    const bool hasBlanks = trimmed(line).find(' ') != std::string_view::npos;
    return !hasBlanks && line.find('\t') != std::string_view::npos && !line.starts_with('\t');
}

}  // namespace

NumberStyle numberStyleOf(std::string_view line) {
    if (line.find(';') != std::string_view::npos) {
        return {.separator = ';', .decimalComma = true};
    }
    if (line.find(',') == std::string_view::npos || hasDecimalCommas(line)) {
        return {.separator = isTabbed(line) ? '\t' : ' ', .decimalComma = true};
    }
    return {.separator = ',', .decimalComma = false};
}

void readNumberRow(std::string_view line, const NumberStyle& style, NumberRow& row) {
    row.numbers.clear();
    row.endsEmpty = false;
    row.wrong = {};
    if (style.separator == ' ') {
        readBlankSeparated(line, style, row);
    } else {
        readCells(style.separator == '\t' ? line : trimmed(line), style, row);
    }
}

bool isMissingWord(std::string_view cell) {
    const bool dashes = cell.size() > 1 && consistsOf(cell, '-');
    return dashes || consistsOf(cell, '*') ||
           std::ranges::count(kMissingWords, lowerCase(cell)) > 0;
}

NumberRange numberRangeOf(const ReadRow& rows, ImageSize size) {
    NumberRange range;
    RowRoom room;
    std::vector<double> numbers(static_cast<std::size_t>(size.columns));
    for (int row = 0; row < size.rows; ++row) {
        rows(row, room, numbers.data());
        for (const double number : numbers) {
            if (isFiniteHeight(number)) {
                range.lowest = std::min(range.lowest, number);
                range.highest = std::max(range.highest, number);
            }
        }
    }
    return range;
}

}  // namespace asperity
