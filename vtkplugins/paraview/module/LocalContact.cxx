#include "vtkplugins/paraview/module/LocalContact.h"

#include "core/Error.h"
#include "core/SiFormat.h"
#include "core/deformation/ContactDeformation.h"
#include "core/map/JumpSearch.h"
#include "core/map/MapPlan.h"
#include "core/scene/Scene.h"

#include <algorithm>

namespace asperity {

namespace {

Vector2 positionOf(const Scene& scene, const ContactRequest& request) {
    const BSplineSurface& surface = scene.surface;
    const Vector2 position =
        request.position.value_or(Vector2(0.5 * surface.sizeX(), 0.5 * surface.sizeY()));
    if (!surface.contains(position.x(), position.y())) {
        throw Error("the point lies outside the scan, which is " + formatSi(surface.sizeX(), "m") +
                    " wide and " + formatSi(surface.sizeY(), "m") + " high");
    }
    return position;
}

double halfWidthOf(const ContactRequest& request, const TipState& state, double tipRadius) {
    return request.halfWidth > 0.0 ? request.halfWidth
                                   : std::max(2.0 * tipRadius, 2.5 * state.contact.contactRadius);
}

ContactDeformation deformationAt(const Scene& scene, const TipState& state) {
    const DeformationModel model = scene.model.deformation;
    if (model != DeformationModel::HalfSpace) {
        return {scene, state, model};
    }
    const HalfSpaceAnswer answer = HalfSpaceModel().solve(scene, state);
    return {scene, state, model, &answer};
}

}  // namespace

LocalContact contactAt(const Scene& scene, const ContactRequest& request) {
    const double setpoint = setpointOn(scene, request.setpoint);
    const MapInstrument instrument(scene, false);
    VerticalPath path(instrument, positionOf(scene, request));
    const std::optional<Engagement> engagement = engage(path, setpoint);
    if (!engagement) {
        throw Error("the tip does not come to " + formatSi(setpoint, "N") + " at this point");
    }
    const TipState& state = engagement->atSetpoint.state;
    const ContactDeformation deformation = deformationAt(scene, state);
    const double tipRadius = scene.belief.tipRadius();
    const double halfWidth = halfWidthOf(request, state, tipRadius);
    return {.state = state,
            .patch = drawnPatch(scene, deformation,
                                {.halfWidth = halfWidth, .samples = request.samples}),
            .halfWidth = halfWidth,
            .tip = deformation.contact().tip(),
            .tipDisplacement =
                [deformation](double distance) { return deformation.tipDisplacement(distance); },
            .contactPoint = displacedPoint(scene, state, scene.model.deformation)};
}

}  // namespace asperity
