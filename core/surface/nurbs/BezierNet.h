#pragma once

#include "core/Vector.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>

namespace asperity {

/// No spline of a higher degree is accepted.
inline constexpr int kMaxDegree = 5;

/// (w x, w y, w z, w) of a control point (x, y, z) [m] with the weight w > 0.
using HomogeneousPoint = Eigen::Vector4d;

/// A position of a parametric surface with its derivatives by the parameters.
struct ParametricSample {
    Vector3 point = Vector3::Zero();  ///< world [m]
    Vector3 du = Vector3::Zero();     ///< per unit of the parameter [m]
    Vector3 dv = Vector3::Zero();
    Vector3 duu = Vector3::Zero();
    Vector3 duv = Vector3::Zero();
    Vector3 dvv = Vector3::Zero();
};

/// The control net of one rational Bezier patch. Both its parameters go from 0 to 1.
struct BezierNet {
    static constexpr std::size_t kMaxAlong = kMaxDegree + 1;
    static constexpr std::size_t kMaxPoints = kMaxAlong * kMaxAlong;

    int degreeU = 1;
    int degreeV = 1;
    std::array<HomogeneousPoint, kMaxPoints> points;

    [[nodiscard]] static constexpr std::size_t index(int i, int j) {
        return static_cast<std::size_t>(j) * kMaxAlong + static_cast<std::size_t>(i);
    }
    [[nodiscard]] const HomogeneousPoint& at(int i, int j) const { return points[index(i, j)]; }
    [[nodiscard]] HomogeneousPoint& at(int i, int j) { return points[index(i, j)]; }

    /// The control point itself, world [m].
    [[nodiscard]] Vector3 position(int i, int j) const { return at(i, j).head<3>() / at(i, j)[3]; }

    /// Point and derivatives, exact for the rational patch.
    [[nodiscard]] ParametricSample sample(double u, double v) const noexcept;

    /// The same patch seen from `origin`: its control points are relative to it.
    [[nodiscard]] BezierNet seenFrom(const Vector3& origin) const noexcept;
};

/// A patch cut in two at the middle of one parameter.
struct BezierHalves {
    BezierNet low;
    BezierNet high;
};

[[nodiscard]] BezierHalves halvedAlongU(const BezierNet& net) noexcept;
[[nodiscard]] BezierHalves halvedAlongV(const BezierNet& net) noexcept;

}  // namespace asperity
