#pragma once

#include "core/io/heightmap/SampleRows.h"

#include <limits>
#include <string_view>
#include <vector>

namespace asperity {

/// Notation of the numbers in the lines of a text file.
struct NumberStyle {
    char separator = ' ';       ///< ';', ',', '\t', or ' ' for blanks and tabs, any number of them
    bool decimalComma = false;  ///< "1,5"; a point is a decimal sign as well
};

/// Detects it from the first line of numbers: a ';' separates; a ',' does where nothing else can.
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

/// Returns whether a cell means "no data".
[[nodiscard]] bool isMissingWord(std::string_view cell);

/// Lowest and highest number of an image; infinite, the lowest above the highest, when it has none.
struct NumberRange {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();

    [[nodiscard]] bool isFlat() const { return !(highest > lowest); }
};

/// Returns the range of all numbers that are finite.
[[nodiscard]] NumberRange numberRangeOf(const ReadRow& rows, ImageSize size);

}  // namespace asperity
