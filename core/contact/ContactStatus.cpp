#include "core/contact/ContactStatus.h"

#include "core/contact/Within.h"

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
    case ContactStatus::ApproachOutOfRange:
        return "approach_out_of_range";
    case ContactStatus::ComplianceOutOfRange:
        return "compliance_out_of_range";
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

ContactStatus checkRequest(double approach, double compliance) noexcept {
    if (!isWithin(approach, -1e3, 1e3)) {
        return ContactStatus::ApproachOutOfRange;
    }
    return isWithin(compliance, 0.0, 1e6) ? ContactStatus::Solved
                                          : ContactStatus::ComplianceOutOfRange;
}

}  // namespace asperity
