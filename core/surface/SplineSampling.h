#pragma once

#include "core/Simd.h"
#include "core/surface/BSplineSurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace asperity {

/// Brings a position into [0, size]; the comparisons are quiet for a position that is not a number.
ASPERITY_INLINE double clampedToScan(double position, double size) {
    if (!std::isgreater(position, 0.0)) {
        return 0.0;
    }
    return std::isless(position, size) ? position : size;
}

/// A position within a span of one axis.
struct SpanPosition {
    int first = 0;   ///< control height that the span starts with, in the padded grid
    double t = 0.0;  ///< 0..1 in the span; beyond it at the scan's edges
};

/// The span at `position` pixels from the scan's edge.
ASPERITY_INLINE SpanPosition spanAt(double position, int pixels) {
    // The conversion rounds up only below 0, where span 0 is continued anyway.
    const int first = std::clamp(static_cast<int>(position - 0.5), 0, std::max(pixels - 2, 0));
    return {.first = first, .t = position - 0.5 - first};
}

/// A uniform cubic B-spline on one span as the polynomial c0 + c1 t + c2 t^2 + c3 t^3, for four
/// splines at a time.
struct Cubic4 {
    Double4 c0;
    Double4 c1;
    Double4 c2;
    Double4 c3;

    [[nodiscard]] ASPERITY_INLINE Double4 value(double t) const {
        return c0 + t * (c1 + t * (c2 + t * c3));
    }
    [[nodiscard]] ASPERITY_INLINE Double4 slope(double t) const {
        return c1 + t * (2.0 * c2 + t * (3.0 * c3));
    }
    [[nodiscard]] ASPERITY_INLINE Double4 curvature(double t) const {
        return 2.0 * c2 + t * (6.0 * c3);
    }
};

/// Returns the cubic of the four rows of control heights that shape the span.
ASPERITY_INLINE Cubic4 cubicOf(Double4 a, Double4 b, Double4 c, Double4 d) {
    const Double4 bend = 0.5 * (a + c) - b;
    return {b + bend * (1.0 / 3.0), 0.5 * (c - a), bend, ((d - a) + 3.0 * (b - c)) * (1.0 / 6.0)};
}

/// Height and derivatives from 4 x 4 control heights, per span.
ASPERITY_INLINE HeightSample sampled(const std::array<Double4, 4>& rows, double t, double s) {
    const Cubic4 up = cubicOf(rows[0], rows[1], rows[2], rows[3]);
    const Cubic4 weights = cubicOf(Double4{1.0, 0.0, 0.0, 0.0}, Double4{0.0, 1.0, 0.0, 0.0},
                                   Double4{0.0, 0.0, 1.0, 0.0}, Double4{0.0, 0.0, 0.0, 1.0});
    const Double4 value = weights.value(t);
    const Double4 slope = weights.slope(t);
    const Double4 height = up.value(s);
    const Double4 rise = up.slope(s);
    const Double4 first = laneSums(height * value, height * slope, rise * value, rise * slope);
    const Double4 second =
        laneSums(height * weights.curvature(t), up.curvature(s) * value, Double4{}, Double4{});
    return {.height = first[0],
            .dx = first[1],
            .dy = first[2],
            .dxx = second[0],
            .dxy = first[3],
            .dyy = second[1]};
}

ASPERITY_INLINE Double4 widened(const float* heights) {
    return Double4{heights[0], heights[1], heights[2], heights[3]};
}

/// Data that the heights of a surface are sampled from, for functions of their own AVX2 version:
/// all of this is inlined into them.
struct SplineSampling {
    const BSplineSurface::Grid& grid;
    double perPitchX = 0.0;  ///< [1/m]
    double perPitchY = 0.0;  ///< [1/m]
};

/// Control heights of a cell with what single precision leaves of them; rests null: nothing.
struct CellCorner {
    const float* heights = nullptr;
    const float* rests = nullptr;
    std::ptrdiff_t stride = 0;

    [[nodiscard]] ASPERITY_INLINE Double4 row(std::ptrdiff_t i) const {
        const Double4 stored = widened(heights + i * stride);
        return rests == nullptr ? stored : stored + widened(rests + i * stride);
    }
};

ASPERITY_INLINE CellCorner cornerOf(const BSplineSurface::Grid& grid, std::ptrdiff_t row,
                                    std::ptrdiff_t column) {
    const std::ptrdiff_t stride = grid.columns + 2;
    const std::ptrdiff_t first = row * stride + column;
    return {grid.controlHeights.data() + first,
            grid.controlRests.empty() ? nullptr : grid.controlRests.data() + first, stride};
}

/// On a grid with a single pixel along an axis; apart, so that it costs the others nothing.
void sampleThin(const BSplineSurface::Grid& grid, const SpanPosition& across,
                const SpanPosition& up, HeightSample& sample) noexcept;

/// As BSplineSurface::at().
ASPERITY_INLINE HeightSample sampledAt(const SplineSampling& surface, double x, double y) {
    const BSplineSurface::Grid& grid = surface.grid;
    const double perX = surface.perPitchX;
    const double perY = surface.perPitchY;
    const SpanPosition across =
        spanAt(clampedToScan(x, grid.columns * grid.pitchX) * perX, grid.columns);
    const SpanPosition up = spanAt(clampedToScan(y, grid.rows * grid.pitchY) * perY, grid.rows);
    HeightSample sample;
    if (grid.columns == 1 || grid.rows == 1) {
        sampleThin(grid, across, up, sample);
    } else {
        const CellCorner corner = cornerOf(grid, up.first, across.first);
        sample =
            sampled({corner.row(0), corner.row(1), corner.row(2), corner.row(3)}, across.t, up.t);
    }
    sample.height += grid.datum;
    sample.dx *= perX;
    sample.dy *= perY;
    sample.dxx *= perX * perX;
    sample.dxy *= perX * perY;
    sample.dyy *= perY * perY;
    return sample;
}

}  // namespace asperity
