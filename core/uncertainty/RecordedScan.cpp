#include "core/uncertainty/RecordedScan.h"

#include <Eigen/LU>

#include <cmath>
#include <optional>

namespace asperity {

namespace {

Vector2 across(const HeightSample& sample) noexcept { return sample.normal().head<2>(); }

/// Derivative of the place over which the point lies that is `length` along the normal.
Eigen::Matrix2d spreadOf(const HeightSample& sample, double length) noexcept {
    const Vector2 slope(sample.dx, sample.dy);
    Eigen::Matrix2d bend;
    bend << sample.dxx, sample.dxy, sample.dxy, sample.dyy;
    const double square = 1.0 + slope.squaredNorm();
    const Eigen::Matrix2d identity = Eigen::Matrix2d::Identity();
    return identity -
           (length / std::sqrt(square)) * (identity - (slope * slope.transpose() / square)) * bend;
}

/// The place whose point that far along the normal lies over a target, by Newton's method from the
/// target on; none: the surface folds on the way.
std::optional<Vector2> placeUnder(const BSplineSurface& surface, const Vector2& target,
                                  double length) noexcept {
    constexpr int kIterations = 30;
    constexpr double kClose = 1e-6;  // of a pixel
    Vector2 place = target;
    for (int i = 0; i < kIterations; ++i) {
        const HeightSample sample = surface.at(place.x(), place.y());
        const Vector2 missing = target - place - (length * across(sample));
        if (missing.norm() < kClose * surface.finestPitch()) {
            return place;
        }
        const Eigen::Matrix2d spread = spreadOf(sample, length);
        if (!(spread.determinant() > 0.0)) {
            return std::nullopt;
        }
        place += spread.inverse() * missing;
    }
    return std::nullopt;
}

}  // namespace

RecordedScan::RecordedScan(const Scene& scene)
    : RecordedScan(scene.surface, scene.description.sample.erode
                                      ? scene.description.sample.imagingTipRadius
                                      : 0.0) {}

Relief RecordedScan::reliefAt(double x, double y) const noexcept {
    const std::optional<Vector2> under = placeUnder(surface_, Vector2(x, y), erodedBy_);
    if (!under) {
        return reliefOf(surface_.at(x, y));
    }
    HeightSample sample = surface_.at(under->x(), under->y());
    Eigen::Matrix2d bend;
    bend << sample.dxx, sample.dxy, sample.dxy, sample.dyy;
    bend *= spreadOf(sample, erodedBy_).inverse();
    return {sample.dx, sample.dy, bend(0, 0), 0.5 * (bend(0, 1) + bend(1, 0)), bend(1, 1)};
}

RecordedPlaces recordedPlaces(const Scene& scene, const TipState& state) noexcept {
    const SampleDescription& sample = scene.description.sample;
    const Vector2 point = state.closest.point.head<2>();
    const Vector2 normal = state.closest.normal.head<2>();
    if (sample.erode) {
        const Vector2 recorded = point + (sample.imagingTipRadius * normal);
        return {recorded, recorded};
    }
    if (sample.imagingTipRadius == 0.0) {
        return {point, point};
    }
    const double tip = scene.belief.tipRadius();
    const std::optional<Vector2> touched =
        placeUnder(scene.surface, point + (tip * normal), tip - sample.imagingTipRadius);
    return {point, touched.value_or(point)};
}

}  // namespace asperity
