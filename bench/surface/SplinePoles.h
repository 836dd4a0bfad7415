#pragma once

#include "core/surface/BSplineSurface.h"

#include <vector>

namespace asperity {

/// The surface as programs for free-form shapes take it: control points and knots in nanometers
/// (their tolerances are absolute), parametrized by its own x and y.
class SplinePoles {
public:
    static constexpr double kUnit = 1e-9;  ///< [m]

    explicit SplinePoles(const BSplineSurface& surface)
        : surface_(surface), grid_(surface.grid()) {}

    [[nodiscard]] int alongX() const { return grid_.columns + 2; }
    [[nodiscard]] int alongY() const { return grid_.rows + 2; }

    [[nodiscard]] Vector3 pole(int row, int column) const {
        return Vector3((column - 0.5) * grid_.pitchX, (row - 0.5) * grid_.pitchY,
                       surface_.control(row - 1, column - 1)) /
               kUnit;
    }
    [[nodiscard]] std::vector<double> knotsX() const { return knots(alongX(), grid_.pitchX); }
    [[nodiscard]] std::vector<double> knotsY() const { return knots(alongY(), grid_.pitchY); }

private:
    /// A cubic's control point belongs to the middle one of the knots that it acts between.
    static std::vector<double> knots(int poles, double pitch) {
        std::vector<double> all;
        for (int i = 0; i < poles + 4; ++i) {
            all.push_back((i - 2.5) * pitch / kUnit);
        }
        return all;
    }

    const BSplineSurface& surface_;
    const BSplineSurface::Grid& grid_;
};

}  // namespace asperity
