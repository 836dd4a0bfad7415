#include "core/contact/laws/PunchIntegrals.h"

#include "core/contact/numerics/GaussLegendre.h"
#include "core/contact/numerics/Leg.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

/// Integrands have poles and branch points just beyond the ends of sphere and cone: pieces that
/// grow by this factor from there keep all of them about as far away as a piece is long, where 16
/// points are good to 1e-12.
constexpr double kPieceGrowth = 3.0;

/// Where an integral over the rings of a contact begins and ends, by a coordinate and by the angle
/// that stands for it.
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
