#include "core/probe/ForceDecoupling.h"

#include "core/contact/Within.h"
#include "core/probe/DecouplingRows.h"
#include "core/probe/LeastSquares.h"
#include "core/probe/ProbeSystem.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

using decoupling::adhesiveFriction;
using decoupling::ContactGeometry;
using decoupling::frictionScale;
using decoupling::geometryOf;
using decoupling::kFrictionLawDefect;
using decoupling::kMinFriction;
using decoupling::kPlanarityDefect;
using decoupling::NormalErrors;
using decoupling::normalErrors;

constexpr double kNearSingularCondition = 100.0;
constexpr double kSingularCondition = 1e15;  // what rounding leaves of an exactly singular system
constexpr double kMaxInput = 1e12;           // in SI: far beyond any measurement, no overflow below
constexpr double kMinSigma = 1e-30;          // same
constexpr double kMinNormal = 1e-30;         // shorter ones lose their direction when squared
constexpr double kPlausibleSigmas = 3.0;
constexpr double kSureSigmas = 5.0;   // of one signal: its noise does so once in half an hour
constexpr double kUsableRest = 1e-3;  // of sigma_N: below it only the model told N

bool usable(double value) noexcept { return isWithin(value, -kMaxInput, kMaxInput); }

bool usable(const Vector3& v) noexcept { return usable(v.x()) && usable(v.y()) && usable(v.z()); }

bool notNegative(double value) noexcept { return isWithin(value, 0.0, kMaxInput); }

bool isDeviation(double value) noexcept { return isWithin(value, kMinSigma, kMaxInput); }

bool inputIsUsable(const DecouplingInput& in) noexcept {
    return usable(in.signals.bending) && usable(in.signals.torsion) &&
           isDeviation(in.sigma.bending) && isDeviation(in.sigma.torsion) && usable(in.normal) &&
           in.normal.norm() >= kMinNormal && usable(in.velocity) &&
           notNegative(in.frictionCoefficient) && notNegative(in.shearStrength) &&
           notNegative(in.contactArea) && usable(in.normalForceModel) &&
           isDeviation(in.normalForceSigma) && notNegative(in.frictionLawError) &&
           isWithin(in.normalDeviation, 0.0, kMaxNormalDeviation);
}

/// Ratio of the singular values of the 2x2 system (N, T) -> force-equivalent signals.
double conditionOf(const ContactGeometry& geometry, double coupling) noexcept {
    if (geometry.sliding.certainty == 0.0) {
        return std::numeric_limits<double>::infinity();
    }
    const Vector3& n = geometry.normal;
    const Vector3& f = geometry.sliding.friction;
    const double nn = n.z() + (coupling * n.x());
    const double ff = f.z() + (coupling * f.x());
    const double largest =
        0.5 * (std::hypot(nn + f.y(), ff - n.y()) + std::hypot(nn - f.y(), ff + n.y()));
    const double determinant = std::abs((nn * f.y()) - (ff * n.y()));
    if (determinant * kSingularCondition <= largest * largest) {
        return std::numeric_limits<double>::infinity();
    }
    return largest * largest / determinant;
}

/// The five scalar observations of docs/theory.md 6.5, each divided by its standard deviation.
struct WhitenedSystem {
    Eigen::Matrix<double, 5, 3> rows = Eigen::Matrix<double, 5, 3>::Zero();
    Eigen::Matrix<double, 5, 1> values = Eigen::Matrix<double, 5, 1>::Zero();

    void set(int row, const Vector3& direction, double value, double sigma) noexcept {
        rows.row(row) = direction.transpose() / sigma;
        values(row) = value / sigma;
    }
    /// Adds a share of another row.
    void add(int row, double share, int other) noexcept {
        rows.row(row) += share * rows.row(other);
        values(row) += share * values(other);
    }
};

/// Standard deviation of the friction law [N].
double lawDeviation(const Sliding& sliding, double scale) noexcept {
    return scale * std::hypot(sliding.certainty * kFrictionLawDefect, sliding.doubt);
}

/// Weight of T = mu N + tau A against T = 0, which takes its place where the model pulls the tip so
/// hard that it would be negative: between the two within one sigma of N, so that nothing jumps.
double frictionLawWeight(const DecouplingInput& in) noexcept {
    const double friction = (in.frictionCoefficient * in.normalForceModel) + adhesiveFriction(in);
    if (friction >= 0.0) {
        return 1.0;
    }
    const double uncertainty = in.frictionCoefficient * in.normalForceSigma;
    return -friction < uncertainty ? 1.0 + (friction / uncertainty) : 0.0;
}

WhitenedSystem whitenedSystem(const Cantilever& cantilever, const DecouplingInput& in,
                              const ContactGeometry& geometry) noexcept {
    const Vector3& normal = geometry.normal;
    const Sliding& sliding = geometry.sliding;
    const double cz = cantilever.bendingPerFz();
    const double cy = cantilever.torsionPerFy();
    const double g = sliding.certainty;
    const double scale = frictionScale(in);
    const double law = g * frictionLawWeight(in);
    const Vector3 planeNormal = normal.cross(sliding.friction);
    const Vector3 frictionLaw = sliding.friction - (law * in.frictionCoefficient * normal);

    const NormalErrors errors = normalErrors(in, geometry);
    // Deviation of the friction law apart from the turn that it shares with the contact model, and
    // with it.
    const double lawAlone =
        std::hypot(std::hypot(lawDeviation(sliding, scale), in.frictionLawError), errors.apart);
    const double lawSigma = std::hypot(lawAlone, errors.along);
    // Deviation of the contact model once the friction law is known.
    const double modelSigma =
        std::hypot(in.normalForceSigma, errors.normal * (lawAlone / lawSigma));

    WhitenedSystem system;
    system.set(0, Vector3(cantilever.couplingRatio(), 0.0, 1.0), in.signals.bending / cz,
               in.sigma.bending / cz);
    system.set(1, Vector3::UnitY(), in.signals.torsion / cy, in.sigma.torsion / cy);
    system.set(2, planeNormal, 0.0,
               std::hypot(scale * std::hypot(g * kPlanarityDefect, sliding.doubt), errors.across));
    system.set(3, frictionLaw, law * adhesiveFriction(in), lawSigma);
    system.set(4, normal, in.normalForceModel, modelSigma);
    if (errors.normal != 0.0) {
        system.add(4, errors.normal * (errors.along / lawSigma) / modelSigma, 3);
    }
    return system;
}

DecouplingCase kindOf(const ContactGeometry& geometry, double condition) noexcept {
    if (geometry.sliding.certainty == 0.0) {
        return DecouplingCase::NoSliding;
    }
    return condition > kNearSingularCondition ? DecouplingCase::NearSingular
                                              : DecouplingCase::Regular;
}

double deviationAlong(const Matrix3& covariance, const Vector3& direction) noexcept {
    return std::sqrt(std::max(0.0, direction.dot(covariance * direction)));
}

/// Returns whether the torsion shows more force than the estimate holds, by more than its noise and
/// the rest of the estimate leave open: a friction law that is too sure outweighs it.
bool outweighsTorsion(const WhitenedSystem& system, const Vector3& force,
                      const Matrix3& inverse) noexcept {
    const double measured = system.values(1);
    const double estimated = system.rows.row(1).dot(force);
    const double known = (system.rows.row(1) * inverse).squaredNorm();
    const double rest = std::sqrt(std::max(0.0, 1.0 - known));
    return std::abs(measured) > std::abs(estimated) && rest > kUsableRest &&
           std::abs(measured - estimated) > kSureSigmas * rest;
}

/// Force and covariance in the frame of the geometry.
Plausibility plausibilityOf(const DecouplingInput& in, const ContactGeometry& geometry,
                            const Vector3& force, const Matrix3& covariance) noexcept {
    const Vector3& n = geometry.normal;
    const Vector3& f = geometry.sliding.friction;
    const double normalForce = force.dot(n);
    const NormalErrors errors = normalErrors(in, geometry);
    // The model is part of the estimate: what they may differ by is the rest of its variance.
    const double variance = n.dot(covariance * n);
    const double modelVariance =
        (in.normalForceSigma * in.normalForceSigma) + (errors.normal * errors.normal);
    const double rest = std::sqrt(std::max(0.0, modelVariance - variance));
    Plausibility plausibility;
    plausibility.contradictsModel =
        rest > kUsableRest * in.normalForceSigma &&
        std::abs(normalForce - in.normalForceModel) > kPlausibleSigmas * rest;
    const Sliding& sliding = geometry.sliding;
    const double scale = frictionScale(in);
    const double friction = force.dot(f);
    const double law = (in.frictionCoefficient * normalForce) + adhesiveFriction(in);
    const Vector3 excess = law > 0.0 ? Vector3(f - (in.frictionCoefficient * n)) : f;
    // The law itself holds to a share only, and at rest friction may have any direction.
    const double sigma = std::hypot(
        deviationAlong(covariance, excess),
        std::hypot(lawDeviation(sliding, scale), std::hypot(errors.along, errors.apart)));
    plausibility.pushesAlong =
        friction <
        -(kMinFriction + std::hypot(kPlausibleSigmas * sliding.doubt * scale,
                                    kPlausibleSigmas * std::hypot(errors.along, errors.apart)));
    plausibility.excessFriction =
        std::abs(friction) - std::max(0.0, law) > kPlausibleSigmas * sigma;
    return plausibility;
}

}  // namespace

std::string caseText(const ForceEstimate& estimate) {
    std::string text = keyOf(estimate.kind);
    text += estimate.plausibility.pushesAlong ? "|pushes_along" : "";
    text += estimate.plausibility.excessFriction ? "|excess_friction" : "";
    text += estimate.plausibility.contradictsModel ? "|contradicts_model" : "";
    return text;
}

ForceEstimate estimateForce(const Cantilever& cantilever, const DecouplingInput& input) noexcept {
    ForceEstimate estimate;
    if (!inputIsUsable(input)) {
        estimate.condition = std::numeric_limits<double>::infinity();
        estimate.kind = DecouplingCase::InvalidInput;
        return estimate;
    }
    const ContactGeometry geometry = geometryOf(cantilever, input);
    const WhitenedSystem system = whitenedSystem(cantilever, input, geometry);
    const LeastSquares3 solved = leastSquares<5>(system.rows, system.values);
    const Vector3& local = solved.solution;
    const Matrix3& inverse = solved.inverseRoot;

    const Matrix3 toLab = cantilever.rotation().transpose();
    const Matrix3 labInverse = toLab * inverse;
    const Matrix3 covariance = labInverse * labInverse.transpose();
    estimate.force = toLab * local;
    estimate.covariance = 0.5 * (covariance + covariance.transpose());  // exactly symmetric
    estimate.deflection = cantilever.compliance() * estimate.force;
    estimate.plausibility = plausibilityOf(input, geometry, local, inverse * inverse.transpose());
    estimate.plausibility.excessFriction |= outweighsTorsion(system, local, inverse);
    estimate.condition = conditionOf(geometry, cantilever.couplingRatio());
    estimate.kind = kindOf(geometry, estimate.condition);
    return estimate;
}

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

/// Adds the force's change by a turn of the normal by its deviation, about each of two axes.
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
