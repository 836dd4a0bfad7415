#pragma once

#include "core/Simd.h"
#include "core/surface/closest/Range4.h"

namespace asperity {

/// Least value of slope * t + bend * t^2 / 2 for |t| <= half.
ASPERITY_INLINE Double4 leastOnAxis(Double4 slope, Double4 bend, Double4 half) {
    const Double4 steep = magnitude(slope);
    const Double4 atSide = half * (0.5 * bend * half - steep);
    const Double4 inside = overPositive(-0.5 * steep * steep, bend);
    return steep >= bend * half ? atSide : inside;
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

/// Axes u up the slope and v across it, each as long as the vector (p, q): a place (x, y) is
/// u (p, q) + v (-q, p). Everything that is said along u and v is said per this length.
struct SlopeFrame {
    Double4 p;
    Double4 q;
    Double4 square;  ///< of the axes' length

    /// Where there is hardly any slope the axes are x and y: the box around a part is larger along
    /// any others.
    [[nodiscard]] ASPERITY_INLINE static SlopeFrame of(const Pair4& slope) {
        constexpr double kSlope = 2.0;
        const Double4 steepness = magnitude(slope.x) + magnitude(slope.y);
        const Long4 hasSlope = steepness > kSlope;
        const Double4 per = 1.0 / (hasSlope ? steepness : Double4{} + 1.0);
        const Double4 p = hasSlope ? slope.x * per : Double4{} + 1.0;
        const Double4 q = hasSlope ? slope.y * per : Double4{};
        return {p, q, p * p + q * q};
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

}  // namespace asperity
