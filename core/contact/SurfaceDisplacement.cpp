#include "core/contact/SurfaceDisplacement.h"

#include "core/contact/EllipticIntegrals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

using std::numbers::pi;

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

/// The integral I of docs/physics.md 4.3 over the part of the cohesive zone a < t < c seen from r;
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
    const double a = contact.contactRadius;
    const double r = radius;
    if (a > 0.0 && r <= a) {
        return contact.indentation - (r * r / (2.0 * contact.tipRadius));
    }
    const double cohesive = 2.0 * contact.cohesiveStress / contact.reducedModulus *
                            cohesiveIntegral(a, contact.cohesiveRadius, r);
    if (a == 0.0) {
        return -2.0 / pi * cohesive;
    }
    const double angle = std::asin(a / r);
    const double paraboloid =
        ((r * r * angle) - (a * std::sqrt((r - a) * (r + a)))) / (2.0 * contact.tipRadius);
    return 2.0 / pi * ((contact.indentation * angle) - paraboloid - cohesive);
}

double surfaceDisplacement(const ContactModel& model, const ContactState& state,
                           double radius) noexcept {
    const ContactModel::Split* split = model.split();
    const bool untouched = state.branch == ContactBranch::Far && !(state.force < 0.0);
    if (!state.solved() || untouched) {
        return 0.0;
    }
    CohesiveContact contact{.tipRadius = model.pair().tipRadius,
                            .reducedModulus = model.pair().reducedModulus,
                            .cohesiveStress = model.cohesiveStress(),
                            .indentation = state.indentation,
                            .contactRadius = state.contactRadius,
                            .cohesiveRadius = state.cohesiveRadius};
    if (split == nullptr) {
        return surfaceDisplacement(contact, radius);
    }
    const AttractiveTail& tail = split->separate().tail();
    if (state.branch == ContactBranch::Far) {
        return -attractionLift(tail, tail.attraction().separationAt(state.force), radius);
    }
    const AdhesionSplit& shares = split->bonded().split();
    contact.indentation += shares.tailLift;
    const double outside = std::max(0.0, radius - state.contactRadius);
    const double lift =
        shares.tailSnaps ? 0.0 : attractionLift(tail, shares.jointSeparation, outside);
    return surfaceDisplacement(contact, radius) - lift;
}

}  // namespace asperity
