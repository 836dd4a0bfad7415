#include "core/scene/ContactPatch.h"

#include "core/contact/SurfaceDisplacement.h"

namespace asperity {

SurfacePatch contactPatch(const Scene& scene, const TipState& state, DeformationTier tier,
                          const PatchGrid& grid) {
    const double radius = scene.belief.tipRadius();
    const TipContact contact{.foot = state.foot.point,
                             .normal = state.foot.normal,
                             .tipCentre = state.tip + Vector3(0.0, 0.0, radius),
                             .tipRadius = radius,
                             .contactRadius = state.contact.contactRadius,
                             .indentation = state.contact.indentation};
    const SceneDescription& description = scene.description;
    const double share = sampleShare(description.sample.material.elastic, description.tip.elastic);
    const auto displacement = [&](double distance) {
        return share * surfaceDisplacement(scene.belief.contact, state.contact, distance);
    };
    return deformedPatch(scene.surface, contact, grid, tier, displacement);
}

}  // namespace asperity
