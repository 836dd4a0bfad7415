#pragma once

#include "core/io/TextLines.h"
#include "core/io/heightmap/HeaderFields.h"
#include "core/io/heightmap/HeightMapFile.h"
#include "core/io/heightmap/PhysicalUnit.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// Header of a text file: all before the first of its numbers.
struct TextHeader {
    std::string title;             ///< empty: none given
    double sizeX = 0.0;            ///< of the whole image, in the lateral unit; 0: not given
    double sizeY = 0.0;            ///< as sizeX
    double originX = 0.0;          ///< as sizeX
    double originY = 0.0;          ///< as sizeX
    double pitch = 0.0;            ///< of a pixel, as sizeX; given instead of a size
    std::string sizeSource;        ///< location of the size or pitch
    std::string lateralUnit;       ///< SI base unit; empty: none given
    PhysicalUnit unit;             ///< of a number
    std::string unitSource;        ///< location of the unit
    long long columns = 0;         ///< 0: not given
    long long rows = 0;            ///< 0: not given
    std::optional<double> noData;  ///< the number that means "no data"
    bool isMatrix = false;         ///< its facts are those of a matrix, not of points
    bool hasMask = false;          ///< as many lines follow that say which numbers are valid (1)
    std::array<PhysicalUnit, 3> pointUnits;  ///< of x, y, z where the columns are labeled
    BoundedTexts texts;
    std::vector<std::string> notes;
    std::string firstLine;  ///< of numbers
};

/// Reads up to the first line of numbers. Known are the comments of Gwyddion's export in whatever
/// language and those of SPIP, "h=305 w=75", the keys of ESRI grids and of WSxM's matrices, and
/// labels of three columns, WSxM's among them.
/// @return empty when anything else is there, as in a text that is no height map
/// @throw InputError when a known line does not hold what it should
[[nodiscard]] std::optional<TextHeader> readTextHeader(TextLines& lines);

/// "# Width: 10.00 µm"
struct TextComment {
    std::string key;    ///< "Width"
    std::string value;  ///< "10.00 µm"
    long long line = 0;
};

/// Comments of our own files; lengths.
inline constexpr std::string_view kOriginXComment = "X offset";
inline constexpr std::string_view kOriginYComment = "Y offset";

/// Reads the comments before a matrix: Gwyddion's export writes title, width, height and unit of
/// the values, in this order and in the user's language; ours have the origin after them. All
/// others become metadata.
void takeComments(const std::vector<TextComment>& comments, TextHeader& header);

/// A text with a decimal point in place of a decimal comma: "10,00 µm". Three digits behind a comma
/// may be thousands.
[[nodiscard]] std::string withDecimalPoint(std::string text);

/// Returns whether comments of the form "key = value", the keys in lower case, are those of SPIP.
[[nodiscard]] bool isSpip(const std::vector<TextComment>& assignments);
/// Takes size, origin and unit from them.
/// @param lines of them, for messages
/// @throw InputError when a number is none
void takeSpip(const std::vector<TextComment>& assignments, const TextLines& lines,
              TextHeader& header);

/// Returns whether they state the size of a matrix.
[[nodiscard]] bool giveSize(const std::vector<TextComment>& comments);

}  // namespace asperity
