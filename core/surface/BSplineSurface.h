#pragma once

#include "core/Progress.h"
#include "core/Vector.h"
#include "core/surface/CellBounds.h"
#include "core/surface/Curvature.h"
#include "core/surface/PixelVector.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace asperity {

struct SplineSampling;

/// A uniform bicubic B-spline height field: immutable, O(1) look-up, safe to read from any thread.
/// Copies share what it consists of, so that they cost nothing.
///
/// Control point (row, column) of the padded grid belongs to the pixel (row - 1, column - 1), rows
/// counted from the BOTTOM (y up), so that the spline's parameter grows with world x and y.
///
/// Control heights are kept in single precision, so that large scans fit into memory, and relative
/// to a datum, so that single precision resolves them to 2^-24 of their distance from it. Where
/// pixels are so fine that this would show in the curvature, what it leaves of them is kept beside
/// them. Both together DEFINE the surface: at() evaluates them in double precision.
class BSplineSurface {
public:
    struct Grid {
        int columns = 0;                    ///< pixels along x
        int rows = 0;                       ///< pixels along y
        double pitchX = 0.0;                ///< [m]
        double pitchY = 0.0;                ///< [m]
        double datum = 0.0;                 ///< height that control heights are relative to [m]
        PixelVector<float> controlHeights;  ///< (rows + 2) x (columns + 2), bottom row first [m]
        /// Remainders beyond single precision, as many; empty: nothing that matters [m].
        PixelVector<float> controlRests = {};
        PixelMask invalid;  ///< rows x columns, bottom row first; empty: all valid
    };

    /// @throw Error when the arrays do not match the size, a pitch is not positive, or a control
    ///        height or the datum is not finite; Canceled
    explicit BSplineSurface(Grid grid, Progress* progress = nullptr);

    /// Height and derivatives at world (x, y) [m]. Outside the pixel centers the spline of the
    /// nearest span is continued; outside the scan the position is clamped to its edge. Along an
    /// axis with a single pixel the surface is level. A position that is not a number counts as 0.
    [[nodiscard]] HeightSample at(double x, double y) const noexcept;

    /// The same for SplineSampling.h.
    [[nodiscard]] SplineSampling sampling() const noexcept;

    [[nodiscard]] bool contains(double x, double y) const noexcept;
    /// Returns whether the pixel under (x, y) held data in the scan (false: filled by us).
    [[nodiscard]] bool isMeasured(double x, double y) const noexcept;

    [[nodiscard]] double sizeX() const noexcept { return grid().columns * grid().pitchX; }  ///< [m]
    [[nodiscard]] double sizeY() const noexcept { return grid().rows * grid().pitchY; }     ///< [m]
    [[nodiscard]] const Grid& grid() const noexcept { return parts_->grid; }
    [[nodiscard]] double finestPitch() const noexcept {  ///< [m]
        return std::min(grid().pitchX, grid().pitchY);
    }

    /// Control height of pixel (row, column), rows from the bottom; either may lie beyond the scan
    /// by any amount: the outermost span's polynomial is continued exactly. [m]
    [[nodiscard]] double control(int row, int column) const noexcept;
    /// No control height is larger in magnitude [m]: the scale of rounding errors in at().
    [[nodiscard]] double heightScale() const noexcept { return parts_->heightScale; }
    /// Bounds of each cell, known without looking into it.
    [[nodiscard]] const CellBounds& bounds() const noexcept { return parts_->bounds; }

private:
    [[nodiscard]] double controlInRow(int row, int column) const noexcept;
    [[nodiscard]] double relativeControl(int row, int column) const noexcept;

    struct Parts {
        Parts(Grid usable, Progress* progress);

        Grid grid;
        double inversePitchX;  ///< [1/m]
        double inversePitchY;  ///< [1/m]
        double heightScale;    ///< [m]
        CellBounds bounds;
    };
    std::shared_ptr<const Parts> parts_;
};

/// The 4 x 4 control heights of a cell (see CellBounds) above the grid's datum, rows along y [m].
[[nodiscard]] Eigen::Matrix4d cellControls(const BSplineSurface::Grid& grid, int row,
                                           int column) noexcept;

/// The position itself where the scan holds data, else the center of the nearest pixel that holds
/// some; the position, too, where no pixel does. World frame [m].
[[nodiscard]] Vector2 nearestMeasured(const BSplineSurface& surface, const Vector2& position);

/// A straight line of sight, from the eye on; world frame.
struct SurfaceRay {
    Vector3 origin = Vector3::Zero();       ///< [m]
    Vector3 direction = -Vector3::UnitZ();  ///< of any length but 0
};

/// The first position of the surface that a line of sight meets within a rectangle of the scan,
/// from above; found to 1e-13 of the surface's extent. The ray is followed in steps of half a
/// pixel: a ridge that it touches over less than that may be missed. None where the ray does not
/// meet the surface there, or is below it where it comes into the rectangle: it sees the cut face.
/// @param low, high corners of the rectangle, world x, y [m]
[[nodiscard]] std::optional<Vector3> firstHit(const BSplineSurface& surface, const SurfaceRay& ray,
                                              const Vector2& low, const Vector2& high);

}  // namespace asperity
