#pragma once

#include "core/Random.h"
#include "core/probe/LeverResonance.h"

#include <Eigen/Core>

#include <cstdint>

namespace asperity {

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

}  // namespace asperity
