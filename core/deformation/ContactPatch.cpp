#include "core/deformation/ContactPatch.h"

#include "core/contact/displacement/SurfaceDisplacement.h"
#include "core/deformation/HalfSpaceField.h"
#include "core/deformation/HalfSpaceModel.h"
#include "core/scene/Scene.h"

namespace asperity {

SurfacePatch drawnPatch(const Scene& scene, const ContactDeformation& deformation,
                        const PatchGrid& grid) {
    return deformedPatch(scene.surface, deformation.contact(), grid, deformation.field());
}

SurfacePatch exactPatch(const Scene& scene, const TipState& state, DeformationModel model,
                        const PatchGrid& grid) {
    if (model == DeformationModel::HalfSpace) {
        const HalfSpaceAnswer answer = HalfSpaceModel().solve(scene, state);
        if (answer.valid()) {
            return halfSpacePatch(scene, answer, grid);
        }
    }
    return deformedPatch(scene.surface, tipContact(scene, state), grid, model,
                         [&state, share = shareOfSample(scene, state, model),
                          model = contactModelAt(scene, state)](double distance) {
                             return share * surfaceDisplacement(model, state.contact, distance);
                         });
}

SurfacePatch halfSpacePatch(const Scene& scene, const HalfSpaceAnswer& answer,
                            const PatchGrid& grid) {
    const TipContact contact = tipContact(scene, answer.state);
    const double share = shareOfSample(scene, answer.state, DeformationModel::HalfSpace);
    return deformedPatch(scene.surface, contact, grid,
                         halfSpaceField(contact, answer.field, share));
}

Vector3 displacedPoint(const Scene& scene, const TipState& state, DeformationModel model) {
    return state.closest.point -
           shareOfSample(scene, state, model) * state.contact.indentation * state.closest.normal;
}

}  // namespace asperity
