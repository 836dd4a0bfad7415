#include "core/surface/BSplineSurface.h"

#include "core/Error.h"
#include "core/surface/CellBoundsBuilder.h"
#include "core/surface/HeightMap.h"
#include "core/surface/UniformCubic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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

/// The span at `place` pixels from the scan's edge.
CubicSpan spanAt(double place, int pixels) {
    return cubicSpan(place - 0.5, std::max(pixels - 1, 1));
}

/// One over the pixel size [1/m].
struct InversePitch {
    double x = 0.0;
    double y = 0.0;
};

/// Height and derivatives from the 4 x 4 control heights that start at `corner`.
template <class Height>
HeightSample sampled(const Height* corner, std::ptrdiff_t stride, const CubicSpan& across,
                     const CubicSpan& up, InversePitch scale) {
    using Controls = Eigen::Matrix<Height, 4, 1>;
    Weights height = Weights::Zero();
    Weights slope = Weights::Zero();
    Weights curvature = Weights::Zero();
    for (int j = 0; j < 4; ++j) {
        const Weights row = Eigen::Map<const Controls>(corner + j * stride).template cast<double>();
        height += up.value[j] * row;
        slope += up.slope[j] * row;
        curvature += up.curvature[j] * row;
    }
    return {.height = height.dot(across.value),
            .dx = height.dot(across.slope) * scale.x,
            .dy = slope.dot(across.value) * scale.y,
            .dxx = height.dot(across.curvature) * (scale.x * scale.x),
            .dxy = slope.dot(across.slope) * (scale.x * scale.y),
            .dyy = curvature.dot(across.value) * (scale.y * scale.y)};
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
    if (grid.controlHeights.size() != (rows + 2) * (columns + 2) ||
        (!grid.invalid.empty() && grid.invalid.size() != rows * columns)) {
        throw Error("the control heights of a spline surface do not match its size");
    }
    return grid;
}

double largestMagnitude(const BSplineSurface::Grid& grid) {
    float largest = 0.0F;
    for (const float height : grid.controlHeights) {
        if (!isFiniteHeight(height)) {
            throw Error("a control height is not a finite number");
        }
        largest = std::max(largest, std::abs(height));
    }
    if (!isFiniteHeight(grid.datum)) {
        throw Error("the datum of the control heights is not a finite number");
    }
    return std::abs(grid.datum) + static_cast<double>(largest);
}

}  // namespace

BSplineSurface::BSplineSurface(Grid grid)
    : grid_(usable(std::move(grid)))
    , inversePitchX_(1.0 / grid_.pitchX)
    , inversePitchY_(1.0 / grid_.pitchY)
    , heightScale_(largestMagnitude(grid_))
    , bounds_(cellBoundsOf(grid_)) {}

HeightSample BSplineSurface::at(double x, double y) const noexcept {
    const CubicSpan across = spanAt(clampedToScan(x, sizeX()) * inversePitchX_, grid_.columns);
    const CubicSpan up = spanAt(clampedToScan(y, sizeY()) * inversePitchY_, grid_.rows);
    const InversePitch scale{inversePitchX_, inversePitchY_};
    HeightSample sample;
    if (grid_.columns == 1 || grid_.rows == 1) {
        const std::array<double, 16> heights = relativeControlsFrom(up.first - 1, across.first - 1);
        sample = sampled(heights.data(), 4, across, up, scale);
    } else {
        const std::ptrdiff_t stride = grid_.columns + 2;
        const float* corner = grid_.controlHeights.data() + up.first * stride + across.first;
        sample = sampled(corner, stride, across, up, scale);
    }
    sample.height += grid_.datum;
    return sample;
}

std::array<double, 16> BSplineSurface::relativeControlsFrom(int row, int column) const noexcept {
    std::array<double, 16> heights{};
    for (int i = 0; i < 16; ++i) {
        heights[static_cast<std::size_t>(i)] = relativeControl(row + i / 4, column + i % 4);
    }
    return heights;
}

bool BSplineSurface::contains(double x, double y) const noexcept {
    return std::isgreaterequal(x, 0.0) && std::islessequal(x, sizeX()) &&
           std::isgreaterequal(y, 0.0) && std::islessequal(y, sizeY());
}

bool BSplineSurface::isMeasured(double x, double y) const noexcept {
    if (grid_.invalid.empty()) {
        return true;
    }
    const int column =
        std::min(static_cast<int>(clampedToScan(x, sizeX()) * inversePitchX_), grid_.columns - 1);
    const int row =
        std::min(static_cast<int>(clampedToScan(y, sizeY()) * inversePitchY_), grid_.rows - 1);
    return grid_.invalid[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.columns) +
                         static_cast<std::size_t>(column)] == 0;
}

double BSplineSurface::control(int row, int column) const noexcept {
    return grid_.datum + relativeControl(row, column);
}

double BSplineSurface::relativeControl(int row, int column) const noexcept {
    return controlAlong(row, grid_.rows, [&](int r) { return controlInRow(r, column); });
}

double BSplineSurface::controlInRow(int row, int column) const noexcept {
    const std::size_t stride = static_cast<std::size_t>(grid_.columns) + 2;
    const float* line =
        grid_.controlHeights.data() + static_cast<std::size_t>(row + 1) * stride + 1;
    return controlAlong(column, grid_.columns, [line](int c) -> double { return line[c]; });
}

Eigen::Matrix4d cellControls(const BSplineSurface::Grid& grid, int row, int column) noexcept {
    const std::ptrdiff_t stride = grid.columns + 2;
    Eigen::Matrix4d controls;
    for (int i = 0; i < 4; ++i) {
        // Along an axis with a single pixel the surface is level.
        const float* line = grid.controlHeights.data() + (grid.rows == 1 ? 1 : row + i) * stride;
        for (int j = 0; j < 4; ++j) {
            controls(i, j) = line[grid.columns == 1 ? 1 : column + j];
        }
    }
    return controls;
}

}  // namespace asperity
