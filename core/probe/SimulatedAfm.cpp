#include "core/probe/SimulatedAfm.h"

namespace asperity {

SimulatedAfm::SimulatedAfm(const BSplineSurface& surface, const InstrumentTruth& truth)
    : surface_(surface), truth_(truth), random_(truth.seed) {}

AfmMeasurement SimulatedAfm::exchange(const BaseMotion& target) noexcept {
    state_ = tipEquilibrium(surface_, truth_.system, target, memory_);
    LeverSignals signals = leverSignals(truth_.system.cantilever, state_.force);
    signals.bending += truth_.noise.bending * random_.normal();
    signals.torsion += truth_.noise.torsion * random_.normal();
    return {signals, 0.0};
}

}  // namespace asperity
