#include "core/contact/ContactStatus.h"

#include "core/Error.h"
#include "core/contact/Within.h"

#include <cmath>
#include <string>

namespace asperity {

namespace {

constexpr double kSmallestRange = 1e-15;  // of the cohesion [m]
constexpr double kLargestRange = 1.0;     // [m]

bool stressIsUsable(double work, double stress) noexcept {
    return work < kSmallestAdhesion ||
           isWithin(stress, work / kLargestRange, work / kSmallestRange);
}

}  // namespace

const char* nameOf(ContactStatus status) noexcept {
    switch (status) {
    case ContactStatus::Solved:
        return "ok";
    case ContactStatus::TipRadiusOutOfRange:
        return "tip_radius_out_of_range";
    case ContactStatus::ModulusOutOfRange:
        return "modulus_out_of_range";
    case ContactStatus::AdhesionOutOfRange:
        return "adhesion_out_of_range";
    case ContactStatus::StressOutOfRange:
        return "cohesive_stress_out_of_range";
    case ContactStatus::FilmThicknessOutOfRange:
        return "film_thickness_out_of_range";
    case ContactStatus::PoissonRatioOutOfRange:
        return "poisson_ratio_out_of_range";
    case ContactStatus::ApproachOutOfRange:
        return "approach_out_of_range";
    case ContactStatus::ComplianceOutOfRange:
        return "compliance_out_of_range";
    }
    return "unknown";
}

const char* expectationOf(ContactStatus status) noexcept {
    switch (status) {
    case ContactStatus::Solved:
        return "nothing is wrong";
    case ContactStatus::TipRadiusOutOfRange:
        return "the tip radius must lie between 1e-12 and 1 m";
    case ContactStatus::ModulusOutOfRange:
        return "the reduced modulus must lie between 0.1 and 1e15 Pa";
    case ContactStatus::AdhesionOutOfRange:
        return "the work of adhesion must lie between 0 and 1000 J/m^2";
    case ContactStatus::StressOutOfRange:
        return "the range of the cohesive stress, w / sigma0, must lie between 1e-15 and 1 m";
    case ContactStatus::FilmThicknessOutOfRange:
        return "the film's thickness must lie between 1e-12 and 1 m";
    case ContactStatus::PoissonRatioOutOfRange:
        return "the film's Poisson ratio must lie between 0 and 0.5";
    case ContactStatus::ApproachOutOfRange:
        return "the approach of tip or lever base must lie within 1000 m of first touch";
    case ContactStatus::ComplianceOutOfRange:
        return "the lever's compliance must lie between 0 and 1e6 m/N";
    }
    return "unknown";
}

ContactStatus checkPair(const ContactPair& pair, double cohesiveStress) noexcept {
    if (!isWithin(pair.tipRadius, kSmallestTipRadius, kLargestTipRadius)) {
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

void requirePair(const ContactPair& pair, double cohesiveStress) {
    const ContactStatus status = checkPair(pair, cohesiveStress);
    if (status != ContactStatus::Solved) {
        throw Error(std::string("contact: ") + expectationOf(status));
    }
}

double nearestCompliance(double compliance) noexcept {
    constexpr double kRigid = 1e-30;  // [m/N]
    if (std::isnan(compliance) || compliance < kRigid) {
        return 0.0;
    }
    return std::fmin(compliance, kLargestCompliance);
}

ContactStatus checkRequest(double approach, double compliance) noexcept {
    if (!isWithin(approach, -1e3, 1e3)) {
        return ContactStatus::ApproachOutOfRange;
    }
    return isWithin(compliance, 0.0, kLargestCompliance) ? ContactStatus::Solved
                                                         : ContactStatus::ComplianceOutOfRange;
}

}  // namespace asperity
