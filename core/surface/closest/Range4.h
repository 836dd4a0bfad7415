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

}  // namespace asperity
