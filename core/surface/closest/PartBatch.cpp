#include "core/surface/closest/PartBatch.h"

#include "core/surface/BezierCell.h"
#include "core/surface/SplineSampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace asperity {

namespace {

ASPERITY_INLINE void toBezier(Double4& a, Double4& b, Double4& c, Double4& d) {
    constexpr double kSixth = 1.0 / 6.0;
    constexpr double kThird = 1.0 / 3.0;
    const Double4 first = kSixth * (a + 4.0 * b + c);
    const Double4 last = kSixth * (b + 4.0 * c + d);
    const Double4 second = kThird * (2.0 * b + c);
    const Double4 third = kThird * (b + 2.0 * c);
    a = first;
    b = second;
    c = third;
    d = last;
}

/// Bezier points of four cells.
ASPERITY_WITH_AVX2 void bezierOfCells(const std::array<CellCorner, 4>& corners, PartBatch& batch) {
    for (int i = 0; i < 4; ++i) {
        Double4 row[4];
        for (std::size_t lane = 0; lane < 4; ++lane) {
            row[lane] = corners[lane].row(i);
        }
        transpose(row);
        toBezier(row[0], row[1], row[2], row[3]);
        for (int k = 0; k < 4; ++k) {
            batch.net[i][k] = row[k];
        }
    }
    for (int k = 0; k < 4; ++k) {
        toBezier(batch.net[0][k], batch.net[1][k], batch.net[2][k], batch.net[3][k]);
    }
}

/// Lower and upper half of four cubics (de Casteljau).
ASPERITY_INLINE void halve(const Double4 (&points)[4], Double4 (&low)[4], Double4 (&high)[4]) {
    const Double4 ab = 0.5 * (points[0] + points[1]);
    const Double4 bc = 0.5 * (points[1] + points[2]);
    const Double4 cd = 0.5 * (points[2] + points[3]);
    low[0] = points[0];
    low[1] = ab;
    low[2] = 0.5 * (ab + bc);
    high[3] = points[3];
    high[2] = cd;
    high[1] = 0.5 * (bc + cd);
    low[3] = 0.5 * (low[2] + high[1]);
    high[0] = low[3];
}

ASPERITY_WITH_AVX2 void quarterNet(const PartBatch& batch, int lane, PartBatch& quarters) {
    Double4 columns[4];  // lanes: along y
    for (int k = 0; k < 4; ++k) {
        columns[k] = Double4{batch.net[0][k][lane], batch.net[1][k][lane], batch.net[2][k][lane],
                             batch.net[3][k][lane]};
    }
    Double4 left[4];
    Double4 right[4];
    halve(columns, left, right);
    transpose(left);  // lanes: along x
    transpose(right);
    Double4 parts[4][4];
    halve(left, parts[0], parts[2]);
    halve(right, parts[1], parts[3]);
    for (int i = 0; i < 4; ++i) {
        Double4 row[4] = {parts[0][i], parts[1][i], parts[2][i], parts[3][i]};
        transpose(row);
        for (int k = 0; k < 4; ++k) {
            quarters.net[i][k] = row[k];
        }
    }
}

/// The part of each of four cubics between two places, 0..1 along each of them (polar form).
ASPERITY_INLINE void cut(Double4 (&points)[4], Double4 from, Double4 to) {
    const auto between = [](Double4 low, Double4 high, Double4 at) {
        return low + at * (high - low);
    };
    Double4 first[3];
    Double4 last[3];
    for (int i = 0; i < 3; ++i) {
        first[i] = between(points[i], points[i + 1], from);
        last[i] = between(points[i], points[i + 1], to);
    }
    const Double4 low[2] = {between(first[0], first[1], from), between(first[1], first[2], from)};
    const Double4 high[2] = {between(last[0], last[1], to), between(last[1], last[2], to)};
    points[0] = between(low[0], low[1], from);
    points[1] = between(low[0], low[1], to);
    points[2] = between(high[0], high[1], from);
    points[3] = between(high[0], high[1], to);
}

/// Where in its cell each of four parts lies, 0..1 along the cell's sides.
struct PartSides {
    Double4 left;
    Double4 right;
    Double4 low;
    Double4 high;
};

/// Cells become parts of theirs.
ASPERITY_WITH_AVX2 void cutNets(const PartSides& sides, PartBatch& batch) {
    for (auto& row : batch.net) {
        cut(row, sides.left, sides.right);
    }
    for (int k = 0; k < 4; ++k) {
        Double4 column[4] = {batch.net[0][k], batch.net[1][k], batch.net[2][k], batch.net[3][k]};
        cut(column, sides.low, sides.high);
        for (int i = 0; i < 4; ++i) {
            batch.net[i][k] = column[i];
        }
    }
    batch.centerX += batch.halfX * (sides.left + sides.right - 1.0);
    batch.centerY += batch.halfY * (sides.low + sides.high - 1.0);
    batch.halfX *= sides.right - sides.left;
    batch.halfY *= sides.high - sides.low;
}

/// Whether a cell reaches to the scan's edge, or has a single pixel along an axis.
bool isOutermost(const BSplineSurface::Grid& grid, const CellIndex& cell) {
    return cell.row == 0 || cell.column == 0 || cell.row >= grid.rows - 2 ||
           cell.column >= grid.columns - 2;
}

/// The points of a cell that reaches farther than its span.
void setOutermost(const BSplineSurface::Grid& grid, const CellIndex& cell, int lane,
                  PartBatch& batch) {
    const SpanPart x = cellExtent(cell.column, grid.columns);
    const SpanPart y = cellExtent(cell.row, grid.rows);
    const Eigen::Matrix4d net =
        bezierOfSpan(y) * cellControls(grid, cell.row, cell.column) * bezierOfSpan(x).transpose();
    for (int i = 0; i < 4; ++i) {
        for (int k = 0; k < 4; ++k) {
            batch.net[i][k][lane] = net(i, k);
        }
    }
    batch.centerX[lane] = (cell.column + 0.5 + x.middle()) * grid.pitchX;
    batch.centerY[lane] = (cell.row + 0.5 + y.middle()) * grid.pitchY;
    batch.halfX[lane] = 0.5 * x.length() * grid.pitchX;
    batch.halfY[lane] = 0.5 * y.length() * grid.pitchY;
}

}  // namespace

void loadCells(const BSplineSurface::Grid& grid, std::span<const CellIndex> cells,
               PartBatch& batch) noexcept {
    std::array<CellIndex, PartBatch::kLanes> all;
    all.fill(cells.front());
    std::ranges::copy(cells, all.begin());
    const auto lanesOf = [&](int CellIndex::*index) {
        return Double4{all[0].*index + 0.0, all[1].*index + 0.0, all[2].*index + 0.0,
                       all[3].*index + 0.0};
    };
    batch.centerX = (lanesOf(&CellIndex::column) + 1.0) * grid.pitchX;
    batch.centerY = (lanesOf(&CellIndex::row) + 1.0) * grid.pitchY;
    batch.halfX = Double4{} + 0.5 * grid.pitchX;
    batch.halfY = Double4{} + 0.5 * grid.pitchY;
    if (grid.rows > 1 && grid.columns > 1) {
        std::array<CellCorner, PartBatch::kLanes> corners;
        for (std::size_t lane = 0; lane < all.size(); ++lane) {
            // The outermost are set below; until then any place of the grid will do.
            const bool inner = !isOutermost(grid, all[lane]);
            corners[lane] =
                inner ? cornerOf(grid, all[lane].row, all[lane].column) : cornerOf(grid, 0, 0);
        }
        bezierOfCells(corners, batch);
    }
    for (std::size_t lane = 0; lane < all.size(); ++lane) {
        if (isOutermost(grid, all[lane])) {
            setOutermost(grid, all[lane], static_cast<int>(lane), batch);
        }
    }
}

bool CellPart::contains(const BSplineSurface::Grid& grid, const Vector2& place) const noexcept {
    const double parts = 1 << depth;
    // Outermost cells reach farther than their spans.
    const auto isWithin = [&](double inSpans, const SpanPart& extent, int index) {
        const double at = (inSpans - extent.low) / extent.length() * parts - index;
        return at >= 0.0 && at <= 1.0;
    };
    return isWithin(place.x() / grid.pitchX - 0.5 - cell.column,
                    cellExtent(cell.column, grid.columns), column) &&
           isWithin(place.y() / grid.pitchY - 0.5 - cell.row, cellExtent(cell.row, grid.rows), row);
}

void loadParts(const BSplineSurface::Grid& grid, std::span<const CellPart> parts,
               PartBatch& batch) noexcept {
    std::array<CellIndex, PartBatch::kLanes> cells;
    PartSides sides{};
    for (std::size_t lane = 0; lane < cells.size(); ++lane) {
        const CellPart& part = parts[lane < parts.size() ? lane : 0];
        const auto at = static_cast<int>(lane);
        const double size = std::ldexp(1.0, -part.depth);
        cells[lane] = part.cell;
        sides.left[at] = size * part.column;
        sides.right[at] = size * (part.column + 1);
        sides.low[at] = size * part.row;
        sides.high[at] = size * (part.row + 1);
    }
    loadCells(grid, cells, batch);
    cutNets(sides, batch);
}

void quarter(const PartBatch& batch, int lane, PartBatch& quarters) noexcept {
    quarterNet(batch, lane, quarters);
    const double halfX = 0.5 * batch.halfX[lane];
    const double halfY = 0.5 * batch.halfY[lane];
    quarters.halfX = Double4{} + halfX;
    quarters.halfY = Double4{} + halfY;
    quarters.centerX = batch.centerX[lane] + halfX * Double4{-1.0, 1.0, -1.0, 1.0};
    quarters.centerY = batch.centerY[lane] + halfY * Double4{-1.0, -1.0, 1.0, 1.0};
}

}  // namespace asperity
