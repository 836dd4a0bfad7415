#pragma once

#include "core/surface/BSplineSurface.h"
#include "core/surface/closest/Box.h"
#include "core/surface/deformation/SurfaceDeformation.h"

#include <cstddef>
#include <vector>

namespace asperity {

/// A piece of a uniform bicubic B-spline surface whose control points are free in space. At rest
/// the point for (x, y) lies at world x, y, so that (x, y) name a point also after control points
/// have been moved.
struct SplinePatch {
    /// The control points along one axis.
    struct Axis {
        int count = 0;
        double first = 0.0;    ///< rest position of the first [m]
        double spacing = 0.0;  ///< [m]

        [[nodiscard]] double low() const { return first + spacing; }                 ///< [m]
        [[nodiscard]] double high() const { return first + (count - 2) * spacing; }  ///< [m]
    };

    Axis x;
    Axis y;
    std::vector<Vector3> controls;  ///< row-major, smallest y first; world [m]

    [[nodiscard]] std::size_t index(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(x.count) +
               static_cast<std::size_t>(column);
    }
    [[nodiscard]] bool contains(double restX, double restY) const {
        return restX >= x.low() && restX <= x.high() && restY >= y.low() && restY <= y.high();
    }
    /// Outside the patch its outermost spans are continued. [m]
    [[nodiscard]] Vector3 point(double restX, double restY) const;
    /// Unit normal, out of the sample.
    [[nodiscard]] Vector3 normal(double restX, double restY) const;
};

/// A patch never holds more control points than this; where the wanted spacing would need more,
/// refinement stops one halving earlier.
inline constexpr std::size_t kMaxPatchControls = std::size_t{1} << 20U;

/// The part of the surface over `window`, by exact knot insertion: the same surface on a control
/// net whose spacing is halved along each axis until it is at most `spacing` [m] (or
/// kMaxPatchControls is reached: the patch's axes tell the spacing it has).
/// The patch covers the whole window as far as that lies in the scan, and up to a cell around it.
/// @throw Error when the spacing is not positive, the window is not finite, or the window holds
///        more than kMaxPatchControls control points as it is
[[nodiscard]] SplinePatch refined(const BSplineSurface& surface, const Box& window, double spacing);

/// The four control points around the closest point move by the indentation against the normal.
[[nodiscard]] DisplacementField fourPointField(const BSplineSurface& surface,
                                               const TipContact& contact);

/// The control points within the contact radius of the contact's axis move along that axis onto the
/// tip: down where the tip indents the surface, up where it draws out a neck. Those at the rim move
/// part of the way, so that it is round.
[[nodiscard]] DisplacementField contactRadiusField(const BSplineSurface& surface,
                                                   const TipContact& contact);

/// Every point moves by displacement(distance from the contact's axis) against the normal.
[[nodiscard]] DisplacementField closedFormField(const TipContact& contact,
                                                RadialDisplacement displacement);

/// Returns the displacements of the surface in a model; see deformedPatch().
/// @throw Error where ClosedForm or HalfSpace is given no displacement
[[nodiscard]] DisplacementField displacementField(const BSplineSurface& surface,
                                                  const TipContact& contact, DeformationModel model,
                                                  const RadialDisplacement& displacement);

/// The surface around the contact, refined to `spacing` along its slope, and wide enough that
/// control points within the contact radius or beside the closest point shape no point at its edge.
[[nodiscard]] SplinePatch netAroundContact(const BSplineSurface& surface, const TipContact& contact,
                                           double spacing);

/// Returns the displacements of the surface by a net whose control points hold displacements.
[[nodiscard]] DisplacementField fieldOf(SplinePatch displacements);

/// Distance of a point from the contact's axis [m].
[[nodiscard]] double distanceFromAxis(const TipContact& contact, const Vector3& point);

}  // namespace asperity
