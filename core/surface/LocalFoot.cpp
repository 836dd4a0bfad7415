#include "core/surface/LocalFoot.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

/// Beyond this a square would overflow; no instrument reaches as far. [m]
constexpr double kFarthest = 1e100;
/// A search that ended properly is preferred to one as near that did not. [relative]
constexpr double kAsNear = 1e-12;

/// The answer to a query that is no point: a surface point, and the word that it means nothing.
SurfaceFoot meaninglessFoot(const BSplineSurface& surface) {
    const Vector2 middle(0.5 * surface.sizeX(), 0.5 * surface.sizeY());
    const HeightSample sample = surface.at(middle.x(), middle.y());
    SurfaceFoot foot;
    foot.point = Vector3(middle.x(), middle.y(), sample.height);
    foot.normal = sample.normal();
    foot.insideScan = false;
    foot.proof = FootProof::NotConverged;
    return foot;
}

/// One search: keeps the nearest foot of all starts tried so far.
class LocalSearch {
public:
    LocalSearch(const BSplineSurface& surface, const Vector3& query)
        : objective_(surface, query)
        , newton_(objective_, scanBox(surface),
                  0.25 * std::min(surface.grid().pitchX, surface.grid().pitchY)) {}

    /// Whether the nearest foot so far is a minimum.
    bool tryFrom(const Vector2& start) {
        const BoxMinimum found = newton_.minimise(start);
        iterations_ += found.iterations;
        const double allowance = found.converged ? kAsNear : 0.0;
        if (!tried_ || found.model.value <= best_.model.value * (1.0 + allowance)) {
            best_ = found;
        }
        tried_ = true;
        return best_.converged;
    }

    void tryAround(const Vector2& centre, const Vector2& reach) {
        for (int i = -1; i <= 1; ++i) {
            for (int j = -1; j <= 1; ++j) {
                const bool isCentre = i == 0 && j == 0;
                if (!isCentre && tryFrom(centre + Vector2(i * reach.x(), j * reach.y()))) {
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

LocalModel HalfSquaredDistance::operator()(const Vector2& place) const noexcept {
    const HeightSample s = surface_.at(place.x(), place.y());
    const Vector3 r(place.x() - query_.x(), place.y() - query_.y(), s.height - query_.z());
    LocalModel model;
    model.surface = s;
    model.value = 0.5 * r.squaredNorm();
    model.gradient = Vector2(r.x() + r.z() * s.dx, r.y() + r.z() * s.dy);
    model.convex << 1.0 + s.dx * s.dx, s.dx * s.dy, s.dx * s.dy, 1.0 + s.dy * s.dy;
    model.hessian << model.convex(0, 0) + r.z() * s.dxx, model.convex(0, 1) + r.z() * s.dxy,
        model.convex(0, 1) + r.z() * s.dxy, model.convex(1, 1) + r.z() * s.dyy;
    addNoise(r, model);
    return model;
}

/// Rounding of the place, of the height and of the slopes, as they enter value and gradient.
void HalfSquaredDistance::addNoise(const Vector3& r, LocalModel& model) const noexcept {
    const HeightSample& s = model.surface;
    const double steepness = model.convex(0, 0) + model.convex(1, 1);
    const double bend = std::abs(s.dxx) + std::abs(s.dxy) + std::abs(s.dyy);
    const double common =
        rounding_.place * steepness + std::abs(r.z()) * (rounding_.slope + bend * rounding_.place);
    model.gradientNoise = Vector2(common + rounding_.height * std::abs(s.dx),
                                  common + rounding_.height * std::abs(s.dy));
    model.valueNoise = r.lpNorm<1>() * (rounding_.place * steepness + rounding_.height);
}

bool isUsableQuery(const Vector3& query) noexcept {
    return std::isless(std::abs(query.x()), kFarthest) &&
           std::isless(std::abs(query.y()), kFarthest) &&
           std::isless(std::abs(query.z()), kFarthest);
}

SurfaceFoot footOf(const BoxMinimum& minimum, const Vector3& query) noexcept {
    SurfaceFoot foot;
    foot.point = Vector3(minimum.place.x(), minimum.place.y(), minimum.model.surface.height);
    foot.normal = minimum.model.surface.normal();
    const Vector3 towardsQuery = query - foot.point;
    foot.distance = std::copysign(towardsQuery.norm(), towardsQuery.dot(foot.normal));
    foot.curvatures = principalCurvatures(minimum.model.surface);
    foot.iterations = minimum.iterations;
    foot.converged = minimum.converged;
    foot.proof = foot.converged ? FootProof::NotSought : FootProof::NotConverged;
    foot.insideScan = !minimum.pushedOut;
    return foot;
}

SurfaceFoot localFoot(const BSplineSurface& surface, const Vector3& query,
                      const FootGuess& guess) noexcept {
    if (!isUsableQuery(query)) {
        return meaninglessFoot(surface);
    }
    LocalSearch search(surface, query);
    const bool warm = guess.valid && std::isfinite(guess.x) && std::isfinite(guess.y) &&
                      search.tryFrom(Vector2(guess.x, guess.y));
    if (!warm && !search.tryFrom(query.head<2>())) {
        // Two pixels away the spline is another polynomial.
        search.tryAround(search.best().place,
                         Vector2(2.0 * surface.grid().pitchX, 2.0 * surface.grid().pitchY));
    }
    SurfaceFoot foot = footOf(search.best(), query);
    foot.iterations = search.iterations();
    return foot;
}

}  // namespace asperity
