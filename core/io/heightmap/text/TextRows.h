#pragma once

#include "core/io/TextLines.h"
#include "core/io/heightmap/NumberRow.h"
#include "core/io/heightmap/text/TextHeader.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace asperity {

/// The lines of numbers of a text, the first of which the header holds. All have as many numbers as
/// the first; empty lines and comments between them are left out.
class TextRows {
public:
    /// @param lines  where the header ended; must outlive this, as must the header
    TextRows(TextLines& lines, const TextHeader& header);

    /// The numbers of the next line, NaN where there are no data; they hold until the next call.
    /// Empty at the end of the text.
    /// @throw InputError naming the line when it holds anything but numbers, more or fewer than the
    ///        first one, or more than 65536
    [[nodiscard]] std::span<const double> next();
    [[nodiscard]] std::size_t columns() const { return columns_; }
    /// Returns separator and decimal sign of the numbers so far, unless they are blanks and points.
    [[nodiscard]] std::vector<Provenance> provenance() const;

private:
    void read(std::string_view line);

    TextLines& lines_;
    const TextHeader& header_;
    NumberStyle style_;
    NumberRow row_;
    std::size_t columns_ = 0;
    bool hasDecimalComma_ = false;
    bool isFirst_ = true;
    bool isAfterComment_ = false;  ///< behind the first numbers
};

/// Returns whether the numbers are x, y and z of points: three columns and no size of a matrix.
[[nodiscard]] bool holdsPoints(const TextHeader& header);

/// The header of a text that begins like a height map; few bytes of it are looked at.
[[nodiscard]] std::optional<TextHeader> glanceAtText(const ByteSource& bytes);

/// The header, which must be there.
/// @throw InputError
[[nodiscard]] TextHeader requireTextHeader(TextLines& lines);

}  // namespace asperity
