#include "core/surface/leveling/FacetPlane.h"

#include "core/ShareOut.h"
#include "core/Vector.h"
#include "core/surface/leveling/CountedPixels.h"

#include <Eigen/LU>

#include <cmath>
#include <vector>

namespace asperity {

namespace {

/// Sums over squares of pixels.
struct SlopeSums {
    double weight = 0.0;
    Vector2 slope = Vector2::Zero();                   ///< times weight
    Eigen::Matrix2d square = Eigen::Matrix2d::Zero();  ///< times weight

    void add(double weightOfOne, const Vector2& one) {
        weight += weightOfOne;
        slope += weightOfOne * one;
        square += weightOfOne * one * one.transpose();
    }
    [[nodiscard]] Vector2 mean() const { return slope / weight; }
    [[nodiscard]] Eigen::Matrix2d covariance() const {
        return square / weight - mean() * mean().transpose();
    }
};

/// The squares of 2 x 2 pixels of a map, of every `stride`-th row, and their slopes, world frame.
template <class Heights>
class Facets {
public:
    Facets(const BasicHeightMap<Heights>& map, int stride) : map_(map), stride_(stride) {}

    /// Sums of what add(SlopeSums&, slope) makes of the squares, row by row: a row's sum does not
    /// depend on the thread that takes it.
    template <class Add>
    [[nodiscard]] SlopeSums sum(Progress* progress, const Add& add) const {
        const int count = (map_.rows - 1 + stride_ - 1) / stride_;
        if (count < 1 || map_.columns < 2) {
            return {};
        }
        SlopeSums all;
        for (const SlopeSums& one :
             ofEachRow(count, progress, [&](int i) { return rowSum(i * stride_, add); })) {
            all.weight += one.weight;
            all.slope += one.slope;
            all.square += one.square;
        }
        return all;
    }

private:
    template <class Add>
    [[nodiscard]] SlopeSums rowSum(int row, const Add& add) const {
        SlopeSums sums;
        bool leftCounts = isColumnPair(row, 0);
        for (int column = 1; column < map_.columns; ++column) {
            const bool rightCounts = isColumnPair(row, column);
            if (leftCounts && rightCounts) {
                add(sums, slopeAt(row, column));
            }
            leftCounts = rightCounts;
        }
        return sums;
    }

    [[nodiscard]] bool isColumnPair(int row, int column) const {
        return counts(map_, row, column) && counts(map_, row + 1, column);
    }

    /// Of the square whose upper right pixel this is.
    [[nodiscard]] Vector2 slopeAt(int row, int column) const {
        const double topLeft = map_.at(row, column - 1);
        const double topRight = map_.at(row, column);
        const double bottomLeft = map_.at(row + 1, column - 1);
        const double bottomRight = map_.at(row + 1, column);
        return {0.5 * ((topRight - topLeft) + (bottomRight - bottomLeft)) / map_.pitchX,
                0.5 * ((topLeft - bottomLeft) + (topRight - bottomRight)) / map_.pitchY};
    }

    const BasicHeightMap<Heights>& map_;
    int stride_;
};

/// Mean slope and mean square distance from it.
struct Spread {
    Vector2 mean = Vector2::Zero();
    double square = 0.0;

    /// s^2 of the weights around a slope.
    [[nodiscard]] double widthSquareAt(const Vector2& slope) const {
        constexpr double kShare = 1.0 / 20.0;
        return kShare * (square + (mean - slope).squaredNorm());
    }
};

template <class Heights>
Spread spreadOf(const Facets<Heights>& facets, Progress* progress) {
    ProgressPart ofMean(progress, 0.0, 0.5);
    const SlopeSums all =
        facets.sum(&ofMean, [](SlopeSums& sums, const Vector2& slope) { sums.add(1.0, slope); });
    if (all.weight == 0.0) {
        return {};
    }
    const Vector2 mean = all.mean();
    ProgressPart ofSquare(progress, 0.5, 1.0);
    const SlopeSums square = facets.sum(&ofSquare, [&](SlopeSums& sums, const Vector2& slope) {
        sums.weight += (slope - mean).squaredNorm();
    });
    return {.mean = mean, .square = square.weight / all.weight};
}

/// The squares near `slope`, relative to it, with their weights.
template <class Heights>
SlopeSums weightedAround(const Facets<Heights>& facets, const Vector2& slope, double widthSquare,
                         Progress* progress) {
    constexpr double kNegligible = 40.0;  // exp(-40) of the largest weight
    return facets.sum(progress, [&](SlopeSums& sums, const Vector2& one) {
        const Vector2 from = one - slope;
        const double exponent = from.squaredNorm() / widthSquare;
        if (exponent < kNegligible) {
            sums.add(std::exp(-exponent), from);
        }
    });
}

/// From a slope towards the one that is its own weighted mean. Near that one, a step to the mean
/// closes a few percent of the gap only; Newton's step closes it.
Vector2 stepFrom(const SlopeSums& near, double widthSquare) {
    const Vector2 toMean = near.mean();
    const Eigen::Matrix2d gap = Eigen::Matrix2d::Identity() - 2.0 / widthSquare * near.covariance();
    const bool isNearPeak = gap.determinant() > 0.0 && gap.trace() > 0.0;
    if (!isNearPeak) {
        return toMean;
    }
    const Vector2 newton = gap.inverse() * toMean;
    return newton.squaredNorm() < widthSquare ? newton : toMean;
}

/// The prevailing slope of the facets, sought from `slope` on.
template <class Heights>
Vector2 prevailingSlope(const Facets<Heights>& facets, Vector2 slope, Progress* progress) {
    constexpr int kMaxPasses = 100;
    constexpr double kSettled = 1e-6;     // of the width of the weights
    constexpr double kShareOfPass = 0.2;  // of the progress that is left: a few passes do
    ProgressPart spreading(progress, 0.0, kShareOfPass);
    const Spread spread = spreadOf(facets, &spreading);
    double done = kShareOfPass;
    for (int pass = 0; pass < kMaxPasses; ++pass) {
        const double widthSquare = spread.widthSquareAt(slope);
        if (!(widthSquare > 0.0)) {
            break;  // all squares have this slope
        }
        const double next = done + kShareOfPass * (1.0 - done);
        ProgressPart part(progress, done, next);
        done = next;
        const SlopeSums near = weightedAround(facets, slope, widthSquare, &part);
        if (near.weight == 0.0) {
            break;
        }
        const Vector2 step = stepFrom(near, widthSquare);
        slope += step;
        if (step.squaredNorm() < kSettled * kSettled * widthSquare) {
            break;
        }
    }
    return slope;
}

/// Large maps are searched on some rows before they are on all: the last passes decide.
template <class Heights>
Vector2 prevailingSlope(const BasicHeightMap<Heights>& map, Progress* progress) {
    constexpr std::size_t kManySquares = std::size_t{1} << 19U;
    const auto stride = static_cast<int>(map.heights.size() / kManySquares);
    Vector2 slope = Vector2::Zero();
    ProgressPart some(progress, 0.0, 0.3);
    if (stride > 1) {
        slope = prevailingSlope(Facets<Heights>(map, stride), slope, &some);
    }
    ProgressPart all(progress, 0.3, 1.0);
    return prevailingSlope(Facets<Heights>(map, 1), slope, &all);
}

}  // namespace

template <class Heights>
PlaneFit facetPlane(const BasicHeightMap<Heights>& map, Progress* progress) {
    ProgressPart ofMean(progress, 0.0, 0.1);
    PlaneFit plane = planeOf(map, &ofMean);
    ProgressPart ofSlope(progress, 0.1, 1.0);
    const Vector2 slope = prevailingSlope(map, &ofSlope);
    plane.slopeX = slope.x();
    plane.slopeY = slope.y();
    return plane;
}

template PlaneFit facetPlane(const BasicHeightMap<std::vector<double>>&, Progress*);
template PlaneFit facetPlane(const BasicHeightMap<PixelVector<float>>&, Progress*);

}  // namespace asperity
