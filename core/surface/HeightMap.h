#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace asperity {

/// A rectangular grid of heights, as a scan gives it.
///
/// Row-major; row 0 is the top row of the image, column 0 its left column. In the world frame
/// (x right, y up, z out of the sample; origin at the image's lower-left corner) the centre of pixel
/// (row, column) lies at ((column + 0.5) pitchX, (rows - row - 0.5) pitchY).
struct HeightMap {
    int columns = 0;
    int rows = 0;
    double pitchX = 0.0;          ///< pixel width [m]
    double pitchY = 0.0;          ///< pixel height [m]
    std::vector<double> heights;  ///< rows x columns [m]; NaN where invalid
    /// rows x columns, 1 where the scan holds no data; empty when every pixel is valid.
    std::vector<std::uint8_t> invalid;

    [[nodiscard]] std::size_t index(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
    [[nodiscard]] double at(int row, int column) const { return heights[index(row, column)]; }
    [[nodiscard]] bool isValid(int row, int column) const {
        return invalid.empty() || invalid[index(row, column)] == 0;
    }
    [[nodiscard]] double sizeX() const { return columns * pitchX; }  ///< [m]
    [[nodiscard]] double sizeY() const { return rows * pitchY; }     ///< [m]
};

}  // namespace asperity
