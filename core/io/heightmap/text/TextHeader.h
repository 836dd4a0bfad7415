#pragma once

#include "core/io/TextLines.h"
#include "core/io/heightmap/BoundedTexts.h"
#include "core/io/heightmap/HeightMapFile.h"
#include "core/io/heightmap/PhysicalUnit.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// What a text file says about its numbers before the first of them.
struct TextHeader {
    std::string title;             ///< empty: none given
    double sizeX = 0.0;            ///< of the whole image, in the lateral unit; 0: not given
    double sizeY = 0.0;            ///< as sizeX
    double originX = 0.0;          ///< as sizeX
    double originY = 0.0;          ///< as sizeX
    double pitch = 0.0;            ///< of a pixel, as sizeX; given instead of a size
    std::string sizeSource;        ///< where the size or pitch stands
    std::string lateralUnit;       ///< SI base unit; empty: none given
    PhysicalUnit unit;             ///< of a number
    std::string unitSource;        ///< where the unit stands
    long long columns = 0;         ///< 0: not given
    long long rows = 0;            ///< 0: not given
    std::optional<double> noData;  ///< the number that means "no data"
    bool isMatrix = false;         ///< what it gives belongs to a matrix, not to points
    bool hasMask = false;          ///< as many lines follow that say which numbers are valid (1)
    std::array<PhysicalUnit, 3> pointUnits;  ///< of x, y, z where the columns are labeled
    BoundedTexts texts;
    std::vector<std::string> notes;
    std::string firstLine;  ///< of numbers
};

/// Reads up to the first line of numbers. Known are the comments of Gwyddion's export in whatever
/// language and those of SPIP, "h=305 w=75", the keys of ESRI grids and of WSxM's matrices, and
/// labels of three columns, WSxM's among them.
/// @return empty when anything else stands there, as in a text that is no height map
/// @throw InputError when a known line does not hold what it should
[[nodiscard]] std::optional<TextHeader> readTextHeader(TextLines& lines);

}  // namespace asperity
