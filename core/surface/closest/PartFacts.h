#pragma once

#include "core/Simd.h"
#include "core/Vector.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/closest/Box.h"
#include "core/surface/closest/BoxNewton.h"

#include <cstdint>
#include <span>

namespace asperity {

/// Four rectangles within cells of a height field, each with the Bezier points of the height over
/// it: what a search looks at at a time, a lane each.
struct PartBatch {
    static constexpr int kLanes = 4;
    static constexpr unsigned kAllLanes = (1U << kLanes) - 1U;

    Double4 net[4][4];  ///< heights above the datum, [along y][along x] [m]
    Double4 centerX;    ///< world [m]
    Double4 centerY;    ///< world [m]
    Double4 halfX;      ///< half the size [m]
    Double4 halfY;      ///< half the size [m]
};

/// The whole of up to four cells; lanes left over repeat the first.
void loadCells(const BSplineSurface::Grid& grid, std::span<const CellIndex> cells,
               PartBatch& batch) noexcept;

/// A part of a cell, whose sides are halved `depth` times.
struct CellPart {
    static constexpr int kMaxDepth = 7;

    CellIndex cell;
    std::uint8_t depth = 0;
    std::uint8_t row = 0;     ///< from the cell's lower edge, in parts
    std::uint8_t column = 0;  ///< from the cell's left edge, in parts

    /// Returns whether a position lies in the part.
    [[nodiscard]] bool contains(const BSplineSurface::Grid& grid,
                                const Vector2& point) const noexcept;
    /// One of its quarters, in the order of quarter().
    [[nodiscard]] CellPart quarter(int lane) const noexcept {
        return {.cell = cell,
                .depth = static_cast<std::uint8_t>(depth + 1),
                .row = static_cast<std::uint8_t>(2 * row + lane / 2),
                .column = static_cast<std::uint8_t>(2 * column + lane % 2)};
    }
};

/// Up to four parts of cells; lanes left over repeat the first.
void loadParts(const BSplineSurface::Grid& grid, std::span<const CellPart> parts,
               PartBatch& batch) noexcept;

/// The four quarters of the part in a lane: lane 1 and 3 the upper halves along x, 2 and 3 along y.
void quarter(const PartBatch& batch, int lane, PartBatch& quarters) noexcept;

/// A vector in space, for each of four parts [m].
struct Vector4 {
    Double4 x;
    Double4 y;
    Double4 z;
};

/// Half the squared distance from a query over the parts of a batch: its value and gradient at the
/// center, and what is known of it everywhere in the part. A bit a lane. Where all parts are far,
/// nothing is said of minima.
struct PartFacts {
    Double4 value;      ///< at the center [m^2]
    Double4 gradientX;  ///< at the center [m]
    Double4 gradientY;  ///< at the center [m]
    /// The next four say nothing where no part of the batch is near the scan's edge.
    Double4 spreadX;   ///< by which that differs elsewhere, rounding included [m]
    Double4 spreadY;   ///< by which that differs elsewhere, rounding included [m]
    Double4 bendX;     ///< least second derivative along x
    Double4 bendY;     ///< least second derivative along y
    Double4 least;     ///< nowhere is it less [m^2]
    Vector4 way;       ///< from the query to about the nearest position of the part
    Double4 alongWay;  ///< all of the part is so far along it, times its length [m^2]
    /// Distance that the query may move with no minimum getting into the part; <= 0: the part may
    /// hold one, or is at the scan's edge [m].
    Double4 calm;
    /// Distance that the query may move with no second minimum getting into a convex part [m].
    Double4 convexFor;
    unsigned far = 0;             ///< farther than the limit
    unsigned withoutMinimum = 0;  ///< no minimum, unless at the scan's edge
    unsigned convex = 0;          ///< at most one minimum
};

/// Query about a part.
struct PartQuery {
    Vector3 point = Vector3::Zero();  ///< x and y world, z above the datum [m]
    SurfaceRounding rounding;         ///< of positions and heights
    double limit = 0.0;               ///< half a squared distance [m^2]
    Box scan;                         ///< all of it
};

/// Second derivatives are bounded up the slope and across it, not along x and y: on a steep slope
/// the distance bends far more up it than across, and along x and y the two would be mixed.
void examine(const PartBatch& batch, const PartQuery& query, PartFacts& facts) noexcept;

}  // namespace asperity
