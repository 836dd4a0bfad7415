#include "core/contact/laws/SphereMaugisLaw.h"

#include "core/contact/maugis/MaugisDugdale.h"
#include "core/contact/numerics/GaussLegendre.h"
#include "core/contact/numerics/RootSearch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

using std::numbers::pi;

/// The brackets of the condition for the cohesive radius that depend on the shape alone.
struct Opening {
    double lift;   ///< s - a phi
    double shape;  ///< phi - q theta
};

/// Sums of powers of the angles for narrow zones, s / (a q) < 0.4.
Opening narrowOpening(double a, double s, double q) noexcept {
    constexpr int kTerms = 20;  // 0.4^(2 kTerms) is rounding
    const double t = s / a;
    const double square = t * t;
    const double stretched = square / (q * q);
    double power = 1.0;  // (-t^2)^(k - 1)
    double mixed = 1.0;  // the same times 1 + q^-2 + .. + q^-2(k - 1)
    double lift = 0.0;
    double shape = 0.0;
    for (int k = 1; k <= kTerms; ++k) {
        const double odd = (2.0 * k) + 1.0;
        lift += power / odd;
        shape += mixed / odd;
        power *= -square;
        mixed = power - (stretched * mixed);
    }
    const double c2 = (a * a) + (s * s);
    return {a * t * square * lift, c2 / (q * q) * t * square * shape};
}

/// The same for wide zones; phi - q theta = (1 - q) phi - q (theta - phi).
Opening wideOpening(double a, double s, double q, double phi) noexcept {
    const double square = (a * a) + (s * s);
    const double drop = square / (1.0 + q);
    const double turn = std::atan2(drop * s * a, (q * a * a) + (s * s));
    return {s - (a * phi), (drop * phi) - (q * turn)};
}

using std::numbers::pi;

double held(const LawPoint& point, double softness) noexcept {
    return point.indentation + (softness * point.force);
}

/// Rate of the held quantity along the curve; stable states have > 0.
double heldRate(const SphereState& state, double softness) noexcept {
    return state.indentationRate + (softness * state.forceRate);
}

}  // namespace

/// The cohesive zone around one contact.
struct SphereCurve::Zone {
    double width;       ///< s
    double height;      ///< q
    double radius;      ///< c
    double angle;       ///< phi
    double slopeAngle;  ///< theta
    Rise opening;       ///< left side of the condition, by the angle asin(s / rim)
};

SphereCurve::Zone SphereCurve::zoneAt(const SphereContact& contact, double width,
                                      double height) const noexcept {
    constexpr double kRounding = 4e-16;
    const double a = contact.radius;
    const double s = width;
    const double q = height;
    const double c = std::hypot(a, s);
    const double phi = std::atan2(s, a);
    const double theta = std::atan2(s, a * q);
    const auto [lift, shape] = s < 0.4 * a * q ? narrowOpening(a, s, q) : wideOpening(a, s, q, phi);
    const double margin = s * (s / (c + a));  // c - a
    const double value = (contact.depth * lift) + shape + (cohesion_ * ((s * phi) - margin));
    const double bent =
        (contact.depth * (s / c) * (s / c)) + (cohesion_ * (phi - (s / c * (margin / c))));
    return {s, q, c, phi, theta, {value, (s * theta) + (q * bent), kRounding * value}};
}

/// From above: each bracket alone, for a zone narrow or wide against the contact.
double SphereCurve::zoneGuess(const SphereContact& contact) const noexcept {
    const double a = contact.radius;
    const double target = pi / 2.0 * range_;
    const double byShape = std::cbrt(1.5 * a * target) + std::sqrt(1.28 * target);
    if (!(cohesion_ > 0.0)) {
        return byShape;
    }
    const double pulled = target / cohesion_;
    const double byCohesion =
        (0.88 * pulled) + std::sqrt((0.88 * pulled * 0.88 * pulled) + (2.0 * a * pulled));
    return std::min(byShape, 1.05 * byCohesion);
}

SphereCurve::Zone SphereCurve::solveZone(const SphereContact& contact) const noexcept {
    const double rim = contact.rim;
    const double target = pi / 2.0 * range_;
    if (!(range_ > 0.0)) {
        return {0.0, rim, contact.radius, 0.0, 0.0, {}};
    }
    const double guess = zoneGuess(contact);
    if (guess > 0.3 * rim) {
        const Zone full = zoneAt(contact, rim, 0.0);
        if (full.opening.value <= target) {
            return full;
        }
    }
    const auto zoneAtAngle = [&](double chi) {
        return zoneAt(contact, rim * std::sin(chi), rim * std::cos(chi));
    };
    const double chi = RisingSearch(0.0, 0.0, target, pi / 2.0)
                           .solve([&](double x) { return zoneAtAngle(x).opening; },
                                  std::asin(std::min(guess / rim, 0.8)));
    return zoneAtAngle(chi);
}

SphereState SphereCurve::contact(const SphereContact& contact) const noexcept {
    const Zone zone = solveZone(contact);
    const double a = contact.radius;
    const double pressed = a * contact.depth;
    const double lift = cohesion_ * zone.width;
    const double push = sphereForce(contact);
    const double pull = cohesion_ * ((zone.radius * zone.radius * zone.angle) + (a * zone.width));
    SphereState state;
    state.point = {.force = push - pull,
                   .indentation = pressed - lift,
                   .contactRadius = a,
                   .cohesiveRadius = zone.height > 0.0 ? zone.radius : 1.0};
    state.forceSize = push + pull;
    state.indentationSize = pressed + lift;
    setRates(contact, zone, state);
    return state;
}

/// The edge of the zone moves with the contact unless it is at the equator or there is no zone.
void SphereCurve::setRates(const SphereContact& contact, const Zone& zone,
                           SphereState& state) const noexcept {
    const double a = contact.radius;
    const double square = contact.rim * contact.rim;
    const double plain = a + (contact.depth * square);
    if (!(range_ > 0.0) || zone.height == 0.0) {
        state.perDepth = plain + (range_ > 0.0 ? cohesion_ * a * contact.rim : 0.0);
        state.indentationRate = 1.0;
        state.forceRate = 2.0 * a;
        state.point.stiffness = 2.0 * a;
        return;
    }
    const double s = zone.width;
    const double c = zone.radius;
    const double margin = s * (s / (c + a));  // c - a
    const double opened =
        (c * zone.slopeAngle) + (zone.height * ((contact.depth * s) - (cohesion_ * margin)) / c);
    const double drawn = zone.height * cohesion_ * c * zone.angle;
    state.perDepth = ((plain * s) + (cohesion_ * a * square)) / ((s * opened) + drawn);
    state.indentationRate = opened;
    state.forceRate = 2.0 * ((a * opened) - (drawn * zone.angle));
    state.point.stiffness = boundedSlope(state.forceRate, state.indentationRate);
}

/// With u = tan(beta / 2): c = 2u / (1 + u^2), 1 - q = 2u^2 / (1 + u^2).
SphereState SphereCurve::noncontact(double halfTangent) const noexcept {
    const double u = halfTangent;
    const double c = 2.0 * u / (1.0 + (u * u));
    const double q = (1.0 - u) * (1.0 + u) / (1.0 + (u * u));
    const double lift = 2.0 / pi * cohesion_ * c;
    const double pull = pi / 2.0 * cohesion_ * c * c;
    const double forceRate = -pi * cohesion_ * c * q;
    const double indentationRate = c - (2.0 / pi * cohesion_ * q);
    SphereState state;
    state.point = {.force = -pull,
                   .indentation = (u * c) - lift - range_,
                   .cohesiveRadius = c,
                   .stiffness = c > 0.0 ? boundedSlope(forceRate, indentationRate) : 0.0};
    state.forceRate = forceRate;
    state.indentationRate = indentationRate;
    state.forceSize = pull;
    state.indentationSize = (u * c) + lift + range_;
    return state;
}

bool SphereCurve::wrapsBeforeTouch() const noexcept {
    return range_ >= 1.0 + ((1.0 - (2.0 / pi)) * cohesion_);
}

/// The root of 1 - cos(beta) + k sin(beta) = h0.
double SphereCurve::touch() const noexcept {
    if (wrapsBeforeTouch()) {
        return 1.0;
    }
    if (!(range_ > 0.0)) {
        return 0.0;
    }
    const double k = (1.0 - (2.0 / pi)) * cohesion_;
    return range_ / (k + std::sqrt((k * k) + (range_ * (2.0 - range_))));
}

double SphereCurve::energy(const LawPoint& point) const noexcept {
    if (point.contactRadius > 0.0) {
        return contactEnergy(point);
    }
    // As contactEnergy(), without contact.
    const double c = point.cohesiveRadius;
    const double q = std::sqrt((1.0 - c) * (1.0 + c));
    const double drop = c * c / (1.0 + q);  // 1 - q
    const double overlap = point.indentation + range_;
    return cohesion_ * ((pi / 2.0 * ((drop * drop * (1.0 + (2.0 * q)) / 3.0) - (overlap * c * c))) -
                        (2.0 / 3.0 * cohesion_ * c * c * c));
}

/// Elastic energy, less the work of adhesion of contact and zone, plus what is still to be had from
/// the zone (stress times the integral of the gap, by its Abel transform). Stationary in both radii
/// at a given indentation, so that their rounding does not count.
double SphereCurve::contactEnergy(const LawPoint& point) const noexcept {
    const SphereContact contact = sphereContactOfRadius(point.contactRadius);
    const Zone zone = solveZone(contact);
    const double a = contact.radius;
    const double s = zone.width;
    const double c = zone.radius;
    const double inContact =
        sphereElasticEnergy(contact, point.indentation) - (pi / 2.0 * cohesion_ * range_ * c * c);
    if (!(s > 0.0)) {
        return inContact;
    }
    const double margin = s * (s / (c + a));  // c - a
    const double inZone = margin * margin * ((2.0 * c) + a) / 3.0;
    const double sector = ((c * c * zone.angle) - (a * s)) / 2.0;
    const double lift = (a * contact.depth) - point.indentation;
    const double opened = shapeWork(contact, zone) + (lift * sector);
    return inContact + (cohesion_ * ((2.0 * opened) - (cohesion_ * inZone)));
}

/// Integral of (t atanh t - a atanh a) sqrt(c^2 - t^2) over the zone; t = c cos(eta), eta = phi y^3
/// smoothes the logarithm that the integrand has where the zone ends at the equator.
double SphereCurve::shapeWork(const SphereContact& contact, const Zone& zone) noexcept {
    const double a = contact.radius;
    const double c = zone.radius;
    const auto integrand = [&](double y) {
        const double eta = zone.angle * y * y * y;
        const double sine = std::sin(eta);
        const double t = c * std::cos(eta);
        const double ahead = 2.0 * c * std::sin((zone.angle + eta) / 2.0) *
                             std::sin((zone.angle - eta) / 2.0);  // t - a
        // 1 - a t from the rim: both radii may round to the tip's.
        const double apart = (contact.rim * contact.rim) - (a * ahead);
        const double beyond = std::atanh(std::min(ahead / apart, 1.0 - 1e-16));
        const double rise = (ahead * contact.depth) + (t * beyond);
        return rise * c * c * sine * sine * 3.0 * zone.angle * y * y;
    };
    return gaussLegendre(integrand, 0.0, 0.5) + gaussLegendre(integrand, 0.5, 1.0);
}

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
