#include "core/scene/ContactPatch.h"

#include "core/contact/SurfaceDisplacement.h"
#include "core/scene/RadialTable.h"
#include "core/scene/RimRounding.h"

namespace asperity {

namespace {

double shareOfSample(const Scene& scene) {
    return sampleShare(scene.description.sample.material.elastic, scene.description.tip.elastic);
}

SurfacePatch patchOf(const Scene& scene, const TipState& state, DeformationTier tier,
                     const PatchGrid& grid, const RadialDisplacement& displacement) {
    const double radius = scene.belief.tipRadius();
    const TipContact contact{.foot = state.foot.point,
                             .normal = state.foot.normal,
                             .tipCentre = state.tip + Vector3(0.0, 0.0, radius),
                             .tipRadius = radius,
                             .contactRadius = state.contact.contactRadius,
                             .indentation = state.contact.indentation};
    return deformedPatch(scene.surface, contact, grid, tier, displacement);
}

}  // namespace

SurfacePatch contactPatch(const Scene& scene, const TipState& state, DeformationTier tier,
                          const PatchGrid& grid) {
    return patchOf(scene, state, tier, grid,
                   [&state, share = shareOfSample(scene),
                    model = contactModelAt(scene, state)](double distance) {
                       return share * surfaceDisplacement(model, state.contact, distance);
                   });
}

SurfacePatch drawnPatch(const Scene& scene, const TipState& state, DeformationTier tier,
                        const PatchGrid& grid) {
    const double rounding = rimRounding(state.contact, scene.belief.tipRadius());
    if (rounding == 0.0) {
        return contactPatch(scene, state, tier, grid);
    }
    const double share = shareOfSample(scene);
    const auto exact = [&state, model = contactModelAt(scene, state)](double distance) {
        return surfaceDisplacement(model, state.contact, distance);
    };
    const RadialTable table(
        [&](double distance) { return share * averagedOverRim(exact, distance, rounding); },
        state.contact.contactRadius, 4.0 * grid.halfWidth);
    return patchOf(scene, state, tier, grid,
                   [&table](double distance) { return table.at(distance); });
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
