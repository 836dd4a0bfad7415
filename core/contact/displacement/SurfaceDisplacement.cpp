#include "core/contact/displacement/SurfaceDisplacement.h"

#include "core/contact/Within.h"
#include "core/contact/laws/AttractiveTail.h"
#include "core/contact/laws/SplitLaw.h"
#include "core/contact/numerics/EllipticIntegrals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

using std::numbers::pi;

/// Lift of the surface by van der Waals attraction at separation D over that on the axis, at
/// `ratio` = r / sqrt(2 R D): the pressure H / (6 pi (D + r^2/2R)^3) in Abel's representation.
double attractionLiftShape(double ratio) noexcept {
    const double complement = 1.0 / (1.0 + (ratio * ratio));  // 1 - m
    const double m = 1.0 - complement;
    const double first = carlsonRf(0.0, complement, 1.0);
    const double second = first - (m / 3.0 * carlsonRd(0.0, complement, 1.0));
    return 2.0 / (3.0 * pi) * std::sqrt(complement) *
           ((2.0 * (1.0 + complement) * second) - (complement * first));
}

double attractionLift(const AttractiveTail& tail, double separation, double radius) noexcept {
    const double width = std::sqrt(2.0 * tail.attraction().radius() * separation);
    return tail.lift(separation) * attractionLiftShape(radius / width);
}

}  // namespace

CohesiveContact contactProfile(const ContactModel& model, const ContactState& state) noexcept {
    CohesiveContact contact{.tipRadius = model.pair().tipRadius,
                            .reducedModulus = model.pair().reducedModulus,
                            .cohesiveStress = model.cohesiveStress(),
                            .indentation = state.indentation,
                            .contactRadius = state.contactRadius,
                            .cohesiveRadius = state.cohesiveRadius,
                            .edgeWork = isJkr(model.law()) ? model.pair().workOfAdhesion : 0.0,
                            .shape =
                                isSphere(model.law()) ? TipShape::Sphere : TipShape::Paraboloid,
                            .coneHalfAngle = model.coneHalfAngle()};
    if (isFilm(model.law())) {
        contact.film = model.film();
        contact.filmThickness = model.filmThickness();
    }
    if (const AdhesionSplit* shares = model.split()) {
        contact.indentation += shares->tailLift;
    }
    return contact;
}

double tailLift(const ContactModel& model, const ContactState& state, double radius) noexcept {
    const AdhesionSplit* shares = model.split();
    if (shares == nullptr || shares->tailSnaps || state.branch == ContactBranch::Far) {
        return 0.0;
    }
    const double outside = std::max(0.0, radius - state.contactRadius);
    return attractionLift(*model.tail(), shares->jointSeparation, outside);
}

double surfaceDisplacement(const ContactModel& model, const ContactState& state,
                           double radius) noexcept {
    const bool untouched = state.branch == ContactBranch::Far && !(state.force < 0.0);
    if (!state.solved() || untouched || !isWithin(radius, 0.0, kFarAway)) {
        return 0.0;
    }
    const AttractiveTail* tail = model.tail();
    if (tail != nullptr && state.branch == ContactBranch::Far) {
        return -attractionLift(*tail, tail->attraction().separationAt(state.force), radius);
    }
    return surfaceDisplacement(contactProfile(model, state), radius) -
           tailLift(model, state, radius);
}

}  // namespace asperity
