#include "core/probe/PlanarForce.h"

#include "core/probe/Sliding.h"

#include <cmath>
#include <limits>

namespace asperity {

PlanarForce planarForce(const Cantilever& cantilever, const LeverSignals& signals,
                        const Vector3& normal, const Vector3& velocity) noexcept {
    constexpr double kMinDeterminant = 1e-12;
    const Vector3 n = cantilever.rotation() * normal;
    const Sliding sliding = slidingOf(n, cantilever.rotation() * velocity);
    const Vector3 p = n.cross(sliding.friction);
    const double kappa = cantilever.couplingRatio();
    PlanarForce result;
    if (sliding.certainty == 0.0) {
        return result;
    }
    result.determinant = p.x() - (kappa * p.z());
    result.singular = std::abs(result.determinant) < kMinDeterminant;
    if (!result.singular) {
        const double y1 = signals.bending / cantilever.bendingPerFz();
        const double y2 = signals.torsion / cantilever.torsionPerFy();
        const Vector3 scaled(-(p.y() * y2) - (p.z() * y1), result.determinant * y2,
                             (p.x() * y1) + (kappa * p.y() * y2));
        result.force = cantilever.rotation().transpose() * scaled / result.determinant;
    }
    return result;
}

namespace {

/// What a turn of the normal by its deviation, about each of two axes, does to the force.
void addNormalDeviation(const Cantilever& cantilever, const DecouplingInput& input,
                        const Vector3& normal, ForceEstimate& estimate) noexcept {
    if (input.normalDeviation == 0.0) {
        return;
    }
    const Vector3 first = normal.unitOrthogonal();
    for (const Vector3& axis : {first, Vector3(normal.cross(first))}) {
        const Vector3 turned = (normal + input.normalDeviation * axis).normalized();
        const PlanarForce planar = planarForce(cantilever, input.signals, turned, input.velocity);
        const Vector3 change = planar.force - estimate.force;
        estimate.covariance += change * change.transpose();
    }
}

}  // namespace

ForceEstimate planarEstimate(const Cantilever& cantilever, const DecouplingInput& input) noexcept {
    const Vector3 normal = input.normal.normalized();
    const auto forceOf = [&](const LeverSignals& signals) {
        return planarForce(cantilever, signals, normal, input.velocity);
    };
    const PlanarForce planar = forceOf(input.signals);
    ForceEstimate estimate;
    if (!planar.force.allFinite()) {
        estimate.kind = DecouplingCase::InvalidInput;
        return estimate;
    }
    if (planar.singular) {
        const double sigma = input.normalForceSigma;
        estimate.force = input.normalForceModel * normal;
        const double aside = input.normalDeviation * input.normalForceModel;
        estimate.covariance = (sigma * sigma * normal * normal.transpose()) +
                              (aside * aside * (Matrix3::Identity() - normal * normal.transpose()));
        estimate.condition = std::numeric_limits<double>::infinity();
        const bool slides = slidingOf(normal, input.velocity).certainty > 0.0;
        estimate.kind = slides ? DecouplingCase::NearSingular : DecouplingCase::NoSliding;
    } else {
        // The force is linear in the signals.
        const Vector3 byBending = forceOf({.bending = input.sigma.bending}).force;
        const Vector3 byTorsion = forceOf({.torsion = input.sigma.torsion}).force;
        estimate.force = planar.force;
        estimate.covariance = byBending * byBending.transpose() + byTorsion * byTorsion.transpose();
        addNormalDeviation(cantilever, input, normal, estimate);
    }
    estimate.deflection = cantilever.compliance() * estimate.force;
    return estimate;
}

}  // namespace asperity
