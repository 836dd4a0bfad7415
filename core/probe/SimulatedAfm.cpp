#include "core/probe/SimulatedAfm.h"

#include "core/Error.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace asperity {

namespace {

/// From rest towards an equilibrium at 1, in units of 1 / w0: what remains to know of the motion
/// follows from it.
struct StepResponse {
    double position = 0.0;
    double velocity = 0.0;
    double acceleration = 1.0;
};

/// z'' = 1 - 2 zeta z' - z as a power series: no difference of almost equal numbers while little
/// has happened.
StepResponse seriesResponse(double damping, double time) {
    constexpr int kTerms = 26;
    double before = 0.0;              // coefficient n - 1 times time^(n - 1)
    double term = 0.5 * time * time;  // coefficient n times time^n
    StepResponse response{term, time, 0.0};
    for (int n = 2; n < kTerms; ++n) {
        const double next =
            -((2.0 * damping * time * n * term) + (time * time * before)) / ((n + 1.0) * n);
        before = term;
        term = next;
        response.position += term;
        response.velocity += (n + 1.0) * term / time;
    }
    response.acceleration = 1.0 - (2.0 * damping * response.velocity) - response.position;
    return response;
}

/// Two rates far apart, slow * fast = 1.
StepResponse overdampedResponse(double damping, double halfSpread, double time) {
    const double fast = damping + halfSpread;
    const double slow = 1.0 / fast;
    const double spread = 2.0 * halfSpread;
    const double slowLeft = std::exp(-slow * time);
    const double fastLeft = std::exp(-fast * time);
    const double velocity = -slowLeft * std::expm1(-spread * time) / spread;
    return {((slow * std::expm1(-fast * time)) - (fast * std::expm1(-slow * time))) / spread,
            velocity, ((fast * fastLeft) - (slow * slowLeft)) / spread};
}

/// Under-damped, critically damped or little more than that; spreadSquare = zeta^2 - 1.
StepResponse oscillatingResponse(double damping, double spreadSquare, double time) {
    const double rate = std::sqrt(std::abs(spreadSquare));
    const double phase = rate * time;
    const bool circular = spreadSquare < 0.0;
    const double cosine = circular ? std::cos(phase) : std::cosh(std::min(phase, 700.0));
    double sine = time;  // over the rate
    if (phase > 0.0) {
        sine = (circular ? std::sin(phase) : std::sinh(std::min(phase, 700.0))) / rate;
    }
    const double left = std::exp(-damping * time);
    return {1.0 - (left * (cosine + (damping * sine))), left * sine,
            left * (cosine - (damping * sine))};
}

void requirePositive(double value, const char* what) {
    if (!(std::isfinite(value) && value > 0.0)) {
        throw Error(std::string("oscillator: ") + what + " must be finite and positive");
    }
}

StepResponse stepResponse(double damping, double time) {
    constexpr double kSeriesReach = 0.5;
    constexpr double kWellSeparated = 0.25;
    if (time * std::max(1.0, 2.0 * damping) < kSeriesReach) {
        return seriesResponse(damping, time);
    }
    const double spreadSquare = (damping - 1.0) * (damping + 1.0);
    if (spreadSquare > kWellSeparated) {
        return overdampedResponse(damping, std::sqrt(spreadSquare), time);
    }
    return oscillatingResponse(damping, spreadSquare, time);
}

constexpr double kBoltzmann = 1.380649e-23;  // [J/K], exact since 2019

/// A square root of I - P P^T, what one step must add to keep the variance. The velocity, which the
/// force of heat acts on, comes first: over a short step its noise is the larger by far.
Eigen::Matrix2d noiseRoot(const Eigen::Matrix2d& propagator) {
    const Eigen::Matrix2d noise =
        Eigen::Matrix2d::Identity() - (propagator * propagator.transpose());
    const double velocity = std::sqrt(std::max(0.0, noise(1, 1)));
    const double shared = velocity > 0.0 ? noise(0, 1) / velocity : 0.0;
    const double own = std::sqrt(std::max(0.0, noise(0, 0) - (shared * shared)));
    Eigen::Matrix2d root;
    root << own, shared, 0.0, velocity;
    return root;
}

Oscillator oscillatorOf(const FlexuralMode& mode, double qualityFactor) {
    return {.stiffness = mode.stiffness,
            .angularFrequency = mode.angularFrequency,
            .qualityFactor = qualityFactor};
}

/// Another stream of random numbers than that of the detector, so that a temperature leaves the
/// detector's noise as it is.
std::uint64_t thermalSeed(std::uint64_t seed) { return splitMix64(seed); }

}  // namespace

LeverResonance::LeverResonance(const Oscillator& oscillator, double timeStep)
    : oscillator_(oscillator) {
    requirePositive(oscillator.stiffness, "stiffness");
    requirePositive(oscillator.angularFrequency, "frequency");
    requirePositive(oscillator.qualityFactor, "quality factor");
    requirePositive(timeStep, "time step");
    const StepResponse response =
        stepResponse(0.5 / oscillator.qualityFactor, oscillator.angularFrequency * timeStep);
    step_ = {response.position, response.velocity};
    free_ << 1.0 - response.position, response.velocity,  //
        -response.velocity, response.acceleration;
}

OscillatorState LeverResonance::advanced(const OscillatorState& state, double base,
                                         double force) const noexcept {
    const double equilibrium = base + (force / oscillator_.stiffness);
    const double omega = oscillator_.angularFrequency;
    const Eigen::Vector2d next =
        (free_ * Eigen::Vector2d(state.position, state.velocity / omega)) + (equilibrium * step_);
    return {.position = next.x(), .velocity = next.y() * omega};
}

double thermalDeviation(double temperature, double stiffness) {
    if (!(std::isfinite(temperature) && temperature >= 0.0)) {
        throw Error("thermal noise: the temperature must be zero or a positive number of kelvin");
    }
    return std::sqrt(kBoltzmann * temperature / stiffness);
}

ThermalNoise::ThermalNoise(const Oscillator& oscillator, double temperature, double timeStep,
                           std::uint64_t seed)
    : free_(LeverResonance(oscillator, timeStep).propagator())
    , kick_(noiseRoot(free_))
    , deviation_(thermalDeviation(temperature, oscillator.stiffness))
    , random_(seed)
    , state_(draw()) {}

double ThermalNoise::next() noexcept {
    state_ = (free_ * state_) + (kick_ * draw());
    return deviation_ * state_.x();
}

Eigen::Vector2d ThermalNoise::draw() noexcept {
    const double first = random_.normal();
    return {first, random_.normal()};
}

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
