#include "core/scene/ContactPatch.h"

#include "core/contact/SurfaceDisplacement.h"

namespace asperity {

namespace {

double shareOfSample(const Scene& scene) {
    return sampleShare(scene.description.sample.material.elastic, scene.description.tip.elastic);
}

}  // namespace

ContactModel contactModelAt(const Scene& scene, const TipState& state) {
    const double radius = state.effectiveRadius;
    return radius > 0.0 ? scene.belief.contact.withTipRadius(radius) : scene.belief.contact;
}

SurfacePatch contactPatch(const Scene& scene, const TipState& state, DeformationTier tier,
                          const PatchGrid& grid) {
    const double radius = scene.belief.tipRadius();
    const TipContact contact{.foot = state.foot.point,
                             .normal = state.foot.normal,
                             .tipCentre = state.tip + Vector3(0.0, 0.0, radius),
                             .tipRadius = radius,
                             .contactRadius = state.contact.contactRadius,
                             .indentation = state.contact.indentation};
    const double share = shareOfSample(scene);
    const auto displacement = [&, model = contactModelAt(scene, state)](double distance) {
        return share * surfaceDisplacement(model, state.contact, distance);
    };
    return deformedPatch(scene.surface, contact, grid, tier, displacement);
}

Vector3 displacedFoot(const Scene& scene, const TipState& state, DeformationTier tier) {
    const double share = tier == DeformationTier::ClosedForm ? shareOfSample(scene) : 1.0;
    return state.foot.point - share * state.contact.indentation * state.foot.normal;
}

RadialDisplacement tipDisplacement(const Scene& scene, const TipState& state,
                                   DeformationTier tier) {
    if (tier != DeformationTier::ClosedForm) {
        return [](double) { return 0.0; };
    }
    const double share = 1.0 - shareOfSample(scene);
    return [share, contact = state.contact, model = contactModelAt(scene, state)](double distance) {
        return share * surfaceDisplacement(model, contact, distance);
    };
}

}  // namespace asperity
