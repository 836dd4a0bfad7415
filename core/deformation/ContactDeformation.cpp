#include "core/deformation/ContactDeformation.h"

#include "core/contact/displacement/SurfaceDisplacement.h"
#include "core/deformation/HalfSpaceField.h"
#include "core/deformation/RimRounding.h"
#include "core/scene/Scene.h"

#include <algorithm>

namespace asperity {

namespace {

/// About where the displacement outside the contact has fallen to half of that at its rim.
double scaleOf(const TipContact& contact) {
    constexpr double kOfTheTip = 0.25;  // where there is no contact yet
    return std::max(contact.contactRadius, kOfTheTip * contact.tipRadius);
}

/// Displacement of sample and tip together by the closed form.
std::shared_ptr<const RadialTable> displacementTable(const Scene& scene, const TipState& state) {
    const double rounding = rimRounding(state.contact, scene.belief.tipRadius());
    const auto exact = [&state, model = contactModelAt(scene, state)](double distance) {
        return surfaceDisplacement(model, state.contact, distance);
    };
    return std::make_shared<RadialTable>(
        [&](double distance) { return averagedOverRim(exact, distance, rounding); },
        state.contact.contactRadius, scaleOf(tipContact(scene, state)));
}

}  // namespace

TipContact tipContact(const Scene& scene, const TipState& state) {
    const double radius = scene.belief.tipRadius();
    return {.closest = state.closest.point,
            .normal = state.closest.normal,
            .tipCenter = state.tip + Vector3(0.0, 0.0, radius),
            .tipRadius = radius,
            .contactRadius = state.contact.contactRadius,
            .indentation = state.contact.indentation,
            .coneHalfAngle = scene.description.tip.coneHalfAngle};
}

double shareOfSample(const Scene& scene, const TipState& state, DeformationModel model) {
    if (!sharesDisplacement(model)) {
        return 1.0;
    }
    const SceneDescription& description = scene.description;
    Elastic sample = description.sample.material.elastic;
    if (const MaterialField* const field = scene.belief.field.get()) {
        const Vector3& place = state.closest.point;
        sample.youngsModulus = field->at(place.x(), place.y()).youngsModulus;
    }
    return sampleShare(sample, description.tip.elastic);
}

ContactDeformation::ContactDeformation(const Scene& scene, const TipState& state,
                                       DeformationModel model, const HalfSpaceAnswer* halfSpace)
    : contact_(tipContact(scene, state))
    , share_(shareOfSample(scene, state, model))
    , closedForm_(sharesDisplacement(model) ? displacementTable(scene, state) : nullptr)
    , field_(
          fieldFor(scene.surface, model,
                   halfSpace != nullptr && stillHolds(*halfSpace, state) ? halfSpace : nullptr)) {}

DisplacementField ContactDeformation::fieldFor(const BSplineSurface& surface,
                                               DeformationModel model,
                                               const HalfSpaceAnswer* halfSpace) const {
    if (model == DeformationModel::HalfSpace && halfSpace != nullptr) {
        return halfSpaceField(contact_, halfSpace->field, share_);
    }
    return displacementField(surface, contact_, model,
                             [share = share_, table = closedForm_](double distance) {
                                 return share * table->at(distance);
                             });
}

}  // namespace asperity
