#include "core/surface/leveling/PlaneFit.h"

#include "core/Error.h"
#include "core/ShareOut.h"
#include "core/SiFormat.h"
#include "core/Vector.h"
#include "core/surface/LeastSquares.h"
#include "core/surface/leveling/CountedPixels.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace asperity {

namespace {

/// Sums over valid pixels of position [pixel], from the middle of the map, y up, and of height.
struct Moments {
    double count = 0.0;
    Vector2 position = Vector2::Zero();
    Eigen::Matrix2d square = Eigen::Matrix2d::Zero();
    double height = 0.0;
    Vector2 tilt = Vector2::Zero();  ///< of position times height

    Moments& operator+=(const Moments& other) {
        count += other.count;
        position += other.position;
        square += other.square;
        height += other.height;
        tilt += other.tilt;
        return *this;
    }
};

/// Moments of one row; heights are taken from `origin`, so that an offset costs no digits.
template <class Heights>
Moments rowMoments(const BasicHeightMap<Heights>& map, int row, double origin) {
    double count = 0.0;
    double x = 0.0;
    double xx = 0.0;
    double z = 0.0;
    double xz = 0.0;
    const double middle = 0.5 * (map.columns - 1);
    for (int column = 0; column < map.columns; ++column) {
        if (!counts(map, row, column)) {
            continue;
        }
        const double position = column - middle;
        const double height = map.at(row, column) - origin;
        count += 1.0;
        x += position;
        xx += position * position;
        z += height;
        xz += position * height;
    }
    const double y = 0.5 * (map.rows - 1) - row;
    Moments moments{.count = count, .position = {x, count * y}, .height = z, .tilt = {xz, y * z}};
    moments.square << xx, x * y, x * y, count * y * y;
    return moments;
}

template <class Heights>
Moments mapMoments(const BasicHeightMap<Heights>& map, double origin, Progress* progress) {
    Moments sum;
    for (const Moments& one :
         ofEachRow(map.rows, progress, [&](int row) { return rowMoments(map, row, origin); })) {
        sum += one;
    }
    return sum;
}

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

    /// Slope of the square whose upper right pixel this is.
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

std::string pointText(const Vector2& point) {
    return "(" + formatSi(point.x(), "m") + ", " + formatSi(point.y(), "m") + ")";
}

/// Mean position and height of the pixels around a position.
struct Support {
    Vector2 position;     ///< [m]
    double height = 0.0;  ///< [m]
};

template <class Heights>
Support supportAt(const BasicHeightMap<Heights>& map, const Vector2& point) {
    const double right = point.x() / map.pitchX;
    const double down = map.rows - point.y() / map.pitchY;
    if (!(right >= 0.0 && right <= map.columns && down >= 0.0 && down <= map.rows)) {
        throw Error("three_point: the point " + pointText(point) + " lies outside the scan");
    }
    const int column = std::min(static_cast<int>(right), map.columns - 1);
    const int row = std::min(static_cast<int>(down), map.rows - 1);
    Vector2 position = Vector2::Zero();
    double height = 0.0;
    double count = 0.0;
    for (int r = row - 1; r <= row + 1; ++r) {
        for (int c = column - 1; c <= column + 1; ++c) {
            if (r < 0 || c < 0 || r >= map.rows || c >= map.columns || !counts(map, r, c)) {
                continue;
            }
            position += Vector2((c + 0.5) * map.pitchX, (map.rows - r - 0.5) * map.pitchY);
            height += map.at(r, c);
            count += 1.0;
        }
    }
    if (count == 0.0) {
        throw Error("three_point: no pixel around the point " + pointText(point) + " holds data");
    }
    return {.position = position / count, .height = height / count};
}

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

template <class Heights, class Scale>
RowSums rowSums(const BasicHeightMap<Heights>& map, int row, double origin, const Scale& scaled) {
    RowSums sums;
    for (int column = 0; column < map.columns; ++column) {
        if (!counts(map, row, column)) {
            continue;
        }
        const double u = scaled(column);
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
double firstHeight(const BasicHeightMap<Heights>& map) {
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            if (counts(map, row, column)) {
                return map.at(row, column);
            }
        }
    }
    throw Error("the height map holds no valid pixel");
}

template <class Heights>
PlaneFit planeOf(const BasicHeightMap<Heights>& map, Progress* progress) {
    requireUsable(map);
    const double origin = firstHeight(map);
    const Moments sums = mapMoments(map, origin, progress);
    const Vector2 center = sums.position / sums.count;
    const Eigen::Matrix2d spread = sums.square - sums.position * center.transpose();
    // The smallest solution: level across a line, should the pixels form one.
    const Vector2 perPixel = leastSquares(spread, sums.tilt - center * sums.height);
    return {.slopeX = perPixel.x() / map.pitchX,
            .slopeY = perPixel.y() / map.pitchY,
            .mean = origin + sums.height / sums.count,
            .centerX = (center.x() + 0.5 * map.columns) * map.pitchX,
            .centerY = (center.y() + 0.5 * map.rows) * map.pitchY};
}

template <class Heights>
void subtractPlane(BasicHeightMap<Heights>& map, const PlaneFit& plane, Progress* progress) {
    subtract(
        map,
        [&](int row, int column) {
            return plane.at((column + 0.5) * map.pitchX, (map.rows - row - 0.5) * map.pitchY);
        },
        progress);
}

PlaneFit fitPlane(const HeightMap& map) { return planeOf(map); }

PlaneFit fitPlane(const ScanMap& map) {
    PlaneFit plane = planeOf(map);
    plane.mean += map.datum;
    return plane;
}

template double firstHeight(const BasicHeightMap<std::vector<double>>&);
template double firstHeight(const BasicHeightMap<PixelVector<float>>&);
template PlaneFit planeOf(const BasicHeightMap<std::vector<double>>&, Progress*);
template PlaneFit planeOf(const BasicHeightMap<PixelVector<float>>&, Progress*);
template void subtractPlane(BasicHeightMap<std::vector<double>>&, const PlaneFit&, Progress*);
template void subtractPlane(BasicHeightMap<PixelVector<float>>&, const PlaneFit&, Progress*);

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

template <class Heights>
PlaneFit threePointPlane(const BasicHeightMap<Heights>& map, const LevelPoints& points) {
    requireUsable(map);
    if (const std::string refusal = refusalOf(points); !refusal.empty()) {
        throw Error(refusal);
    }
    const Support a = supportAt(map, points[0]);
    const Support b = supportAt(map, points[1]);
    const Support c = supportAt(map, points[2]);
    const Vector2 ab = b.position - a.position;
    const Vector2 ac = c.position - a.position;
    const double longest = std::max({ab.norm(), ac.norm(), (c.position - b.position).norm()});
    const double twiceArea = ab.x() * ac.y() - ab.y() * ac.x();
    if (!(std::abs(twiceArea) > std::min(map.pitchX, map.pitchY) * longest)) {
        throw Error("three_point needs three points that do not lie on one line within a pixel");
    }
    const double riseB = b.height - a.height;
    const double riseC = c.height - a.height;
    const Vector2 center = (a.position + b.position + c.position) / 3.0;
    return {.slopeX = (riseB * ac.y() - riseC * ab.y()) / twiceArea,
            .slopeY = (riseC * ab.x() - riseB * ac.x()) / twiceArea,
            .mean = a.height + (riseB + riseC) / 3.0,
            .centerX = center.x(),
            .centerY = center.y()};
}

template PlaneFit threePointPlane(const BasicHeightMap<std::vector<double>>&, const LevelPoints&);
template PlaneFit threePointPlane(const BasicHeightMap<PixelVector<float>>&, const LevelPoints&);

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
