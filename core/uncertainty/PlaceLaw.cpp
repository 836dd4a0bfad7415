#include "core/uncertainty/PlaceLaw.h"

#include "core/contact/EffectiveRadius.h"
#include "core/scene/Scene.h"
#include "core/surface/Curvature.h"

#include <algorithm>

namespace asperity {

namespace {

/// A surface lies inside the scan of it as a parallel surface does: its radii of curvature are less
/// by that of the tip.
double withoutTip(double curvature, double tip) noexcept {
    constexpr double kLeast = 0.1;  // what a scan shows sharper than its own tip is noise
    return curvature / std::max(1.0 - (tip * curvature), kLeast);
}

}  // namespace

PlaceLaw::PlaceLaw(const Scene& scene, const TipState& state, double force)
    : scene_(scene), state_(state), force_(force) {
    if (!scene.shape) {
        relief_ =
            asperity::reliefOf(scene.surface.at(state.closest.point.x(), state.closest.point.y()));
    }
}

Relief PlaceLaw::reliefOf(const PlaceNumbers& numbers) const noexcept {
    const double slope = numbers.heightScale / numbers.lateralScale;
    Relief scale;
    scale << slope, slope, Eigen::Vector3d::Constant(slope / numbers.lateralScale);
    return relief_.cwiseProduct(scale) + numbers.relief;
}

double PlaceLaw::radiusOf(const PlaceNumbers& numbers) const noexcept {
    const ProbeSystem& system = scene_.belief;
    const double tip = system.tipRadius() * numbers.tipRadius;
    if (!system.curvature || isSphere(system.contact.law())) {
        return tip;
    }
    const PrincipalCurvatures bend =
        scene_.shape ? state_.closest.curvatures : principalCurvatures(sampleOf(reliefOf(numbers)));
    return effectiveRadius(tip, withoutTip(bend.largest, numbers.imagingTip),
                           withoutTip(bend.smallest, numbers.imagingTip))
        .radius;
}

double PlaceLaw::complianceOf(const PlaceNumbers& numbers) const noexcept {
    Vector3 normal = scene_.shape ? state_.closest.normal : sampleOf(reliefOf(numbers)).normal();
    const Vector3 first = normal.cross(Vector3::UnitX()).normalized();
    normal = (normal + (numbers.turn.x() * first) + (numbers.turn.y() * first.cross(normal)))
                 .normalized();
    return normal.dot(scene_.belief.cantilever.compliance() * normal) / numbers.stiffness;
}

Landmarks PlaceLaw::at(const PlaceNumbers& numbers) const {
    const double radius = state_.effectiveRadius * radiusOf(numbers) / radiusOf({});
    const ContactPair pair = scene_.belief.pairAt(state_.closest.point, radius);
    return landmarksOf(withNumbers(scene_.description, scene_.belief.contact, pair, numbers),
                       complianceOf(numbers), force_ * numbers.force);
}

}  // namespace asperity
