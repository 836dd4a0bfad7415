#pragma once

#include "core/surface/HeightMap.h"

#include <limits>
#include <string>
#include <vector>

namespace asperity {

/// A quantity that is known at the pixels of a scan, to be looked up between them. Immutable, safe
/// to read from any thread. Kept in single precision.
class PixelField {
public:
    /// @param map  the values in place of heights; what is invalid or not finite holds none
    /// @param unit of the values, for people
    /// @throw Error when the map is unusable
    template <class Heights>
    PixelField(const BasicHeightMap<Heights>& map, std::string unit);

    /// At world (x, y) [m], linear between the four pixels around it; a place beyond the outermost
    /// pixel centers counts as the nearest one among them. Not a number where a pixel that bears
    /// weight holds no value.
    [[nodiscard]] double at(double x, double y) const noexcept;

    [[nodiscard]] const std::string& unit() const noexcept { return unit_; }
    /// Of all values; not a number where there is none.
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

}  // namespace asperity
