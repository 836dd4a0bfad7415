#include "core/scene/ContactValidity.h"

#include "core/contact/LawChoice.h"
#include "core/contact/SurfaceDisplacement.h"
#include "core/scene/LawRange.h"

namespace asperity {

namespace {

constexpr double kHalfSpaceFilm = 0.035;  // a/t where 1 + 1.133 a/t + 1.283 (a/t)^2 is 1.04
constexpr double kSeriesFilm = 1.0;       // a/t up to which the film law's series is credible

/// Whether the pressure at the middle of the contact is above the hardness.
bool yields(const ContactModel& model, const ContactState& state, double hardness) noexcept {
    return hardness > 0.0 && state.contactRadius > 0.0 &&
           contactPressure(contactProfile(model, state), 0.0) > hardness;
}

/// Whether a film is too thin for the law at a contact of this radius [m].
bool isThin(double thickness, ContactLaw law, double contactRadius) noexcept {
    const double widest = law == ContactLaw::HertzFilm ? kSeriesFilm : kHalfSpaceFilm;
    return thickness > 0.0 && contactRadius > widest * thickness;
}

}  // namespace

ValidityFlags contactValidity(const ContactModel& model, const ContactState& state,
                              const SampleMaterial& material) noexcept {
    ValidityFlags flags;
    flags.set(Validity::LargeContact, isLargeContact(state.contactRadius, model.pair().tipRadius));
    flags.set(Validity::ElasticLimit, yields(model, state, material.hardness));
    flags.set(Validity::ThinFilm, isThin(material.filmThickness, model.law(), state.contactRadius));
    flags.set(Validity::LawOutOfRange, leavesLawsRange(model, state));
    return flags;
}

}  // namespace asperity
