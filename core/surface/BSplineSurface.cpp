#include "core/surface/BSplineSurface.h"

#include "core/Error.h"
#include "core/Simd.h"
#include "core/surface/CellBoundsBuilder.h"
#include "core/surface/HeightMap.h"
#include "core/surface/SplineSampling.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace asperity {

namespace {

using SplineWeights = Eigen::Vector4d;

ASPERITY_WITH_AVX2 void sampleAt(const SplineSampling& surface, double x, double y,
                                 HeightSample& sample) {
    sample = sampledAt(surface, x, y);
}

/// A control height above the grid's datum [m].
double storedControl(const BSplineSurface::Grid& grid, std::size_t index) {
    const double height = grid.controlHeights[index];
    return grid.controlRests.empty() ? height
                                     : height + static_cast<double>(grid.controlRests[index]);
}

/// Continues a cubic sequence before c0: the fourth difference is zero.
double continued(const SplineWeights& c) { return 4.0 * c[0] - 6.0 * c[1] + 4.0 * c[2] - c[3]; }

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
    SplineWeights c(stored(last), stored(last + inward), stored(last + 2 * inward),
                    stored(last + 3 * inward));
    for (; last != index; last -= inward) {
        c = SplineWeights(continued(c), c[0], c[1], c[2]);
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

constexpr double kStep = 0.5;      // of a pixel, along the surface
constexpr int kMaxSteps = 100000;  // beyond, steps become longer
constexpr int kMaxHalvings = 200;
constexpr double kTolerance = 1e-14;  // of the part of the ray that is searched

/// A part of a ray, by multiples of its direction.
struct Stretch {
    double from = 0.0;
    double to = std::numeric_limits<double>::infinity();

    /// Keeps what lies between two planes across one axis.
    void clip(double origin, double direction, double low, double high) {
        if (direction == 0.0) {
            if (origin < low || origin > high) {
                to = -1.0;
            }
            return;
        }
        const double first = (low - origin) / direction;
        const double second = (high - origin) / direction;
        from = std::max(from, std::min(first, second));
        to = std::min(to, std::max(first, second));
    }
    [[nodiscard]] bool empty() const { return !(from <= to); }
};

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
    HeightSample sample;
    sampleAt(sampling(), x, y, sample);
    return sample;
}

SplineSampling BSplineSurface::sampling() const noexcept {
    return {grid(), parts_->inversePitchX, parts_->inversePitchY};
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
    const auto pixelAt = [](double position, double size, double perPitch, int pixels) {
        const auto pixel = static_cast<int>(clampedToScan(position, size) * perPitch);
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

void sampleThin(const BSplineSurface::Grid& grid, const SpanPosition& across,
                const SpanPosition& up, HeightSample& sample) noexcept {
    const Eigen::Matrix4d controls = cellControls(grid, up.first, across.first);
    std::array<Double4, 4> rows{};
    for (int i = 0; i < 4; ++i) {
        rows[static_cast<std::size_t>(i)] =
            Double4{controls(i, 0), controls(i, 1), controls(i, 2), controls(i, 3)};
    }
    sample = sampled(rows, across.t, up.t);
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

Vector2 nearestMeasured(const BSplineSurface& surface, const Vector2& position) {
    if (surface.isMeasured(position.x(), position.y())) {
        return position;
    }
    const BSplineSurface::Grid& grid = surface.grid();
    Vector2 nearest = position;
    double distance = std::numeric_limits<double>::max();
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const Vector2 center((column + 0.5) * grid.pitchX, (row + 0.5) * grid.pitchY);
            const double here = (center - position).squaredNorm();
            if (here < distance && surface.isMeasured(center.x(), center.y())) {
                distance = here;
                nearest = center;
            }
        }
    }
    return nearest;
}

std::optional<Vector3> firstHit(const BSplineSurface& surface, const SurfaceRay& ray,
                                const Vector2& low, const Vector2& high) {
    const Vector3 direction = ray.direction.normalized();
    if (!direction.allFinite() || !ray.origin.allFinite()) {
        return std::nullopt;
    }
    Stretch stretch;
    stretch.clip(ray.origin.x(), direction.x(), low.x(), high.x());
    stretch.clip(ray.origin.y(), direction.y(), low.y(), high.y());
    const double pixel = std::min(surface.grid().pitchX, surface.grid().pitchY);
    const double top = surface.heightScale() + pixel;  // no height is larger in magnitude
    stretch.clip(ray.origin.z(), direction.z(), -top, top);
    if (stretch.empty() || !std::isfinite(stretch.to)) {
        return std::nullopt;
    }
    const auto pointAt = [&](double way) -> Vector3 { return ray.origin + way * direction; };
    const auto above = [&](double way) {
        const Vector3 point = pointAt(way);
        return point.z() - surface.at(point.x(), point.y()).height;
    };
    const auto position = [&](double way) -> Vector3 {
        const Vector3 point = pointAt(way);
        return {point.x(), point.y(), surface.at(point.x(), point.y()).height};
    };
    const double length = stretch.to - stretch.from;
    const double levelLength = direction.head<2>().norm() * length;
    const int steps = static_cast<int>(
        std::clamp(std::ceil(levelLength / (kStep * pixel)), 1.0, double(kMaxSteps)));
    double before = stretch.from;
    if (above(before) < 0.0) {
        return std::nullopt;
    }
    for (int step = 1; step <= steps; ++step) {
        double after = std::lerp(stretch.from, stretch.to, step / double(steps));
        if (above(after) > 0.0) {
            before = after;
            continue;
        }
        for (int i = 0; i < kMaxHalvings && after - before > kTolerance * length; ++i) {
            const double middle = 0.5 * (before + after);
            if (middle <= before || middle >= after) {
                break;
            }
            (above(middle) > 0.0 ? before : after) = middle;
        }
        return position(after);
    }
    return std::nullopt;
}

}  // namespace asperity
