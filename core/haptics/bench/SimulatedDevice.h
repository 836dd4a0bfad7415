#pragma once

#include "core/haptics/bench/VirtualBench.h"
#include "core/haptics/device/PilotedDevice.h"

namespace asperity {

/// A simulated haptic device: the virtual bench with an operator who holds the handle in a normal
/// grip and reaches for where mouse and keyboard pilot it, at most by 0.5 m/s and no farther than
/// to the edge of its workspace. The force that comes back moves the handle away from there, as it
/// does a hand.
class SimulatedDevice final : public PilotedDevice {
public:
    /// @param start where handle and hand rest at first, in the device's own frame [m]
    explicit SimulatedDevice(const Vector3& start, const BenchSetup& setup = {.arm = kNormalGrip});

    [[nodiscard]] DeviceSpecification specification() const noexcept override {
        return bench_.specification();
    }
    [[nodiscard]] double delay() const noexcept override { return bench_.delay(); }
    DeviceState advance(double timeStep) noexcept override;
    void setForce(const Vector3& force) noexcept override { bench_.setForce(force); }

private:
    VirtualBench bench_;
    Vector3 reach_;  ///< where the operator wants the handle [m]
};

}  // namespace asperity
