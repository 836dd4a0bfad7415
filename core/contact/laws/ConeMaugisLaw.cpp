#include "core/contact/laws/ConeMaugisLaw.h"

#include "core/contact/maugis/MaugisUnits.h"
#include "core/contact/numerics/RisingSearch.h"
#include "core/contact/numerics/RootSearch.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

/// Softness of the lever from which a state is not stable: where indentation and force no longer
/// rise together with the curve, a soft lever loses them first.
double softestLever(const SphereState& state) noexcept {
    return state.forceRate < 0.0 ? state.indentationRate / -state.forceRate
                                 : std::numeric_limits<double>::infinity();
}

}  // namespace

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
