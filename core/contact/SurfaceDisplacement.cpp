#include "core/contact/SurfaceDisplacement.h"

#include "core/contact/EllipticIntegrals.h"

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

double attractionLift(const SplitLaw& law, double separation, double radius) noexcept {
    const double width = std::sqrt(2.0 * law.tail().attraction().radius() * separation);
    return law.tail().lift(separation) * attractionLiftShape(radius / width);
}

}  // namespace

double surfaceDisplacement(const ContactModel& model, const ContactState& state,
                           double radius) noexcept {
    const auto& law = model.adhesion();
    const bool untouched = state.branch == ContactBranch::Far && !(state.force < 0.0);
    if (!state.solved || untouched) {
        return 0.0;
    }
    CohesiveContact contact{.tipRadius = model.pair().tipRadius,
                            .reducedModulus = model.pair().reducedModulus,
                            .cohesiveStress = law ? law->split().cohesiveStress : 0.0,
                            .indentation = state.indentation,
                            .contactRadius = state.contactRadius,
                            .cohesiveRadius = state.cohesiveRadius};
    if (!law) {
        return surfaceDisplacement(contact, radius);
    }
    if (state.branch == ContactBranch::Far) {
        const double separation = law->tail().attraction().separationAt(state.force);
        return -attractionLift(*law, separation, radius);
    }
    const AdhesionSplit& split = law->split();
    contact.indentation += split.tailLift;
    const double outside = std::max(0.0, radius - state.contactRadius);
    const double lift =
        split.tailSnaps ? 0.0 : attractionLift(*law, split.jointSeparation, outside);
    return surfaceDisplacement(contact, radius) - lift;
}

}  // namespace asperity
