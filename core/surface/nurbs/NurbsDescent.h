#pragma once

#include "core/surface/closest/BoxNewton.h"
#include "core/surface/nurbs/NurbsSurface.h"

namespace asperity {

/// Half the squared distance from the query to the surface point at a place (u, v) [m^2]; by one
/// patch alone, or by whichever patch holds the place.
class NurbsHalfSquare {
public:
    /// @param patch < 0: all of the surface
    NurbsHalfSquare(const NurbsSurface& surface, const Vector3& query, int patch) noexcept;

    [[nodiscard]] LocalModel operator()(const Vector2& place) const noexcept;

private:
    const NurbsSurface& surface_;
    Vector3 query_;
    int patch_;
    double noise_;  ///< rounding of a place in space [m]
};

/// A local minimum of the distance on the surface.
struct NurbsMinimum {
    Vector2 place = Vector2::Zero();  ///< (u, v)
    double distance = 0.0;            ///< [m]
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

}  // namespace asperity
