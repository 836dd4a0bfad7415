#include "core/scene/ContactValidity.h"

#include "core/contact/displacement/SurfaceDisplacement.h"
#include "core/contact/laws/LawChoice.h"
#include "core/contact/laws/YieldOnset.h"
#include "core/scene/LawRange.h"
#include "core/scene/SampleHardness.h"
#include "core/surface/RoundTip.h"

#include <cmath>

namespace asperity {

namespace {

/// Whether the sample yields somewhere under the contact.
bool yields(const ContactModel& model, const ContactState& state,
            const SampleMaterial& material) noexcept {
    const double hardness = hardnessOf(material).value;
    return hardness > 0.0 && state.contactRadius > 0.0 &&
           contactPressure(contactProfile(model, state), 0.0) >
               yieldPressure(hardness, material.elastic.poissonRatio);
}

}  // namespace

bool isBeyondSphere(const ContactModel& model, const ContactState& state) noexcept {
    return !leavesOutCone(model.law()) && model.coneHalfAngle() == 0.0 &&
           state.contactRadius > model.pair().tipRadius * std::cos(kShankHalfAngle);
}

ValidityFlags contactValidity(const ContactModel& model, const ContactState& state,
                              const SampleMaterial& material) noexcept {
    ValidityFlags flags;
    flags.set(Validity::LargeContact, isLargeContact(state.contactRadius, model.pair().tipRadius));
    flags.set(Validity::ElasticLimit, yields(model, state, material));
    flags.set(Validity::ThinFilm, state.contactRadius > model.widestFilmContact());
    flags.set(Validity::BeyondSphere, isBeyondSphere(model, state));
    flags.set(Validity::LawOutOfRange, leavesLawsRange(model, state));
    return flags;
}

}  // namespace asperity
