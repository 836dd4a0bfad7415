#pragma once

#include "core/surface/BSplineSurface.h"
#include "core/surface/closest/ClosestPoint.h"

#include <vector>

namespace asperity::test {

/// Closest points by looking everywhere: heights on a lattice much finer than the pixels, edges of
/// the scan included, and a search downhill from each position that is lower than its neighbors.
class BruteClosestPoints {
public:
    BruteClosestPoints(const BSplineSurface& surface, int perPixel);

    /// The nearest local minima of the distance from `query`, nearest first. Each is a surface
    /// point, so that no distance is less than the true one.
    [[nodiscard]] std::vector<ClosestPoint> near(const Vector3& query) const;
    [[nodiscard]] ClosestPoint nearest(const Vector3& query) const { return near(query).front(); }

private:
    struct Position {
        double squared = 0.0;  ///< distance [m^2]
        int row = 0;
        int column = 0;
    };

    [[nodiscard]] double squaredAt(const Vector3& query, int row, int column) const;
    [[nodiscard]] bool isLowest(const Vector3& query, const Position& position) const;
    [[nodiscard]] std::vector<Position> lowestPositions(const Vector3& query) const;
    [[nodiscard]] double x(int column) const { return column * stepX_; }
    [[nodiscard]] double y(int row) const { return row * stepY_; }

    const BSplineSurface& surface_;
    int columns_;  ///< of the lattice
    int rows_;
    double stepX_;                 ///< [m]
    double stepY_;                 ///< [m]
    std::vector<double> heights_;  ///< [m]
};

}  // namespace asperity::test
