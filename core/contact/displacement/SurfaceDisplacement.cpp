#include "core/contact/displacement/SurfaceDisplacement.h"

#include "core/contact/Within.h"
#include "core/contact/laws/AttractiveTail.h"
#include "core/contact/laws/SplitLaw.h"
#include "core/contact/laws/TipPunch.h"
#include "core/contact/numerics/EllipticIntegrals.h"
#include "core/contact/numerics/GaussLegendre.h"
#include "core/surface/RoundTip.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace asperity {

namespace {

using std::numbers::pi;

constexpr double kBelowOne = 1.0 - 1e-16;

/// sin and cos of acos(ratio), 0 <= ratio <= 1, without cancellation near 1.
struct EdgeAngle {
    double sine;
    double cosine;
};

EdgeAngle edgeAngle(double inner, double outer) noexcept {
    if (inner == 0.0) {
        return {1.0, 0.0};
    }
    const double ratio = inner / outer;
    return {std::sqrt((outer - inner) / outer * (1.0 + ratio)), ratio};
}

/// Integral of sin^2(t) / sqrt(e + k^2 sin^2 t) from 0 to the edge angle, e > 0.
double zoneIntegral(double e, double k, const EdgeAngle& edge) noexcept {
    const double sine = edge.sine;
    const double toEdge = e + (k * k * sine * sine);
    return e / 3.0 * sine * sine * sine * carlsonRd(e * edge.cosine * edge.cosine, toEdge, e);
}

/// The integral I of docs/theory.md 4.3 over the part of the cohesive zone a < t < c seen from r;
/// in the complement of its angle all terms are positive.
double cohesiveIntegral(double a, double c, double r) noexcept {
    if (c == a) {
        return 0.0;
    }
    const double e = std::abs(c - r) * (c + r);
    if (e == 0.0) {
        return c - a;
    }
    if (r > c) {
        return c * c * zoneIntegral(e, c, edgeAngle(a, c));
    }
    const EdgeAngle edge = edgeAngle(a, r);
    const double toEdge = e + (r * r * edge.sine * edge.sine);
    return (e * edge.sine * carlsonRf(e * edge.cosine * edge.cosine, toEdge, e)) +
           (r * r * zoneIntegral(e, r, edge));
}

/// Height of the undeformed tip over its lowest point.
double tipHeight(const CohesiveContact& contact, double r) noexcept {
    return contact.shape == TipShape::Paraboloid
               ? r * r / (2.0 * contact.tipRadius)
               : RoundTip{contact.tipRadius, contact.coneHalfAngle}.height(r);
}

/// The contact with the cone beyond a unit sphere; none where its edge is on the sphere.
PunchContact coneEdge(const TipPunch& punch, const CohesiveContact& contact) noexcept {
    const double a = contact.contactRadius / contact.tipRadius;
    return punch.hasCone() && a > punch.jointRadius() ? punch.contactOfRadius(a) : PunchContact{};
}

/// Contact with a unit sphere. Where the contact radius has rounded towards the equator, the
/// indentation gives the depth.
SphereContact sphereOf(const CohesiveContact& contact) noexcept {
    constexpr double kRounded = 1e-10;
    const double tip = contact.tipRadius;
    SphereContact sphere = sphereContactOfRadius(contact.contactRadius / tip);
    if (1.0 - sphere.radius < kRounded) {
        const double stress = 2.0 * contact.cohesiveStress / contact.reducedModulus;
        const double edge = 2.0 * pi * contact.contactRadius * contact.edgeWork;
        sphere.depth = ((contact.indentation + std::sqrt(edge / contact.reducedModulus)) / tip) +
                       (stress * leg(contact.cohesiveRadius, contact.contactRadius) / tip);
    }
    return sphere;
}

/// Integral of t^2 / sqrt(r^2 - t^2) over the contact: the paraboloid's part of Abel's transform.
double paraboloidTransform(double a, double r) noexcept {
    return ((r * r * std::asin(a / r)) - (a * leg(r, a))) / 2.0;
}

/// Integral of t atanh(t) / sqrt(r^2 - t^2) over the contact with a unit sphere, r > a: J of
/// docs/theory.md 4.4. Its closed form cancels for small contacts, where the integrand is smooth.
double sphereTransform(const SphereContact& contact, double r) noexcept {
    constexpr double kSmall = 0.3;
    const double a = contact.radius;
    const double angle = std::asin(std::min(1.0, a / r));
    if (a < kSmall) {
        return gaussLegendre(
            [r](double psi) {
                const double t = r * std::sin(psi);
                return t * std::atanh(t);
            },
            0.0, angle);
    }
    const double s = leg(r, a);
    if (r < 1.0) {
        const double q = leg(1.0, r);
        return angle - (s * contact.depth) - (q * std::atan2(a * q, s));
    }
    const double q = leg(r, 1.0);
    const double sum = s + q;
    if (sum == 0.0) {
        return angle;
    }
    return angle - (contact.rim * contact.rim / sum * contact.depth) -
           (q * std::atanh(std::min(a / (1.0 + (q * sum)), kBelowOne)));
}

/// Abel's transform of the tip's shape: what outside of the contact the tip does not press down.
double shapeTransform(const CohesiveContact& contact, double r) noexcept {
    const double tip = contact.tipRadius;
    if (contact.shape == TipShape::Paraboloid) {
        return paraboloidTransform(contact.contactRadius, r) / tip;
    }
    const TipPunch punch(contact.coneHalfAngle);
    const PunchContact edge = coneEdge(punch, contact);
    return edge.run > 0.0
               ? tip * (sphereTransform(sphereContact(punch.jointCoordinate()), r / tip) +
                        coneTransform(punch, edge.run, r / tip))
               : tip * sphereTransform(sphereOf(contact), r / tip);
}

/// Pressure of a unit sphere on a half-space of unit modulus, less that of a singular edge:
/// integral of (atanh t + t / (1 - t^2)) / sqrt(t^2 - r^2) from r to a over pi. With
/// t^2 = r^2 + v^2 the second part is closed; v = v(a) (1 - y^3) smoothes the first where the
/// contact's edge nears the equator.
double spherePressure(const SphereContact& contact, double r) noexcept {
    const double reach = leg(contact.radius, r);
    const double height = leg(1.0, r);
    const double steep = reach < 0.5 * height ? std::atanh(reach / height)
                                              : std::log((height + reach) / contact.rim);
    const auto integrand = [&](double y) {
        const double t = std::hypot(r, reach * (1.0 - (y * y * y)));
        return std::atanh(std::min(t, kBelowOne)) / t * 3.0 * y * y * reach;
    };
    return ((steep / height) + gaussLegendre(integrand, 0.0, 0.5) +
            gaussLegendre(integrand, 0.5, 1.0)) /
           pi;
}

/// Pressure on a film, inside the contact.
double filmPressure(const CohesiveContact& contact, double r) noexcept {
    const double a = contact.contactRadius;
    return contact.reducedModulus / (pi * contact.tipRadius) * a *
           contact.film->pressure(a / contact.filmThickness, leg(a, r) / a);
}

/// Pressure of the tip's shape alone, inside the contact.
double shapePressure(const CohesiveContact& contact, double r) noexcept {
    if (contact.film != nullptr) {
        return filmPressure(contact, r);
    }
    const double tip = contact.tipRadius;
    if (contact.shape == TipShape::Paraboloid) {
        return 2.0 * contact.reducedModulus / (pi * tip) * leg(contact.contactRadius, r);
    }
    const TipPunch punch(contact.coneHalfAngle);
    const PunchContact edge = coneEdge(punch, contact);
    if (edge.run > 0.0) {
        const double onSphere =
            r / tip < punch.jointRadius()
                ? spherePressure(sphereContact(punch.jointCoordinate()), r / tip)
                : 0.0;
        return contact.reducedModulus * (onSphere + (conePressure(punch, edge.run, r / tip) / pi));
    }
    return contact.reducedModulus * spherePressure(sphereOf(contact), r / tip);
}

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

double surfaceDisplacement(const CohesiveContact& contact, double radius) noexcept {
    if (!isWithin(radius, 0.0, kFarAway)) {
        return 0.0;
    }
    const double a = contact.contactRadius;
    const double r = radius;
    if (a > 0.0 && r <= a) {
        return contact.indentation - tipHeight(contact, r);
    }
    const double cohesive = 2.0 * contact.cohesiveStress / contact.reducedModulus *
                            cohesiveIntegral(a, contact.cohesiveRadius, r);
    if (a == 0.0) {
        return -2.0 / pi * cohesive;
    }
    if (contact.film != nullptr) {
        const double t = contact.filmThickness;
        return t * (t / contact.tipRadius) * contact.film->displacement(a / t, r / t);
    }
    return 2.0 / pi *
           ((contact.indentation * std::asin(a / r)) - shapeTransform(contact, r) - cohesive);
}

double surfaceGap(const CohesiveContact& contact, double radius) noexcept {
    if (contact.contactRadius > 0.0 && radius <= contact.contactRadius) {
        return 0.0;
    }
    return tipHeight(contact, radius) - contact.indentation + surfaceDisplacement(contact, radius);
}

double contactPressure(const CohesiveContact& contact, double radius) noexcept {
    const double a = contact.contactRadius;
    if (a > 0.0 && radius == a && contact.edgeWork > 0.0) {
        return -std::numeric_limits<double>::infinity();
    }
    if (radius >= a) {
        const bool inZone = contact.cohesiveStress > 0.0 && radius <= contact.cohesiveRadius;
        return inZone ? -contact.cohesiveStress : 0.0;
    }
    const double reach = leg(a, radius);
    const double edge = std::sqrt(2.0 * contact.reducedModulus * a * contact.edgeWork / pi) / reach;
    const double cohesive =
        2.0 * contact.cohesiveStress / pi * std::atan2(leg(contact.cohesiveRadius, a), reach);
    return shapePressure(contact, radius) - edge - cohesive;
}

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
