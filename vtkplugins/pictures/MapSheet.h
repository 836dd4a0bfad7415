#pragma once

#include "vtkplugins/pictures/RasterImage.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace asperity {

/// Range of 98 % of values, from the 1st to the 99th percentile.
struct CentralRange {
    double low = 0.0;
    double high = 1.0;
};
/// Returns that of the values that are finite; 0 to 1 where none is.
[[nodiscard]] CentralRange centralRange(const std::vector<double>& values);

/// One map of a sheet, seen from above.
struct SheetMap {
    std::string quantity;  ///< "pull-off force"
    std::string unit;      ///< SI unit of the values; empty: numbers
    int columns = 0;
    int rows = 0;
    double width = 1e-6;         ///< of the mapped area [m]
    double height = 1e-6;        ///< same
    std::vector<double> values;  ///< row by row, the top row first; NaN: no data
    bool isSigned = false;       ///< colors diverge from zero
    /// Range that the colors span; none: the central range of the values.
    std::optional<CentralRange> range{};
};

inline constexpr int kChartPixels = 2;

/// Draws up to six maps side by side, each with its color bar and a scale bar. Pixels without data
/// are gray. The same maps give the same bytes.
/// @param chart draws what takes what is left of the last row of three, or a row of its own, with
///        kChartPixels along each side of a pixel of the size that it is given; empty: none
/// @throw Error when there is no map or a map has another number of values than rows times columns,
///        no display answers, or the file cannot be written
void writeMapSheet(const std::filesystem::path& path, const std::string& title,
                   std::span<const SheetMap> maps,
                   const std::function<RasterImage(const PictureSize&)>& chart = {});

}  // namespace asperity
