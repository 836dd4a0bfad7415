#include "core/contact/laws/ConeMaugisLaw.h"

#include "core/contact/maugis/MaugisDugdale.h"
#include "core/contact/numerics/RootSearch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

/// Softness of the lever from which a state is not stable: where indentation and force no longer
/// rise together with the curve, a soft lever loses them first.
double softestLever(const SphereState& state) noexcept {
    return state.forceRate < 0.0 ? state.indentationRate / -state.forceRate
                                 : std::numeric_limits<double>::infinity();
}

}  // namespace

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

ConeMaugisLaw::ConeMaugisLaw(const ContactPair& pair, double cohesiveStress,
                             double coneHalfAngle) noexcept
    : cohesiveStress_(cohesiveStress)
    , lambda_(transitionParameter(maugisUnits(pair), cohesiveStress))
    , units_(pair)
    , curve_(2.0 * cohesiveStress / pair.reducedModulus,
             pair.workOfAdhesion / cohesiveStress / pair.tipRadius, coneHalfAngle) {
    placeSamples();
    takeSamples();
}

SphereState ConeMaugisLaw::stateAt(double coordinate) const noexcept {
    if (coordinate >= 0.0) {
        return curve_.contact(coordinate);
    }
    SphereState state = curve_.noncontact((1.0 + coordinate) * curve_.touch());
    state.perDepth = curve_.touch();
    return state;
}

LawPoint ConeMaugisLaw::inSi(double coordinate) const noexcept {
    LawPoint point = units_.toSi(stateAt(coordinate).point);
    point.coordinate = coordinate;
    return point;
}

LawPoint ConeMaugisLaw::at(double contactRadius) const noexcept {
    return inSi(curve_.punch().contactOfRadius(contactRadius / units_.length).coordinate);
}

LawPoint ConeMaugisLaw::apart(double cohesiveRadius) const noexcept {
    return inSi(std::min(cohesiveRadius / units_.length / curve_.touch(), 1.0) - 1.0);
}

/// Rate of what the lever holds along the curve; stable states have > 0.
double ConeMaugisLaw::heldRate(double coordinate, double softness) const noexcept {
    const SphereState state = stateAt(coordinate);
    return state.indentationRate + (softness * state.forceRate);
}

Rise ConeMaugisLaw::heldAt(double coordinate, double softness) const noexcept {
    constexpr double kRounding = 1e-14;
    const SphereState state = stateAt(coordinate);
    return {state.point.indentation + (softness * state.point.force),
            (state.indentationRate + (softness * state.forceRate)) * state.perDepth,
            kRounding * (state.indentationSize + (softness * state.forceSize))};
}

double ConeMaugisLaw::heldAtLoadFold(double softness) const noexcept {
    return loadFoldIndentation_ + (softness * loadFoldForce_);
}

/// From a contact much narrower than that without load to some joint radii into the cone, from
/// where every lever holds the tip.
void ConeMaugisLaw::placeSamples() noexcept {
    constexpr double kReach = 8.0;  // radii of the joint; beyond, the cone's own growth is all
    const TipPunch& punch = curve_.punch();
    const double joint = punch.jointCoordinate();
    const double unloaded = std::cbrt(0.5 * curve_.cohesion() * curve_.range());
    nearSample_ = 0.25 * std::min(unloaded, joint);
    farSample_ = punch.contactOfRadius(kReach * punch.jointRadius()).coordinate;
    while (stateAt(farSample_).forceRate <= 0.0) {
        farSample_ = joint + (2.0 * (farSample_ - joint));
    }
}

/// Without contact evenly, on the sphere and on the cone by equal factors: the joint is the last
/// one on the sphere.
double ConeMaugisLaw::sampleAt(std::size_t index) const noexcept {
    constexpr double kFirstOnCone = 0.02;  // coordinate beyond the joint, where the rate falls
    if (index < kApartSamples) {
        return (static_cast<double>(index + 1) / kApartSamples) - 1.0;
    }
    const double joint = curve_.punch().jointCoordinate();
    if (index < kApartSamples + kSphereSamples) {
        const double part = static_cast<double>(index - kApartSamples) / (kSphereSamples - 1);
        return nearSample_ * std::pow(joint / nearSample_, part);
    }
    const double part =
        static_cast<double>(index - kApartSamples - kSphereSamples) / (kConeSamples - 1);
    return joint + (kFirstOnCone * std::pow((farSample_ - joint) / kFirstOnCone, part));
}

void ConeMaugisLaw::takeSamples() noexcept {
    std::size_t lastUnstable = 0;
    for (std::size_t i = 0; i < kSamples; ++i) {
        softest_[i] = softestLever(stateAt(sampleAt(i)));
        isSimple_ = isSimple_ && (i == 0 || softest_[i] >= softest_[i - 1]);
        lastUnstable = std::isinf(softest_[i]) ? lastUnstable : i;
    }
    const std::size_t next = std::min(lastUnstable + 1, kSamples - 1);
    loadFold_ = rootBetween([this](double x) { return stateAt(x).forceRate; },
                            sampleAt(lastUnstable), sampleAt(next));
    const LawPoint fold = stateAt(loadFold_).point;
    loadFoldIndentation_ = fold.indentation;
    loadFoldForce_ = fold.force;
}

/// From the curve's beginning on, where no state is stable: a zone that begins to grow is drawn on.
ConeMaugisLaw::Stretches ConeMaugisLaw::stretches(double softness) const noexcept {
    const auto turnBefore = [&](std::size_t i) {
        return rootBetween([&](double x) { return heldRate(x, softness); },
                           i == 0 ? -1.0 : sampleAt(i - 1), sampleAt(i));
    };
    Stretches found;
    bool wasStable = false;
    for (std::size_t i = 0; i < kSamples; ++i) {
        const bool isStable = softness < softest_[i];
        if (isStable && !wasStable) {
            found.push_back({.from = turnBefore(i)});
        } else if (wasStable && !isStable) {
            found.back().to = turnBefore(i);
        }
        wasStable = isStable;
    }
    return found;
}

/// The fold that holds on longest.
LawPoint ConeMaugisLaw::fold(double compliance) const noexcept {
    const double softness = compliance * units_.stiffness;
    const Stretches found = stretches(softness);
    const auto last =
        std::min_element(found.begin(), found.end(), [&](const Stretch& one, const Stretch& other) {
            return heldAt(one.from, softness).value < heldAt(other.from, softness).value;
        });
    return inSi(last->from);
}

std::optional<LawPoint> ConeMaugisLaw::stable(double approach, double compliance,
                                              double coordinate) const noexcept {
    const double softness = compliance * units_.stiffness;
    const double target = approach / units_.length;
    // Every fold lies at or below the one in load control, so above it none needs to be found.
    if (isSimple_ && target >= heldAtLoadFold(softness)) {
        return inSi(climb(target, softness, {.from = loadFold_}, coordinate));
    }
    const Stretches found = stretches(softness);
    const Stretch* own = nullptr;
    for (const Stretch& stretch : found) {
        const bool holds = target >= heldAt(stretch.from, softness).value &&
                           (std::isinf(stretch.to) || target <= heldAt(stretch.to, softness).value);
        if (holds && (own == nullptr || coordinate >= stretch.from)) {
            own = &stretch;
        }
    }
    return own != nullptr ? std::optional(inSi(climb(target, softness, *own, coordinate)))
                          : std::nullopt;
}

/// Coordinate of the state of a stretch that holds the target. @param near where to look first
double ConeMaugisLaw::climb(double target, double softness, const Stretch& stretch,
                            double near) const noexcept {
    const double from = std::clamp(0.0, stretch.from, stretch.to);  // first touch, if it is within
    const double lowest =
        from == loadFold_ ? heldAtLoadFold(softness) : heldAt(from, softness).value;
    if (target <= lowest) {
        return from > stretch.from
                   ? rootBetween([&](double x) { return heldAt(x, softness).value - target; },
                                 stretch.from, from)
                   : from;
    }
    constexpr double kMinGuess = 1e-3;
    const double usual =
        std::max(2.0 * from, std::clamp(std::sqrt(std::abs(target)), kMinGuess, 1.0));
    const double guess = near > from ? near : usual;
    return RisingSearch(from, lowest, target, stretch.to)
        .solve([&](double x) { return heldAt(x, softness); },
               guess < stretch.to ? guess : 0.5 * (from + stretch.to));
}

double ConeMaugisLaw::energy(const LawPoint& point) const noexcept {
    return units_.energy() * curve_.energy(units_.fromSi(point));
}

}  // namespace asperity
