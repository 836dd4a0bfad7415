#include "core/scene/ContactValidity.h"

#include "core/contact/LawChoice.h"
#include "core/contact/SurfaceDisplacement.h"

namespace asperity {

namespace {

constexpr double kThinFilm = 0.1;  // of the film's thickness up to which it counts as deep

/// Whether the pressure at the middle of the contact is above the hardness.
bool yields(const ContactModel& model, const ContactState& state, double hardness) noexcept {
    return hardness > 0.0 && state.contactRadius > 0.0 &&
           contactPressure(contactProfile(model, state), 0.0) > hardness;
}

}  // namespace

ValidityFlags contactValidity(const ContactModel& model, const ContactState& state,
                              const SampleMaterial& material) noexcept {
    ValidityFlags flags;
    flags.set(Validity::LargeContact, isLargeContact(state.contactRadius, model.pair().tipRadius));
    flags.set(Validity::ElasticLimit, yields(model, state, material.hardness));
    flags.set(Validity::ThinFilm, model.law() != ContactLaw::HertzFilm &&
                                      material.filmThickness > 0.0 &&
                                      state.contactRadius > kThinFilm * material.filmThickness);
    return flags;
}

}  // namespace asperity
