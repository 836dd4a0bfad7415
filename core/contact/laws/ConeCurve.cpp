#include "core/contact/laws/ConeCurve.h"

#include "core/contact/laws/PunchIntegrals.h"
#include "core/contact/numerics/RisingSearch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

using std::numbers::pi;

/// The cohesive zone around one contact.
struct ConeCurve::Zone {
    double width;   ///< s
    double radius;  ///< c
    double margin;  ///< c - a
    double angle;   ///< phi
    ZoneIntegrals integrals;
    Rise opening;  ///< left side of the condition, by the width
};

ConeCurve::ConeCurve(double cohesion, double range, double coneHalfAngle) noexcept
    : cohesion_(cohesion), range_(range), punch_(coneHalfAngle), touch_(touchingRadius()) {}

ConeCurve::Zone ConeCurve::zoneAt(const PunchContact& contact, double width) const noexcept {
    constexpr double kQuadrature = 1e-13;
    const double a = contact.radius;
    const double s = width;
    const double c = std::hypot(a, s);
    const double margin = s * (s / (c + a));
    const double phi = std::atan2(s, a);
    const ZoneIntegrals integrals = zoneIntegrals(punch_, contact, s);
    const double value = integrals.opening + (cohesion_ * ((s * phi) - margin));
    const double rate = (s / c * integrals.spread) + (cohesion_ * (phi - (s / c * (margin / c))));
    return {s, c, margin, phi, integrals, {value, rate, kQuadrature * value}};
}

/// From above: each term alone, for a zone narrow or wide against the contact.
double ConeCurve::zoneGuess(const PunchContact& contact) const noexcept {
    const double a = contact.radius;
    const double target = pi / 2.0 * range_;
    const double rate = contact.depth + (a * contact.depthRate / (contact.rim * contact.rim));
    const double narrow = a > 0.0 ? std::cbrt(3.0 * a * a * target / rate) : 0.0;
    const double byShape = narrow + std::sqrt(1.28 * target) + (target * punch_.sine());
    const double pulled = 0.88 * target / cohesion_;
    const double byCohesion = pulled + std::sqrt((pulled * pulled) + (2.27 * a * pulled));
    return std::min(byShape, 1.05 * byCohesion);
}

ConeCurve::Zone ConeCurve::solveZone(const PunchContact& contact) const noexcept {
    const double width =
        RisingSearch(0.0, 0.0, pi / 2.0 * range_)
            .solve([&](double s) { return zoneAt(contact, s).opening; }, zoneGuess(contact));
    return zoneAt(contact, width);
}

SphereState ConeCurve::contact(double coordinate) const noexcept {
    const PunchContact contact = punch_.contact(coordinate);
    const Zone zone = solveZone(contact);
    const double a = contact.radius;
    const double s = zone.width;
    const double c = zone.radius;
    const double square = contact.rim * contact.rim;
    const double pressed = a * contact.depth;
    const double lift = cohesion_ * s;
    const double push = punch_.force(contact);
    const double pull = cohesion_ * ((c * c * zone.angle) + (a * s));
    const double opened = zone.integrals.spread - (cohesion_ * (zone.margin / c));
    const double drawn = cohesion_ * c * zone.angle;
    const double plain = (a * contact.depthRate) + (contact.depth * square);
    SphereState state;
    state.indentationRate = opened;
    state.forceRate = 2.0 * ((a * opened) - (drawn * zone.angle));
    state.perDepth = ((plain * s) + (cohesion_ * a * square)) / ((s * opened) + drawn);
    state.forceSize = push + pull;
    state.indentationSize = pressed + lift;
    state.point = {.force = push - pull,
                   .indentation = pressed - lift,
                   .contactRadius = a,
                   .cohesiveRadius = c,
                   .stiffness = boundedSlope(state.forceRate, state.indentationRate)};
    return state;
}

double ConeCurve::tipHeight(double radius) const noexcept {
    const double joint = punch_.jointRadius();
    if (radius > joint) {
        return (1.0 - punch_.sine()) + ((radius - joint) * punch_.slope());
    }
    return radius * radius / (1.0 + std::sqrt((1.0 - radius) * (1.0 + radius)));
}

SphereState ConeCurve::noncontact(double cohesiveRadius) const noexcept {
    const double c = cohesiveRadius;
    const double lift = 2.0 / pi * cohesion_;
    const double slope =
        c > punch_.jointRadius() ? punch_.slope() : c / std::sqrt((1.0 - c) * (1.0 + c));
    const double height = tipHeight(c);
    SphereState state;
    state.indentationRate = slope - lift;
    state.forceRate = -pi * cohesion_ * c;
    state.perDepth = 1.0;
    state.forceSize = pi / 2.0 * cohesion_ * c * c;
    state.indentationSize = height + (lift * c) + range_;
    state.point = {.force = -state.forceSize,
                   .indentation = height - (lift * c) - range_,
                   .cohesiveRadius = c,
                   .stiffness =
                       c > 0.0 ? boundedSlope(state.forceRate, state.indentationRate) : 0.0};
    return state;
}

/// The root of tip height + (1 - 2/pi) k c = h0.
double ConeCurve::touchingRadius() const noexcept {
    const double k = (1.0 - (2.0 / pi)) * cohesion_;
    const double joint = punch_.jointRadius();
    const double atJoint = tipHeight(joint) + (k * joint);
    if (range_ > atJoint) {
        return joint + ((range_ - atJoint) / (punch_.slope() + k));
    }
    // On the sphere by the half tangent u of the angle that the radius is seen from.
    const double u = range_ / (k + std::sqrt((k * k) + (range_ * (2.0 - range_))));
    return 2.0 * u / (1.0 + (u * u));
}

/// With contact as SphereCurve has it; without, the integral of the force over the indentation.
double ConeCurve::energy(const LawPoint& point) const noexcept {
    if (!(point.contactRadius > 0.0)) {
        const double c = point.cohesiveRadius;
        const double onSphere = std::min(c, punch_.jointRadius());
        const double drop = tipHeight(onSphere);
        const double beyond = (c * c * c) - (onSphere * onSphere * onSphere);
        const double moment = (drop * drop * (3.0 - drop) / 3.0) + (punch_.slope() * beyond / 3.0);
        return cohesion_ * ((cohesion_ * c * c * c / 3.0) - (pi / 2.0 * moment));
    }
    const PunchContact contact = punch_.contactOfRadius(point.contactRadius);
    const Zone zone = solveZone(contact);
    const double a = contact.radius;
    const double c = zone.radius;
    const double inContact =
        punch_.elasticEnergy(contact, point.indentation) - (pi / 2.0 * cohesion_ * range_ * c * c);
    const double inZone = zone.margin * zone.margin * ((2.0 * c) + a) / 3.0;
    const double sector = ((c * c * zone.angle) - (a * zone.width)) / 2.0;
    const double lift = (a * contact.depth) - point.indentation;
    const double opened = zone.integrals.work + (lift * sector);
    return inContact + (cohesion_ * ((2.0 * opened) - (cohesion_ * inZone)));
}

}  // namespace asperity
