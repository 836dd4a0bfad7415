#include "core/contact/laws/SphereMaugisLaw.h"

#include "core/contact/maugis/MaugisUnits.h"
#include "core/contact/numerics/RisingSearch.h"
#include "core/contact/numerics/RootSearch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

using std::numbers::pi;

double held(const LawPoint& point, double softness) noexcept {
    return point.indentation + (softness * point.force);
}

/// Rate of the held quantity along the curve; stable states have > 0.
double heldRate(const SphereState& state, double softness) noexcept {
    return state.indentationRate + (softness * state.forceRate);
}

}  // namespace

SphereMaugisLaw::SphereMaugisLaw(const ContactPair& pair, double cohesiveStress) noexcept
    : cohesiveStress_(cohesiveStress)
    , lambda_(pair.workOfAdhesion > 0.0 ? transitionParameter(maugisUnits(pair), cohesiveStress)
                                        : 0.0)
    , units_(pair)
    , curve_(2.0 * cohesiveStress / pair.reducedModulus,
             pair.workOfAdhesion > 0.0 ? pair.workOfAdhesion / cohesiveStress / pair.tipRadius
                                       : 0.0)
    , touch_(curve_.touch()) {
    if (touch_ == 0.0 || curve_.wrapsBeforeTouch()) {
        return;  // all states with contact are stable
    }
    const auto forceRate = [this](double x) { return contactAt(x).forceRate; };
    double beyond = std::min(std::cbrt(curve_.cohesion() * curve_.range()), 1.0);
    while (forceRate(beyond) <= 0.0) {
        beyond *= 2.0;
    }
    loadFold_ = rootBetween(forceRate, 0.0, beyond);
    const auto indentationRate = [this](double x) { return contactAt(x).indentationRate; };
    if (indentationRate(0.0) < 0.0) {
        displacementFold_ = rootBetween(indentationRate, 0.0, loadFold_);
    }
}

SphereState SphereMaugisLaw::contactAt(double depth) const noexcept {
    return curve_.contact(sphereContact(depth));
}

LawPoint SphereMaugisLaw::at(double contactRadius) const noexcept {
    return units_.toSi(curve_.contact(sphereContactOfRadius(contactRadius / units_.length)).point);
}

LawPoint SphereMaugisLaw::apart(double cohesiveRadius) const noexcept {
    const double c = std::min(cohesiveRadius / units_.length, 1.0);
    return units_.toSi(curve_.noncontact(c / (1.0 + std::sqrt((1.0 - c) * (1.0 + c)))).point);
}

/// Half tangent of the fold without contact, where T (1 - k / sqrt(1 + T^2)) = 2/pi * cohesion with
/// T = tan(beta) and k = pi * softness * cohesion; each side bounds T.
double SphereMaugisLaw::apartFold(double softness) const noexcept {
    const double lift = 2.0 / pi * curve_.cohesion();
    const double k = pi * softness * curve_.cohesion();
    const auto miss = [&](double t) { return (t * (1.0 - (k / std::hypot(1.0, t)))) - lift; };
    const double least = k > 1.0 ? std::sqrt(k - 1.0) * std::sqrt(k + 1.0) : 0.0;
    const double tangent = rootBetween(miss, std::max(lift, least), lift + k);
    return tangent / (1.0 + std::hypot(1.0, tangent));
}

/// The fold and its depth, 0 without contact.
SphereState SphereMaugisLaw::foldState(double softness, double& depth) const noexcept {
    depth = 0.0;
    const double apart = apartFold(softness);
    if (apart <= touch_) {
        return curve_.noncontact(apart);
    }
    if (loadFold_ == 0.0) {
        return contactAt(0.0);
    }
    const auto rate = [&](double x) { return heldRate(contactAt(x), softness); };
    depth = softness > 0.0 ? rootBetween(rate, displacementFold_, loadFold_) : displacementFold_;
    return contactAt(depth);
}

LawPoint SphereMaugisLaw::fold(double compliance) const noexcept {
    double depth = 0.0;
    return units_.toSi(foldState(compliance * units_.stiffness, depth).point);
}

std::optional<LawPoint> SphereMaugisLaw::stable(double approach, double compliance) const noexcept {
    const double softness = compliance * units_.stiffness;
    const double target = approach / units_.length;
    // Every fold lies at or below the one in load control, so above it none needs to be found.
    if (target >= held(contactAt(loadFold_).point, softness)) {
        return units_.toSi(climb(target, softness, loadFold_));
    }
    double depth = 0.0;
    const LawPoint end = foldState(softness, depth).point;
    if (target < held(end, softness)) {
        return std::nullopt;
    }
    if (end.contactRadius > 0.0) {
        return units_.toSi(climb(target, softness, depth));
    }
    if (target >= held(contactAt(0.0).point, softness)) {
        return units_.toSi(climb(target, softness, 0.0));
    }
    return units_.toSi(apartAt(target, softness, apartFold(softness)));
}

/// The state with contact at depth `from` or above.
LawPoint SphereMaugisLaw::climb(double target, double softness, double from) const noexcept {
    constexpr double kRounding = 4e-16;
    const auto heldAt = [&](double depth) {
        const SphereState state = contactAt(depth);
        return Rise{held(state.point, softness), heldRate(state, softness) * state.perDepth,
                    kRounding * (state.indentationSize + (softness * state.forceSize))};
    };
    const double lowest = heldAt(from).value;
    if (target <= lowest) {
        return contactAt(from).point;
    }
    const double guess = std::max(2.0 * from, std::min(std::sqrt(std::abs(target)), 1.0));
    return contactAt(RisingSearch(from, lowest, target).solve(heldAt, guess)).point;
}

/// The state without contact at half tangent `from` or above; with the zone at the equator its
/// force is the same at every indentation until the surfaces touch.
LawPoint SphereMaugisLaw::apartAt(double target, double softness, double from) const noexcept {
    const LawPoint widest = curve_.noncontact(touch_).point;
    if (target >= held(widest, softness)) {
        LawPoint wrapped = widest;
        wrapped.indentation = target - (softness * widest.force);
        return wrapped;
    }
    const auto miss = [&](double u) { return held(curve_.noncontact(u).point, softness) - target; };
    return curve_.noncontact(rootBetween(miss, from, touch_)).point;
}

double SphereMaugisLaw::energy(const LawPoint& point) const noexcept {
    return units_.energy() * curve_.energy(units_.fromSi(point));
}

}  // namespace asperity
