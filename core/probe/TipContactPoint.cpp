#include "core/probe/TipContactPoint.h"

#include "core/probe/ProbeSystem.h"
#include "core/surface/HeightMoments.h"

#include <boost/container/static_vector.hpp>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

constexpr double kUnchanged = 1e-6;  // relative change of R_eff, E*, w or mu that needs no new
                                     // solution
constexpr double kFlatEnough = 0.1;  // relative change of R_eff that a flat sample may cover

bool needsNewSolution(double now, double used) { return std::abs(now - used) > kUnchanged * used; }

bool needsNewSolution(const ContactPair& now, const ContactPair& used) {
    return needsNewSolution(now.tipRadius, used.tipRadius) ||
           needsNewSolution(now.reducedModulus, used.reducedModulus) ||
           needsNewSolution(now.workOfAdhesion, used.workOfAdhesion);
}

/// A sphere against a curved surface is no sphere against a flat one where the contact is about as
/// wide as the tip: the exact-sphere laws take the sample as flat.
EffectiveRadius takenAsFlat(EffectiveRadius curved, double tipRadius) {
    const bool isCurved = std::abs(curved.radius - tipRadius) > kFlatEnough * tipRadius;
    return {.radius = tipRadius,
            .tipFits = curved.tipFits,
            .anisotropic = curved.anisotropic || isCurved};
}

/// The law of a sphere needs the curvature, too: to say where the sample is not as flat as it
/// takes it.
EffectiveRadius radiusAt(const ClosestPoint& foot, const ProbeSystem& system) {
    const bool ofSphere = isSphere(system.contact.law());
    const PrincipalCurvatures bend =
        system.curvature || ofSphere ? foot.curvatures : PrincipalCurvatures{};
    const EffectiveRadius radius = effectiveRadius(system.tipRadius(), bend.largest, bend.smallest);
    return ofSphere ? takenAsFlat(radius, system.tipRadius()) : radius;
}

constexpr double kLineError = 2e-4;  // of attraction beside the contact, as a share of pull-off
constexpr double kFarOff = 100.0;    // times that error, while the tip still moves
constexpr double kSoftest = 0.1;     // of a lever's stiffness that attraction beside it leaves

}  // namespace

bool TipContactPoint::followSample(const ProbeSystem& system) noexcept {
    radius = radiusAt(foot, system);
    ContactPair pair = system.pairAt(foot.point, radius.radius);
    pair.reducedModulus *= timed.stiffening();
    const Friction now = system.frictionAt(foot.point);
    if (!needsNewSolution(pair, model.pair()) &&
        !needsNewSolution(now.coefficient, friction.coefficient)) {
        return false;
    }
    model = system.contact.withPair(pair);
    friction = now;
    return true;
}

void TipContactPoint::hold(double tipRadius, const Vector3& velocity) noexcept {
    constexpr double kHeld = 0.0;  // compliance [m/N]
    slip = slidingOf(foot.normal, velocity).slip();
    contact = timed.equilibrium(model, tipRadius - foot.distance, kHeld, memory.contact,
                                tipRadius - foot.distance);
    force = contact.force * foot.normal + memory.friction * slip;
}

void TipContactPoint::keepJump() noexcept {
    if (contact.branch != memory.contact.branch) {
        memory.contact.branch = contact.branch;
        jumpLoss = contact.energyLost;
        jumpStays = contact.jumped;
    }
}

void TipContactPoint::tellJump() noexcept {
    if (jumpStays && !contact.jumped) {
        contact.jumped = true;
        contact.energyLost = jumpLoss;
    }
}

double TipContactPoint::area() const noexcept {
    return std::numbers::pi * contact.contactRadius * contact.contactRadius;
}

double TipContactPoint::frictionForce() const noexcept {
    const double touching = area();
    return touching > 0.0 ? std::max(0.0, friction.coefficient * (contact.force - contact.drag) +
                                              friction.shearStrength * touching)
                          : 0.0;
}

void BesideContacts::sum(std::span<const TipContactPoint> points, const Vector3& tip) noexcept {
    if (!attracts_) {
        return;
    }
    boost::container::static_vector<Vector3, kMaxContactPoints> feet;
    for (const TipContactPoint& closest : points) {
        feet.push_back(closest.foot.point);
    }
    const TipContactPoint& main = points.front();
    const BodyTraction traction = bodyTraction(system_, main.model.pair());
    force_ =
        bodyForce(*system_.beside, traction, tip, {feet.data(), feet.size()}, main.foot.normal);
    error_ = kLineError * traction.pullOff;
}

bool BesideContacts::follow(std::span<const TipContactPoint> points, const Vector3& tip) noexcept {
    if (!attracts_ || (force_ && force_->holdsAt(tip, error_))) {
        return false;
    }
    sum(points, tip);
    return true;
}

Vector3 BesideContacts::likelyTip(const TipContactPoint& main, const Vector3& tip,
                                  const Vector3& before) const noexcept {
    if (!attracts_ || main.memory.contact.branch != ContactBranch::Bonded ||
        main.foot.distance <= 0.0) {
        return tip;
    }
    const SearchGuess& guess = main.memory.guess;
    const double height = system_.beside->surface().at(guess.x, guess.y).height;
    const Vector3 arm = before - Vector3(guess.x, guess.y, height - system_.tipRadius());
    return tip + (arm.norm() - main.foot.distance) * main.foot.normal;
}

void BesideContacts::pull(std::span<TipContactPoint> points, const Vector3& tip,
                          double compliance) noexcept {
    if (!force_) {
        return;
    }
    // A line leads far astray where the tip jumps, or nothing was known of its position.
    if (!force_->holdsAt(tip, kFarOff * error_)) {
        sum(points, tip);
    }
    TipContactPoint& main = points.front();
    const double indentation = system_.tipRadius() - main.foot.distance;
    BodyPull line = force_->along(main.foot.normal, tip, indentation);
    // Attraction that outruns the lever ends at the contact, to which it falls step by step.
    if (compliance * line.slope < kSoftest - 1.0) {
        const double gentle = (kSoftest - 1.0) / compliance;
        line = {.force = line.at(indentation) - (gentle * indentation), .slope = gentle};
    }
    main.model.setBodyPull(line);
}

}  // namespace asperity
