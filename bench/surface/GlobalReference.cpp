#include "bench/surface/GlobalReference.h"

#include "bench/surface/NewtonSearch.h"
#include "core/Error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace asperity {

namespace {

/// Far below what counts as wrong.
constexpr NewtonEnd kPolished{1e-15};
/// A cell no nearer than this short of the best so far cannot matter; covers rounding. [relative]
constexpr double kMargin = 1e-9;

/// Returns how far a number lies outside [low, high].
double outside(double value, double low, double high) {
    return std::max({low - value, value - high, 0.0});
}

/// Index of an entry in a row-major array with rows of this length.
std::size_t indexOf(int row, int column, int length) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(length) +
           static_cast<std::size_t>(column);
}

/// Returns whether no neighbor in the n x n lattice is lower.
bool isLowest(const std::vector<double>& values, int n, int i, int j) {
    const double value = values[indexOf(i, j, n)];
    for (int k = std::max(i - 1, 0); k <= std::min(i + 1, n - 1); ++k) {
        for (int l = std::max(j - 1, 0); l <= std::min(j + 1, n - 1); ++l) {
            if (values[indexOf(k, l, n)] < value) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace

GlobalReference::GlobalReference(const BSplineSurface& surface, ReferenceEffort effort)
    : surface_(surface)
    , effort_(effort)
    , columns_(surface.grid().columns - 1)
    , rows_(surface.grid().rows - 1) {
    if (columns_ < 1 || rows_ < 1) {
        throw Error("the reference of the closest point needs a scan of two pixels or more");
    }
    ranges_.reserve(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_));
    for (int row = 0; row < rows_; ++row) {
        for (int column = 0; column < columns_; ++column) {
            ranges_.push_back(rangeOf(row, column));
        }
    }
}

/// A B-spline lies in the hull of its control points; beyond the outermost pixel centers, where its
/// polynomials are continued, it need not.
GlobalReference::HeightRange GlobalReference::rangeOf(int row, int column) const {
    constexpr double kAny = std::numeric_limits<double>::infinity();
    if (row == 0 || column == 0 || row == rows_ - 1 || column == columns_ - 1) {
        return {.low = -kAny, .high = kAny};
    }
    HeightRange range{.low = kAny, .high = -kAny};
    for (int i = -1; i <= 2; ++i) {
        for (int j = -1; j <= 2; ++j) {
            const double height = surface_.control(row + i, column + j);
            range.low = std::min(range.low, height);
            range.high = std::max(range.high, height);
        }
    }
    return range;
}

/// The outermost cells reach to the scan's edge, half a pixel beyond the last pixel center.
GlobalReference::Extent GlobalReference::extentOf(int cell, int cells, double pitch) {
    return {.low = cell == 0 ? 0.0 : (cell + 0.5) * pitch,
            .high = cell == cells - 1 ? (cells + 1) * pitch : (cell + 1.5) * pitch};
}

GlobalReference::CellRange GlobalReference::cellsWithin(double center, double reach, int cells,
                                                        double pitch) {
    const double low = std::floor((center - reach) / pitch - 0.5);
    const double high = std::floor((center + reach) / pitch - 0.5);
    return {.first = static_cast<int>(std::clamp(low, 0.0, cells - 1.0)),
            .last = static_cast<int>(std::clamp(high, 0.0, cells - 1.0))};
}

double GlobalReference::leastDistance(const Vector3& query, int row, int column) const {
    const Extent x = extentOf(column, columns_, surface_.grid().pitchX);
    const Extent y = extentOf(row, rows_, surface_.grid().pitchY);
    const HeightRange& z = ranges_[indexOf(row, column, columns_)];
    return std::hypot(outside(query.x(), x.low, x.high), outside(query.y(), y.low, y.high),
                      outside(query.z(), z.low, z.high));
}

void GlobalReference::polish(const Vector3& query, const Vector2& start, Nearest& best) const {
    const Vector2 position = newtonPoint(surface_, query, start, kPolished);
    const double distance = distanceTo(surface_, query, position);
    if (distance < best.distance) {
        best = {.position = position, .distance = distance};
    }
}

void GlobalReference::searchCell(const Vector3& query, int row, int column, Nearest& best) const {
    const Extent x = extentOf(column, columns_, surface_.grid().pitchX);
    const Extent y = extentOf(row, rows_, surface_.grid().pitchY);
    const int n = effort_.samplesPerCell;
    std::vector<Vector2> positions;
    std::vector<double> values;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            positions.emplace_back(x.low + (x.high - x.low) * j / (n - 1),
                                   y.low + (y.high - y.low) * i / (n - 1));
            values.push_back(distanceTo(surface_, query, positions.back()));
        }
    }
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            if (isLowest(values, n, i, j)) {
                polish(query, positions[indexOf(i, j, n)], best);
            }
        }
    }
}

GlobalReference::Nearest GlobalReference::nearest(const Vector3& query) const {
    Nearest best{.distance = std::numeric_limits<double>::infinity()};
    polish(query, query.head<2>(), best);
    const double reach = best.distance;
    const CellRange down = cellsWithin(query.y(), reach, rows_, surface_.grid().pitchY);
    const CellRange along = cellsWithin(query.x(), reach, columns_, surface_.grid().pitchX);
    for (int row = down.first; row <= down.last; ++row) {
        for (int column = along.first; column <= along.last; ++column) {
            if (!effort_.skipsCells ||
                leastDistance(query, row, column) < best.distance * (1.0 + kMargin)) {
                searchCell(query, row, column, best);
            }
        }
    }
    return best;
}

}  // namespace asperity
