#pragma once

#include "core/Progress.h"
#include "core/surface/PixelVector.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace asperity {

/// A rectangular grid of heights, as a scan gives it.
///
/// Row-major; row 0 is the top row of the image, column 0 its left column. In the world frame
/// (x right, y up, z out of the sample; origin at the image's lower-left corner) the center of
/// pixel (row, column) lies at ((column + 0.5) pitchX, (rows - row - 0.5) pitchY).
template <class Heights>
struct BasicHeightMap {
    int columns = 0;
    int rows = 0;
    double pitchX = 0.0;  ///< pixel width [m]
    double pitchY = 0.0;  ///< pixel height [m]
    Heights heights;      ///< rows x columns [m]; NaN where invalid
    /// rows x columns, set where the scan holds no data; empty when every pixel is valid.
    PixelMask invalid;

    [[nodiscard]] std::size_t index(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
    [[nodiscard]] double at(int row, int column) const { return heights[index(row, column)]; }
    [[nodiscard]] bool isValid(int row, int column) const {
        return invalid.empty() || !invalid[index(row, column)];
    }
    [[nodiscard]] double sizeX() const { return columns * pitchX; }  ///< [m]
    [[nodiscard]] double sizeY() const { return rows * pitchY; }     ///< [m]
};

/// Heights as exactly as any file gives them.
using HeightMap = BasicHeightMap<std::vector<double>>;

/// Heights in single precision, relative to a datum: half the memory, for the way of a large scan
/// into a scene. Off by at most 2^-24 of a height's distance from the datum.
struct ScanMap : BasicHeightMap<PixelVector<float>> {
    double datum = 0.0;  ///< the height that `heights` and at() are relative to [m]
};

/// The middle between the lowest and the highest height; 0 when there is none [m].
/// @throw Error when the heights lie too far apart for single precision
[[nodiscard]] double middleHeight(const HeightMap& map);

/// Returns whether a height is a finite number. Tests its bits: over a whole map the compiler turns
/// std::isfinite into comparisons that raise the invalid flag on a NaN.
[[nodiscard]] constexpr bool isFiniteHeight(double height) {
    constexpr std::uint64_t kExponent = 0x7ff0000000000000U;
    return (std::bit_cast<std::uint64_t>(height) & kExponent) != kExponent;
}
[[nodiscard]] constexpr bool isFiniteHeight(float height) {
    constexpr std::uint32_t kExponent = 0x7f800000U;
    return (std::bit_cast<std::uint32_t>(height) & kExponent) != kExponent;
}

/// Refuses a map that no computation can use.
/// @throw Error when it has no pixels, its arrays do not match its size, or a pitch is not positive
template <class Heights>
void requireUsable(const BasicHeightMap<Heights>& map);

/// A height map as those take it who need one row after the other: writers of files.
struct HeightRows {
    int columns = 0;
    int rows = 0;
    double pitchX = 0.0;  ///< pixel width [m]
    double pitchY = 0.0;  ///< pixel height [m]
    /// Writes the heights of a row, 0 at the top [m]; NaN where the scan holds no data.
    std::function<void(int row, double* heights)> readRow;
    /// The same with heights that were filled in where the scan holds none; empty: none were.
    std::function<void(int row, double* heights)> readFilledRow = {};

    [[nodiscard]] double sizeX() const { return columns * pitchX; }  ///< [m]
    [[nodiscard]] double sizeY() const { return rows * pitchY; }     ///< [m]
};

/// The rows of a map, which must outlive them. @throw Error when the map is unusable
[[nodiscard]] HeightRows rowsOf(const HeightMap& map);
[[nodiscard]] HeightRows rowsOf(const ScanMap& map);

/// Calls visit(row, heights), from the top down, with a std::vector<double>&.
/// @throw Canceled
template <class Visit>
void forEachRow(const HeightRows& rows, Progress* progress, const Visit& visit) {
    constexpr int kReports = 50;
    const int step = rows.rows / kReports + 1;
    std::vector<double> heights(static_cast<std::size_t>(rows.columns));
    for (int row = 0; row < rows.rows; ++row) {
        if (row % step == 0) {
            reportTo(progress, static_cast<double>(row) / rows.rows);
        }
        rows.readRow(row, heights.data());
        visit(row, heights);
    }
    reportTo(progress, 1.0);
}

/// A rectangle of pixels of a scan.
struct PixelRectangle {
    int column = 0;   ///< its left column; 0 is that of the scan
    int row = 0;      ///< its top row; 0 is that of the scan
    int columns = 0;  ///< how many
    int rows = 0;     ///< how many

    /// Returns whether it holds a pixel, and none outside a scan of this size.
    [[nodiscard]] constexpr bool liesIn(int scanColumns, int scanRows) const {
        return column >= 0 && row >= 0 && columns > 0 && rows > 0 &&
               columns <= scanColumns - column && rows <= scanRows - row;
    }
    bool operator==(const PixelRectangle&) const = default;
};

/// The map with a height in every pixel: those that held none get a blend of their surroundings,
/// grown inward from the rim of each hole, and are marked in the mask. Linear time.
///
/// A pixel holds no height when its value is not a finite number. A pixel that is marked invalid
/// but holds a finite height (filled before, or masked by the user) keeps both.
/// @throw Error when the map is unusable or no pixel holds a height
[[nodiscard]] HeightMap withInvalidPixelsFilled(HeightMap map);
[[nodiscard]] ScanMap withInvalidPixelsFilled(ScanMap map);

}  // namespace asperity
