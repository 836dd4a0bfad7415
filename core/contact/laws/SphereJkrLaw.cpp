#include "core/contact/laws/SphereJkrLaw.h"

#include "core/contact/numerics/RootSearch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

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

using std::numbers::pi;

/// Derivatives by the coordinate times sqrt(contact radius), which keeps them finite at the first
/// touch.
struct SphereJkrLaw::Rates {
    double force;
    double indentation;
};

SphereJkrLaw::SphereJkrLaw(const ContactPair& pair, double coneHalfAngle) noexcept
    : units_(pair)
    , punch_(coneHalfAngle)
    , adhesion_(pair.workOfAdhesion / units_.stiffness)
    , pull_(std::sqrt(2.0 * pi * adhesion_)) {
    if (!(adhesion_ > 0.0)) {
        return;
    }
    if (punch_.hasCone()) {
        // At a given coordinate a rigid lever has the highest rate, load control the lowest.
        const double joint = punch_.contactOfRadius(punch_.jointRadius()).coordinate;
        const double dip = dipOf(0.0);
        mayDip_ = ratesAt(punch_.contact(dip)).force <= 0.0 &&
                  ratesAt(punch_.contact(joint)).indentation > 0.0;
    }
    if (!mayDip_) {
        findFolds();
    }
}

void SphereJkrLaw::findFolds() noexcept {
    const auto forceRate = [this](double x) { return ratesAt(punch_.contact(x)).force; };
    double beyond = std::fmin(std::cbrt(adhesion_), 1.0);
    while (forceRate(beyond) <= 0.0) {
        beyond *= 2.0;
    }
    loadFold_ = rootBetween(forceRate, 0.0, beyond);
    displacementFold_ = rootBetween(
        [this](double x) { return ratesAt(punch_.contact(x)).indentation; }, 0.0, loadFold_);
}

SphereJkrLaw::Rates SphereJkrLaw::ratesAt(const PunchContact& contact) const noexcept {
    const double a = contact.radius;
    const double square = contact.rim * contact.rim;
    const double pressed = std::sqrt(a) * ((a * contact.depthRate) + (contact.depth * square));
    return {a * ((2.0 * pressed) - (3.0 * pull_ * square)), pressed - (0.5 * pull_ * square)};
}

LawPoint SphereJkrLaw::pointAt(const PunchContact& contact) const noexcept {
    const double a = contact.radius;
    const double pulled = pull_ * std::sqrt(a);
    const Rates rates = ratesAt(contact);
    return {.force = punch_.force(contact) - (2.0 * a * pulled),
            .indentation = (a * contact.depth) - pulled,
            .contactRadius = a,
            .cohesiveRadius = a,
            .stiffness = a > 0.0 ? boundedSlope(rates.force, rates.indentation) : 0.0};
}

LawPoint SphereJkrLaw::inSi(const PunchContact& contact) const noexcept {
    LawPoint point = units_.toSi(pointAt(contact));
    if (mayDip_) {
        point.coordinate = contact.coordinate;
    }
    return point;
}

LawPoint SphereJkrLaw::at(double contactRadius) const noexcept {
    return inSi(punch_.contactOfRadius(contactRadius / units_.length));
}

/// Rate of what the lever holds, times sqrt(contact radius); stable states have > 0.
double SphereJkrLaw::heldRate(double coordinate, double softness) const noexcept {
    const Rates rates = ratesAt(punch_.contact(coordinate));
    return rates.indentation + (softness * rates.force);
}

Rise SphereJkrLaw::heldAt(double coordinate, double softness) const noexcept {
    constexpr double kRounding = 4e-16;
    const PunchContact contact = punch_.contact(coordinate);
    const double pulled = pull_ * std::sqrt(contact.radius);
    const double pressed = contact.radius * contact.depth;
    const double push = punch_.force(contact);
    const double pull = 2.0 * contact.radius * pulled;
    const Rates rates = ratesAt(contact);
    return Rise{(pressed - pulled) + (softness * (push - pull)),
                (rates.indentation + (softness * rates.force)) / std::sqrt(contact.radius),
                kRounding * (pressed + pulled + (softness * (push + pull)))};
}

/// Coordinate beyond the joint where the tip resists a growing contact least, in units of what
/// adhesion gains by it: by golden sections of the stretch that has it.
double SphereJkrLaw::dipOf(double softness) const noexcept {
    constexpr double kReach = 8.0;  // radii of the joint; beyond, the cone's own growth is all
    constexpr int kSteps = 60;
    const double section = 0.5 * (std::sqrt(5.0) - 1.0);
    const auto resistance = [&](double x) {
        const PunchContact contact = punch_.contact(x);
        const double a = contact.radius;
        const double lift = (a * contact.depthRate) + (contact.depth * contact.rim * contact.rim);
        return lift * std::sqrt(a) * (1.0 + (2.0 * a * softness)) / (1.0 + (6.0 * a * softness));
    };
    double low = punch_.contactOfRadius(punch_.jointRadius()).coordinate;
    double high = punch_.contactOfRadius(kReach * punch_.jointRadius()).coordinate;
    std::array<double, 2> inside{high - (section * (high - low)), low + (section * (high - low))};
    std::array<double, 2> values{resistance(inside[0]), resistance(inside[1])};
    for (int i = 0; i < kSteps; ++i) {
        if (values[0] < values[1]) {
            high = inside[1];
            inside = {high - (section * (high - low)), inside[0]};
            values = {resistance(inside[0]), values[0]};
        } else {
            low = inside[0];
            inside = {inside[1], low + (section * (high - low))};
            values = {values[1], resistance(inside[1])};
        }
    }
    return 0.5 * (low + high);
}

/// Returns where the rate becomes positive beyond a coordinate at which it is not.
double SphereJkrLaw::rootBeyond(double coordinate, double softness) const noexcept {
    double beyond = 2.0 * coordinate;
    while (heldRate(beyond, softness) <= 0.0) {
        beyond *= 2.0;
    }
    return rootBetween([&](double x) { return heldRate(x, softness); }, coordinate, beyond);
}

SphereJkrLaw::Stretches SphereJkrLaw::stretches(double softness) const noexcept {
    const auto rate = [&](double x) { return heldRate(x, softness); };
    if (!mayDip_) {
        return {.inner = softness > 0.0 ? rootBetween(rate, displacementFold_, loadFold_)
                                        : displacementFold_};
    }
    const double joint = punch_.contactOfRadius(punch_.jointRadius()).coordinate;
    const double dip = dipOf(softness);
    if (rate(joint) <= 0.0) {
        return {.inner = rootBeyond(std::fmax(joint, dip), softness)};
    }
    Stretches found{.inner = rootBetween(rate, 0.0, joint)};
    if (rate(dip) < 0.0) {
        found.crest = rootBetween(rate, joint, dip);
        found.outer = rootBeyond(dip, softness);
    }
    return found;
}

/// The fold that holds on longest.
LawPoint SphereJkrLaw::fold(double compliance) const noexcept {
    const double softness = compliance * units_.stiffness;
    const Stretches found = stretches(softness);
    const bool isOuter =
        found.areTwo() && heldAt(found.outer, softness).value < heldAt(found.inner, softness).value;
    return inSi(punch_.contact(isOuter ? found.outer : found.inner));
}

/// The stable state between two coordinates, the first of which is a fold.
LawPoint SphereJkrLaw::climb(double target, double softness, double from,
                             double to) const noexcept {
    const double lowest = from > 0.0 ? heldAt(from, softness).value : 0.0;
    const double guess = std::fmax(2.0 * from, std::fmin(std::sqrt(std::fabs(target)), 1.0));
    const double coordinate = target > lowest
                                  ? RisingSearch(from, lowest, target, to)
                                        .solve([&](double x) { return heldAt(x, softness); },
                                               guess < to ? guess : 0.5 * (from + to))
                                  : from;
    return inSi(punch_.contact(coordinate));
}

std::optional<LawPoint> SphereJkrLaw::stable(double approach, double compliance,
                                             double coordinate) const noexcept {
    const double softness = compliance * units_.stiffness;
    const double target = approach / units_.length;
    // Every fold lies at or below the one in load control, so above it none needs to be found.
    if (loadFold_ > 0.0 && target >= heldAt(loadFold_, softness).value) {
        return climb(target, softness, loadFold_, std::numeric_limits<double>::infinity());
    }
    const Stretches found = stretches(softness);
    const double lowest = found.inner > 0.0 ? heldAt(found.inner, softness).value : 0.0;
    if (found.areTwo() && target >= heldAt(found.outer, softness).value) {
        const bool hasInner = target >= lowest && target <= heldAt(found.crest, softness).value;
        if (!hasInner || coordinate > found.crest) {
            return climb(target, softness, found.outer, std::numeric_limits<double>::infinity());
        }
    }
    if (target < lowest || !(found.inner > 0.0 || target > 0.0)) {
        return std::nullopt;
    }
    return climb(target, softness, found.inner, found.crest);
}

double SphereJkrLaw::energy(const LawPoint& point) const noexcept {
    const LawPoint unit = units_.fromSi(point);
    const PunchContact contact = punch_.contactOfRadius(unit.contactRadius);
    return units_.energy() * (punch_.elasticEnergy(contact, unit.indentation) -
                              (pi * adhesion_ * contact.radius * contact.radius));
}

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
