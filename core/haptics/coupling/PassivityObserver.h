#pragma once

#include "core/Vector.h"

#include <vector>

namespace asperity {

/// Watches the energy that goes through the port between device and coupling, as the handle has it:
/// with the force that really acts when a motion is sampled, which is the delay old. A passive
/// coupling takes energy or gives back what its spring has stored; one that gives more shakes the
/// device. Energy leaks away within half a second: else what drag and hysteresis took in a minute
/// would cover for a vibration that begins now. It supervises, it changes no force.
/// Source: Hannaford, Ryu (2002); docs/haptics.md.
class PassivityObserver {
public:
    /// @param stiffness of the coupling [N/m]
    /// @param timeStep  from tick to tick [s]
    /// @param delay     from a sampled motion to its force at the handle [s]
    PassivityObserver(double stiffness, double timeStep, double delay);

    /// One tick: where the device is [m] and the force that is now sent to it [N]. Wait-free.
    void observe(const Vector3& device, const Vector3& force) noexcept;

    /// Dissipated less what leaked, below 0 when the port has given energy: the trace [J].
    [[nodiscard]] double energy() const noexcept { return energy_; }
    /// Energy that the spring stores for the force that now acts at the handle [J].
    [[nodiscard]] double spring() const noexcept { return stored(acting_); }
    /// Returns whether the port gave more than encoder and contact explain: the operator must be
    /// warned.
    [[nodiscard]] bool active() const noexcept;

private:
    [[nodiscard]] double stored(const Vector3& force) const noexcept;

    double stiffness_;
    double keptShare_;           ///< of the energy, from tick to tick
    std::vector<Vector3> sent_;  ///< a ring of forces as long as the delay [N]
    std::size_t oldest_ = 0;
    Vector3 acting_ = Vector3::Zero();  ///< force at the handle since the last tick [N]
    Vector3 device_ = Vector3::Zero();  ///< at the last tick [m]
    bool started_ = false;
    double energy_ = 0.0;
};

}  // namespace asperity
