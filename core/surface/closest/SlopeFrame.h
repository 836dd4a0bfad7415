#pragma once

#include "core/Simd.h"

namespace asperity {

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

/// @param divisor >= 0; nothing is divided by 0
ASPERITY_INLINE Double4 overPositive(Double4 number, Double4 divisor) {
    constexpr double kMin = 1e-150;
    return number / most(divisor, Double4{} + kMin);
}

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

    /// Largest difference of the function's gradient between a box's center and any position in it.
    [[nodiscard]] ASPERITY_INLINE Pair4 spread(const Pair4& half) const {
        return {xx.most() * half.x + xy.most() * half.y, xy.most() * half.x + yy.most() * half.y};
    }
    /// The function falls from the center of the box to any position in it by no more than this.
    [[nodiscard]] ASPERITY_INLINE Double4 fall(const Pair4& gradient, const Pair4& half) const {
        return xy.most() * half.x * half.y - leastOnAxis(gradient.x, xx.low(), half.x) -
               leastOnAxis(gradient.y, yy.low(), half.y);
    }
    /// Returns whether it bends down in some direction everywhere.
    [[nodiscard]] ASPERITY_INLINE Long4 bendDown() const {
        const Double4 mixed = xy.least();
        return (xx.high() < 0.0) | (yy.high() < 0.0) | ((xx * yy).high() < mixed * mixed);
    }
    [[nodiscard]] ASPERITY_INLINE Long4 areConvex() const {
        const Double4 mixed = xy.most();
        return (xx.low() > 0.0) & (yy.low() > 0.0) & (xx.low() * yy.low() > mixed * mixed);
    }
};

/// Axes u up the slope and v across it, each as long as the vector (p, q): a position (x, y) is
/// u (p, q) + v (-q, p). Everything that is said along u and v is said per this length.
struct SlopeFrame {
    Double4 p;
    Double4 q;
    Double4 square;  ///< of the axes' length

    /// Returns the axes for a slope; x and y where there is hardly any slope: the box around a part
    /// is larger along any others.
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
    /// Transforms from the axes back to x and y.
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
    /// Bounds of a number along each of the two axes, from its bounds along x and y, and the other
    /// way round.
    [[nodiscard]] ASPERITY_INLINE Pair4 sizes(const Pair4& most) const {
        return {magnitude(p) * most.x + magnitude(q) * most.y,
                magnitude(q) * most.x + magnitude(p) * most.y};
    }
    /// Half the size of a box along the axes.
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
