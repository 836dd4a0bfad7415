#pragma once

#include "core/Simd.h"
#include "core/Vector.h"
#include "core/surface/BSplineSurface.h"
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

/// The whole of up to four cells; lanes left over repeat the first.
void loadCells(const BSplineSurface::Grid& grid, std::span<const CellIndex> cells,
               PartBatch& batch) noexcept;

/// The four quarters of the part in a lane: lane 1 and 3 the upper halves along x, 2 and 3 along y.
void quarter(const PartBatch& batch, int lane, PartBatch& quarters) noexcept;

}  // namespace asperity
