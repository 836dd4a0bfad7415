#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace asperity {

using Vector2 = Eigen::Vector2d;
using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;

}  // namespace asperity
