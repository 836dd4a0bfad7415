#pragma once

#include "core/surface/HeightMap.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace asperity {

/// A quantity that is known at the pixels of a scan, to be looked up between them. Immutable, safe
/// to read from any thread. Kept in single precision.
class PixelField {
public:
    /// @param map  the values instead of heights; what is invalid or not finite holds none
    /// @param unit of the values, for people
    /// @throw Error when the map is unusable
    template <class Heights>
    PixelField(const BasicHeightMap<Heights>& map, std::string unit);

    /// At world (x, y) [m], linear between the four pixels around it; a position beyond the
    /// outermost pixel centers counts as the nearest one among them. Not a number where a pixel
    /// that bears weight holds no value.
    [[nodiscard]] double at(double x, double y) const noexcept;

    [[nodiscard]] const std::string& unit() const noexcept { return unit_; }
    /// Least of all values; not a number where there is none.
    [[nodiscard]] double lowest() const noexcept { return lowest_; }
    [[nodiscard]] double highest() const noexcept { return highest_; }
    [[nodiscard]] int columns() const noexcept { return columns_; }
    [[nodiscard]] int rows() const noexcept { return rows_; }
    [[nodiscard]] double sizeX() const noexcept { return columns_ * pitchX_; }  ///< [m]
    [[nodiscard]] double sizeY() const noexcept { return rows_ * pitchY_; }     ///< [m]

private:
    [[nodiscard]] double pixel(int row, int column) const noexcept {
        return values_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                       static_cast<std::size_t>(column)];
    }

    int columns_;
    int rows_;
    double pitchX_;              ///< [m]
    double pitchY_;              ///< [m]
    std::vector<float> values_;  ///< row 0 is the top row
    std::string unit_;
    double lowest_ = std::numeric_limits<double>::quiet_NaN();
    double highest_ = std::numeric_limits<double>::quiet_NaN();
};

/// A quantity in the pixels of a rectangle of a surface, such as a force map of a part of a scan;
/// beside the rectangle there is none. Nothing lies between the pixels: a position has the value of
/// the pixel that it lies in.
class RegionField {
public:
    /// A rectangle of the surface, world frame [m].
    struct Area {
        double left = 0.0;
        double bottom = 0.0;
        double width = 0.0;
        double height = 0.0;
    };

    /// @param values row by row, row 0 at the top; not a number where a pixel holds none
    /// @param unit of the values, for people
    /// @throw Error when there is not one value for each pixel, no pixel, or no area
    RegionField(const Area& area, int columns, int rows, std::vector<float> values,
                std::string unit);

    /// Returns whether world (x, y) [m] lies in the rectangle.
    [[nodiscard]] bool covers(double x, double y) const noexcept;
    /// Value at world (x, y) [m]; not a number beside the rectangle or where its pixel holds none.
    [[nodiscard]] double at(double x, double y) const noexcept;
    /// Returns whether a pixel holds no value.
    [[nodiscard]] bool hasGaps() const noexcept;

    [[nodiscard]] const std::string& unit() const noexcept { return unit_; }
    [[nodiscard]] const Area& area() const noexcept { return area_; }

private:
    Area area_;
    int columns_;
    int rows_;
    std::vector<float> values_;
    std::string unit_;
};

/// A position among the pixel centers of a row or column.
struct BetweenPixels {
    int first = 0;
    int second = 0;
    double part = 0.0;  ///< of the way from the first to the second, 0 to below 1
};

/// @param position in pixels, 0 at the center of the first one; clamped to the outermost ones
/// @param pixels in all
[[nodiscard]] inline BetweenPixels betweenPixels(double position, int pixels) noexcept {
    const double inside = std::clamp(position, 0.0, pixels - 1.0);
    const int first = static_cast<int>(inside);
    return {.first = first, .second = std::min(first + 1, pixels - 1), .part = inside - first};
}

/// A position in pixels, or the pixel center that rounding parts it from.
[[nodiscard]] inline double onCenter(double position) noexcept {
    constexpr double kSame = 1e-6;
    const double center = std::round(position);
    return std::abs(position - center) < kSame ? center : position;
}

/// Linear between two values. A weight of zero takes nothing from a value that is no number; not
/// std::lerp(), which does.
[[nodiscard]] inline double mixed(double from, double to, double part) noexcept {
    return part > 0.0 ? from + part * (to - from) : from;
}

/// Linear between four pixels.
/// @param pixel as pixel(row, column)
template <class Pixel>
[[nodiscard]] double bilinear(const BetweenPixels& rows, const BetweenPixels& columns,
                              const Pixel& pixel) noexcept {
    const auto across = [&](int row) {
        return mixed(pixel(row, columns.first), pixel(row, columns.second), columns.part);
    };
    return mixed(across(rows.first), across(rows.second), rows.part);
}

}  // namespace asperity
