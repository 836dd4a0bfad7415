#include "core/probe/ThermalNoise.h"

#include "core/Error.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

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

}  // namespace

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

}  // namespace asperity
