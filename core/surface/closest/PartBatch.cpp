#include "core/surface/closest/PartBatch.h"

#include "core/surface/BezierCell.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace asperity {

namespace {

struct Range4 {
    Double4 low;
    Double4 high;

    [[nodiscard]] ASPERITY_INLINE Double4 middle() const { return 0.5 * (low + high); }
    [[nodiscard]] ASPERITY_INLINE Double4 radius() const { return 0.5 * (high - low); }
    [[nodiscard]] ASPERITY_INLINE Double4 size() const {
        return most(magnitude(low), magnitude(high));
    }
};

/// Range of the values seen so far.
struct Seen {
    Double4 low;
    Double4 high;

    ASPERITY_INLINE explicit Seen(Double4 first) : low(first), high(first) {}
    ASPERITY_INLINE void add(Double4 value) {
        low = least(low, value);
        high = most(high, value);
    }
    /// @param scale > 0
    [[nodiscard]] ASPERITY_INLINE Range4 times(Double4 scale) const {
        return {low * scale, high * scale};
    }
};

ASPERITY_INLINE Range4 operator*(const Range4& a, const Range4& b) {
    Seen product(a.low * b.low);
    product.add(a.low * b.high);
    product.add(a.high * b.low);
    product.add(a.high * b.high);
    return {product.low, product.high};
}

ASPERITY_INLINE Range4 operator+(const Range4& a, const Range4& b) {
    return {a.low + b.low, a.high + b.high};
}

ASPERITY_INLINE Range4 around(Double4 center, Double4 spread) {
    return {center - spread, center + spread};
}

/// Range of the square of a number in a range.
ASPERITY_INLINE Range4 squared(Double4 center, Double4 spread) {
    const Double4 high = magnitude(center) + spread;
    const Double4 low = most(Double4{}, magnitude(center) - spread);
    return {low * low, high * high};
}

/// Least value of slope * t + bend * t^2 / 2 for |t| <= half.
ASPERITY_INLINE Double4 leastOnAxis(Double4 slope, Double4 bend, Double4 half) {
    const Double4 steep = magnitude(slope);
    const Double4 atSide = half * (0.5 * bend * half - steep);
    constexpr double kMin = 1e-300;
    const Double4 inside = -0.5 * steep * steep / most(bend, Double4{} + kMin);
    return steep >= bend * half ? atSide : inside;
}

ASPERITY_INLINE unsigned bitsOf(Long4 lanes) {
    const Long4 bits = lanes & Long4{1, 2, 4, 8};
    return static_cast<unsigned>(bits[0] | bits[1] | bits[2] | bits[3]);
}

/// Second derivatives of the height over each part: a polynomial's derivatives lie within the hull
/// of the differences of its Bezier points.
struct Bends4 {
    Range4 xx;
    Range4 xy;
    Range4 yy;
};

ASPERITY_INLINE Double4 rise(const PartBatch& b, int i, int k) {
    return b.net[i][k + 1] - b.net[i][k];
}

ASPERITY_INLINE Bends4 bendsOf(const PartBatch& b, Double4 perX, Double4 perY) {
    const auto alongX = [&](int i, int k) {
        return (b.net[i][k + 2] - b.net[i][k + 1]) - (b.net[i][k + 1] - b.net[i][k]);
    };
    const auto alongY = [&](int i, int k) {
        return (b.net[k + 2][i] - b.net[k + 1][i]) - (b.net[k + 1][i] - b.net[k][i]);
    };
    Seen xx(alongX(0, 0));
    Seen yy(alongY(0, 0));
    Seen xy(rise(b, 1, 0) - rise(b, 0, 0));
    for (int i = 0; i < 4; ++i) {
        for (int k = 0; k < 2; ++k) {
            xx.add(alongX(i, k));
            yy.add(alongY(i, k));
        }
    }
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            xy.add(rise(b, i + 1, k) - rise(b, i, k));
        }
    }
    return {xx.times(6.0 * perX * perX), xy.times(9.0 * perX * perY), yy.times(6.0 * perY * perY)};
}

/// Value in the middle of a cubic with these Bezier points, and how much it rises along it there.
ASPERITY_INLINE Double4 middle(Double4 a, Double4 b, Double4 c, Double4 d) {
    return 0.125 * ((a + d) + 3.0 * (b + c));
}
ASPERITY_INLINE Double4 middleRise(Double4 a, Double4 b, Double4 c, Double4 d) {
    return 0.75 * ((d - a) + (c - b));
}

/// A number along x and one along y.
struct Pair4 {
    Double4 x;
    Double4 y;
};

/// Second derivatives of half the squared distance: those of (h - z)^2 / 2 are those of h times
/// h - z, plus products of slopes.
struct SquareBends {
    Range4 xx;
    Range4 xy;
    Range4 yy;

    /// Whether the distance bends down in some direction throughout the part.
    [[nodiscard]] ASPERITY_INLINE Long4 bendDown() const {
        const Double4 mixed = most(Double4{}, most(xy.low, -xy.high));
        return (xx.high < 0.0) | (yy.high < 0.0) | ((xx * yy).high < mixed * mixed);
    }
    [[nodiscard]] ASPERITY_INLINE Long4 areConvex() const {
        const Double4 mixed = xy.size();
        return (xx.low > 0.0) & (yy.low > 0.0) & (xx.low * yy.low > mixed * mixed);
    }
    /// Whether the gradient cannot vanish in the part: Newton's step from the center leads out of
    /// it by more than what the second derivatives differ in the part can bring back.
    /// Source: Krawczyk (1969), Newton-Algorithmen zur Bestimmung von Nullstellen mit
    /// Fehlerschranken.
    [[nodiscard]] ASPERITY_INLINE Long4 areSloped(const PartBatch& part, const PartFacts& facts,
                                                  const Pair4& unsure) const {
        const Double4 a = xx.middle();
        const Double4 b = xy.middle();
        const Double4 c = yy.middle();
        const Double4 size = magnitude(a * c - b * b);
        const Double4 unsureX = xx.radius() * part.halfX + xy.radius() * part.halfY + unsure.x;
        const Double4 unsureY = xy.radius() * part.halfX + yy.radius() * part.halfY + unsure.y;
        const Double4 stepX = magnitude(b * facts.gradientY - c * facts.gradientX);
        const Double4 stepY = magnitude(b * facts.gradientX - a * facts.gradientY);
        const Double4 backX = magnitude(c) * unsureX + magnitude(b) * unsureY;
        const Double4 backY = magnitude(b) * unsureX + magnitude(a) * unsureY;
        const Long4 leaves =
            (stepX > size * part.halfX + backX) | (stepY > size * part.halfY + backY);
        return leaves | (magnitude(facts.gradientX) > facts.spreadX) |
               (magnitude(facts.gradientY) > facts.spreadY);
    }
};

/// The slopes in each part: those at its center, and by how much they differ elsewhere.
struct Slopes4 {
    Pair4 center;
    Pair4 spread;

    /// How steep it is along x and y at most.
    [[nodiscard]] ASPERITY_INLINE Pair4 steepest() const {
        return {magnitude(center.x) + spread.x, magnitude(center.y) + spread.y};
    }
};

ASPERITY_INLINE Slopes4 slopesOf(const PartBatch& batch, const Bends4& bends, const Pair4& center) {
    return {center,
            {bends.xx.size() * batch.halfX + bends.xy.size() * batch.halfY,
             bends.xy.size() * batch.halfX + bends.yy.size() * batch.halfY}};
}

/// @param ball how far the query may be from where it is said to be [m]
ASPERITY_INLINE SquareBends squareBends(const PartBatch& batch, const Bends4& bends,
                                        const Slopes4& slopes, Double4 above, double ball) {
    const Pair4 steepest = slopes.steepest();
    const Range4 height = around(above, steepest.x * batch.halfX + steepest.y * batch.halfY + ball);
    const Range4 one{Double4{} + 1.0, Double4{} + 1.0};
    return {one + squared(slopes.center.x, slopes.spread.x) + height * bends.xx,
            around(slopes.center.x, slopes.spread.x) * around(slopes.center.y, slopes.spread.y) +
                height * bends.xy,
            one + squared(slopes.center.y, slopes.spread.y) + height * bends.yy};
}

/// Rounding of the gradient at the center of a part and of its spread over it: a minimum on the
/// side that two parts share must not be denied to both.
/// @param slope of the height at the center; @param above the query, there [m]
ASPERITY_INLINE Pair4 gradientRounding(const PartBatch& batch, const SquareBends& bends,
                                       const Pair4& slope, Double4 above,
                                       const SurfaceRounding& rounding) {
    constexpr double kRelative = 1e-13;
    const auto along = [&](Double4 bend, Double4 mixed, Double4 steepness, Double4 half) {
        // A slope is told from heights no farther apart than the part is wide.
        const Double4 lever = magnitude(steepness) + magnitude(above) * (2.0 / half);
        return rounding.place * (1.0 + bend + mixed) + rounding.height * lever +
               kRelative * (bend * half);
    };
    const Double4 mixed = bends.xy.size();
    const Double4 x = along(bends.xx.size(), mixed, slope.x, batch.halfX);
    const Double4 y = along(bends.yy.size(), mixed, slope.y, batch.halfY);
    return {x + kRelative * mixed * batch.halfY, y + kRelative * mixed * batch.halfX};
}

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

ASPERITY_WITH_AVX2 void examineLanes(const PartBatch& batch, const PartQuery& query,
                                     PartFacts& facts) {
    const Double4 perX = 0.5 / batch.halfX;
    const Double4 perY = 0.5 / batch.halfY;
    Double4 alongX[4];
    Double4 riseX[4];
    for (int i = 0; i < 4; ++i) {
        const auto& row = batch.net[i];
        alongX[i] = middle(row[0], row[1], row[2], row[3]);
        riseX[i] = middleRise(row[0], row[1], row[2], row[3]);
    }
    const Double4 above = middle(alongX[0], alongX[1], alongX[2], alongX[3]) - query.point.z();
    const Double4 slopeX = perX * middle(riseX[0], riseX[1], riseX[2], riseX[3]);
    const Double4 slopeY = perY * middleRise(alongX[0], alongX[1], alongX[2], alongX[3]);
    const Double4 x = batch.centerX - query.point.x();
    const Double4 y = batch.centerY - query.point.y();
    facts.value = 0.5 * (x * x + y * y + above * above);
    facts.gradientX = x + above * slopeX;
    facts.gradientY = y + above * slopeY;

    const Bends4 heightBends = bendsOf(batch, perX, perY);
    const Slopes4 slopes = slopesOf(batch, heightBends, {slopeX, slopeY});
    const SquareBends bends = squareBends(batch, heightBends, slopes, above, query.ball);
    facts.bendX = bends.xx.low;
    facts.bendY = bends.yy.low;
    const Double4 nearest = facts.value + leastOnAxis(facts.gradientX, facts.bendX, batch.halfX) +
                            leastOnAxis(facts.gradientY, facts.bendY, batch.halfY) -
                            bends.xy.size() * batch.halfX * batch.halfY;
    facts.far = bitsOf(nearest >= query.limit);
    if (facts.far == PartBatch::kAllLanes) {
        return;
    }
    Pair4 unsure = gradientRounding(batch, bends, slopes.center, above, query.rounding);
    // A query elsewhere in the ball sees the gradient differ by the way to it, along x or y and up
    // the slope.
    const Pair4 steepest = slopes.steepest();
    unsure.x += query.ball * (1.0 + steepest.x);
    unsure.y += query.ball * (1.0 + steepest.y);
    facts.spreadX = bends.xx.size() * batch.halfX + bends.xy.size() * batch.halfY + unsure.x;
    facts.spreadY = bends.xy.size() * batch.halfX + bends.yy.size() * batch.halfY + unsure.y;
    facts.withoutMinimum = bitsOf(bends.areSloped(batch, facts, unsure) | bends.bendDown());
    facts.convex = bitsOf(bends.areConvex());
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

void examine(const PartBatch& batch, const PartQuery& query, PartFacts& facts) noexcept {
    examineLanes(batch, query, facts);
}

}  // namespace asperity
