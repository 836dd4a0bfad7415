#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace asperity {

/// A quantity in the pixels of a rectangle of a surface, such as a force map of a part of a scan;
/// beside the rectangle there is none. Nothing lies between the pixels: a place has the value of
/// the pixel that it lies in.
class RegionField {
public:
    /// A rectangle of the surface, world frame [m].
    struct Place {
        double left = 0.0;
        double bottom = 0.0;
        double width = 0.0;
        double height = 0.0;
    };

    /// @param values row by row, row 0 at the top; not a number where a pixel holds none
    /// @param unit of the values, for people
    /// @throw Error when there is not one value for each pixel, no pixel, or no area
    RegionField(const Place& place, int columns, int rows, std::vector<float> values,
                std::string unit);

    /// Whether world (x, y) [m] lies in the rectangle.
    [[nodiscard]] bool covers(double x, double y) const noexcept;
    /// At world (x, y) [m]; not a number where its pixel holds none, and beside the rectangle.
    [[nodiscard]] double at(double x, double y) const noexcept;
    /// Whether a pixel holds no value.
    [[nodiscard]] bool hasGaps() const noexcept;

    [[nodiscard]] const std::string& unit() const noexcept { return unit_; }
    [[nodiscard]] const Place& place() const noexcept { return place_; }

private:
    Place place_;
    int columns_;
    int rows_;
    std::vector<float> values_;
    std::string unit_;
};

}  // namespace asperity
