#pragma once

#include "core/identify/cycle/AdhesiveCycle.h"
#include "core/identify/cycle/MeasuredCycle.h"

#include <optional>

namespace asperity {

/// Root mean squares of measured less simulated forces, as shares of the measured force range. But
/// for `cycleWithJumps` they leave out the samples by a jump, see kSnapInMargin.
struct CycleResiduals {
    double approachContact = 0.0;
    double retractContact = 0.0;
    double contact = 0.0;
    double cycle = 0.0;
    double cycleWithJumps = 0.0;
    double forwardCycle = 0.0;  ///< of the simulation from the base motion alone
    double noise = 0.0;         ///< of the baseline: residuals below are fitted noise
};

/// Distances in base position from a measured jump within which residuals are not counted [m]: an
/// error of its place would outweigh all else. By convention.
inline constexpr double kSnapInMargin = 1e-9;
inline constexpr double kPullOffMargin = 2e-9;

/// @param fitted forces of the fit  @param forward forces from the base motion alone
[[nodiscard]] CycleResiduals cycleResiduals(const MeasuredCycle& cycle, const CycleEvents& events,
                                            const SimulatedCycle& fitted,
                                            const SimulatedCycle& forward);

/// Numbers by which a cycle is described.
struct CycleFigures {
    std::optional<double> snapInBase;   ///< [m]; none: no snap-in
    std::optional<double> snapInForce;  ///< just behind the snap-in, at kSnapInMargin [N]
    std::optional<double> pullOffBase;  ///< [m]; none: no pull-off
    double lowestForce = 0.0;           ///< of the retract [N]
    double approachSlope = 0.0;         ///< of the force over the base at high loads [N/m]
    double retractSlope = 0.0;          ///< [N/m]
    double loopEnergy = 0.0;            ///< work of the base that is lost in the cycle [J]
};

/// Returns the figures of forces at some base positions. @param events of the measured cycle
[[nodiscard]] CycleFigures cycleFigures(const MeasuredCycle& cycle, const CycleEvents& events);

/// The same of a simulation at the measured base positions, with the places of the model's jumps.
[[nodiscard]] CycleFigures simulatedFigures(const MeasuredCycle& cycle, const CycleEvents& events,
                                            const AdhesiveCycle& model,
                                            const SimulatedCycle& simulation);

}  // namespace asperity
