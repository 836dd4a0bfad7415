#pragma once

#include "core/Simd.h"
#include "core/Vector.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/closest/CellIndex.h"

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

    /// Whether a place lies in it.
    [[nodiscard]] bool contains(const BSplineSurface::Grid& grid,
                                const Vector2& place) const noexcept;
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

}  // namespace asperity
