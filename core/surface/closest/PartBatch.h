#pragma once

#include "core/Simd.h"
#include "core/Vector.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/closest/BoxNewton.h"
#include "core/surface/closest/CellIndex.h"

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

/// Half the squared distance from a query over the parts of a batch: its value and gradient at the
/// center, and what is known of it everywhere in the part. A bit a lane. Where all parts are far,
/// nothing is said of minima.
struct PartFacts {
    Double4 value;                ///< at the center [m^2]
    Double4 gradientX;            ///< at the center [m]
    Double4 gradientY;            ///< at the center [m]
    Double4 spreadX;              ///< by which that differs elsewhere, rounding included [m]
    Double4 spreadY;              ///< by which that differs elsewhere, rounding included [m]
    Double4 bendX;                ///< least second derivative along x
    Double4 bendY;                ///< least second derivative along y
    unsigned far = 0;             ///< farther than the limit
    unsigned withoutMinimum = 0;  ///< no minimum, unless at the scan's edge
    unsigned convex = 0;          ///< at most one minimum
};

/// The whole of up to four cells; lanes left over repeat the first.
void loadCells(const BSplineSurface::Grid& grid, std::span<const CellIndex> cells,
               PartBatch& batch) noexcept;

/// The four quarters of the part in a lane: lane 1 and 3 the upper halves along x, 2 and 3 along y.
void quarter(const PartBatch& batch, int lane, PartBatch& quarters) noexcept;

/// What a part is asked about.
struct PartQuery {
    Vector3 point = Vector3::Zero();  ///< x and y world, z above the datum [m]
    SurfaceRounding rounding;         ///< of places and heights
    double limit = 0.0;               ///< half a squared distance [m^2]
    /// Answers hold for all queries no farther than this from `point`, but `far`: from there [m].
    double ball = 0.0;
};

void examine(const PartBatch& batch, const PartQuery& query, PartFacts& facts) noexcept;

}  // namespace asperity
