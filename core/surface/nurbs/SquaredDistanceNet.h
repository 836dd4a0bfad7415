#pragma once

#include "core/surface/nurbs/BezierNet.h"

#include <array>
#include <cstddef>

namespace asperity {

/// The squared distance of a rational patch from the origin, F / W with F = |w S|^2 and W = w^2,
/// both as Bernstein polynomials of twice the patch's degree: what it can be lies between the least
/// and the greatest ratio of their coefficients.
class SquaredDistanceNet {
public:
    /// @param net seen from the query (BezierNet::seenFrom)
    /// @param placeNoise rounding of its control points [m]
    SquaredDistanceNet(const BezierNet& net, double placeNoise) noexcept;

    /// Whether no point of the patch is nearer than the root of `square` [m^2]. Like isConvex(),
    /// true only where that holds whatever the rounding.
    [[nodiscard]] bool isAtLeast(double square) const noexcept;

    /// Whether F - square W + slack w_min^2 (u^2 + v^2) / 2, w_min the least weight, is convex over
    /// the patch. F - square W has the sign of the distance's excess over `square`.
    /// @param square [m^2]  @param slack [m^2]
    [[nodiscard]] bool isConvex(double square, double slack) const noexcept;

private:
    static constexpr std::size_t kAlong = 2 * kMaxDegree + 1;
    using Coefficients = std::array<double, kAlong * kAlong>;

    [[nodiscard]] static constexpr std::size_t index(int i, int j) {
        return static_cast<std::size_t>(j) * kAlong + static_cast<std::size_t>(i);
    }

    int degreeU_;  ///< of F and W
    int degreeV_;
    Coefficients distance_;  ///< of F [m^2]
    Coefficients weight_;    ///< of W
    double leastWeight_;     ///< of W
    double noise_;           ///< rounding of a coefficient of F [m^2]
};

}  // namespace asperity
