#pragma once

#include "core/identify/cycle/AdhesiveFit.h"
#include "core/identify/cycle/BoundedFit.h"
#include "core/identify/cycle/CycleResiduals.h"
#include "core/identify/cycle/MeasuredCycle.h"
#include "core/identify/cycle/RelaxingContact.h"

namespace asperity {

/// What is known before a fit of a cycle in a liquid or of a sample that relaxes.
struct RelaxationFitOptions {
    double tipRadius = 0.0;     ///< [m]
    bool sphere = true;         ///< exact, not its paraboloid
    double poissonRatio = 0.5;  ///< of the sample
    bool relaxation = true;     ///< of the sample
    bool drag = true;           ///< by the wall
    std::size_t bins = 160;     ///< of each branch
    bool wholeCycle = false;    ///< rather than from windowBegin() on
    FittedBranch branch = FittedBranch::Both;
    /// Continue with the force over the base motion alone, and with more samples: slower, but noise
    /// of the force then is no noise of the indentation.
    bool forward = false;
};

/// Sample and drag as a cycle shows them.
struct RelaxationFit {
    RelaxingParameters parameters;
    BoundedFit bounded;           ///< with the keys of fit.json
    CycleBranch samples;          ///< that it was fitted to: approach, dwell, retract
    std::size_t turn = 0;         ///< first of them after the approach
    std::vector<double> fitted;   ///< forces with the measured indentation [N]
    std::vector<double> forward;  ///< forces with the base motion alone [N]
    double stiffness = 0.0;       ///< of the lever [N/m]
    CycleResiduals residuals;     ///< of these samples; in contact: with an indentation
    CycleFigures measured;        ///< of these samples
    CycleFigures simulated;       ///< from the base motion alone
};

/// Base position at which the part of a cycle about its contact begins [m]: half of the way before
/// contact, or half a tip radius, since beyond a wall's drag is no longer that of a narrow gap.
[[nodiscard]] double windowBegin(const MeasuredCycle& cycle, const CycleEvents& events,
                                 double tipRadius);

/// Fits the force over the measured indentation. Source: docs/theory.md 7.7.
/// @throw Error where the cycle has no times or no contact
[[nodiscard]] RelaxationFit relaxationFit(const MeasuredCycle& cycle,
                                          const RelaxationFitOptions& options);

/// Simulates all samples of a cycle from their base motion alone.
[[nodiscard]] SimulatedCycle simulated(const RelaxationFit& fit, const MeasuredCycle& cycle);

}  // namespace asperity
