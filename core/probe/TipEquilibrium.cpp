#include "core/probe/TipEquilibrium.h"

#include "core/probe/Sliding.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

constexpr int kMaxIterations = 24;
constexpr double kPositionTolerance =
    1e-15;  // [m]: a millionth of an atom's radius, above rounding

/// Lever and friction along one surface normal.
struct ContactDirections {
    Vector3 normal;
    Vector3 slip;
    double normalCompliance;  ///< n.C n [m/N]
    double slipCompliance;    ///< n.C f [m/N]
};

ContactDirections directionsAt(const ProbeSystem& system, const Vector3& normal,
                               const Vector3& velocity) {
    const Matrix3& compliance = system.cantilever.compliance();
    const Vector3 slip = slidingOf(normal, velocity).slip();
    return {normal, slip, normal.dot(compliance * normal), normal.dot(compliance * slip)};
}

double frictionForce(const Friction& friction, const ContactState& contact) {
    const double area = std::numbers::pi * contact.contactRadius * contact.contactRadius;
    if (area <= 0.0) {
        return 0.0;
    }  // nothing touches
    return std::max(0.0, friction.coefficient * contact.force + friction.shearStrength * area);
}

/// Sliding so that friction drags the tip deeper faster than the lever lifts it.
bool isLocked(const ContactDirections& directions, double frictionCoefficient) {
    return directions.normalCompliance + frictionCoefficient * directions.slipCompliance <= 0.0;
}

}  // namespace

TipState tipEquilibrium(const BSplineSurface& surface, const ProbeSystem& system,
                        const BaseMotion& base, EquilibriumMemory& memory) noexcept {
    const double radius = system.tipRadius();
    const Vector3 toCentre(0.0, 0.0, radius);
    TipState state;
    Vector3 deflection = memory.deflection;
    double friction = memory.friction;
    FootGuess guess = memory.foot;
    for (int i = 0; i < kMaxIterations && !state.converged; ++i) {
        state.foot = closestPoint(surface, base.position + deflection + toCentre, guess);
        guess = {state.foot.point.x(), state.foot.point.y(), state.foot.converged};
        const ContactDirections along = directionsAt(system, state.foot.normal, base.velocity);
        state.slip = along.slip;
        state.locked = isLocked(along, system.friction.coefficient);
        // Approach of the undeflected tip towards the tangent plane of the present foot.
        const double approach = radius - state.foot.distance + along.normal.dot(deflection) -
                                along.slipCompliance * friction;
        state.contact = system.contact.equilibrium(approach, along.normalCompliance, memory.branch);
        friction = frictionForce(system.friction, state.contact);
        state.force = state.contact.force * along.normal + friction * along.slip;
        const Vector3 next = system.cantilever.compliance() * state.force;
        state.converged = (next - deflection).norm() <= kPositionTolerance;
        deflection = next;
    }
    state.tip = base.position + deflection;
    memory = {guess, state.contact.branch, deflection, friction};
    return state;
}

}  // namespace asperity
