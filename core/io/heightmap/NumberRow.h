#pragma once

#include <string_view>
#include <vector>

namespace asperity {

/// How the numbers of a text file stand in their lines.
struct NumberStyle {
    char separator = ' ';       ///< ';', ',', '\t', or ' ' for blanks and tabs, any number of them
    bool decimalComma = false;  ///< "1,5"; a point is a decimal sign as well
};

/// What the first line of numbers shows: a ';' separates; a ',' does where nothing else can.
[[nodiscard]] NumberStyle numberStyleOf(std::string_view line);

/// The numbers of one line.
struct NumberRow {
    /// NaN for a word that means "no data" ("NaN", "Bad", "***", "1.#QNAN") and for an empty cell.
    std::vector<double> numbers;
    bool hasDecimalComma = false;  ///< in any number
    bool endsEmpty = false;        ///< its last cell is empty: the line ends with a separator
    std::string_view wrong;        ///< the first cell that is neither; empty when all are well
};

/// Reads a line; what is in `row` is replaced, its memory used again.
void readNumberRow(std::string_view line, const NumberStyle& style, NumberRow& row);

/// Whether a cell means "no data".
[[nodiscard]] bool isMissingWord(std::string_view cell);

}  // namespace asperity
