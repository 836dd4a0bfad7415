#include "core/scene/ContactPatch.h"

#include "core/contact/SurfaceDisplacement.h"
#include "core/scene/RadialTable.h"
#include "core/scene/RimRounding.h"

#include <optional>

namespace asperity {

namespace {

double shareOfSample(const Scene& scene) {
    return sampleShare(scene.description.sample.material.elastic, scene.description.tip.elastic);
}

/// The half-space's patch where it is asked for and valid.
std::optional<SurfacePatch> solvedPatch(const Scene& scene, const TipState& state,
                                        DeformationTier tier, const PatchGrid& grid) {
    if (tier != DeformationTier::HalfSpace) {
        return std::nullopt;
    }
    const HalfSpaceAnswer answer = HalfSpaceModel().solve(scene, state);
    return answer.valid() ? std::optional(halfSpacePatch(scene, answer, grid)) : std::nullopt;
}

}  // namespace

TipContact tipContact(const Scene& scene, const TipState& state) {
    const double radius = scene.belief.tipRadius();
    return {.foot = state.foot.point,
            .normal = state.foot.normal,
            .tipCentre = state.tip + Vector3(0.0, 0.0, radius),
            .tipRadius = radius,
            .contactRadius = state.contact.contactRadius,
            .indentation = state.contact.indentation};
}

SurfacePatch contactPatch(const Scene& scene, const TipState& state, DeformationTier tier,
                          const PatchGrid& grid) {
    if (const auto solved = solvedPatch(scene, state, tier, grid)) {
        return *solved;
    }
    return deformedPatch(scene.surface, tipContact(scene, state), grid, tier,
                         [&state, share = shareOfSample(scene),
                          model = contactModelAt(scene, state)](double distance) {
                             return share * surfaceDisplacement(model, state.contact, distance);
                         });
}

SurfacePatch halfSpacePatch(const Scene& scene, const HalfSpaceAnswer& answer,
                            const PatchGrid& grid) {
    const TipContact contact = tipContact(scene, answer.state);
    return deformedPatch(scene.surface, contact, grid,
                         halfSpaceField(contact, answer.field, shareOfSample(scene)));
}

SurfacePatch drawnPatch(const Scene& scene, const TipState& state, DeformationTier tier,
                        const PatchGrid& grid) {
    const double rounding = rimRounding(state.contact, scene.belief.tipRadius());
    if (rounding == 0.0) {
        return contactPatch(scene, state, tier, grid);
    }
    if (const auto solved = solvedPatch(scene, state, tier, grid)) {
        return *solved;
    }
    const double share = shareOfSample(scene);
    const auto exact = [&state, model = contactModelAt(scene, state)](double distance) {
        return surfaceDisplacement(model, state.contact, distance);
    };
    const RadialTable table(
        [&](double distance) { return share * averagedOverRim(exact, distance, rounding); },
        state.contact.contactRadius, 4.0 * grid.halfWidth);
    return deformedPatch(scene.surface, tipContact(scene, state), grid, tier,
                         [&table](double distance) { return table.at(distance); });
}

Vector3 displacedFoot(const Scene& scene, const TipState& state, DeformationTier tier) {
    const double share = sharesDisplacement(tier) ? shareOfSample(scene) : 1.0;
    return state.foot.point - share * state.contact.indentation * state.foot.normal;
}

RadialDisplacement tipDisplacement(const Scene& scene, const TipState& state,
                                   DeformationTier tier) {
    if (!sharesDisplacement(tier)) {
        return [](double) { return 0.0; };
    }
    const double share = 1.0 - shareOfSample(scene);
    return [share, contact = state.contact, model = contactModelAt(scene, state)](double distance) {
        return share * surfaceDisplacement(model, contact, distance);
    };
}

}  // namespace asperity
