#pragma once

#include "core/Vector.h"
#include "core/probe/DetectorCalibration.h"
#include "core/probe/ForceDecoupling.h"

namespace asperity {

/// Evidence of the innovations up to now: two defects, that of the contact model's normal force and
/// that of the friction law, in units of their stated standard deviations, and the noise.
struct InnovationMemory {
    static constexpr double kWide = 25.0;  ///< variance of a defect of which nothing is known

    double normalDefect = 0.0;        ///< of N, mean
    double frictionDefect = 0.0;      ///< of T, mean
    double normalVariance = kWide;    ///< of normalDefect
    double frictionVariance = kWide;  ///< of frictionDefect
    double bendingNoise = 1.0;        ///< mean square innovation over what is stated
    double torsionNoise = 1.0;        ///< same
    double age = 0.0;                 ///< of the last measurement [s]
    bool contradicted = false;        ///< the contact model is
    bool frictionWrong = false;       ///< the friction law is
    bool noisy = false;               ///< the signals scatter more than stated

    bool operator==(const InnovationMemory&) const = default;
};

/// Consequences of that for the estimate of a tick.
struct InnovationVerdict {
    bool modelContradicted = false;     ///< N is off by more than three standard deviations
    bool estimateInconsistent = false;  ///< friction law or noise are not as stated
    double frictionLawError = 0.0;      ///< beside the law's stated deviation, in squares [N]
    double covarianceFactor = 1.0;      ///< >= 1: that the noise calls for
};

/// One measurement and when it was taken.
struct InnovationInput {
    DecouplingInput belief;    ///< with N of the contact model and its stated standard deviation
    bool modelJumped = false;  ///< it has just snapped in or let go
    double age = 0.0;          ///< of the measurement [s]
    double timeStep = 0.0;     ///< since the last tick [s]
};

/// Compares both signals with their prediction from contact model and friction law, over as many
/// ticks as it takes. The stated deviations of model and law are systematic: they do not average
/// out, the noise of the signals does. So two Kalman filters follow the defects as slow
/// random walks: that of N in the bending, that of T in the torsion. A flag needs a defect that is
/// large (three standard deviations of N, half a one of T) and more significant than noise is once
/// in 1e4 s; it goes at 0.8 of the one or half of the other. A measurement that comes again (age)
/// counts once. No allocation. Source: Bar-Shalom, Li, Kirubarajan (2001), Estimation with
/// applications, 5.4; docs/adr/0006-innovations-over-many-ticks.md.
[[nodiscard]] InnovationVerdict monitorInnovation(const Cantilever& cantilever,
                                                  const InnovationInput& input,
                                                  InnovationMemory& memory) noexcept;

/// Changes of the signals that the model expects.
struct SignalHistory {
    LeverSignals expected;  ///< in the last tick [rad]
    LeverSignals change;    ///< over about the age of the signals, all ways added up [rad]
    bool started = false;
};

/// Returns how much the signals may differ from those of now, because they were measured `age` ago:
/// all that the model expected to change since. 0 for signals of now. [rad]
/// @param expected what the model expects of the signals now [rad]
[[nodiscard]] LeverSignals stalenessOf(const LeverSignals& expected, double age, double timeStep,
                                       SignalHistory& memory) noexcept;

/// Signals older than this are flagged, however little the model expects to happen [s].
inline constexpr double kOldSignals = 0.1;

}  // namespace asperity
