#include "core/uncertainty/PlaceLaw.h"

#include "core/contact/EffectiveRadius.h"
#include "core/contact/laws/LawChoice.h"
#include "core/surface/Curvature.h"

namespace asperity {

PlaceLaw::PlaceLaw(const Scene& scene, const TipState& state, double force)
    : scene_(scene), state_(state), force_(force) {
    if (!scene.shape) {
        relief_ =
            asperity::reliefOf(scene.surface.at(state.closest.point.x(), state.closest.point.y()));
    }
}

bool PlaceLaw::hasCohesiveRange() const noexcept {
    const LawTraits& law = traitsOf(scene_.belief.contact.law());
    return law.attraction == Attraction::Zone && !law.tail;
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
    return effectiveRadius(tip, bend.largest, bend.smallest).radius;
}

double PlaceLaw::complianceOf(const PlaceNumbers& numbers) const noexcept {
    Vector3 normal = scene_.shape ? state_.closest.normal : sampleOf(reliefOf(numbers)).normal();
    const Vector3 first = normal.cross(Vector3::UnitX()).normalized();
    normal = (normal + (numbers.turn.x() * first) + (numbers.turn.y() * first.cross(normal)))
                 .normalized();
    return normal.dot(scene_.belief.cantilever.compliance() * normal) / numbers.stiffness;
}

ContactModel PlaceLaw::modelOf(const PlaceNumbers& numbers) const {
    const ContactModel& believed = scene_.belief.contact;
    if (!numbers.cohesiveRange) {
        return believed;
    }
    ContactOptions options = contactOptions(scene_.description, scene_.description.sample.material);
    options.cohesiveStress /= *numbers.cohesiveRange;
    options.solver = SolverSetting::Exact;
    return ContactModel(believed.law(), believed.pair(), options);
}

Landmarks PlaceLaw::at(const PlaceNumbers& numbers) const {
    const double radius = state_.effectiveRadius * radiusOf(numbers) / radiusOf({});
    ContactPair pair = scene_.belief.pairAt(state_.closest.point, radius);
    const Elastic& tip = scene_.description.tip.elastic;
    const Elastic& sample = scene_.description.sample.material.elastic;
    Elastic moved = sample;
    moved.youngsModulus *= numbers.modulus;
    pair.reducedModulus *= reducedModulus(moved, tip) / reducedModulus(sample, tip);
    pair.workOfAdhesion *= numbers.workOfAdhesion;
    return landmarksOf(modelOf(numbers).withPair(pair), complianceOf(numbers),
                       force_ * numbers.force);
}

}  // namespace asperity
