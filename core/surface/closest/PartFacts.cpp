#include "core/surface/closest/PartFacts.h"

namespace asperity {

namespace {

/// All numbers no farther than `radius` from `middle`.
struct Range4 {
    Double4 middle;
    Double4 radius;

    [[nodiscard]] ASPERITY_INLINE Double4 low() const { return middle - radius; }
    [[nodiscard]] ASPERITY_INLINE Double4 high() const { return middle + radius; }
    /// The largest magnitude.
    [[nodiscard]] ASPERITY_INLINE Double4 most() const { return magnitude(middle) + radius; }
    /// The least magnitude.
    [[nodiscard]] ASPERITY_INLINE Double4 least() const {
        return asperity::most(Double4{}, magnitude(middle) - radius);
    }
};

ASPERITY_INLINE Range4 between(Double4 low, Double4 high) {
    return {0.5 * (low + high), 0.5 * (high - low)};
}

ASPERITY_INLINE Range4 operator+(const Range4& a, const Range4& b) {
    return {a.middle + b.middle, a.radius + b.radius};
}

ASPERITY_INLINE Range4 operator*(Double4 factor, const Range4& a) {
    return {factor * a.middle, magnitude(factor) * a.radius};
}

ASPERITY_INLINE Range4 operator*(const Range4& a, const Range4& b) {
    return {a.middle * b.middle, magnitude(a.middle) * b.radius + a.radius * b.most()};
}

/// Range of the square of a number in a range.
ASPERITY_INLINE Range4 squared(const Range4& a) {
    return between(a.least() * a.least(), a.most() * a.most());
}

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
        return between(low * scale, high * scale);
    }
};

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

/// A number along each of two axes.
struct Pair4 {
    Double4 x;
    Double4 y;
};

/// Ranges of the second derivatives of a function along two axes.
struct Bends4 {
    Range4 xx;
    Range4 xy;
    Range4 yy;

    /// How much the function's gradient differs at most between the center of a box and any place
    /// in it.
    [[nodiscard]] ASPERITY_INLINE Pair4 spread(const Pair4& half) const {
        return {xx.most() * half.x + xy.most() * half.y, xy.most() * half.x + yy.most() * half.y};
    }
    /// The function falls from the center of the box to any place in it by no more than this.
    [[nodiscard]] ASPERITY_INLINE Double4 fall(const Pair4& gradient, const Pair4& half) const {
        return xy.most() * half.x * half.y - leastOnAxis(gradient.x, xx.low(), half.x) -
               leastOnAxis(gradient.y, yy.low(), half.y);
    }
    /// Whether it bends down in some direction everywhere.
    [[nodiscard]] ASPERITY_INLINE Long4 bendDown() const {
        const Double4 mixed = xy.least();
        return (xx.high() < 0.0) | (yy.high() < 0.0) | ((xx * yy).high() < mixed * mixed);
    }
    [[nodiscard]] ASPERITY_INLINE Long4 areConvex() const {
        const Double4 mixed = xy.most();
        return (xx.low() > 0.0) & (yy.low() > 0.0) & (xx.low() * yy.low() > mixed * mixed);
    }
};

/// A polynomial's derivatives lie within the hull of the differences of its Bezier points.
ASPERITY_INLINE Double4 rise(const PartBatch& b, int i, int k) {
    return b.net[i][k + 1] - b.net[i][k];
}

/// Of the height over each part.
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

/// Axes u up the slope and v across it, each as long as the vector (p, q): a place (x, y) is
/// u (p, q) + v (-q, p). Everything that is said along u and v is said per this length.
struct SlopeFrame {
    Double4 p;
    Double4 q;
    Double4 square;  ///< of the axes' length

    /// Where there is hardly any slope the axes are x and y: the box around a part is larger along
    /// any others.
    ASPERITY_INLINE explicit SlopeFrame(const Pair4& slope) {
        constexpr double kSlope = 2.0;
        const Double4 steepness = magnitude(slope.x) + magnitude(slope.y);
        const Long4 hasSlope = steepness > kSlope;
        const Double4 per = 1.0 / (hasSlope ? steepness : Double4{} + 1.0);
        p = hasSlope ? slope.x * per : Double4{} + 1.0;
        q = hasSlope ? slope.y * per : Double4{};
        square = p * p + q * q;
    }

    /// A gradient along the axes.
    [[nodiscard]] ASPERITY_INLINE Pair4 along(const Pair4& gradient) const {
        return {p * gradient.x + q * gradient.y, p * gradient.y - q * gradient.x};
    }
    [[nodiscard]] ASPERITY_INLINE Bends4 along(const Bends4& b) const { return turned(b, q); }
    /// From the axes back to x and y.
    [[nodiscard]] ASPERITY_INLINE Bends4 back(const Bends4& b) const {
        const Double4 per = 1.0 / (square * square);
        const Bends4 turnedBack = turned(b, -q);
        return {per * turnedBack.xx, per * turnedBack.xy, per * turnedBack.yy};
    }
    /// No second derivative along x and y is larger than this.
    [[nodiscard]] ASPERITY_INLINE Double4 mostAlongXY(const Bends4& b) const {
        const Double4 per = 1.0 / (square * square);
        return per * (b.xx.most() + 2.0 * b.xy.most() + b.yy.most());
    }
    /// How much a number along each of two axes can be, from how much it can be along x and y, and
    /// the other way round.
    [[nodiscard]] ASPERITY_INLINE Pair4 sizes(const Pair4& most) const {
        return {magnitude(p) * most.x + magnitude(q) * most.y,
                magnitude(q) * most.x + magnitude(p) * most.y};
    }
    /// How far a box reaches along the axes.
    [[nodiscard]] ASPERITY_INLINE Pair4 reach(const Pair4& half) const {
        const Double4 per = 1.0 / square;
        const Pair4 size = sizes(half);
        return {per * size.x, per * size.y};
    }

private:
    [[nodiscard]] ASPERITY_INLINE Bends4 turned(const Bends4& b, Double4 sine) const {
        const Double4 mixed = p * sine;
        const Range4 twice = (2.0 * mixed) * b.xy;
        return {(p * p) * b.xx + twice + (sine * sine) * b.yy,
                mixed * b.yy + (-mixed) * b.xx + (p * p - sine * sine) * b.xy,
                (sine * sine) * b.xx + Range4{-twice.middle, twice.radius} + (p * p) * b.yy};
    }
};

/// How much the slopes along the axes of a frame differ between the center of a part and any place
/// in it: the second derivatives by one axis of the frame and one of x and y, times the way.
ASPERITY_INLINE Pair4 slopeSpread(const Bends4& b, const SlopeFrame& f, const Pair4& half) {
    const Range4 ux = f.p * b.xx + f.q * b.xy;
    const Range4 uy = f.p * b.xy + f.q * b.yy;
    const Range4 vx = f.p * b.xy + (-f.q) * b.xx;
    const Range4 vy = f.p * b.yy + (-f.q) * b.xy;
    return {ux.most() * half.x + uy.most() * half.y, vx.most() * half.x + vy.most() * half.y};
}

/// Of half the squared distance along the axes of a frame: second derivatives of (h - z)^2 / 2 are
/// those of h times h - z, plus products of slopes.
/// @param offset h - z [m]
ASPERITY_INLINE Bends4 distanceBends(const Bends4& height, const SlopeFrame& frame,
                                     const Pair4& slope, const Range4& offset, const Pair4& half) {
    const Bends4 bends = frame.along(height);
    const Pair4 center = frame.along(slope);
    const Pair4 spread = slopeSpread(height, frame, half);
    const Range4 u{center.x, spread.x};
    const Range4 v{center.y, spread.y};
    const Range4 flat{frame.square, Double4{}};
    return {flat + squared(u) + offset * bends.xx, u * v + offset * bends.xy,
            flat + squared(v) + offset * bends.yy};
}

/// Rounding of the gradient at the center of a part and of its spread over it: a minimum on the
/// side that two parts share must not be denied to both.
/// @param bend no second derivative along x and y is larger
/// @param above the query, at the center [m]
ASPERITY_INLINE Pair4 gradientRounding(Double4 bend, const Pair4& slope, Double4 above,
                                       const Pair4& half, const Pair4& per,
                                       const SurfaceRounding& rounding) {
    constexpr double kRelative = 1e-13;
    const Double4 common =
        rounding.place * (1.0 + 2.0 * bend) + kRelative * bend * (half.x + half.y);
    // A slope is told from heights no farther apart than the part is wide.
    const Double4 lever = 4.0 * magnitude(above);
    return {common + rounding.height * (magnitude(slope.x) + lever * per.x),
            common + rounding.height * (magnitude(slope.y) + lever * per.y)};
}

/// Whether a function's gradient cannot vanish in a part: Newton's step from the center leads out
/// of it by more than what the second derivatives differ in the part can bring back.
/// @param bends along the axes of the frame
/// Source: Krawczyk (1969), Newton-Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken.
ASPERITY_INLINE Long4 areSloped(const Bends4& bends, const Pair4& gradient, const SlopeFrame& frame,
                                const Pair4& half, const Pair4& reach, const Pair4& unsure) {
    const Double4 a = bends.xx.middle;
    const Double4 b = bends.xy.middle;
    const Double4 c = bends.yy.middle;
    const Double4 size = magnitude(a * c - b * b);
    const Pair4 unsureAlong = frame.sizes(unsure);
    const Double4 unsureU = bends.xx.radius * reach.x + bends.xy.radius * reach.y + unsureAlong.x;
    const Double4 unsureV = bends.xy.radius * reach.x + bends.yy.radius * reach.y + unsureAlong.y;
    const Pair4 g = frame.along(gradient);
    const Double4 stepU = b * g.y - c * g.x;
    const Double4 stepV = b * g.x - a * g.y;
    const Pair4 back = frame.sizes({magnitude(c) * unsureU + magnitude(b) * unsureV,
                                    magnitude(b) * unsureU + magnitude(a) * unsureV});
    const Double4 stepX = magnitude(frame.p * stepU - frame.q * stepV);
    const Double4 stepY = magnitude(frame.q * stepU + frame.p * stepV);
    const Pair4 spread = bends.spread(reach);
    return (stepX > size * half.x + back.x) | (stepY > size * half.y + back.y) |
           (magnitude(g.x) > spread.x + unsureAlong.x) |
           (magnitude(g.y) > spread.y + unsureAlong.y);
}

/// A vector in space [m].
struct Vector4 {
    Double4 x;
    Double4 y;
    Double4 z;
};

/// From the query to about the nearest place of each part, were it level with its center's slope.
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

/// Whether all of a part lies farther than the limit: beyond a plane across the way to about its
/// nearest place. It lies within the hull of its Bezier points.
/// @param center from the query to the part's center; @param height of the query above the datum
ASPERITY_INLINE Long4 liesBeyond(const PartBatch& batch, const Vector4& center, const Pair4& slope,
                                 double height, double limit) {
    constexpr double kThird = 1.0 / 3.0;
    const Vector4 way = wayToNearest(batch, center, slope);
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
    nearest += way.x * center.x + way.y * center.y;
    const Double4 square = way.x * way.x + way.y * way.y + way.z * way.z;
    return (nearest > 0.0) & (nearest * nearest >= (2.0 * limit) * square);
}

ASPERITY_INLINE bool reachesEdge(const PartBatch& batch, const Box& scan) {
    // One part beside the edge is as good as at it.
    const Long4 atEdge = (batch.centerX - 2.0 * batch.halfX < scan.low.x()) |
                         (batch.centerY - 2.0 * batch.halfY < scan.low.y()) |
                         (batch.centerX + 2.0 * batch.halfX > scan.high.x()) |
                         (batch.centerY + 2.0 * batch.halfY > scan.high.y());
    return bitsOf(atEdge) != 0;
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
    const Long4 beyond =
        liesBeyond(batch, {x, y, above}, center.slope, query.point.z(), query.limit);
    facts.far = bitsOf(beyond);
    if (facts.far == PartBatch::kAllLanes) {
        return;
    }

    const SlopeFrame frame(center.slope);
    const Bends4 height = heightBends(batch, per);
    const Pair4 slopeSpread = height.spread(half);
    const Range4 offset{above, (magnitude(center.slope.x) + 0.5 * slopeSpread.x) * half.x +
                                   (magnitude(center.slope.y) + 0.5 * slopeSpread.y) * half.y +
                                   query.ball};
    const Bends4 bends = distanceBends(height, frame, center.slope, offset, half);
    const Pair4 reach = frame.reach(half);
#ifndef NOFALL
    const Double4 fall = bends.fall(frame.along(gradient), reach);
    facts.far = bitsOf(beyond | (facts.value - fall >= query.limit));
    if (facts.far == PartBatch::kAllLanes) {
        return;
    }
#endif
    const Double4 most = frame.mostAlongXY(bends);
    Pair4 unsure = gradientRounding(most, center.slope, above, half, per, query.rounding);
    // A query elsewhere in the ball sees the gradient differ by the way to it, along x or y and up
    // the slope.
    unsure.x += query.ball * (1.0 + magnitude(center.slope.x) + slopeSpread.x);
    unsure.y += query.ball * (1.0 + magnitude(center.slope.y) + slopeSpread.y);
    facts.withoutMinimum =
        bitsOf(areSloped(bends, gradient, frame, half, reach, unsure) | bends.bendDown());
    if (reachesEdge(batch, query.scan)) {
        const Bends4 alongXY = frame.back(bends);
        const Pair4 spread = alongXY.spread(half);
        facts.bendX = alongXY.xx.low();
        facts.bendY = alongXY.yy.low();
        facts.spreadX = spread.x + unsure.x;
        facts.spreadY = spread.y + unsure.y;
    }
    facts.convex = bitsOf(bends.areConvex());
}

}  // namespace

void examine(const PartBatch& batch, const PartQuery& query, PartFacts& facts) noexcept {
    examineLanes(batch, query, facts);
}

}  // namespace asperity
