#pragma once

#include "core/surface/BSplineSurface.h"
#include "core/surface/closest/Box.h"

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
        double first = 0.0;    ///< rest place of the first [m]
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
    [[nodiscard]] bool contains(double placeX, double placeY) const {
        return placeX >= x.low() && placeX <= x.high() && placeY >= y.low() && placeY <= y.high();
    }
    /// Outside the patch its outermost spans are continued. [m]
    [[nodiscard]] Vector3 point(double placeX, double placeY) const;
    /// Unit normal, out of the sample.
    [[nodiscard]] Vector3 normal(double placeX, double placeY) const;
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

}  // namespace asperity
