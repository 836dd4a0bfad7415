#include "core/surface/leveling/QuadraticFit.h"

#include "core/surface/LeastSquares.h"
#include "core/surface/leveling/CountedPixels.h"
#include "core/surface/leveling/PlaneFit.h"

#include <utility>
#include <vector>

namespace asperity {

namespace {

constexpr int kTerms = 6;
/// Powers of u and v of each term.
constexpr std::array<std::pair<int, int>, kTerms> kPowers{
    {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};

using Matrix6 = Eigen::Matrix<double, kTerms, kTerms>;
using Vector6 = Eigen::Matrix<double, kTerms, 1>;

/// Sums along a row of powers of u, and of those times the height.
struct RowSums {
    std::array<double, 5> powers{};
    std::array<double, 3> heights{};
};

template <class Heights, class Place>
RowSums rowSums(const BasicHeightMap<Heights>& map, int row, double origin, const Place& placeOf) {
    RowSums sums;
    for (int column = 0; column < map.columns; ++column) {
        if (!counts(map, row, column)) {
            continue;
        }
        const double u = placeOf(column);
        const double uu = u * u;
        const double height = map.at(row, column) - origin;
        sums.powers[0] += 1.0;
        sums.powers[1] += u;
        sums.powers[2] += uu;
        sums.powers[3] += uu * u;
        sums.powers[4] += uu * uu;
        sums.heights[0] += height;
        sums.heights[1] += u * height;
        sums.heights[2] += uu * height;
    }
    return sums;
}

/// Adds what a row at v has in the normal equations.
void addRow(const RowSums& sums, double v, Matrix6& normal, Vector6& right) {
    const std::array<double, 5> powers{1.0, v, v * v, v * v * v, v * v * v * v};
    for (int i = 0; i < kTerms; ++i) {
        const auto [ui, vi] = kPowers[static_cast<std::size_t>(i)];
        for (int j = 0; j < kTerms; ++j) {
            const auto [uj, vj] = kPowers[static_cast<std::size_t>(j)];
            normal(i, j) += sums.powers[static_cast<std::size_t>(ui + uj)] *
                            powers[static_cast<std::size_t>(vi + vj)];
        }
        right(i) +=
            sums.heights[static_cast<std::size_t>(ui)] * powers[static_cast<std::size_t>(vi)];
    }
}

}  // namespace

template <class Heights>
QuadraticFit::QuadraticFit(const BasicHeightMap<Heights>& map, Progress* progress)
    : middleColumn_(0.5 * (map.columns - 1))
    , middleRow_(0.5 * (map.rows - 1))
    , halfColumns_(0.5 * map.columns)
    , halfRows_(0.5 * map.rows)
    , halfWidth_(0.5 * map.sizeX())
    , halfHeight_(0.5 * map.sizeY())
    , origin_(0.0) {
    requireUsable(map);
    origin_ = firstHeight(map);
    Matrix6 normal = Matrix6::Zero();
    Vector6 right = Vector6::Zero();
    const std::vector<RowSums> rows = ofEachRow(map.rows, progress, [&](int row) {
        return rowSums(map, row, origin_,
                       [&](int column) { return (column - middleColumn_) / halfColumns_; });
    });
    for (int row = 0; row < map.rows; ++row) {
        addRow(rows[static_cast<std::size_t>(row)], (middleRow_ - row) / halfRows_, normal, right);
    }
    Vector6::Map(terms_.data()) = leastSquares(normal, right);
}

template QuadraticFit::QuadraticFit(const BasicHeightMap<std::vector<double>>&, Progress*);
template QuadraticFit::QuadraticFit(const BasicHeightMap<PixelVector<float>>&, Progress*);

}  // namespace asperity
