#include "core/contact/ContactStatus.h"

#include "core/Error.h"
#include "core/contact/Within.h"

#include <cmath>
#include <string>

namespace asperity {

namespace {

constexpr double kMinRange = 1e-15;  // of the cohesion [m]
constexpr double kMaxRange = 1.0;    // [m]

bool stressIsUsable(double work, double stress) noexcept {
    return work < kMinAdhesion || isWithin(stress, work / kMaxRange, work / kMinRange);
}

}  // namespace

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
