#include "core/probe/LeverResonance.h"

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

}  // namespace asperity
