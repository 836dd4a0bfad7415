#include "core/surface/closest/NearestSample.h"

#include "core/Simd.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace asperity {

namespace {

constexpr int kMaxToASide = 15;  // pixels

/// Pixels first..last along one axis.
struct PixelRun {
    int first = 0;
    int last = -1;
};

/// @param place of the query, in pixels from the first pixel's center
PixelRun pixelsAround(double place, double reach, int pixels) {
    const double toASide = std::min(reach, kMaxToASide + 0.0);
    // Far outside the scan no pixel is near; a place too far for an int is one of them.
    const double low = std::max(place - toASide, 0.0);
    const double high = std::min(place + toASide, pixels - 1.0);
    return low <= high ? PixelRun{static_cast<int>(std::ceil(low)), static_cast<int>(high)}
                       : PixelRun{};
}

/// The pixels of a query's neighborhood, lengths in pixels along x.
struct Neighborhood {
    const float* controls = nullptr;  ///< of the padded grid, bottom row first [m]
    std::ptrdiff_t stride = 0;
    int columns = 0;
    PixelRun x;
    PixelRun y;
    float placeX = 0.0F;     ///< of the query [pixel]
    float placeY = 0.0F;     ///< of the query [pixel]
    float height = 0.0F;     ///< of the query above the datum [pixel along x]
    float aspect = 1.0F;     ///< pitch along y [pixel along x]
    float perHeight = 0.0F;  ///< [pixel along x / m]
};

struct Sample {
    int row = 0;
    int column = 0;
};

/// By how much a step downhill within the pixel lowers half the squared distance.
ASPERITY_INLINE Float8 gain(Float8 slope, Float8 stiffness, Float8 softness, float halfPixel) {
    const Float8 size = slope < 0.0F ? -slope : slope;
    const Float8 wanted = size * softness;
    const Float8 step = wanted < halfPixel ? wanted : Float8{} + halfPixel;
    return step * (size - 0.5F * stiffness * step);
}

ASPERITY_WITH_AVX2 Sample leastPromise(const Neighborhood& n) {
    constexpr Float8 kLane{0, 1, 2, 3, 4, 5, 6, 7};
    constexpr float kSixth = 1.0F / 6.0F;
    Float8 least = Float8{} + std::numeric_limits<float>::max();
    Int8 rows{};
    Int8 columns{};
    for (int row = n.y.first; row <= n.y.last; ++row) {
        const float* below = n.controls + row * n.stride;
        const float awayY = (static_cast<float>(row) - n.placeY) * n.aspect;
        for (int group = n.x.first; group <= n.x.last; group += kFloatLanes) {
            // A whole group at the scan's right edge looks at some pixels twice.
            const int first = std::min(group, n.columns - kFloatLanes);
            Float8 sum[3];
            Float8 rise[3];
            for (int k = 0; k < 3; ++k) {
                const Float8 low = loaded<Float8>(below + first + k);
                const Float8 middle = loaded<Float8>(below + n.stride + first + k);
                const Float8 high = loaded<Float8>(below + 2 * n.stride + first + k);
                sum[k] = low + 4.0F * middle + high;
                rise[k] = high - low;
            }
            const float scale = n.perHeight * kSixth;
            const Float8 r = (sum[0] + 4.0F * sum[1] + sum[2]) * (scale * kSixth) - n.height;
            const Float8 slopeX = (sum[2] - sum[0]) * (0.5F * scale);
            const Float8 slopeY = (rise[0] + 4.0F * rise[1] + rise[2]) * (0.5F * scale / n.aspect);
            const Float8 awayX = kLane + (static_cast<float>(first) - n.placeX);
            const Float8 stiffness = 1.0F + slopeX * slopeX + slopeY * slopeY;
            const Float8 softness = 1.0F / stiffness;
            const Float8 promise = 0.5F * (awayX * awayX + awayY * awayY + r * r) -
                                   gain(awayX + r * slopeX, stiffness, softness, 0.5F) -
                                   gain(awayY + r * slopeY, stiffness, softness, 0.5F * n.aspect);
            const Int8 better = promise < least;
            least = better ? promise : least;
            rows = better ? Int8{} + row : rows;
            columns = better ? Int8{} + first : columns;
        }
    }
    int best = 0;
    for (int lane = 1; lane < kFloatLanes; ++lane) {
        best = least[lane] < least[best] ? lane : best;
    }
    return {rows[best], columns[best] + best};
}

}  // namespace

std::optional<Vector2> nearestSample(const BSplineSurface& surface, const Vector3& query,
                                     double distance) noexcept {
    constexpr double kMaxHeight = 1e15;  // pixels: higher is as high, and its square has room
    const BSplineSurface::Grid& grid = surface.grid();
    const double placeX = query.x() / grid.pitchX - 0.5;
    const double placeY = query.y() / grid.pitchY - 0.5;
    const PixelRun x = pixelsAround(placeX, distance / grid.pitchX, grid.columns);
    const PixelRun y = pixelsAround(placeY, distance / grid.pitchY, grid.rows);
    if (grid.columns < kFloatLanes || x.first > x.last || y.first > y.last) {
        return std::nullopt;
    }
    const double height = (query.z() - grid.datum) / grid.pitchX;
    const Neighborhood near{.controls = grid.controlHeights.data(),
                            .stride = grid.columns + 2,
                            .columns = grid.columns,
                            .x = x,
                            .y = y,
                            .placeX = static_cast<float>(placeX),
                            .placeY = static_cast<float>(placeY),
                            .height =
                                static_cast<float>(std::clamp(height, -kMaxHeight, kMaxHeight)),
                            .aspect = static_cast<float>(grid.pitchY / grid.pitchX),
                            .perHeight = static_cast<float>(1.0 / grid.pitchX)};
    const Sample best = leastPromise(near);
    return Vector2((best.column + 0.5) * grid.pitchX, (best.row + 0.5) * grid.pitchY);
}

}  // namespace asperity
