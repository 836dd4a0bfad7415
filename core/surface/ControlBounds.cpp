#include "core/surface/ControlBounds.h"

#include "core/Error.h"
#include "core/surface/HeightMap.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <future>

namespace asperity {

namespace {

/// Control heights side by side: the compiler turns sums and comparisons into few instructions.
constexpr std::ptrdiff_t kSideBySide = 16;
using Heights = Eigen::Array<float, kSideBySide, 1>;

Heights load(const float* from) { return Eigen::Map<const Heights>(from); }

/// Largest bits of a magnitude among `count` heights; as whole numbers they keep the order.
std::int32_t largestBits(const float* heights, std::ptrdiff_t count) {
    constexpr std::int32_t kMagnitude = 0x7fffffff;
    std::int32_t largest = 0;
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        largest = std::max(largest, std::bit_cast<std::int32_t>(heights[i]) & kMagnitude);
    }
    return largest;
}

/// The largest magnitude, and the largest second differences along x, along y and mixed.
struct Differences {
    std::int32_t bits = 0;
    float alongX = 0.0F;
    float alongY = 0.0F;
    float mixed = 0.0F;

    Differences& operator|=(const Differences& other) {
        bits = std::max(bits, other.bits);
        alongX = std::max(alongX, other.alongX);
        alongY = std::max(alongY, other.alongY);
        mixed = std::max(mixed, other.mixed);
        return *this;
    }
};

/// The largest over i = 0..count-1 of difference(i), or 0. `many` gives kSideBySide of them at
/// once; the last of these look at some again.
template <class Difference, class Many>
float largestOf(std::ptrdiff_t count, const Difference& difference, const Many& many) {
    if (count < kSideBySide) {
        float largest = 0.0F;
        for (std::ptrdiff_t i = 0; i < count; ++i) {
            largest = std::max(largest, difference(i));
        }
        return largest;
    }
    Heights largest = Heights::Zero();
    for (std::ptrdiff_t i = 0; i < count; i += kSideBySide) {
        const Heights candidate = many(std::min(i, count - kSideBySide));
        largest = largest.max(candidate);
    }
    return largest.maxCoeff();
}

float largestAlongX(const float* c, std::ptrdiff_t count) {
    return largestOf(
        count, [c](std::ptrdiff_t i) { return (c[i] - c[i + 1]) + (c[i + 2] - c[i + 1]); },
        [c](std::ptrdiff_t i) -> Heights {
            return (load(c + i) - load(c + i + 1)) + (load(c + i + 2) - load(c + i + 1));
        });
}

float largestAlongY(const float* c, std::ptrdiff_t stride) {
    const float* up = c + stride;
    const float* higher = up + stride;
    return largestOf(
        stride, [=](std::ptrdiff_t i) { return (c[i] - up[i]) + (higher[i] - up[i]); },
        [=](std::ptrdiff_t i) -> Heights {
            return (load(c + i) - load(up + i)) + (load(higher + i) - load(up + i));
        });
}

float largestMixed(const float* c, std::ptrdiff_t stride) {
    const float* up = c + stride;
    return largestOf(
        stride - 1,
        [=](std::ptrdiff_t i) { return std::abs((up[i + 1] - c[i + 1]) - (up[i] - c[i])); },
        [=](std::ptrdiff_t i) -> Heights {
            return ((load(up + i + 1) - load(c + i + 1)) - (load(up + i) - load(c + i))).abs();
        });
}

Differences differencesOf(const BSplineSurface::Grid& grid, int firstRow, int endRow) {
    const std::ptrdiff_t stride = grid.columns + 2;
    Differences largest;
    for (int row = firstRow; row < endRow; ++row) {
        const float* c = grid.controlHeights.data() + row * stride;
        const std::int32_t bits = largestBits(c, stride);
        largest |= {.bits = bits};
        if (!isFiniteHeight(std::bit_cast<float>(bits))) {
            return largest;
        }
        largest |= {.alongX = largestAlongX(c, stride - 2)};
        if (row < grid.rows) {
            largest |= {.alongY = largestAlongY(c, stride)};
        }
        if (row < grid.rows + 1) {
            largest |= {.mixed = largestMixed(c, stride)};
        }
    }
    return largest;
}

}  // namespace

ControlBounds controlBoundsOf(const BSplineSurface::Grid& grid) {
    constexpr std::size_t kWorthAThread = std::size_t{1} << 18U;  // control heights
    const int rows = grid.rows + 2;
    const int half = grid.controlHeights.size() > kWorthAThread ? rows / 2 : 0;
    auto lower = std::async(half > 0 ? std::launch::async : std::launch::deferred,
                            [&] { return differencesOf(grid, 0, half); });
    Differences largest = differencesOf(grid, half, rows);
    largest |= lower.get();
    const double magnitude = std::bit_cast<float>(largest.bits);
    if (!isFiniteHeight(magnitude)) {
        throw Error("a control height is not a finite number");
    }
    // Each difference of three or four heights is rounded three times.
    const double rounding = 0x1p-21 * magnitude;
    const auto bounded = [rounding](float difference) { return difference + rounding; };
    // Second derivatives of a cubic spline are averages of its control heights' second differences,
    // and no principal curvature is stronger than the largest eigenvalue of the second derivatives.
    const double alongX = bounded(largest.alongX) / (grid.pitchX * grid.pitchX);
    const double alongY = bounded(largest.alongY) / (grid.pitchY * grid.pitchY);
    const double mixed = bounded(largest.mixed) / (grid.pitchX * grid.pitchY);
    return {.magnitude = magnitude, .concavity = std::max(alongX, alongY) + mixed};
}

}  // namespace asperity
