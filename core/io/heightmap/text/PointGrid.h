#pragma once

#include <cmath>
#include <cstddef>
#include <deque>
#include <optional>

namespace asperity {

/// Points of a text, x, y and z one after the other, whose x and y are finite.
struct TextPoints {
    std::deque<double> numbers;

    [[nodiscard]] std::size_t size() const { return numbers.size() / 3; }
    /// @param axis 0: x, 1: y, 2: z
    [[nodiscard]] double at(std::size_t point, std::size_t axis) const {
        return numbers[3 * point + axis];
    }
    /// Removes the first point, of which there must be one.
    void removeFirst() { numbers.erase(numbers.begin(), numbers.begin() + 3); }
};

/// Equally spaced nodes along an axis.
struct GridAxis {
    double first = 0.0;
    double pitch = 0.0;  ///< 0 for one node alone
    int count = 0;

    [[nodiscard]] int nodeOf(double position) const {
        return pitch > 0.0 ? static_cast<int>(std::lround((position - first) / pitch)) : 0;
    }
};

/// The nodes on which the points lie along an axis, whatever their order: coordinates are one node
/// where they differ by less than 1e-6 of the range, and a tenth of the pitch away from their node
/// at most. Nodes without any point may lie between. One pass over the points.
/// @return empty when they lie on no such nodes, or on more than 65536
[[nodiscard]] std::optional<GridAxis> gridAxis(const TextPoints& points, std::size_t axis);

}  // namespace asperity
