#include "core/surface/BSplineSurface.h"

#include "core/Error.h"
#include "core/Simd.h"
#include "core/surface/CellBoundsBuilder.h"
#include "core/surface/HeightMap.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace asperity {

namespace {

using Weights = Eigen::Vector4d;

/// Brings a place into [0, size]; the comparisons are quiet for a place that is not a number.
double clampedToScan(double place, double size) {
    if (!std::isgreater(place, 0.0)) {
        return 0.0;
    }
    return std::isless(place, size) ? place : size;
}

/// A place within a span of one axis.
struct SpanPlace {
    int first = 0;   ///< control height that the span starts with, in the padded grid
    double t = 0.0;  ///< 0..1 in the span; beyond it at the scan's edges
};

/// The span at `place` pixels from the scan's edge.
SpanPlace spanAt(double place, int pixels) {
    // The conversion rounds up only below 0, where span 0 is continued anyway.
    const int first = std::clamp(static_cast<int>(place - 0.5), 0, std::max(pixels - 2, 0));
    return {.first = first, .t = place - 0.5 - first};
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

/// From the four rows of control heights that shape the span.
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

ASPERITY_WITH_AVX2 void sampleCell(const float* corner, std::ptrdiff_t stride, double t, double s,
                                   HeightSample& sample) {
    sample = sampled({widened(corner), widened(corner + stride), widened(corner + 2 * stride),
                      widened(corner + 3 * stride)},
                     t, s);
}

/// The first of a cell's control heights, and what single precision leaves of it.
struct FineCorner {
    const float* heights = nullptr;
    const float* rests = nullptr;
    std::ptrdiff_t stride = 0;

    [[nodiscard]] ASPERITY_INLINE Double4 row(std::ptrdiff_t i) const {
        return widened(heights + i * stride) + widened(rests + i * stride);
    }
};

ASPERITY_WITH_AVX2 void sampleFineCell(const FineCorner& corner, double t, double s,
                                       HeightSample& sample) {
    sample = sampled({corner.row(0), corner.row(1), corner.row(2), corner.row(3)}, t, s);
}

/// On a grid with a single pixel along an axis; apart, so that it costs the others nothing.
[[gnu::noinline]] void sampleThin(const BSplineSurface::Grid& grid, const SpanPlace& across,
                                  const SpanPlace& up, HeightSample& sample) {
    const Eigen::Matrix4d controls = cellControls(grid, up.first, across.first);
    std::array<Double4, 4> rows{};
    for (int i = 0; i < 4; ++i) {
        rows[static_cast<std::size_t>(i)] =
            Double4{controls(i, 0), controls(i, 1), controls(i, 2), controls(i, 3)};
    }
    sample = sampled(rows, across.t, up.t);
}

/// A control height above the grid's datum [m].
double storedControl(const BSplineSurface::Grid& grid, std::size_t index) {
    const double height = grid.controlHeights[index];
    return grid.controlRests.empty() ? height
                                     : height + static_cast<double>(grid.controlRests[index]);
}

/// Continues a cubic sequence before c0: the fourth difference is zero.
double continued(const Weights& c) { return 4.0 * c[0] - 6.0 * c[1] + 4.0 * c[2] - c[3]; }

/// Value of a control sequence of `pixels` pixels at `index`, which may lie outside -1..pixels.
/// `stored(i)` gives what the padded grid holds for i in -1..pixels.
template <class Stored>
double controlAlong(int index, int pixels, const Stored& stored) {
    if (pixels == 1) {
        return stored(0);
    }
    if (index >= -1 && index <= pixels) {
        return stored(index);
    }
    const int inward = index < 0 ? 1 : -1;
    int last = index < 0 ? -1 : pixels;
    Weights c(stored(last), stored(last + inward), stored(last + 2 * inward),
              stored(last + 3 * inward));
    for (; last != index; last -= inward) {
        c = Weights(continued(c), c[0], c[1], c[2]);
    }
    return c[0];
}

BSplineSurface::Grid usable(BSplineSurface::Grid grid) {
    if (grid.columns < 1 || grid.rows < 1 || !std::isfinite(grid.pitchX) ||
        !std::isfinite(grid.pitchY) || grid.pitchX <= 0.0 || grid.pitchY <= 0.0) {
        throw Error("a spline surface needs at least one pixel and a positive pixel size");
    }
    const auto columns = static_cast<std::size_t>(grid.columns);
    const auto rows = static_cast<std::size_t>(grid.rows);
    const std::size_t controls = (rows + 2) * (columns + 2);
    if (grid.controlHeights.size() != controls ||
        (!grid.controlRests.empty() && grid.controlRests.size() != controls) ||
        (!grid.invalid.empty() && grid.invalid.size() != rows * columns)) {
        throw Error("the control heights of a spline surface do not match its size");
    }
    if (!isFiniteHeight(grid.datum)) {
        throw Error("the datum of the control heights is not a finite number");
    }
    return grid;
}

double largestMagnitude(const PixelVector<float>& heights) {
    // By the bits, whose order is that of the magnitudes: whole numbers are compared many at once.
    constexpr std::int32_t kMagnitude = 0x7fffffff;
    std::int32_t largest = 0;
    for (const float height : heights) {
        largest = std::max(largest, std::bit_cast<std::int32_t>(height) & kMagnitude);
    }
    const auto magnitude = std::bit_cast<float>(largest);
    if (!isFiniteHeight(magnitude)) {
        throw Error("a control height is not a finite number");
    }
    return static_cast<double>(magnitude);
}

double heightScaleOf(const BSplineSurface::Grid& grid) {
    return std::abs(grid.datum) + largestMagnitude(grid.controlHeights) +
           largestMagnitude(grid.controlRests);
}

}  // namespace

BSplineSurface::Parts::Parts(Grid usable, Progress* progress)
    : grid(std::move(usable))
    , inversePitchX(1.0 / grid.pitchX)
    , inversePitchY(1.0 / grid.pitchY)
    , heightScale(heightScaleOf(grid))
    , bounds(cellBoundsOf(grid, progress)) {}

BSplineSurface::BSplineSurface(Grid grid, Progress* progress)
    : parts_(std::make_shared<const Parts>(usable(std::move(grid)), progress)) {}

HeightSample BSplineSurface::at(double x, double y) const noexcept {
    const Grid& grid = parts_->grid;
    const double perX = parts_->inversePitchX;
    const double perY = parts_->inversePitchY;
    const SpanPlace across = spanAt(clampedToScan(x, sizeX()) * perX, grid.columns);
    const SpanPlace up = spanAt(clampedToScan(y, sizeY()) * perY, grid.rows);
    HeightSample sample;
    if (grid.columns == 1 || grid.rows == 1) {
        sampleThin(grid, across, up, sample);
    } else {
        const std::ptrdiff_t stride = grid.columns + 2;
        const std::ptrdiff_t first = up.first * stride + across.first;
        const float* corner = grid.controlHeights.data() + first;
        if (grid.controlRests.empty()) {
            sampleCell(corner, stride, across.t, up.t, sample);
        } else {
            sampleFineCell({corner, grid.controlRests.data() + first, stride}, across.t, up.t,
                           sample);
        }
    }
    sample.height += grid.datum;
    sample.dx *= perX;
    sample.dy *= perY;
    sample.dxx *= perX * perX;
    sample.dxy *= perX * perY;
    sample.dyy *= perY * perY;
    return sample;
}

bool BSplineSurface::contains(double x, double y) const noexcept {
    return std::isgreaterequal(x, 0.0) && std::islessequal(x, sizeX()) &&
           std::isgreaterequal(y, 0.0) && std::islessequal(y, sizeY());
}

bool BSplineSurface::isMeasured(double x, double y) const noexcept {
    const Grid& grid = parts_->grid;
    if (grid.invalid.empty()) {
        return true;
    }
    const auto pixelAt = [](double place, double size, double perPitch, int pixels) {
        const auto pixel = static_cast<int>(clampedToScan(place, size) * perPitch);
        return static_cast<std::size_t>(std::min(pixel, pixels - 1));
    };
    const std::size_t column = pixelAt(x, sizeX(), parts_->inversePitchX, grid.columns);
    const std::size_t row = pixelAt(y, sizeY(), parts_->inversePitchY, grid.rows);
    return !grid.invalid[row * static_cast<std::size_t>(grid.columns) + column];
}

double BSplineSurface::control(int row, int column) const noexcept {
    return grid().datum + relativeControl(row, column);
}

double BSplineSurface::relativeControl(int row, int column) const noexcept {
    return controlAlong(row, grid().rows, [&](int r) { return controlInRow(r, column); });
}

double BSplineSurface::controlInRow(int row, int column) const noexcept {
    const std::size_t stride = static_cast<std::size_t>(grid().columns) + 2;
    const std::size_t first = static_cast<std::size_t>(row + 1) * stride + 1;
    return controlAlong(column, grid().columns, [&](int c) {
        return storedControl(grid(), first + static_cast<std::size_t>(c));
    });
}

Eigen::Matrix4d cellControls(const BSplineSurface::Grid& grid, int row, int column) noexcept {
    const std::ptrdiff_t stride = grid.columns + 2;
    Eigen::Matrix4d controls;
    for (int i = 0; i < 4; ++i) {
        // Along an axis with a single pixel the surface is level.
        const std::ptrdiff_t line = (grid.rows == 1 ? 1 : row + i) * stride;
        for (int j = 0; j < 4; ++j) {
            const std::ptrdiff_t at = line + (grid.columns == 1 ? 1 : column + j);
            controls(i, j) = storedControl(grid, static_cast<std::size_t>(at));
        }
    }
    return controls;
}

}  // namespace asperity
