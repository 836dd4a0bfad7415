#include "core/surface/closest/ClosestPointTracker.h"

#include "core/Simd.h"
#include "core/surface/closest/ClosestPointList.h"
#include "core/surface/closest/ExhaustiveSearch.h"
#include "core/surface/closest/LocalClosestPoint.h"
#include "core/surface/closest/PartSearch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <new>

namespace asperity {

namespace {

constexpr int kMaxToASide = 15;  // pixels

/// Pixels first..last along one axis.
struct PixelRun {
    int first = 0;
    int last = -1;
};

/// @param position of the query, in pixels from the first pixel's center
PixelRun pixelsAround(double position, double reach, int pixels) {
    const double toASide = std::min(reach, kMaxToASide + 0.0);
    // Far outside the scan no pixel is near; a position too far for an int is one of them.
    const double low = std::max(position - toASide, 0.0);
    const double high = std::min(position + toASide, pixels - 1.0);
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
    float queryX = 0.0F;     ///< of the query [pixel]
    float queryY = 0.0F;     ///< of the query [pixel]
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
        const float awayY = (static_cast<float>(row) - n.queryY) * n.aspect;
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
            const Float8 awayX = kLane + (static_cast<float>(first) - n.queryX);
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

struct ClosestPointTracker::Proofs {
    ProvenBall ball;
    int rest = 0;  ///< queries, the last time that no ball was proven
    int untilNextTry = 0;
};

namespace {

/// Radius of the balls that are tried: smaller ones are left sooner, larger ones leave more cells
/// open [pixel].
constexpr double kBall = 0.2;
/// Queries after which another ball is tried where none was proven. A try costs about as much as it
/// spares each of the queries after it.
constexpr int kMaxRest = 31;

/// Returns whether the scan as a whole leaves no position for a closest point but the one that is
/// known: all of it lies so far below the query that nothing is within reach, or the distance bends
/// up everywhere.
bool isProvenByScan(const BSplineSurface& surface, const Vector3& query, const SearchReach& reach) {
    constexpr double kSurely = 1.0 - 1e-6;
    const BoxBounds scan = surface.bounds().all();
    const double above = query.z() - scan.highest;
    return above > reach.farthest ||
           (above >= 0.0 && scan.concavity * (query.z() - scan.lowest) < kSurely);
}

/// Returns whether a search from `position` would most likely end at one of the closest points.
bool isBesideOneOf(const ClosestPointList& points, const Vector2& position,
                   const BSplineSurface& surface) {
    constexpr double kBeside = 1.0;  // pixel
    const BSplineSurface::Grid& grid = surface.grid();
    return std::ranges::any_of(points.all(), [&](const ClosestPoint& closest) {
        return std::abs(closest.point.x() - position.x()) <= kBeside * grid.pitchX &&
               std::abs(closest.point.y() - position.y()) <= kBeside * grid.pitchY;
    });
}

/// Adds the closest point that the nearest sample leads to.
void addLikelyPoint(const BSplineSurface& surface, const Vector3& query, const SearchReach& reach,
                    ClosestPointList& points) {
    const double limit = reach.limit(points.all().front());
    const auto start = nearestSample(surface, query, limit);
    if (!start || isBesideOneOf(points, *start, surface)) {
        return;
    }
    const ClosestPoint closest = localClosestPoint(surface, query, {start->x(), start->y(), true});
    if (closest.converged && std::abs(closest.distance) <= limit) {
        points.add(closest, sameMinimum(surface));
    }
}

}  // namespace

ClosestPointTracker::ClosestPointTracker() noexcept {
    static_assert(sizeof(Proofs) <= kProofsSize && alignof(Proofs) <= kProofsAlignment);
    new (proofs_.data()) Proofs;
}

ClosestPointTracker::ClosestPointTracker(const ClosestPointTracker& other) noexcept {
    new (proofs_.data()) Proofs(other.proofs());
}

ClosestPointTracker& ClosestPointTracker::operator=(const ClosestPointTracker& other) noexcept {
    proofs() = other.proofs();
    return *this;
}

ClosestPointTracker::~ClosestPointTracker() { std::destroy_at(&proofs()); }

ClosestPointTracker::Proofs& ClosestPointTracker::proofs() noexcept {
    return *std::launder(reinterpret_cast<Proofs*>(proofs_.data()));
}

const ClosestPointTracker::Proofs& ClosestPointTracker::proofs() const noexcept {
    return *std::launder(reinterpret_cast<const Proofs*>(proofs_.data()));
}

SearchProof ClosestPointTracker::completePoints(const BSplineSurface& surface, const Vector3& query,
                                                const SearchReach& reach, SearchEffort effort,
                                                ClosestPointList& points) noexcept {
    if (settles(surface, query, reach, effort, points.all().front())) {
        return SearchProof::Nearest;
    }
    switch (effort) {
    case SearchEffort::Local:
        return SearchProof::NotSought;
    case SearchEffort::Global:
        addLikelyPoint(surface, query, reach, points);
        return SearchProof::Likely;
    case SearchEffort::Certified:
        return provePoints(surface, query, reach, points);
    }
    return SearchProof::NotSought;
}

bool ClosestPointTracker::settles(const BSplineSurface& surface, const Vector3& query,
                                  const SearchReach& reach, SearchEffort effort,
                                  const ClosestPoint& nearest) const noexcept {
    const ProvenBall& ball = proofs().ball;
    const bool byBall = effort == SearchEffort::Certified && ball.open.empty() &&
                        ball.covers(query, reach, nearest);
    return byBall || (nearest.converged && isProvenByScan(surface, query, reach));
}

SearchProof ClosestPointTracker::provePoints(const BSplineSurface& surface, const Vector3& query,
                                             const SearchReach& reach,
                                             ClosestPointList& points) noexcept {
    auto& [ball, rest, untilNextTry] = proofs();
    SearchProof proof = SearchProof::NotSought;
    if (ball.covers(query, reach, points.all().front())) {
        proof = asperity::completePoints(surface, query, reach, ball, points);
    } else if (untilNextTry > 0) {
        --untilNextTry;
        return asperity::completePoints(surface, query, reach, points);
    } else {
        const double radius = kBall * std::min(surface.grid().pitchX, surface.grid().pitchY);
        proof = asperity::completePoints(surface, {query, radius}, reach, points, ball);
    }
    rest = ball.queries.radius > 0.0 ? 0 : std::min(2 * rest + 1, kMaxRest);
    untilNextTry = rest;
    return proof;
}

std::optional<Vector2> nearestSample(const BSplineSurface& surface, const Vector3& query,
                                     double distance) noexcept {
    constexpr double kMaxHeight = 1e15;  // pixels: higher is as high, and its square has room
    const BSplineSurface::Grid& grid = surface.grid();
    const double queryX = query.x() / grid.pitchX - 0.5;
    const double queryY = query.y() / grid.pitchY - 0.5;
    const PixelRun x = pixelsAround(queryX, distance / grid.pitchX, grid.columns);
    const PixelRun y = pixelsAround(queryY, distance / grid.pitchY, grid.rows);
    if (grid.columns < kFloatLanes || x.first > x.last || y.first > y.last) {
        return std::nullopt;
    }
    const double height = (query.z() - grid.datum) / grid.pitchX;
    const Neighborhood near{.controls = grid.controlHeights.data(),
                            .stride = grid.columns + 2,
                            .columns = grid.columns,
                            .x = x,
                            .y = y,
                            .queryX = static_cast<float>(queryX),
                            .queryY = static_cast<float>(queryY),
                            .height =
                                static_cast<float>(std::clamp(height, -kMaxHeight, kMaxHeight)),
                            .aspect = static_cast<float>(grid.pitchY / grid.pitchX),
                            .perHeight = static_cast<float>(1.0 / grid.pitchX)};
    const Sample best = leastPromise(near);
    return Vector2((best.column + 0.5) * grid.pitchX, (best.row + 0.5) * grid.pitchY);
}

}  // namespace asperity
