#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

/// Half angle of the shank that pictures give a tip without a cone [rad].
inline constexpr double kShankHalfAngle = 0.3;

/// A tip that ends in a sphere. The sphere goes on to its equator, or as the cone that touches it
/// all around. The laws of the exact tip, half-space, pictures and fields take its shape from here.
struct RoundTip {
    double radius = 0.0;         ///< of the sphere [m]
    double coneHalfAngle = 0.0;  ///< between the cone and its axis [rad]; 0: no cone

    [[nodiscard]] bool hasCone() const noexcept { return coneHalfAngle > 0.0; }

    /// Distance from the axis up to which the tip has a surface that faces the sample [m].
    [[nodiscard]] double reach() const noexcept {
        return hasCone() ? std::numeric_limits<double>::infinity() : radius;
    }

    /// Height of the surface above the lowest point at a distance from the axis; beyond reach()
    /// that of the equator [m].
    [[nodiscard]] double height(double distance) const noexcept {
        const double joint = hasCone() ? radius * std::cos(coneHalfAngle) : radius;
        if (hasCone() && distance > joint) {
            return (radius * (1.0 - std::sin(coneHalfAngle))) +
                   ((distance - joint) / std::tan(coneHalfAngle));
        }
        const double up = std::sqrt(std::max(0.0, radius - distance) * (radius + distance));
        return distance < radius ? distance * distance / (radius + up) : radius;
    }

    /// Half angle of the shank as drawn [rad].
    [[nodiscard]] double shankHalfAngle() const noexcept {
        return hasCone() ? coneHalfAngle : kShankHalfAngle;
    }
};

}  // namespace asperity
