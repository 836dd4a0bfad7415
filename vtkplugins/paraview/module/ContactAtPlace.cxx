#include "vtkplugins/paraview/module/ContactAtPlace.h"

#include "core/Error.h"
#include "core/SiFormat.h"
#include "core/deformation/ContactPatch.h"
#include "core/map/Engagement.h"
#include "core/map/MapPlan.h"
#include "core/scene/Scene.h"

#include <algorithm>

namespace asperity {

namespace {

Vector2 placeOf(const Scene& scene, const ContactRequest& request) {
    const BSplineSurface& surface = scene.surface;
    const Vector2 place =
        request.place.value_or(Vector2(0.5 * surface.sizeX(), 0.5 * surface.sizeY()));
    if (!surface.contains(place.x(), place.y())) {
        throw Error("the place lies outside the scan, which is " + formatSi(surface.sizeX(), "m") +
                    " wide and " + formatSi(surface.sizeY(), "m") + " high");
    }
    return place;
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

ContactAtPlace contactAt(const Scene& scene, const ContactRequest& request) {
    const double setpoint = setpointOn(scene, request.setpoint);
    const MapInstrument instrument(scene, false);
    VerticalPath path(instrument, placeOf(scene, request));
    const std::optional<Engagement> engagement = engage(path, setpoint);
    if (!engagement) {
        throw Error("the tip does not come to " + formatSi(setpoint, "N") + " at this place");
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
