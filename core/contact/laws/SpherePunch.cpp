#include "core/contact/laws/SpherePunch.h"

#include "core/contact/numerics/GaussLegendre.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

using std::numbers::pi;

/// Integral of t atanh(t) over the contact; for small contacts by its series, free of cancellation.
double firstMoment(const SphereContact& contact) noexcept {
    constexpr double kSeriesLimit = 0.4;
    constexpr int kTerms = 20;  // 0.4^(2 kTerms) is rounding
    const double a = contact.radius;
    if (a >= kSeriesLimit) {
        return 0.5 * (a - (contact.rim * contact.rim * contact.depth));
    }
    double sum = 0.0;
    for (int k = kTerms; k >= 0; --k) {
        const double odd = (2.0 * k) + 1.0;
        sum = (a * a * sum) + (1.0 / (odd * (odd + 2.0)));
    }
    return a * a * a * sum;
}

/// Integral of x tanh(x) from 0 to `depth` >= 1: its growth less the dilogarithm that is left.
double deepTangentMoment(double depth) noexcept {
    constexpr int kTerms = 20;  // exp(-2 kTerms) is rounding
    const double decay = -std::exp(-2.0 * depth);
    double power = 1.0;
    double tail = 0.0;
    for (int k = 1; k <= kTerms; ++k) {
        power *= decay;
        tail -= power * ((depth / k) + (0.5 / k / k));
    }
    return (depth * depth / 2.0) - (pi * pi / 24.0) + tail;
}

/// Integral of (t atanh t)^2 over the contact.
double squareMoment(const SphereContact& contact) noexcept {
    if (contact.depth < 1.0) {
        return gaussLegendre(
            [](double x) {
                const double t = std::tanh(x);
                return x * x * t * t * (1.0 - t) * (1.0 + t);
            },
            0.0, contact.depth);
    }
    const double cube = contact.radius * contact.radius * contact.radius;
    return (cube * contact.depth * contact.depth -
            (2.0 * (deepTangentMoment(contact.depth) - firstMoment(contact)))) /
           3.0;
}

}  // namespace

SphereContact sphereContact(double depth) noexcept {
    const double decay = std::exp(-depth);
    return {depth, std::tanh(depth), 2.0 * decay / (1.0 + (decay * decay))};
}

SphereContact sphereContactOfRadius(double radius) noexcept {
    constexpr double kMaxArgument = 20.0;  // 1 - tanh(20) is lost in rounding
    if (!(radius < 1.0)) {
        return {kMaxArgument, 1.0, 2.0 * std::exp(-kMaxArgument)};
    }
    return {std::atanh(radius), radius, std::sqrt((1.0 - radius) * (1.0 + radius))};
}

double sphereForce(const SphereContact& contact) noexcept {
    const double a = contact.radius;
    return 2.0 * ((a * a * contact.depth) - firstMoment(contact));
}

double sphereElasticEnergy(const SphereContact& contact, double indentation) noexcept {
    return (indentation * ((indentation * contact.radius) - (2.0 * firstMoment(contact)))) +
           squareMoment(contact);
}

SphereUnits::SphereUnits(const ContactPair& pair) noexcept
    : length(pair.tipRadius), stiffness(pair.reducedModulus * pair.tipRadius) {}

LawPoint SphereUnits::toSi(const LawPoint& point) const noexcept {
    return {.force = point.force * force(),
            .indentation = point.indentation * length,
            .contactRadius = point.contactRadius * length,
            .cohesiveRadius = point.cohesiveRadius * length,
            .stiffness = point.stiffness * stiffness};
}

LawPoint SphereUnits::fromSi(const LawPoint& point) const noexcept {
    return {.force = point.force / force(),
            .indentation = point.indentation / length,
            .contactRadius = point.contactRadius / length,
            .cohesiveRadius = point.cohesiveRadius / length,
            .stiffness = point.stiffness / stiffness};
}

double boundedSlope(double forceRate, double indentationRate) noexcept {
    constexpr double kMaxSlope = 1e30;
    if (std::abs(indentationRate) * kMaxSlope <= std::abs(forceRate)) {
        return std::copysign(kMaxSlope, forceRate);
    }
    return forceRate / indentationRate;
}

}  // namespace asperity
