#pragma once

#include "core/Random.h"
#include "core/Vector.h"
#include "core/probe/AfmController.h"
#include "core/probe/CantileverModes.h"
#include "core/probe/ProbeSystem.h"
#include "core/surface/sample/SampleSurface.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>

namespace asperity {

/// A lever as one damped oscillator, m z'' + (m w0 / Q) z' + k (z - zb) = F.
struct Oscillator {
    double stiffness = 0.0;         ///< k [N/m]
    double angularFrequency = 0.0;  ///< w0 [rad/s]
    double qualityFactor = 0.0;     ///< Q
};

/// Position and velocity of the oscillator.
struct OscillatorState {
    double position = 0.0;  ///< z [m]
    double velocity = 0.0;  ///< z' [m/s]
};

/// Moves an oscillator over one time step under a force and a base that are constant within it:
/// exact and stable for every step, whether under-, critically or over-damped.
/// Source: docs/theory.md 7.3.
class LeverResonance {
public:
    /// @throw Error unless stiffness, frequency, quality factor and time step [s] are finite and
    ///        positive
    LeverResonance(const Oscillator& oscillator, double timeStep);

    /// The state one step later, with the base at zb [m] and the force F [N].
    [[nodiscard]] OscillatorState advanced(const OscillatorState& state, double base,
                                           double force) const noexcept;

    /// Free motion over one step of (z, z' / w0).
    [[nodiscard]] const Eigen::Matrix2d& propagator() const noexcept { return free_; }

private:
    Oscillator oscillator_;
    Eigen::Matrix2d free_ = Eigen::Matrix2d::Identity();
    /// (z, z' / w0) after one step from rest towards an equilibrium at 1.
    Eigen::Vector2d step_ = Eigen::Vector2d::Zero();
};

/// Returns the standard deviation of a spring's end by heat, sqrt(kB T / k) [m].
/// @param temperature [K] @param stiffness [N/m]
/// @throw Error when the temperature is negative or not finite
[[nodiscard]] double thermalDeviation(double temperature, double stiffness);

/// The lever's free end shaken by heat: the Ornstein-Uhlenbeck process of a damped oscillator,
/// sampled exactly at a fixed step, so that variance (equipartition, kB T / k) and correlation from
/// one sample to the next are right whatever the step. In thermal equilibrium from the first
/// sample. Source: docs/theory.md 7.3.
class ThermalNoise {
public:
    /// @param temperature [K], 0: the lever rests
    /// @throw Error as LeverResonance, or when the temperature is negative or not finite
    ThermalNoise(const Oscillator& oscillator, double temperature, double timeStep,
                 std::uint64_t seed);

    /// Deflection at the next sample [m]. No allocation.
    [[nodiscard]] double next() noexcept;

private:
    Eigen::Vector2d draw() noexcept;

    Eigen::Matrix2d free_;                            ///< of the state in units of its deviation
    Eigen::Matrix2d kick_ = Eigen::Matrix2d::Zero();  ///< standard normal pair to one step's noise
    double deviation_ = 0.0;                          ///< of the deflection [m]
    Random random_;
    Eigen::Vector2d state_ = Eigen::Vector2d::Zero();  ///< (z, z' / w0) over the deviation
};

/// An instrument that knows where its tip really is, as a simulated one does. This goes to the
/// pictures alone, beside the tick: neither tick nor estimator sees it.
class TrueTip {
public:
    virtual ~TrueTip() = default;
    /// Apex behind the last measurement, lab frame [m]; none before there is one.
    [[nodiscard]] virtual std::optional<Vector3> trueTip() const noexcept = 0;
};

/// True parameters of the simulated instrument, apart from what the operator's side believes.
struct InstrumentTruth {
    ProbeSystem system;
    LeverSignals noise;        ///< standard deviation of the detector's white noise [rad]
    std::uint64_t seed = 1;    ///< of all noise
    double temperature = 0.0;  ///< of the lever [K]; 0: no thermal noise
    double timeStep = 1e-3;    ///< from one exchange to the next [s]
};

/// An AFM that answers at once with the quasi-static state of its own truth, plus what heat does to
/// the lever's fundamental mode and the white noise of the detector. The heat shakes a lever in
/// contact as if it were free: an upper bound, since the sample would hold it. Only the two signals
/// and their age leave it through the port; where the tip really is only pictures show (TrueTip).
class SimulatedAfm final : public AfmController, public TrueTip {
public:
    /// The surface must outlive the instrument. @throw Error when time step or temperature is no
    /// such thing
    SimulatedAfm(const SampleSurface& surface, const InstrumentTruth& truth);

    AfmMeasurement exchange(const BaseMotion& target) noexcept override;

    /// The state behind the last measurement: for tests and experiments, never for the tick.
    [[nodiscard]] const TipState& trueState() const noexcept { return state_; }
    [[nodiscard]] std::optional<Vector3> trueTip() const noexcept override;

private:
    SimulatedAfm(const SampleSurface& surface, const InstrumentTruth& truth,
                 const FlexuralMode& fundamental);

    SampleSurface surface_;
    InstrumentTruth truth_;
    Random random_;
    ThermalNoise thermal_;
    double bendingPerDeflection_;  ///< of the fundamental mode [rad/m]
    EquilibriumMemory memory_;
    ClosestPointTracker tracker_;
    TipState state_;
    bool measured_ = false;  ///< state_ is of a measurement
};

}  // namespace asperity
