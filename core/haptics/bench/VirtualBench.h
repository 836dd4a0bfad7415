#pragma once

#include "core/haptics/device/HapticDevice.h"

#include <cstdint>
#include <vector>

namespace asperity {

/// The moving part of a haptic device, the same along each axis.
struct HandlePhysics {
    double mass = 0.075;            ///< effective, at the handle [kg]
    double coulombFriction = 0.04;  ///< of its joints, as felt at the handle [N]
    double viscousFriction = 0.0;   ///< [N s/m]
    double resolution = 30e-6;      ///< of the sensed position [m]; 0: exact
    double maxForce = 8.5;          ///< that its motors give, along each axis [N]
    double maxStiffness = 800.0;    ///< that it renders [N/m]
    double maxDamping = 8.0;        ///< that it renders [N s/m]
    double workspaceRadius = 0.1;   ///< of the ball in which it moves [m]
};

/// The arm that holds the handle: a spring to where the operator wants it, and a damper.
struct ArmImpedance {
    double stiffness = 0.0;  ///< [N/m]
    double damping = 0.0;    ///< [N s/m]
};

/// The device of docs/haptics.md, Phantom class; and how people hold it.
inline constexpr HandlePhysics kPhantomClass{};
inline constexpr ArmImpedance kLightGrip{.stiffness = 80.0, .damping = 0.5};
inline constexpr ArmImpedance kNormalGrip{.stiffness = 150.0, .damping = 2.0};
inline constexpr ArmImpedance kNoGrip{};

struct BenchSetup {
    HandlePhysics handle = kPhantomClass;
    ArmImpedance arm = kLightGrip;
    double delay = 1e-3;  ///< from sampling a position to its force at the handle [s]
};

/// A haptic device with an operator's hand on it, simulated: reproducible, on the caller's clock.
/// The force is held from one setForce() to the next (zero-order hold) and acts late by the whole
/// delay; a real device splits it between sensing and acting, which makes no difference to the
/// loop. Joint friction sticks and slips (Coulomb), axis by axis.
class VirtualBench final : public HapticDevice {
public:
    /// @param start where handle and hand rest at first [m]
    VirtualBench(const BenchSetup& setup, const Vector3& start);

    /// Sets where the operator wants the handle from now on [m].
    void reachFor(const Vector3& target) noexcept { target_ = target; }
    /// Sets how the handle is held from now on.
    void grip(const ArmImpedance& arm) noexcept { arm_ = arm; }

    [[nodiscard]] DeviceSpecification specification() const noexcept override;
    [[nodiscard]] double delay() const noexcept override { return delay_; }
    /// The position as the encoders sense it.
    DeviceState advance(double timeStep) noexcept override;
    void setForce(const Vector3& force) noexcept override { command_ = force; }

    /// True position of the handle [m].
    [[nodiscard]] const Vector3& position() const noexcept { return position_; }
    [[nodiscard]] const Vector3& velocity() const noexcept { return velocity_; }  ///< [m/s]

private:
    void substep() noexcept;
    [[nodiscard]] Vector3 delayed(const Vector3& force) noexcept;

    HandlePhysics handle_;
    ArmImpedance arm_;
    double delay_;                        ///< [s]
    Vector3 target_;                      ///< [m]
    Vector3 position_;                    ///< [m]
    Vector3 velocity_ = Vector3::Zero();  ///< [m/s]
    Vector3 command_ = Vector3::Zero();   ///< newest force [N]
    std::vector<Vector3> onTheWay_;       ///< one force a substep, a ring as long as the delay
    std::size_t oldest_ = 0;
    double time_ = 0.0;  ///< [s]
    std::int64_t substeps_ = 0;
};

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
