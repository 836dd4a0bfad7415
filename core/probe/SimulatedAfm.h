#pragma once

#include "core/Random.h"
#include "core/probe/AfmController.h"

#include <cstdint>

namespace asperity {

/// What is true inside the simulated instrument, apart from what the operator's side believes.
struct InstrumentTruth {
    ProbeSystem system;
    LeverSignals noise;      ///< standard deviation of each signal [rad]
    std::uint64_t seed = 1;  ///< of the noise
};

/// An AFM that answers at once with the quasi-static state of its own truth. Only the two signals
/// and their age leave it through the port.
class SimulatedAfm final : public AfmController {
public:
    /// The surface must outlive the instrument.
    SimulatedAfm(const BSplineSurface& surface, const InstrumentTruth& truth);

    AfmMeasurement exchange(const BaseMotion& target) noexcept override;

    /// The state behind the last measurement: for tests and experiments, never for the tick.
    [[nodiscard]] const TipState& trueState() const noexcept { return state_; }

private:
    const BSplineSurface& surface_;
    InstrumentTruth truth_;
    Random random_;
    EquilibriumMemory memory_;
    TipState state_;
};

}  // namespace asperity
