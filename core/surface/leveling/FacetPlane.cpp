#include "core/surface/leveling/FacetPlane.h"

#include "core/ShareOut.h"
#include "core/Vector.h"
#include "core/surface/leveling/CountedPixels.h"

#include <cmath>
#include <vector>

namespace asperity {

namespace {

/// Sums over squares of pixels.
struct SlopeSums {
    double weight = 0.0;
    Vector2 slope = Vector2::Zero();  ///< times weight
};

/// The squares of 2 x 2 pixels of a map and their slopes, world frame.
template <class Heights>
class Facets {
public:
    explicit Facets(const BasicHeightMap<Heights>& map) : map_(map) {}

    /// Sums of what add(SlopeSums&, slope) makes of the squares, row by row: a row's sum does not
    /// depend on the thread that takes it.
    template <class Add>
    [[nodiscard]] SlopeSums sum(Progress* progress, const Add& add) const {
        if (map_.rows < 2 || map_.columns < 2) {
            return {};
        }
        std::vector<SlopeSums> ofRows(static_cast<std::size_t>(map_.rows) - 1);
        shareOut(map_.rows - 1, progress, [&](int row, const CancelCheck& /*check*/) {
            ofRows[static_cast<std::size_t>(row)] = rowSum(row, add);
        });
        SlopeSums all;
        for (const SlopeSums& one : ofRows) {
            all.weight += one.weight;
            all.slope += one.slope;
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
};

/// Mean slope and mean square distance from it.
struct Spread {
    Vector2 mean = Vector2::Zero();
    double square = 0.0;
};

template <class Heights>
Spread spreadOf(const Facets<Heights>& facets) {
    const SlopeSums all = facets.sum(nullptr, [](SlopeSums& sums, const Vector2& slope) {
        sums.weight += 1.0;
        sums.slope += slope;
    });
    if (all.weight == 0.0) {
        return {};
    }
    const Vector2 mean = all.slope / all.weight;
    const SlopeSums square = facets.sum(nullptr, [&](SlopeSums& sums, const Vector2& slope) {
        sums.weight += (slope - mean).squaredNorm();
    });
    return {.mean = mean, .square = square.weight / all.weight};
}

/// The next mean slope after `slope`.
template <class Heights>
Vector2 weightedMean(const Facets<Heights>& facets, const Vector2& slope, double widthSquare,
                     Progress* progress) {
    constexpr double kNegligible = 100.0;  // exp(-100) of the largest weight
    const SlopeSums near = facets.sum(progress, [&](SlopeSums& sums, const Vector2& one) {
        const double exponent = (one - slope).squaredNorm() / widthSquare;
        if (exponent < kNegligible) {
            const double weight = std::exp(-exponent);
            sums.weight += weight;
            sums.slope += weight * one;
        }
    });
    return near.weight > 0.0 ? Vector2(near.slope / near.weight) : slope;
}

template <class Heights>
Vector2 prevailingSlope(const BasicHeightMap<Heights>& map, Progress* progress) {
    constexpr int kMaxPasses = 100;
    constexpr double kShare = 1.0 / 20.0;
    constexpr double kSettled = 1e-6;  // of the width of the weights
    const Facets<Heights> facets(map);
    const Spread spread = spreadOf(facets);
    Vector2 slope = Vector2::Zero();
    for (int pass = 0; pass < kMaxPasses; ++pass) {
        const double widthSquare = kShare * (spread.square + (spread.mean - slope).squaredNorm());
        if (!(widthSquare > 0.0)) {
            break;  // all squares have this slope
        }
        ProgressPart part(progress, static_cast<double>(pass) / kMaxPasses,
                          static_cast<double>(pass + 1) / kMaxPasses);
        const Vector2 next = weightedMean(facets, slope, widthSquare, &part);
        const double step = (next - slope).squaredNorm();
        slope = next;
        if (step < kSettled * kSettled * widthSquare) {
            break;
        }
    }
    return slope;
}

}  // namespace

template <class Heights>
PlaneFit facetPlane(const BasicHeightMap<Heights>& map, Progress* progress) {
    PlaneFit plane = planeOf(map);
    const Vector2 slope = prevailingSlope(map, progress);
    plane.slopeX = slope.x();
    plane.slopeY = slope.y();
    return plane;
}

template PlaneFit facetPlane(const BasicHeightMap<std::vector<double>>&, Progress*);
template PlaneFit facetPlane(const BasicHeightMap<PixelVector<float>>&, Progress*);

}  // namespace asperity
