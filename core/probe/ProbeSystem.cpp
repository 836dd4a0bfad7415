#include "core/probe/ProbeSystem.h"

#include <cmath>

namespace asperity {

namespace {

/// Slower counts as rest, faster as this fast: in between no square leaves the range of a double.
constexpr double kRest = 1e-30;              // [m/s]
constexpr double kMaxSpeed = 1e100;          // [m/s]
constexpr double kSlidingThreshold = 1e-12;  // of |v|: below it the direction is rounding noise

/// Each component without what is no number and within what can be squared.
Vector3 measurable(const Vector3& velocity) noexcept {
    return velocity.unaryExpr([](double v) {
        const double speed = std::fmin(std::fabs(v), kMaxSpeed);
        return std::isnan(v) || speed < kRest ? 0.0 : std::copysign(speed, v);
    });
}

Vector3 anyTangent(const Vector3& normal) noexcept {
    Vector3::Index smallest = 0;
    normal.cwiseAbs().minCoeff(&smallest);
    return normal.cross(Vector3::Unit(smallest)).normalized();
}

}  // namespace

Sliding slidingOf(const Vector3& normal, const Vector3& velocity) noexcept {
    Sliding sliding;
    const Vector3 moved = measurable(velocity);
    const Vector3 tangential = moved - (moved.dot(normal) * normal);
    const double speed = tangential.norm();
    if (!(speed > kRest && speed > kSlidingThreshold * moved.norm())) {
        sliding.friction = anyTangent(normal);
        return sliding;
    }
    const Vector3 against = -tangential / speed;
    // A second pass: where v is almost parallel to n, the first leaves a normal part of rounding.
    sliding.friction = (against - (against.dot(normal) * normal)).normalized();
    const double total = std::hypot(speed, kRestSpeed);
    sliding.certainty = speed / total;
    sliding.doubt = kRestSpeed / total;
    return sliding;
}

ContactPair ProbeSystem::pairAt(const Vector3& point, double effectiveRadius) const noexcept {
    ContactPair pair = contact.pair();
    pair.tipRadius = effectiveRadius;
    if (field != nullptr) {
        const LocalMaterial material = field->at(point.x(), point.y());
        pair.reducedModulus = field->reducedModulus(material);
        pair.workOfAdhesion = material.workOfAdhesion;
    }
    return pair;
}

Friction ProbeSystem::frictionAt(const Vector3& point) const noexcept {
    Friction local = friction;
    if (field != nullptr) {
        local.coefficient = field->at(point.x(), point.y()).frictionCoefficient;
    }
    return local;
}

}  // namespace asperity
