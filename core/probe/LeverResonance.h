#pragma once

#include <Eigen/Core>

namespace asperity {

/// A lever as one damped oscillator, m z'' + (m w0 / Q) z' + k (z - zb) = F.
struct Oscillator {
    double stiffness = 0.0;         ///< k [N/m]
    double angularFrequency = 0.0;  ///< w0 [rad/s]
    double qualityFactor = 0.0;     ///< Q
};

/// Where the oscillator is and how it moves.
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

}  // namespace asperity
