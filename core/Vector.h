#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>

namespace asperity {

using Vector2 = Eigen::Vector2d;
using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;

/// Returns whether both are numbers. Eigen's allFinite() subtracts: it raises the invalid flag.
[[nodiscard]] inline bool isFinite(const Vector2& vector) {
    return std::isfinite(vector.x()) && std::isfinite(vector.y());
}

}  // namespace asperity
