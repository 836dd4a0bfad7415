#include "core/surface/closest/PartFacts.h"

#include "core/surface/BezierCell.h"
#include "core/surface/SplineSampling.h"
#include "core/surface/closest/SlopeFrame.h"

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

/// The part of each of four cubics between two positions, 0..1 along each of them (polar form).
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

/// Returns whether a cell reaches to the scan's edge, or has a single pixel along an axis.
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

/// A polynomial's derivatives lie within the hull of the differences of its Bezier points.
ASPERITY_INLINE Double4 rise(const PartBatch& b, int i, int k) {
    return b.net[i][k + 1] - b.net[i][k];
}

/// Second derivatives of the height over each part.
/// @param per 1 / length of the part's sides
ASPERITY_INLINE Bends4 heightBends(const PartBatch& b, const Pair4& per) {
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
    return {xx.times(6.0 * per.x * per.x), xy.times(9.0 * per.x * per.y),
            yy.times(6.0 * per.y * per.y)};
}

/// Value in the middle of a cubic with these Bezier points, and how much it rises along it there.
ASPERITY_INLINE Double4 middle(Double4 a, Double4 b, Double4 c, Double4 d) {
    return 0.125 * ((a + d) + 3.0 * (b + c));
}
ASPERITY_INLINE Double4 middleRise(Double4 a, Double4 b, Double4 c, Double4 d) {
    return 0.75 * ((d - a) + (c - b));
}

/// The height at the center of each part.
struct Center4 {
    Double4 height;  ///< above the datum [m]
    Pair4 slope;
};

ASPERITY_INLINE Center4 centerOf(const PartBatch& batch, const Pair4& per) {
    Double4 alongX[4];
    Double4 riseX[4];
    for (int i = 0; i < 4; ++i) {
        const auto& row = batch.net[i];
        alongX[i] = middle(row[0], row[1], row[2], row[3]);
        riseX[i] = middleRise(row[0], row[1], row[2], row[3]);
    }
    return {middle(alongX[0], alongX[1], alongX[2], alongX[3]),
            {per.x * middle(riseX[0], riseX[1], riseX[2], riseX[3]),
             per.y * middleRise(alongX[0], alongX[1], alongX[2], alongX[3])}};
}

/// Returns how much the slopes along a frame's axes differ between a part's center and any position
/// in it: the second derivatives by one axis of the frame and one of x and y, times the way.
ASPERITY_INLINE Pair4 slopesAlong(const Bends4& b, const SlopeFrame& f, const Pair4& half) {
    const Range4 ux = f.p * b.xx + f.q * b.xy;
    const Range4 uy = f.p * b.xy + f.q * b.yy;
    const Range4 vx = f.p * b.xy + (-f.q) * b.xx;
    const Range4 vy = f.p * b.yy + (-f.q) * b.xy;
    return {ux.most() * half.x + uy.most() * half.y, vx.most() * half.x + vy.most() * half.y};
}

/// The height's derivatives in a part along the axes of a frame.
struct HeightIn {
    Bends4 bends;
    Pair4 slope;   ///< at the center
    Pair4 spread;  ///< by which that differs elsewhere
};

/// Second derivatives of half the squared distance along the axes of a frame: second derivatives of
/// (h - z)^2 / 2 are those of h times h - z, plus products of slopes.
/// @param square of the axes' length; @param offset h - z [m]
ASPERITY_INLINE Bends4 distanceBends(const HeightIn& height, Double4 square, const Range4& offset) {
    const Range4 u{height.slope.x, height.spread.x};
    const Range4 v{height.slope.y, height.spread.y};
    const Range4 flat{square, Double4{}};
    return {flat + squared(u) + offset * height.bends.xx, u * v + offset * height.bends.xy,
            flat + squared(v) + offset * height.bends.yy};
}

/// Half the length of each part's sides, and the inverse of the whole.
struct Sides4 {
    Pair4 half;  ///< [m]
    Pair4 per;   ///< [1/m]
};

/// Rounding of the gradient at the center of a part and of its spread over it: a minimum on the
/// side that two parts share must not be denied to both.
/// @param bend no second derivative along x and y is larger
/// @param above the query, at the center [m]
ASPERITY_INLINE Pair4 gradientRounding(Double4 bend, const Pair4& slope, Double4 above,
                                       const Sides4& sides, const SurfaceRounding& rounding) {
    constexpr double kRelative = 1e-13;
    const Double4 common =
        rounding.position * (1.0 + 2.0 * bend) + kRelative * bend * (sides.half.x + sides.half.y);
    // A slope is told from heights no farther apart than the part is wide.
    const Double4 lever = 4.0 * magnitude(above);
    return {common + rounding.height * (magnitude(slope.x) + lever * sides.per.x),
            common + rounding.height * (magnitude(slope.y) + lever * sides.per.y)};
}

/// Range of a function's gradient in a part, along the axes of a frame.
struct GradientIn {
    Pair4 center;       ///< along x and y
    Pair4 unsure;       ///< of that, along x and y
    Pair4 perMove;      ///< by how much that differs after a unit move of the query, along x and y
    Bends4 bends;       ///< along the axes of the frame
    Pair4 bendsByMove;  ///< by how much those let it differ more after a unit move of the query
};

/// Returns how far the query may move until the function's gradient may vanish in a part: Newton's
/// step from the center leads out of it by more than what the second derivatives differ in the part
/// can bring back, or the gradient is larger than what they can make it differ. < 0: it may vanish.
/// Source: Krawczyk (1969), Newton-Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken.
ASPERITY_INLINE Double4 calmOf(const GradientIn& gradient, const SlopeFrame& frame,
                               const Pair4& half, const Pair4& reach) {
    const Bends4& bends = gradient.bends;
    const Double4 a = bends.xx.middle;
    const Double4 b = bends.xy.middle;
    const Double4 c = bends.yy.middle;
    const Double4 size = magnitude(a * c - b * b);
    // A Newton step for an unsure gradient, times the determinant.
    const auto stepFor = [&](const Pair4& most) {
        return frame.sizes({magnitude(c) * most.x + magnitude(b) * most.y,
                            magnitude(b) * most.x + magnitude(a) * most.y});
    };
    const Pair4 unsure = frame.sizes(gradient.unsure);
    const Pair4 perMove = frame.sizes(gradient.perMove);
    const Pair4 more{perMove.x + gradient.bendsByMove.x, perMove.y + gradient.bendsByMove.y};
    const Pair4 back = stepFor({bends.xx.radius * reach.x + bends.xy.radius * reach.y + unsure.x,
                                bends.xy.radius * reach.x + bends.yy.radius * reach.y + unsure.y});
    const Pair4 moreBack = stepFor(more);
    const Pair4 g = frame.along(gradient.center);
    const Double4 stepU = b * g.y - c * g.x;
    const Double4 stepV = b * g.x - a * g.y;
    const Double4 stepX = magnitude(frame.p * stepU - frame.q * stepV);
    const Double4 stepY = magnitude(frame.q * stepU + frame.p * stepV);
    const Pair4 spread = bends.spread(reach);
    const Double4 byStep = most(overPositive(stepX - size * half.x - back.x, moreBack.x),
                                overPositive(stepY - size * half.y - back.y, moreBack.y));
    const Double4 bySpread = most(overPositive(magnitude(g.x) - spread.x - unsure.x, more.x),
                                  overPositive(magnitude(g.y) - spread.y - unsure.y, more.y));
    return most(byStep, bySpread);
}

/// From the query to about the nearest point of each part, were it level with its center's slope.
ASPERITY_INLINE Vector4 wayToNearest(const PartBatch& batch, const Vector4& center,
                                     const Pair4& slope) {
    // The step to the point of the plane that is nearest, cut off at the part's sides.
    const Double4 along = (center.x * slope.x + center.y * slope.y - center.z) /
                          (1.0 + slope.x * slope.x + slope.y * slope.y);
    const auto within = [](Double4 step, Double4 half) { return most(-half, least(half, step)); };
    const Double4 stepX = within(along * slope.x - center.x, batch.halfX);
    const Double4 stepY = within(along * slope.y - center.y, batch.halfY);
    return {center.x + stepX, center.y + stepY, center.z + slope.x * stepX + slope.y * stepY};
}

/// Returns how far along a way from the query all of a part lies, times the length of the way:
/// beyond a plane across it, as its Bezier points do.
/// @param center from the query to the part's center; @param height of the query above the datum
ASPERITY_INLINE Double4 leastAlong(const Vector4& way, const PartBatch& batch,
                                   const Vector4& center, double height) {
    constexpr double kThird = 1.0 / 3.0;
    const Double4 sideX = way.x * batch.halfX;
    const Double4 sideY = way.y * batch.halfY;
    const Double4 alongX[4] = {-sideX, -kThird * sideX, kThird * sideX, sideX};
    const Double4 alongY[4] = {-sideY, -kThird * sideY, kThird * sideY, sideY};
    Double4 nearest = alongX[0] + alongY[0] + way.z * (batch.net[0][0] - height);
    for (int i = 0; i < 4; ++i) {
        for (int k = 0; k < 4; ++k) {
            nearest = least(nearest, (alongX[k] + alongY[i]) + way.z * (batch.net[i][k] - height));
        }
    }
    return nearest + (way.x * center.x + way.y * center.y);
}

/// Half the squared distance of a plane across a way.
ASPERITY_INLINE Double4 halfSquareOf(const Vector4& way, Double4 along) {
    const Double4 beyond = most(along, Double4{});
    const Double4 square = way.x * way.x + way.y * way.y + way.z * way.z;
    return 0.5 * beyond * overPositive(beyond, square);
}

/// Returns how far the query may move with a convex part staying so. Its second derivatives along
/// the axes differ then by those of the height times the way.
ASPERITY_INLINE Double4 convexFor(const Bends4& bends, const Bends4& height) {
    const Double4 a = height.xx.most();
    const Double4 b = height.xy.most();
    const Double4 c = height.yy.most();
    const Double4 mixed = bends.xy.most();
    const Double4 determinant = bends.xx.low() * bends.yy.low() - mixed * mixed;
    const Double4 loss = a * bends.yy.low() + c * bends.xx.low() + 2.0 * b * mixed;
    // The determinant falls by no more than loss * way + (b * way)^2, and the way is no longer than
    // this:
    const Double4 longest = overPositive(determinant, loss);
    return least(overPositive(determinant, loss + b * b * longest),
                 least(overPositive(bends.xx.low(), a), overPositive(bends.yy.low(), c)));
}

ASPERITY_INLINE Long4 areAtEdge(const PartBatch& batch, const Box& scan) {
    // One part beside the edge is as good as at it.
    return (batch.centerX - 2.0 * batch.halfX < scan.low.x()) |
           (batch.centerY - 2.0 * batch.halfY < scan.low.y()) |
           (batch.centerX + 2.0 * batch.halfX > scan.high.x()) |
           (batch.centerY + 2.0 * batch.halfY > scan.high.y());
}

ASPERITY_WITH_AVX2 void examineLanes(const PartBatch& batch, const PartQuery& query,
                                     PartFacts& facts) {
    const Pair4 half{batch.halfX, batch.halfY};
    const Pair4 per{0.5 / batch.halfX, 0.5 / batch.halfY};
    const Center4 center = centerOf(batch, per);
    const Double4 above = center.height - query.point.z();
    const Double4 x = batch.centerX - query.point.x();
    const Double4 y = batch.centerY - query.point.y();
    const Pair4 gradient{x + above * center.slope.x, y + above * center.slope.y};
    facts.value = 0.5 * (x * x + y * y + above * above);
    facts.gradientX = gradient.x;
    facts.gradientY = gradient.y;
    facts.way = wayToNearest(batch, {x, y, above}, center.slope);
    facts.alongWay = leastAlong(facts.way, batch, {x, y, above}, query.point.z());
    facts.least = halfSquareOf(facts.way, facts.alongWay);
    facts.far = bitsOf(facts.least >= query.limit);
    if (facts.far == PartBatch::kAllLanes) {
        return;
    }

    const SlopeFrame frame = SlopeFrame::of(center.slope);
    const Pair4 reach = frame.reach(half);
    const Bends4 height = heightBends(batch, per);
    const Bends4 heightAlong = frame.along(height);
    const Pair4 slopeSpread = height.spread(half);
    const Range4 offset{above, (magnitude(center.slope.x) + 0.5 * slopeSpread.x) * half.x +
                                   (magnitude(center.slope.y) + 0.5 * slopeSpread.y) * half.y};
    const Bends4 bends =
        distanceBends({heightAlong, frame.along(center.slope), slopesAlong(height, frame, half)},
                      frame.square, offset);
    facts.least = most(facts.least, facts.value - bends.fall(frame.along(gradient), reach));
    facts.far = bitsOf(facts.least >= query.limit);
    if (facts.far == PartBatch::kAllLanes) {
        return;
    }
    const Pair4 unsure = gradientRounding(frame.mostAlongXY(bends), center.slope, above,
                                          {half, per}, query.rounding);
    facts.calm =
        calmOf({.center = gradient,
                .unsure = unsure,
                // By the way along x or y, and by that along z times the slope.
                .perMove = {1.0 + magnitude(center.slope.x), 1.0 + magnitude(center.slope.y)},
                .bends = bends,
                .bendsByMove = heightAlong.spread(reach)},
               frame, half, reach);
    facts.withoutMinimum = bitsOf((facts.calm > 0.0) | bends.bendDown());
    facts.convex = bitsOf(bends.areConvex());
    facts.convexFor = convexFor(bends, heightAlong);
    if (const Long4 atEdge = areAtEdge(batch, query.scan); bitsOf(atEdge) != 0) {
        facts.calm = atEdge ? Double4{} : facts.calm;
        facts.convexFor = atEdge ? Double4{} : facts.convexFor;
        const Bends4 alongXY = frame.back(bends);
        const Pair4 spread = alongXY.spread(half);
        facts.bendX = alongXY.xx.low();
        facts.bendY = alongXY.yy.low();
        facts.spreadX = spread.x + unsure.x;
        facts.spreadY = spread.y + unsure.y;
    }
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
            // The outermost are set below; until then any position of the grid will do.
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

bool CellPart::contains(const BSplineSurface::Grid& grid, const Vector2& point) const noexcept {
    const double parts = 1 << depth;
    // Outermost cells reach farther than their spans.
    const auto isWithin = [&](double inSpans, const SpanPart& extent, int index) {
        const double at = (inSpans - extent.low) / extent.length() * parts - index;
        return at >= 0.0 && at <= 1.0;
    };
    return isWithin(point.x() / grid.pitchX - 0.5 - cell.column,
                    cellExtent(cell.column, grid.columns), column) &&
           isWithin(point.y() / grid.pitchY - 0.5 - cell.row, cellExtent(cell.row, grid.rows), row);
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

void examine(const PartBatch& batch, const PartQuery& query, PartFacts& facts) noexcept {
    examineLanes(batch, query, facts);
}

}  // namespace asperity
