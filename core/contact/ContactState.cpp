#include "core/contact/ContactState.h"

#include "core/Error.h"
#include "core/contact/Within.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace asperity {

namespace {

constexpr double kNoUpperLimit = std::numeric_limits<double>::infinity();

/// Returns whether it is an elastic body or a rigid one; quiet for what is not a number.
bool isBody(const Elastic& body) noexcept {
    constexpr double kMinModulus = 1e-100;  // so that no compliance overflows [Pa]
    const bool rigid = std::isinf(body.youngsModulus) && !std::signbit(body.youngsModulus);
    return isWithin(body.poissonRatio, 0.0, 0.5) &&
           (rigid || isWithin(body.youngsModulus, kMinModulus, std::numeric_limits<double>::max()));
}

/// (1 - nu^2) / E [1/Pa]; zero for a rigid body (E infinite).
double planeCompliance(const Elastic& body) noexcept {
    return (1.0 - (body.poissonRatio * body.poissonRatio)) / body.youngsModulus;
}

constexpr double kMinRange = 1e-15;  // of the cohesion [m]
constexpr double kMaxRange = 1.0;    // [m]

bool stressIsUsable(double work, double stress) noexcept {
    return work < kMinAdhesion || isWithin(stress, work / kMaxRange, work / kMinRange);
}

}  // namespace

EffectiveRadius effectiveRadius(double tipRadius, double largest, double smallest) noexcept {
    constexpr double kMinFactor = 0.1;
    constexpr double kAnisotropicRatio = 2.0;
    if (!isWithin(tipRadius, kMinTipRadius, kMaxTipRadius) || !std::isfinite(largest) ||
        !std::isfinite(smallest)) {
        return {.radius = tipRadius, .tipFits = false};
    }
    const double sharper = 1.0 + (largest * tipRadius);
    const double blunter = 1.0 + (smallest * tipRadius);
    const double first = std::max(sharper, kMinFactor);
    const double second = std::max(blunter, kMinFactor);
    return {.radius = std::max(tipRadius / std::sqrt(first * second), kMinTipRadius),
            .tipFits = blunter >= kMinFactor,
            .anisotropic = first > kAnisotropicRatio * second};
}

double reducedModulus(const Elastic& sample, const Elastic& tip) noexcept {
    if (!isBody(sample) || !isBody(tip)) {
        return 0.0;
    }
    const double compliance = planeCompliance(sample) + planeCompliance(tip);
    return compliance > 1.0 / std::numeric_limits<double>::max() ? 1.0 / compliance : kNoUpperLimit;
}

double sampleShare(const Elastic& sample, const Elastic& tip) noexcept {
    const double modulus = reducedModulus(sample, tip);
    const bool shared = modulus > 0.0 && std::isfinite(modulus);
    return shared ? planeCompliance(sample) * modulus : 0.0;
}

ContactStatus checkPair(const ContactPair& pair, double cohesiveStress) noexcept {
    if (!isWithin(pair.tipRadius, kMinTipRadius, kMaxTipRadius)) {
        return ContactStatus::TipRadiusOutOfRange;
    }
    if (!isWithin(pair.reducedModulus, 0.1, 1e15)) {
        return ContactStatus::ModulusOutOfRange;
    }
    if (!isWithin(pair.workOfAdhesion, 0.0, 1e3)) {
        return ContactStatus::AdhesionOutOfRange;
    }
    return stressIsUsable(pair.workOfAdhesion, cohesiveStress) ? ContactStatus::Solved
                                                               : ContactStatus::StressOutOfRange;
}

ContactStatus checkFilm(double thickness, double poissonRatio) noexcept {
    if (thickness == 0.0) {
        return ContactStatus::Solved;
    }
    if (!isWithin(thickness, 1e-12, 1.0)) {
        return ContactStatus::FilmThicknessOutOfRange;
    }
    return isWithin(poissonRatio, 0.0, 0.5) ? ContactStatus::Solved
                                            : ContactStatus::PoissonRatioOutOfRange;
}

ContactStatus checkCone(double halfAngle) noexcept {
    return halfAngle == 0.0 || isWithin(halfAngle, kMinConeHalfAngle, kMaxConeHalfAngle)
               ? ContactStatus::Solved
               : ContactStatus::ConeHalfAngleOutOfRange;
}

void requirePair(const ContactPair& pair, double cohesiveStress) {
    const ContactStatus status = checkPair(pair, cohesiveStress);
    if (status != ContactStatus::Solved) {
        throw Error(std::string("contact: ") + nameOf(status));
    }
}

double nearestCompliance(double compliance) noexcept {
    constexpr double kRigid = 1e-30;  // [m/N]
    if (std::isnan(compliance) || compliance < kRigid) {
        return 0.0;
    }
    return std::fmin(compliance, kMaxCompliance);
}

ContactStatus checkRequest(double approach, double compliance) noexcept {
    if (!isWithin(approach, -1e3, 1e3)) {
        return ContactStatus::ApproachOutOfRange;
    }
    return isWithin(compliance, 0.0, kMaxCompliance) ? ContactStatus::Solved
                                                     : ContactStatus::ComplianceOutOfRange;
}

}  // namespace asperity
