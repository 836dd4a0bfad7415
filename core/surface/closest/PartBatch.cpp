#include "core/surface/closest/PartBatch.h"

#include "core/surface/BezierCell.h"

#include <algorithm>
#include <array>
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

ASPERITY_INLINE Double4 widened(const float* heights) {
    return Double4{heights[0], heights[1], heights[2], heights[3]};
}

/// The control heights of a surface with what single precision leaves of them.
struct StoredControls {
    const float* heights = nullptr;
    const float* rests = nullptr;  ///< null: nothing
    std::ptrdiff_t stride = 0;

    [[nodiscard]] ASPERITY_INLINE Double4 fourAt(std::ptrdiff_t first) const {
        const Double4 four = widened(heights + first);
        return rests == nullptr ? four : four + widened(rests + first);
    }
};

/// Bezier points of four cells from the indices of their first control heights.
ASPERITY_WITH_AVX2 void bezierOfCells(const StoredControls& controls,
                                      const std::array<std::ptrdiff_t, 4>& corners,
                                      PartBatch& batch) {
    for (int i = 0; i < 4; ++i) {
        Double4 row[4];
        for (std::size_t lane = 0; lane < 4; ++lane) {
            row[lane] = controls.fourAt(corners[lane] + i * controls.stride);
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
    const std::ptrdiff_t stride = grid.columns + 2;
    std::array<CellIndex, PartBatch::kLanes> all;
    all.fill(cells.front());
    std::ranges::copy(cells, all.begin());
    std::array<std::ptrdiff_t, PartBatch::kLanes> corners{};
    for (std::size_t lane = 0; lane < all.size(); ++lane) {
        // The outermost are set below; until then any place of the grid will do.
        const bool inner = !isOutermost(grid, all[lane]);
        corners[lane] = inner ? all[lane].row * stride + all[lane].column : 0;
    }
    const auto lanesOf = [&](int CellIndex::*index) {
        return Double4{all[0].*index + 0.0, all[1].*index + 0.0, all[2].*index + 0.0,
                       all[3].*index + 0.0};
    };
    batch.centerX = (lanesOf(&CellIndex::column) + 1.0) * grid.pitchX;
    batch.centerY = (lanesOf(&CellIndex::row) + 1.0) * grid.pitchY;
    batch.halfX = Double4{} + 0.5 * grid.pitchX;
    batch.halfY = Double4{} + 0.5 * grid.pitchY;
    if (grid.rows > 1 && grid.columns > 1) {
        const float* rests = grid.controlRests.empty() ? nullptr : grid.controlRests.data();
        bezierOfCells({grid.controlHeights.data(), rests, stride}, corners, batch);
    }
    for (std::size_t lane = 0; lane < all.size(); ++lane) {
        if (isOutermost(grid, all[lane])) {
            setOutermost(grid, all[lane], static_cast<int>(lane), batch);
        }
    }
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
