#include "core/contact/laws/JkrLaw.h"

#include "core/contact/numerics/RootSearch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

// With s the square root of the contact radius in Maugis' units, force and indentation are
// polynomials: P = s^6 - sqrt(6) s^3, delta = s^4 - (2/3) sqrt(6) s.
const double kRootOfSix = std::sqrt(6.0);
const double kLoadFold = std::cbrt(kRootOfSix / 2.0);          // s of the smallest force
const double kDisplacementFold = std::cbrt(kRootOfSix / 6.0);  // s of the smallest indentation
const double kUnloaded = std::cbrt(kRootOfSix);                // s without force
constexpr double kPullOff = -1.5;

double forceAt(double s) noexcept {
    const double cube = s * s * s;
    return cube * (cube - kRootOfSix);
}

double indentationAt(double s) noexcept { return s * ((s * s * s) - (2.0 / 3.0 * kRootOfSix)); }

double forceRate(double s) noexcept { return 3.0 * s * s * ((2.0 * s * s * s) - kRootOfSix); }

double indentationRate(double s) noexcept { return (4.0 * s * s * s) - (2.0 / 3.0 * kRootOfSix); }

/// a^3 of the stable state at a force.
double cubeAtForce(double force) noexcept {
    return force + 3.0 + std::sqrt(6.0 * (force - kPullOff));
}

}  // namespace

JkrLaw::JkrLaw(const ContactPair& pair) noexcept : units_(maugisUnits(pair)) {}

LawPoint JkrLaw::atRoot(double root) const noexcept {
    const double radius = root * root * units_.radius;
    const double rate = indentationRate(root);
    return {.force = forceAt(root) * units_.force,
            .indentation = indentationAt(root) * units_.indentation,
            .contactRadius = radius,
            .cohesiveRadius = radius,
            .stiffness = curveStiffness(forceRate(root) * units_.force, rate * units_.indentation)};
}

LawPoint JkrLaw::atContactRadius(double contactRadius) const noexcept {
    return atRoot(std::sqrt(contactRadius / units_.radius));
}

std::optional<LawPoint> JkrLaw::atForce(double force) const noexcept {
    const double load = force / units_.force;
    if (!(load >= kPullOff)) {
        return std::nullopt;
    }
    return atRoot(std::pow(cubeAtForce(load), 1.0 / 6.0));
}

std::optional<LawPoint> JkrLaw::unstableAtForce(double force) const noexcept {
    const double load = force / units_.force;
    if (!(load >= kPullOff && load <= 0.0)) {
        return std::nullopt;
    }
    return atRoot(std::cbrt(-load / std::sqrt(cubeAtForce(load))));
}

std::optional<LawPoint> JkrLaw::atIndentation(double indentation) const noexcept {
    return stable(indentation, 0.0);
}

std::optional<LawPoint> JkrLaw::unstableAtIndentation(double indentation) const noexcept {
    const double held = indentation / units_.indentation;
    if (!(held >= indentationAt(kDisplacementFold) && held <= 0.0)) {
        return std::nullopt;
    }
    const auto excess = [held](double s) { return held - indentationAt(s); };
    return atRoot(rootBetween(excess, 0.0, kDisplacementFold));
}

LawPoint JkrLaw::fold(double compliance) const noexcept {
    const double soft = compliance * units_.force / units_.indentation;
    const auto rate = [soft](double s) { return indentationRate(s) + (soft * forceRate(s)); };
    return atRoot(rootBetween(rate, kDisplacementFold, kLoadFold));
}

/// From the unloaded state on, each of the two terms alone bounds the root from above.
std::optional<LawPoint> JkrLaw::stable(double approach, double compliance) const noexcept {
    const double soft = compliance * units_.force / units_.indentation;
    const double target = approach / units_.indentation;
    const auto excess = [soft, target](double s) {
        return indentationAt(s) + (soft * forceAt(s)) - target;
    };
    const double end = std::sqrt(fold(compliance).contactRadius / units_.radius);
    if (excess(end) > 0.0) {
        return std::nullopt;
    }
    const double above = std::max(0.0, target);
    const double stiff = std::sqrt(std::sqrt(above));
    const double reach = soft > 0.0 ? std::min(stiff, std::pow(above / soft, 1.0 / 6.0)) : stiff;
    return atRoot(rootBetween(excess, end, kUnloaded + reach));
}

/// Integral of force over indentation from the separate bodies on.
double JkrLaw::energy(const LawPoint& point) const noexcept {
    const double a = point.contactRadius / units_.radius;
    const double cube = a * a * a;
    return units_.energy() * a * a *
           ((0.4 * cube) - (2.0 / 3.0 * kRootOfSix * std::sqrt(cube)) + 1.0);
}

}  // namespace asperity
