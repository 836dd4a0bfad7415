#pragma once

#include "core/contact/laws/ContactModel.h"
#include "tests/core/contact/laws/ContactCases.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <ostream>
#include <rapidcheck.h>

namespace asperity::test {

/// A law with its materials, tip and lever from the ends of what a scene may ask for: sample E 1 Pa
/// .. 10 TPa, nu 0 .. 0.5 with both ends, w 0 .. 100 J/m^2, R 0.1 nm .. 1 mm, lever rigid or
/// 1e-4 .. 1e6 N/m, any range of cohesion, any film, with water or without.
struct AnyContact {
    ContactLaw law = ContactLaw::Hertz;
    ContactPair pair;
    ContactOptions options;
    double compliance = 0.0;  ///< [m/N]

    [[nodiscard]] ContactModel model() const { return {law, pair, options}; }
};

inline void showValue(const AnyContact& contact, std::ostream& stream) {
    const ContactOptions& options = contact.options;
    stream.precision(17);
    stream << nameOf(contact.law) << ", ";
    asperity::showValue(contact.pair, stream);
    stream << ", sigma0 " << options.cohesiveStress << " Pa, film " << options.filmThickness
           << " m (Poisson ratio " << options.film.poissonRatio << ", share " << options.film.share
           << "), meniscus " << options.meniscus.surfaceTension << " N/m "
           << options.meniscus.contactAngle << " rad " << options.meniscus.range << " m, tier "
           << static_cast<int>(options.solver) << ", compliance " << contact.compliance << " m/N";
}

inline std::ostream& operator<<(std::ostream& stream, const AnyContact& contact) {
    showValue(contact, stream);
    return stream;
}

/// A fraction that is as often one of its ends as not.
inline double fractionWithEnds() {
    return *rc::gen::oneOf(rc::gen::just(0.0), rc::gen::just(1.0), fraction());
}

inline ContactPair extremePair() {
    const double radius = *logUniform(1e-10, 1e-3);
    const Elastic sample{*logUniform(1.0, 1e13), 0.5 * fractionWithEnds()};
    const bool rigid = *rc::gen::inRange(0, 2) == 0;
    const Elastic tip{rigid ? std::numeric_limits<double>::infinity() : 169e9, 0.27};
    const double work = *rc::gen::oneOf(rc::gen::just(0.0), rc::gen::just(100.0),
                                        logUniform(1e-13, 100.0), logUniform(1e-3, 1.0));
    return {radius, reducedModulus(sample, tip), work};
}

inline Meniscus anyMeniscus() {
    return {.surfaceTension = *logUniform(1e-4, 1.0),
            .contactAngle = 0.5 * std::numbers::pi * fractionWithEnds(),
            .range = *logUniform(1e-10, 1e-6)};
}

/// A lever on which the tip pulls off within a kilometer: a softer one is refused there by name.
inline double anyLever(const ContactPair& pair) {
    constexpr double kMaxBase = 200.0;  // [m]
    const double pull = 2.0 * std::numbers::pi * pair.tipRadius * (pair.workOfAdhesion + 2.0);
    const double compliance = *rc::gen::oneOf(rc::gen::just(0.0), logUniform(1e-6, 1e4));
    return std::min(compliance, kMaxBase / pull);
}

/// Any law; without water, by the exact solver or by Newton's method.
inline AnyContact anyDryContact() {
    AnyContact contact;
    contact.law = *rc::gen::elementOf(kValues<ContactLaw>);
    contact.pair = extremePair();
    contact.compliance = anyLever(contact.pair);
    contact.options.filmThickness =
        contact.law == ContactLaw::HertzFilm ? *logUniform(1e-10, 1e-2) : 0.0;
    contact.options.film = {.poissonRatio = *rc::gen::element(0.0, 0.3, 0.5),
                            .share = *rc::gen::element(0.4, 1.0)};
    contact.options.solver = *rc::gen::element(SolverSetting::Exact, SolverSetting::Newton);
    if (*rc::gen::inRange(0, 2) == 0) {
        contact.options.cohesiveStress = contact.pair.workOfAdhesion / *logUniform(1e-12, 1e-7);
    }
    return contact;
}

inline AnyContact anyContact() {
    AnyContact contact = anyDryContact();
    if (*rc::gen::inRange(0, 3) == 0) {
        contact.options.meniscus = anyMeniscus();
    }
    return contact;
}

/// From -1 um to 10 R, dense around the two ends of the branches.
inline double anyApproach(const ContactModel& model, double compliance) {
    const double pullOff = model.pullOffApproach(compliance);
    const double jumpIn = model.jumpInApproach(compliance);
    const double where = *fraction();
    switch (*rc::gen::inRange(0, 6)) {
    case 0:
        return -1e-6 * where;
    case 1:
        return 10.0 * model.pair().tipRadius * where;
    case 2:
        return pullOff + ((where - 0.5) * 1e-9 * std::abs(pullOff));
    case 3:
        return jumpIn + ((where - 0.5) * 1e-9 * std::abs(jumpIn));
    case 4:
        return pullOff + (where * (jumpIn - pullOff));
    default:
        return pullOff + (model.pair().tipRadius * *logUniform(1e-12, 10.0));
    }
}

/// Sum of the forces that cancel in a state [N]: what rounding of its force is relative to.
inline double forceSize(const AnyContact& contact, const ContactModel& model,
                        const ContactState& state) {
    const ContactPair& pair = contact.pair;
    const double a = state.contactRadius;
    const double c = state.cohesiveRadius;
    const double elastic = 4.0 / 3.0 * pair.reducedModulus * a * a * (a / pair.tipRadius);
    const double neck = std::sqrt(8.0 * std::numbers::pi * a * pair.workOfAdhesion) * a *
                        std::sqrt(pair.reducedModulus);
    const double zone = model.cohesiveStress() * c * std::sqrt((c - a) * (c + a));
    const double water = contact.options.meniscus.pull(pair.tipRadius);
    return std::abs(state.force) + elastic + neck + (4.0 * zone) + water +
           (2.0 * std::numbers::pi * pair.workOfAdhesion * pair.tipRadius);
}

/// Sum of the lengths that cancel in a state's indentation [m].
inline double indentationSize(const AnyContact& contact, const ContactModel& model,
                              const ContactState& state) {
    const ContactPair& pair = contact.pair;
    const double a = state.contactRadius;
    const double c = state.cohesiveRadius;
    const double neck =
        std::sqrt(2.0 * std::numbers::pi * a * pair.workOfAdhesion / pair.reducedModulus);
    const double zone = 2.0 * model.cohesiveStress() / pair.reducedModulus *
                        (std::sqrt((c - a) * (c + a)) + (a > 0.0 ? 0.0 : c));
    return std::abs(state.indentation) + (a * (a / pair.tipRadius)) + neck + zone +
           std::max(0.0, -model.jumpInApproach(0.0));
}

}  // namespace asperity::test
