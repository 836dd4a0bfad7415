#pragma once

#include "core/surface/closest/BoxNewton.h"
#include "core/surface/nurbs/BezierNet.h"
#include "core/surface/nurbs/NurbsSurface.h"

#include <array>
#include <cstddef>

namespace asperity {

/// Half the squared distance from the query to the surface point at a position (u, v) [m^2]; by one
/// patch alone, or by whichever patch holds the position.
class NurbsHalfSquare {
public:
    /// @param patch < 0: all of the surface
    NurbsHalfSquare(const NurbsSurface& surface, const Vector3& query, int patch) noexcept;

    [[nodiscard]] LocalModel operator()(const Vector2& position) const noexcept;

private:
    const NurbsSurface& surface_;
    Vector3 query_;
    int patch_;
    double noise_;  ///< rounding of a position in space [m]
};

/// A local minimum of the distance on the surface.
struct NurbsMinimum {
    Vector2 position = Vector2::Zero();  ///< (u, v)
    double distance = 0.0;               ///< [m]
    int iterations = 0;
    bool converged = false;
    bool pushedOut = false;  ///< held back by an edge
};

/// Newton's method on r.Su = 0, r.Sv = 0 over all of the surface: goes on across an edge where the
/// surface closes upon itself, and leaves a pole along the meridian that falls most steeply.
/// Allocation-free, bounded.
class NurbsDescent {
public:
    NurbsDescent(const NurbsSurface& surface, const Vector3& query) noexcept;

    [[nodiscard]] NurbsMinimum from(const Vector2& start) const noexcept;
    /// The minimum over a rectangle of one patch, its edges included.
    [[nodiscard]] NurbsMinimum within(int patch, const Box& box,
                                      const Vector2& start) const noexcept;

private:
    bool crossSeam(NurbsMinimum& state) const noexcept;
    void leavePole(NurbsMinimum& state) const noexcept;
    bool goOnTo(NurbsMinimum next, NurbsMinimum& state) const noexcept;
    [[nodiscard]] NurbsMinimum downMeridian(int edge, double along) const noexcept;
    [[nodiscard]] double steepestMeridian(int edge) const noexcept;
    [[nodiscard]] double slopeInto(int edge, double along) const noexcept;

    const NurbsSurface& surface_;
    Vector3 query_;
    double rounding_;  ///< of a distance [m]
};

/// The squared distance of a rational patch from the origin, F / W with F = |w S|^2 and W = w^2,
/// both as Bernstein polynomials of twice the patch's degree: what it can be lies between the least
/// and the greatest ratio of their coefficients.
class SquaredDistanceNet {
public:
    /// @param net seen from the query (BezierNet::seenFrom)
    /// @param positionNoise rounding of its control points [m]
    SquaredDistanceNet(const BezierNet& net, double positionNoise) noexcept;

    /// Returns whether no point of the patch is nearer than the root of `square` [m^2]. Like
    /// isConvex(), true only where that holds whatever the rounding.
    [[nodiscard]] bool isAtLeast(double square) const noexcept;

    /// Returns whether F - square W + slack w_min^2 (u^2 + v^2) / 2, w_min the least weight, is
    /// convex over the patch. F - square W has the sign of the distance's excess over `square`.
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
