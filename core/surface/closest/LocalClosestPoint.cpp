#include "core/surface/closest/LocalClosestPoint.h"

#include "core/Simd.h"
#include "core/surface/SplineSampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

/// Beyond this a square would overflow; no instrument reaches as far. [m]
constexpr double kMaxDistance = 1e100;
/// A search that ended properly is preferred to one as near that did not. [relative]
constexpr double kAsNear = 1e-12;
/// A Hessian this near to singular is left to the careful search. [relative]
constexpr double kNearlySingular = 1e-6;

/// The answer to a query that is no point: a surface point, and the word that it means nothing.
ClosestPoint meaninglessPoint(const BSplineSurface& surface) {
    const Vector2 middle(0.5 * surface.sizeX(), 0.5 * surface.sizeY());
    const HeightSample sample = surface.at(middle.x(), middle.y());
    ClosestPoint closest;
    closest.point = Vector3(middle.x(), middle.y(), sample.height);
    closest.normal = sample.normal();
    closest.insideScan = false;
    closest.proof = SearchProof::NotConverged;
    return closest;
}

/// The surface beside a sample, to second order.
ASPERITY_INLINE void moveSample(HeightSample& s, const Vector2& step) {
    s.height += (s.dx + 0.5 * (s.dxx * step.x() + s.dxy * step.y())) * step.x() +
                (s.dy + 0.5 * (s.dxy * step.x() + s.dyy * step.y())) * step.y();
    s.dx += s.dxx * step.x() + s.dxy * step.y();
    s.dy += s.dxy * step.x() + s.dyy * step.y();
}

/// Returns whether Newton's method ended at a minimum. The position of `minimum` is the start.
ASPERITY_WITH_AVX2 bool dash(const SplineSampling& surface, const Vector3& query,
                             BoxMinimum& minimum) {
    constexpr int kMaxSteps = 6;
    constexpr double kCloser = 0.25;  // by which each gradient must beat the last, squared
    // After a step this short the surface's second order says as much as another look: the third
    // changes the gradient by less than rounding does. [pixel]
    constexpr double kLastStep = 2e-6;
    const BSplineSurface::Grid& grid = surface.grid;
    const double lastStep = kLastStep * std::min(grid.pitchX, grid.pitchY);
    const double longestStep = std::max(grid.pitchX, grid.pitchY);
    double x = minimum.position.x();
    double y = minimum.position.y();
    double last = std::numeric_limits<double>::max();
    for (minimum.iterations = 1; minimum.iterations <= kMaxSteps; ++minimum.iterations) {
        HeightSample s = sampledAt(surface, x, y);
        const double above = s.height - query.z();
        const double gx = (x - query.x()) + above * s.dx;
        const double gy = (y - query.y()) + above * s.dy;
        const double hxx = 1.0 + s.dx * s.dx + above * s.dxx;
        const double hxy = s.dx * s.dy + above * s.dxy;
        const double hyy = 1.0 + s.dy * s.dy + above * s.dyy;
        const double determinant = hxx * hyy - hxy * hxy;
        if (hxx <= 0.0 || determinant <= kNearlySingular * hxx * hyy) {
            return false;
        }
        const double stepX = (hxy * gy - hyy * gx) / determinant;
        const double stepY = (hxy * gx - hxx * gy) / determinant;
        x += stepX;
        y += stepY;
        const double steepness = gx * gx + gy * gy;
        const double step = most(magnitude(stepX), magnitude(stepY));
        const bool inside =
            x >= 0.0 && x <= grid.columns * grid.pitchX && y >= 0.0 && y <= grid.rows * grid.pitchY;
        if (steepness > kCloser * last || step > longestStep || !inside) {
            return false;
        }
        if (step <= lastStep) {
            moveSample(s, {stepX, stepY});
            minimum.position = Vector2(x, y);
            minimum.model.surface = s;
            minimum.converged = true;
            return true;
        }
        last = steepness;
    }
    return false;
}

/// One search: keeps the closest point of all starts tried so far.
class LocalSearch {
public:
    LocalSearch(const BSplineSurface& surface, const Vector3& query)
        : objective_(surface, query)
        , newton_(objective_, scanBox(surface),
                  0.25 * std::min(surface.grid().pitchX, surface.grid().pitchY)) {}

    /// Returns whether the closest point so far is a minimum.
    bool tryFrom(const Vector2& start) {
        const BoxMinimum found = newton_.minimize(start);
        iterations_ += found.iterations;
        const double allowance = found.converged ? kAsNear : 0.0;
        if (!tried_ || found.model.value <= best_.model.value * (1.0 + allowance)) {
            best_ = found;
        }
        tried_ = true;
        return best_.converged;
    }

    void tryAround(const Vector2& center, const Vector2& reach) {
        for (int i = -1; i <= 1; ++i) {
            for (int j = -1; j <= 1; ++j) {
                const bool isCenter = i == 0 && j == 0;
                if (!isCenter && tryFrom(center + Vector2(i * reach.x(), j * reach.y()))) {
                    return;
                }
            }
        }
    }

    [[nodiscard]] const BoxMinimum& best() const { return best_; }
    [[nodiscard]] int iterations() const { return iterations_; }

private:
    HalfSquaredDistance objective_;
    BoxNewton<HalfSquaredDistance> newton_;
    BoxMinimum best_;
    int iterations_ = 0;
    bool tried_ = false;
};

}  // namespace

LocalModel HalfSquaredDistance::operator()(const Vector2& position) const noexcept {
    LocalModel model;
    const HeightSample s = surface_.at(position.x(), position.y());
    const Vector3 r(position.x() - query_.x(), position.y() - query_.y(), s.height - query_.z());
    model.surface = s;
    model.value = 0.5 * r.squaredNorm();
    model.gradient = Vector2(r.x() + r.z() * s.dx, r.y() + r.z() * s.dy);
    model.convex << 1.0 + s.dx * s.dx, s.dx * s.dy, s.dx * s.dy, 1.0 + s.dy * s.dy;
    model.hessian << model.convex(0, 0) + r.z() * s.dxx, model.convex(0, 1) + r.z() * s.dxy,
        model.convex(0, 1) + r.z() * s.dxy, model.convex(1, 1) + r.z() * s.dyy;
    // Rounding of the position, of the height and of the slopes, as they enter value and gradient.
    const double steepness = model.convex(0, 0) + model.convex(1, 1);
    const double bend = std::abs(s.dxx) + std::abs(s.dxy) + std::abs(s.dyy);
    const double common = rounding_.position * steepness +
                          std::abs(r.z()) * (rounding_.slope + bend * rounding_.position);
    model.gradientNoise = Vector2(common + rounding_.height * std::abs(s.dx),
                                  common + rounding_.height * std::abs(s.dy));
    model.valueNoise = r.lpNorm<1>() * (rounding_.position * steepness + rounding_.height);
    return model;
}

bool isUsableQuery(const Vector3& query) noexcept {
    return std::isless(std::abs(query.x()), kMaxDistance) &&
           std::isless(std::abs(query.y()), kMaxDistance) &&
           std::isless(std::abs(query.z()), kMaxDistance);
}

ClosestPoint closestPointOf(const BoxMinimum& minimum, const Vector3& query) noexcept {
    ClosestPoint closest;
    closest.point =
        Vector3(minimum.position.x(), minimum.position.y(), minimum.model.surface.height);
    closest.normal = minimum.model.surface.normal();
    const Vector3 towardsQuery = query - closest.point;
    closest.distance = std::copysign(towardsQuery.norm(), towardsQuery.dot(closest.normal));
    closest.curvatures = principalCurvatures(minimum.model.surface);
    closest.iterations = minimum.iterations;
    closest.converged = minimum.converged;
    closest.proof = closest.converged ? SearchProof::NotSought : SearchProof::NotConverged;
    closest.insideScan = !minimum.pushedOut;
    return closest;
}

bool findMinimumBeside(const BSplineSurface& surface, const Vector3& query,
                       BoxMinimum& minimum) noexcept {
    return dash(surface.sampling(), query, minimum);
}

ClosestPoint localClosestPoint(const BSplineSurface& surface, const Vector3& query,
                               const SearchGuess& guess) noexcept {
    if (!isUsableQuery(query)) {
        return meaninglessPoint(surface);
    }
    const bool isGuided = guess.valid && surface.contains(guess.x, guess.y);
    if (isGuided) {
        BoxMinimum minimum;
        minimum.position = Vector2(guess.x, guess.y);
        if (findMinimumBeside(surface, query, minimum)) {
            return closestPointOf(minimum, query);
        }
    }
    LocalSearch search(surface, query);
    const bool warm = isGuided && search.tryFrom(Vector2(guess.x, guess.y));
    if (!warm && !search.tryFrom(query.head<2>())) {
        // Two pixels away the spline is another polynomial.
        search.tryAround(search.best().position,
                         Vector2(2.0 * surface.grid().pitchX, 2.0 * surface.grid().pitchY));
    }
    ClosestPoint closest = closestPointOf(search.best(), query);
    closest.iterations = search.iterations();
    return closest;
}

}  // namespace asperity
