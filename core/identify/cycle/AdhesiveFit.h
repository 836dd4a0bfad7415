#pragma once

#include "core/identify/cycle/AdhesiveCycle.h"
#include "core/identify/cycle/BoundedFit.h"

#include <optional>

namespace asperity {

/// Which branches a fit sees.
enum class FittedBranch : std::uint8_t { Both, Approach, Retract };

template <>
inline constexpr auto kEnumTable<FittedBranch> =
    std::to_array<EnumRow<FittedBranch>>({{FittedBranch::Both, "both"},
                                          {FittedBranch::Approach, "approach"},
                                          {FittedBranch::Retract, "retract"}});

/// Known values of an adhesive fit, and which of them it may change.
struct AdhesiveFitOptions {
    std::optional<ContactLaw> law;  ///< none: by the transition parameter, see adhesiveFit()
    bool sphere = true;             ///< where no law is given: the tip is exact, not a paraboloid
    double tipRadius = 0.0;         ///< [m]
    std::optional<double> fixedModulus;  ///< E* of a rigid sample [Pa]; none: fitted
    bool twoWorks = false;               ///< of adhesion, on approach and on retract
    bool freeGain = false;               ///< of the InvOLS
    SpringCalibration calibration = SpringCalibration::Thermal;
    FittedBranch branch = FittedBranch::Both;
    /// Weight of the strongest pull against the force of a sample.
    double pullOffWeight = 5.0;
    /// Weight of the place of the pull-off, and of the snap-in where the law has a range, against
    /// the deflection of a sample.
    double placeWeight = 1.0;
};

/// Tip, sample and lever as a cycle shows them.
struct AdhesiveFit {
    AdhesiveParameters parameters;
    BoundedFit bounded;  ///< with the keys of fit.json
    CycleEvents events;  ///< of the measured cycle
};

/// Fits the bonded branch of a law on a lever to the samples in contact, the strongest pull, the
/// place of the pull-off and, for laws with a range, that of the snap-in.
///
/// Without a law: Maugis-Dugdale, or JKR from a transition parameter of 3.2 on, where both are
/// equal within 1 %, or DMT below 0.05 where the cycle does not resolve a range; again until the
/// law stays. Source: docs/theory.md 2.9.
/// @throw Error where the cycle has no contact, or the options do not go together
[[nodiscard]] AdhesiveFit adhesiveFit(const MeasuredCycle& cycle,
                                      const AdhesiveFitOptions& options);

}  // namespace asperity
