#include "core/deformation/HalfSpaceProblem.h"

#include "core/contact/displacement/SurfaceDisplacement.h"
#include "core/contact/laws/SplitLaw.h"
#include "core/scene/Scene.h"
#include "core/surface/TangentFrame.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kNoTip = 1e-3;  // gap beyond a sphere's equator [m]: no surface reaches so far

/// The cohesive zone of a law; none where the law has none.
struct Cohesion {
    double stress = 0.0;  ///< [Pa]
    double range = 0.0;   ///< [m]
};

Cohesion cohesionOf(const ContactModel& model) {
    const double stress = model.cohesiveStress();
    return stress > 0.0 ? Cohesion{stress, model.cohesiveRange()} : Cohesion{};
}

}  // namespace

HalfSpaceContact halfSpaceContact(const Scene& scene, const TipState& state,
                                  const HalfSpacePatch& patch) {
    const ContactModel model = contactModelAt(scene, state);
    const Cohesion cohesion = cohesionOf(model);
    const double radius = scene.belief.tipRadius();
    HalfSpaceContact contact{
        .samples = patch.samples,
        .pitch = patch.pitch(),
        .gap = heightsOver(scene.surface, tangentFrame(state.closest.point, state.closest.normal),
                           patch.samples, patch.pitch()),
        .approach = contactProfile(model, state.contact).indentation,
        .reducedModulus = model.pair().reducedModulus,
        .cohesiveStress = cohesion.stress,
        .cohesiveRange = cohesion.range,
        .tipRadius = std::min(radius, model.pair().tipRadius)};
    const RoundTip tip = scene.description.tip.shape();
    auto height = contact.gap.begin();
    patch.forEachDistance([&](double distance) {
        const double above = distance < tip.reach() ? tip.height(distance) : kNoTip;
        *height = std::min(above - *height, kNoTip);
        ++height;
    });
    return contact;
}

SurfaceTraction closedFormTraction(const Scene& scene, const TipState& state,
                                   const HalfSpacePatch& patch) {
    const ContactModel model = contactModelAt(scene, state);
    const CohesiveContact profile = contactProfile(model, state.contact);
    const double stress = cohesionOf(model).stress;
    SurfaceTraction traction;
    patch.forEachDistance([&](double distance) {
        const bool touches = distance < profile.contactRadius;
        const double pressure = touches ? contactPressure(profile, distance) : 0.0;
        traction.contact.push_back(touches ? std::max(0.0, pressure + stress) : 0.0);
        traction.cohesion.push_back(stress > 0.0 && distance < profile.cohesiveRadius ? 1.0 : 0.0);
    });
    return traction;
}

double forceBeyondZone(const Scene& scene, const TipState& state) {
    const ContactModel model = contactModelAt(scene, state);
    const AdhesionSplit* shares = model.split();
    const double tail = shares != nullptr ? shares->tailForce : 0.0;
    return tail - scene.description.meniscus.pull(model.pair().tipRadius);
}

}  // namespace asperity
