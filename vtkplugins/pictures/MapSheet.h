#pragma once

#include "vtkplugins/pictures/Charts.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace asperity {

/// What 98 % of values span, from the 1st to the 99th percentile.
struct CentralRange {
    double low = 0.0;
    double high = 1.0;
};
/// Of the values that are finite; 0 to 1 where none is.
[[nodiscard]] CentralRange centralRange(const std::vector<double>& values);

/// One map of a sheet, seen from above.
struct SheetMap {
    std::string quantity;  ///< "pull-off force"
    std::string unit;      ///< SI unit of the values; empty: numbers
    int columns = 0;
    int rows = 0;
    double width = 1e-6;         ///< of the mapped area [m]
    double height = 1e-6;        ///< likewise
    std::vector<double> values;  ///< row by row, the top row first; NaN: no data
    bool isSigned = false;       ///< colors diverge from zero
    /// That colors span; none: the central range of the values.
    std::optional<CentralRange> range{};
};

/// Draws up to six maps side by side, each with its color bar and a scale bar. Pixels without data
/// are gray. The same maps give the same bytes.
/// @param chart takes what is left of the last row of three, or a row of its own; null: none
/// @throw Error when there is no map or a map has another number of values than rows times columns,
///        no display answers, or the file cannot be written
void writeMapSheet(const std::filesystem::path& path, const std::string& title,
                   std::span<const SheetMap> maps, const Chart* chart = nullptr);

}  // namespace asperity
