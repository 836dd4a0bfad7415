#include "core/contact/laws/SphereJkrLaw.h"

#include "core/contact/numerics/RisingSearch.h"
#include "core/contact/numerics/RootSearch.h"

#include <cmath>
#include <numbers>

namespace asperity {

using std::numbers::pi;

/// Derivatives by the depth times sqrt(contact radius), which keeps them finite at the first touch.
struct SphereJkrLaw::Rates {
    double force;
    double indentation;
};

SphereJkrLaw::SphereJkrLaw(const ContactPair& pair) noexcept
    : units_(pair)
    , adhesion_(pair.workOfAdhesion / units_.stiffness)
    , pull_(std::sqrt(2.0 * pi * adhesion_)) {
    if (!(adhesion_ > 0.0)) {
        return;
    }
    const auto forceRate = [this](double x) { return ratesAt(sphereContact(x)).force; };
    double beyond = std::fmin(std::cbrt(adhesion_), 1.0);
    while (forceRate(beyond) <= 0.0) {
        beyond *= 2.0;
    }
    loadFold_ = rootBetween(forceRate, 0.0, beyond);
    displacementFold_ = rootBetween(
        [this](double x) { return ratesAt(sphereContact(x)).indentation; }, 0.0, loadFold_);
}

SphereJkrLaw::Rates SphereJkrLaw::ratesAt(const SphereContact& contact) const noexcept {
    const double a = contact.radius;
    const double square = contact.rim * contact.rim;
    const double pressed = std::sqrt(a) * (a + (contact.depth * square));
    return {a * ((2.0 * pressed) - (3.0 * pull_ * square)), pressed - (0.5 * pull_ * square)};
}

LawPoint SphereJkrLaw::pointAt(const SphereContact& contact) const noexcept {
    const double a = contact.radius;
    const double pulled = pull_ * std::sqrt(a);
    const Rates rates = ratesAt(contact);
    return {.force = sphereForce(contact) - (2.0 * a * pulled),
            .indentation = (a * contact.depth) - pulled,
            .contactRadius = a,
            .cohesiveRadius = a,
            .stiffness = a > 0.0 ? boundedSlope(rates.force, rates.indentation) : 0.0};
}

LawPoint SphereJkrLaw::at(double contactRadius) const noexcept {
    return units_.toSi(pointAt(sphereContactOfRadius(contactRadius / units_.length)));
}

double SphereJkrLaw::foldDepth(double softness) const noexcept {
    const auto rate = [&](double x) {
        const Rates rates = ratesAt(sphereContact(x));
        return rates.indentation + (softness * rates.force);
    };
    return softness > 0.0 ? rootBetween(rate, displacementFold_, loadFold_) : displacementFold_;
}

LawPoint SphereJkrLaw::fold(double compliance) const noexcept {
    return units_.toSi(pointAt(sphereContact(foldDepth(compliance * units_.stiffness))));
}

std::optional<LawPoint> SphereJkrLaw::stable(double approach, double compliance) const noexcept {
    constexpr double kRounding = 4e-16;
    const double softness = compliance * units_.stiffness;
    const double target = approach / units_.length;
    const auto heldAt = [&](double x) {
        const SphereContact contact = sphereContact(x);
        const double pulled = pull_ * std::sqrt(contact.radius);
        const double pressed = contact.radius * x;
        const double push = sphereForce(contact);
        const double pull = 2.0 * contact.radius * pulled;
        const Rates rates = ratesAt(contact);
        return Rise{(pressed - pulled) + (softness * (push - pull)),
                    (rates.indentation + (softness * rates.force)) / std::sqrt(contact.radius),
                    kRounding * (pressed + pulled + (softness * (push + pull)))};
    };
    // Every fold lies at or below the one in load control, so above it none needs to be found.
    double from = loadFold_;
    if (!(from > 0.0 && target >= heldAt(from).value)) {
        from = foldDepth(softness);
    }
    const double lowest = from > 0.0 ? heldAt(from).value : 0.0;
    if (target < lowest || !(from > 0.0 || target > 0.0)) {
        return std::nullopt;
    }
    const double guess = std::fmax(2.0 * from, std::fmin(std::sqrt(std::fabs(target)), 1.0));
    const double depth =
        target > lowest ? RisingSearch(from, lowest, target).solve(heldAt, guess) : from;
    return units_.toSi(pointAt(sphereContact(depth)));
}

double SphereJkrLaw::energy(const LawPoint& point) const noexcept {
    const LawPoint unit = units_.fromSi(point);
    const SphereContact contact = sphereContactOfRadius(unit.contactRadius);
    return units_.energy() * (sphereElasticEnergy(contact, unit.indentation) -
                              (pi * adhesion_ * contact.radius * contact.radius));
}

}  // namespace asperity
