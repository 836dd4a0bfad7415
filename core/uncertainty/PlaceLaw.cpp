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

/// The recorded relief under other calibrations and moves.
Relief movedBy(const PlaceNumbers& numbers, const Relief& relief) noexcept {
    const double slope = numbers.heightScale / numbers.lateralScale;
    Relief scale;
    scale << slope, slope, Eigen::Vector3d::Constant(slope / numbers.lateralScale);
    return relief.cwiseProduct(scale) + numbers.relief;
}

/// Those with which the law is that of the surface that a scene shows.
PlaceNumbers shownNumbers(const Scene& scene) noexcept {
    return {.imagingTip = scene.description.sample.erode ? 1.0 : 0.0};
}

}  // namespace

PlaceLaw::PlaceLaw(const Scene& scene, const TipState& state, const RecordedScan& scan,
                   const RecordedPlaces& places, double force)
    : scene_(scene)
    , state_(state)
    , shown_(scan.reliefAt(places.shown.x(), places.shown.y()))
    , touched_(scan.reliefAt(places.touched.x(), places.touched.y()))
    , force_(force) {}

double PlaceLaw::radiusOf(const Relief& relief, const PlaceNumbers& numbers) const noexcept {
    const ProbeSystem& system = scene_.belief;
    const double tip = system.tipRadius() * numbers.tipRadius;
    if (!system.curvature || isSphere(system.contact.law())) {
        return tip;
    }
    if (scene_.shape) {
        const PrincipalCurvatures& bend = state_.closest.curvatures;
        return effectiveRadius(tip, bend.largest, bend.smallest).radius;
    }
    const PrincipalCurvatures bend = principalCurvatures(sampleOf(relief));
    const double imagingTip = scene_.description.sample.imagingTipRadius * numbers.imagingTip;
    return effectiveRadius(tip, withoutTip(bend.largest, imagingTip),
                           withoutTip(bend.smallest, imagingTip))
        .radius;
}

double PlaceLaw::complianceOf(const Relief& relief, const PlaceNumbers& numbers) const noexcept {
    Vector3 normal = scene_.shape ? state_.closest.normal : sampleOf(relief).normal();
    const Vector3 first = normal.cross(Vector3::UnitX()).normalized();
    normal = (normal + (numbers.turn.x() * first) + (numbers.turn.y() * first.cross(normal)))
                 .normalized();
    return normal.dot(scene_.belief.cantilever.compliance() * normal) / numbers.stiffness;
}

BodyPull PlaceLaw::bodyWith(const PlaceNumbers& numbers) const noexcept {
    const double factor = numbers.workOfAdhesion * numbers.tipRadius;
    return {.force = factor * state_.body.force, .slope = factor * state_.body.slope};
}

Landmarks PlaceLaw::at(const Relief& relief, const PlaceNumbers& numbers) const {
    const Relief moved = movedBy(numbers, relief);
    const double radius =
        state_.effectiveRadius * radiusOf(moved, numbers) / radiusOf(shown_, shownNumbers(scene_));
    const ContactPair pair = scene_.belief.pairAt(state_.closest.point, radius);
    ContactModel law = withNumbers(scene_.description, scene_.belief.contact, pair, numbers);
    law.setBodyPull(bodyWith(numbers));
    return landmarksOf(law, complianceOf(moved, numbers), force_ * numbers.force);
}

Landmarks PlaceLaw::at(const PlaceNumbers& numbers) const { return at(touched_, numbers); }

Landmarks PlaceLaw::shown() const { return at(shown_, shownNumbers(scene_)); }

}  // namespace asperity
