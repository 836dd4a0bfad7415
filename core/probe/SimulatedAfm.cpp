#include "core/probe/SimulatedAfm.h"

namespace asperity {

namespace {

Oscillator oscillatorOf(const FlexuralMode& mode, double qualityFactor) {
    return {.stiffness = mode.stiffness,
            .angularFrequency = mode.angularFrequency,
            .qualityFactor = qualityFactor};
}

/// Another stream of random numbers than that of the detector, so that a temperature leaves the
/// detector's noise as it is.
std::uint64_t thermalSeed(std::uint64_t seed) { return splitMix64(seed); }

}  // namespace

SimulatedAfm::SimulatedAfm(const SampleSurface& surface, const InstrumentTruth& truth)
    : SimulatedAfm(surface, truth, flexuralMode(truth.system.cantilever.geometry(), 1)) {}

SimulatedAfm::SimulatedAfm(const SampleSurface& surface, const InstrumentTruth& truth,
                           const FlexuralMode& fundamental)
    : surface_(surface)
    , truth_(truth)
    , random_(truth.seed)
    , thermal_(oscillatorOf(fundamental, truth.system.cantilever.geometry().qualityFactor),
               truth.temperature, truth.timeStep, thermalSeed(truth.seed))
    , bendingPerDeflection_(fundamental.endSlope) {}

AfmMeasurement SimulatedAfm::exchange(const BaseMotion& target) noexcept {
    state_ = tipEquilibrium(surface_, truth_.system, target, memory_, tracker_);
    measured_ = true;
    LeverSignals signals = leverSignals(truth_.system.cantilever, state_.force);
    signals.bending += bendingPerDeflection_ * thermal_.next();
    signals.bending += truth_.noise.bending * random_.normal();
    signals.torsion += truth_.noise.torsion * random_.normal();
    return {signals, 0.0};
}

std::optional<Vector3> SimulatedAfm::trueTip() const noexcept {
    return measured_ ? std::optional(state_.tip) : std::nullopt;
}

}  // namespace asperity
