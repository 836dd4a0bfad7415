#pragma once

#include "core/Random.h"
#include "core/probe/AfmController.h"
#include "core/probe/CantileverModes.h"
#include "core/probe/ProbeSystem.h"
#include "core/probe/ThermalNoise.h"
#include "core/probe/TrueTip.h"
#include "core/surface/sample/SampleSurface.h"

#include <cstdint>

namespace asperity {

/// What is true inside the simulated instrument, apart from what the operator's side believes.
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
