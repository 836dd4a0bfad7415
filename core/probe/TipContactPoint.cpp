#include "core/probe/TipContactPoint.h"

#include "core/probe/Sliding.h"

#include <cmath>
#include <numbers>

namespace asperity {

namespace {

constexpr double kSamePlace = 1e-6;  // relative change of R_eff, E*, w or mu that needs no new
                                     // solution
constexpr double kFlatEnough = 0.1;  // relative change of R_eff that a flat sample may stand for

bool needsNewSolution(double now, double used) { return std::abs(now - used) > kSamePlace * used; }

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
EffectiveRadius radiusAt(const ClosestPoint& place, const ProbeSystem& system) {
    const bool ofSphere = isSphere(system.contact.law());
    const PrincipalCurvatures bend =
        system.curvature || ofSphere ? place.curvatures : PrincipalCurvatures{};
    const EffectiveRadius radius = effectiveRadius(system.tipRadius(), bend.largest, bend.smallest);
    return ofSphere ? takenAsFlat(radius, system.tipRadius()) : radius;
}

}  // namespace

bool TipContactPoint::followSample(const ProbeSystem& system) noexcept {
    radius = radiusAt(place, system);
    const ContactPair pair = system.pairAt(place.point, radius.radius);
    const Friction now = system.frictionAt(place.point);
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
    slip = slidingOf(place.normal, velocity).slip();
    contact = model.equilibrium(tipRadius - place.distance, kHeld, memory.contact);
    force = contact.force * place.normal + memory.friction * slip;
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
    return touching > 0.0 ? std::max(0.0, friction.coefficient * contact.force +
                                              friction.shearStrength * touching)
                          : 0.0;
}

}  // namespace asperity
