#include "core/contact/laws/TipPunch.h"

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

PunchContact onSphere(const SphereContact& contact) noexcept {
    return {.coordinate = contact.depth,
            .depth = contact.depth,
            .radius = contact.radius,
            .rim = contact.rim};
}

SphereContact sphereEdge(const PunchContact& contact) noexcept {
    return {contact.depth, contact.radius, contact.rim};
}

/// Integrands have poles and branch points just beyond the ends of sphere and cone: pieces that
/// grow by this factor from there keep all of them about as far away as a piece is long, where 16
/// points are good to 1e-12.
constexpr double kPieceGrowth = 3.0;

/// Limits of an integral over the rings of a contact, by a coordinate and by its angle.
struct RingRange {
    double low;
    double high;
    double lowAngle;
    double highAngle;  ///< the smaller one
};

/// Sum of an integral by the angle over pieces of a range, the first of them at its high end.
template <class Integrand, class Next, class Angle>
auto overPieces(const RingRange& range, const Integrand& integrand, const Next& next,
                const Angle& angleOf) noexcept {
    decltype(integrand(range.low)) sum{};
    double from = range.high;
    double fromAngle = range.highAngle;
    do {  // also where the ends of a narrow zone round to one radius: the angles still differ
        const double to = std::max(range.low, next(from));
        const double toAngle = to > range.low ? angleOf(to) : range.lowAngle;
        sum += gaussLegendre(integrand, fromAngle, toAngle);
        from = to;
        fromAngle = toAngle;
    } while (from > range.low);
    return sum;
}

/// Integral over rings on the sphere of f(ring, psi), by psi, where the ring's radius, which the
/// range is of, is outer cos(psi). Pieces grow with the distance from the equator.
template <class Function>
auto overSphere(const RingRange& range, double outer, const Function& function) noexcept {
    return overPieces(
        range,
        [&](double psi) { return function(TipPunch::sphereRing(outer * std::cos(psi)), psi); },
        [](double radius) { return 1.0 - (kPieceGrowth * (1.0 - radius)); },
        [outer](double radius) { return std::atan2(leg(outer, radius), radius); });
}

/// The same on the cone; the range is of runs q = Q cos(eta), and its angles are eta. Pieces grow
/// with the distance from the joint.
/// @param end Q, the run of `outer`
template <class Function>
auto overCone(const TipPunch& punch, const RingRange& range, double end,
              const Function& function) noexcept {
    const double nearest = std::min(punch.sine(), punch.jointRadius());
    return overPieces(
        range,
        [&](double eta) {
            const double run = end * std::cos(eta);
            const PunchRing ring = punch.coneRing(run);
            return (run / ring.radius) *
                   function(ring, std::atan2(end * std::sin(eta), ring.radius));
        },
        [nearest](double run) { return ((run + nearest) / kPieceGrowth) - nearest; },
        [end](double run) { return std::atan2(leg(end, run), run); });
}

/// psi - sin(psi) cos(psi), by its series where that would cancel.
double segmentOf(double psi) noexcept {
    constexpr double kSeriesLimit = 0.1;  // the terms left out are 1e-13 of the sum
    if (psi >= kSeriesLimit) {
        return psi - (std::sin(psi) * std::cos(psi));
    }
    const double square = psi * psi;
    const double sum =
        1.0 - (square / 5.0 * (1.0 - (2.0 / 21.0 * square * (1.0 - (square / 18.0)))));
    return 2.0 / 3.0 * psi * square * sum;
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

TipPunch::TipPunch(double coneHalfAngle) noexcept {
    if (!(coneHalfAngle > 0.0)) {
        return;
    }
    sine_ = std::sin(coneHalfAngle);
    cosine_ = std::cos(coneHalfAngle);
    slope_ = cosine_ / sine_;
    joint_ = std::log((1.0 + cosine_) / sine_);  // atanh(cosine), exact for slender cones
}

PunchContact TipPunch::contact(double coordinate) const noexcept {
    return coordinate > joint_ ? onCone(sine_ * sine_ * (coordinate - joint_), coordinate)
                               : onSphere(sphereContact(coordinate));
}

PunchContact TipPunch::contactOfRadius(double radius) const noexcept {
    const double excess = radius - cosine_;
    return hasCone() && excess > 0.0 ? onCone(excess, joint_ + (excess / (sine_ * sine_)))
                                     : onSphere(sphereContactOfRadius(radius));
}

/// ln((1 + a) / (s + q)), without cancellation where it is small.
double TipPunch::sphereLogarithm(double radius, double run) const noexcept {
    const double square = cosine_ * cosine_;
    return std::log1p(((square / (1.0 + sine_)) + (square / (radius + run))) / (sine_ + run));
}

/// With a d(depth)/da = (a s - q) / ((1 + a) (s + q)) + r0^2 / (s (s + q)), in which the parts that
/// are infinite at the joint have canceled each other.
PunchContact TipPunch::onCone(double excess, double coordinate) const noexcept {
    const double a = cosine_ + excess;
    const double q = std::sqrt(excess * (cosine_ + a));
    const double bend = (((a * sine_) - q) / (1.0 + a)) + (cosine_ * slope_);
    return {.coordinate = coordinate,
            .depth = sphereLogarithm(a, q) + (slope_ * std::atan2(q, cosine_)),
            .radius = a,
            .rim = sine_,
            .depthRate = sine_ * sine_ * bend / ((sine_ + q) * a),
            .run = q};
}

PunchRing TipPunch::sphereRing(double radius) noexcept {
    const double depth = std::atanh(radius);
    return {radius, radius * depth, depth + (radius / ((1.0 - radius) * (1.0 + radius)))};
}

PunchRing TipPunch::coneRing(double run) const noexcept {
    const double a = std::hypot(cosine_, run);
    const double depth = sphereLogarithm(a, run) + (slope_ * std::atan2(run, cosine_));
    const double bend = (((a * sine_) - run) / (1.0 + a)) + (cosine_ * slope_);
    return {a, a * depth, depth + (bend / (sine_ + run))};
}

/// Integral of r^2 f'(r) / sqrt(a^2 - r^2) over the sphere f, to the joint: in closed form, or,
/// where that would cancel, by its depth u = a - sqrt(a^2 - r^2).
double TipPunch::sphereShare(double radius, double run) const noexcept {
    constexpr double kBlunt = 0.5;  // radius of the joint
    if (cosine_ > kBlunt) {
        return 0.5 * (((1.0 + (radius * radius)) * sphereLogarithm(radius, run)) - radius +
                      (sine_ * run));
    }
    return gaussLegendre(
        [radius](double u) {
            const double square = u * ((2.0 * radius) - u);
            return square / std::sqrt(1.0 - square);
        },
        0.0, cosine_ * cosine_ / (radius + run));
}

double TipPunch::force(const PunchContact& contact) const noexcept {
    if (!(contact.run > 0.0)) {
        return sphereForce(sphereEdge(contact));
    }
    const double a = contact.radius;
    const double q = contact.run;
    const double cone = slope_ * ((a * a * std::atan2(q, cosine_)) + (cosine_ * q));
    return cone + (2.0 * sphereShare(a, q));
}

/// Integral of the square of the indentation over the contact radius, along the cone; the logarithm
/// of 1 + q / s for a variable smoothes its beginning.
double TipPunch::coneSquareMoment(double run) const noexcept {
    const double end = std::log1p(run / sine_);
    const int pieces = static_cast<int>(end) + 1;
    const auto integrand = [this](double y) {
        const double q = sine_ * std::expm1(y);
        const double a = std::hypot(cosine_, q);
        const double lift = a * (sphereLogarithm(a, q) + (slope_ * std::atan2(q, cosine_)));
        return lift * lift * (q / a) * (sine_ + q);
    };
    double sum = 0.0;
    for (int i = 0; i < pieces; ++i) {
        sum += gaussLegendre(integrand, end * i / pieces, end * (i + 1) / pieces);
    }
    return sum;
}

double TipPunch::elasticEnergy(const PunchContact& contact, double indentation) const noexcept {
    if (!(contact.run > 0.0)) {
        return sphereElasticEnergy(sphereEdge(contact), indentation);
    }
    const double a = contact.radius;
    const double twiceMoment = (2.0 * a * a * contact.depth) - force(contact);
    const double squares =
        sphereElasticEnergy(sphereContact(joint_), 0.0) + coneSquareMoment(contact.run);
    return (indentation * ((indentation * a) - twiceMoment)) + squares;
}

ZoneIntegrals& ZoneIntegrals::operator+=(const ZoneIntegrals& other) noexcept {
    opening += other.opening;
    spread += other.spread;
    work += other.work;
    return *this;
}

ZoneIntegrals operator+(ZoneIntegrals one, const ZoneIntegrals& other) noexcept {
    return one += other;
}

ZoneIntegrals operator*(double factor, const ZoneIntegrals& integrals) noexcept {
    return {factor * integrals.opening, factor * integrals.spread, factor * integrals.work};
}

/// By parts, so that d(t) - d(a) need not be formed: every term is positive.
ZoneIntegrals zoneIntegrals(const TipPunch& punch, const PunchContact& contact,
                            double width) noexcept {
    const double a = contact.radius;
    const double c = std::hypot(a, width);
    const double joint = punch.jointRadius();
    const auto integrand = [c](const PunchRing& ring, double psi) {
        const double sine = std::sin(psi);
        const double cosine = std::cos(psi);
        return ZoneIntegrals{ring.rate * c * sine * psi, ring.rate * cosine,
                             ring.rate * c * c * c * 0.5 * sine * segmentOf(psi)};
    };
    // c - joint by what a zone is wide: both radii may be close to each other.
    const double beyond = (width * (width / (c + a))) - (joint - a);
    const double end = beyond > 0.0 ? std::sqrt(beyond * (c + joint)) : 0.0;
    const bool isOnCone = contact.run > 0.0;
    ZoneIntegrals sum;
    if (!isOnCone) {
        sum += overSphere({.low = a,
                           .high = end > 0.0 ? joint : c,
                           .lowAngle = std::atan2(width, a),
                           .highAngle = end > 0.0 ? std::atan2(end, joint) : 0.0},
                          c, integrand);
    }
    if (end > 0.0) {
        sum += overCone(punch,
                        {.low = contact.run,
                         .high = end,
                         .lowAngle = std::atan2(isOnCone ? width : end, contact.run),
                         .highAngle = 0.0},
                        end, integrand);
    }
    return sum;
}

double coneTransform(const TipPunch& punch, double run, double radius) noexcept {
    const double end = leg(radius, punch.jointRadius());
    return overCone(punch,
                    {.low = 0.0,
                     .high = run,
                     .lowAngle = std::numbers::pi / 2.0,
                     .highAngle = std::atan2(leg(end, run), run)},
                    end, [](const PunchRing& ring, double /*psi*/) { return ring.indentation; });
}

/// With t^2 = r^2 + v^2 and q^2 = t^2 - r0^2, one of v and q is m sinh(w) and the other m cosh(w),
/// m^2 = |r^2 - r0^2|; a step of 1 in w keeps the poles away.
double conePressure(const TipPunch& punch, double run, double radius) noexcept {
    constexpr double kNearest = 1e-6;  // to the joint, whose own logarithm is finite
    const double joint = punch.jointRadius();
    const bool isOnCone = radius > joint;
    const double m = std::max(isOnCone ? leg(radius, joint) : leg(joint, radius), kNearest * joint);
    const double end = isOnCone ? std::acosh(std::max(1.0, run / m)) : std::asinh(run / m);
    const auto integrand = [&](double w) {
        const PunchRing ring = punch.coneRing(m * (isOnCone ? std::cosh(w) : std::sinh(w)));
        return ring.rate * m * (isOnCone ? std::cosh(w) : std::sinh(w)) / ring.radius;
    };
    const int pieces = static_cast<int>(end) + 1;
    double sum = 0.0;
    for (int i = 0; i < pieces; ++i) {
        sum += gaussLegendre(integrand, end * i / pieces, end * (i + 1) / pieces);
    }
    return sum;
}

}  // namespace asperity
