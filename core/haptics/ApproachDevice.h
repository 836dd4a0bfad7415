#pragma once

#include "core/haptics/DevicePath.h"
#include "core/haptics/PlannedApproach.h"
#include "core/haptics/device/HapticDevice.h"

#include <atomic>

namespace asperity {

/// A device that approaches the sample until the estimated force reaches a setpoint. It knows the
/// force of the tick before; what it makes of it is a device position as any other, so that a
/// recording of it replays without it.
class ApproachDevice final : public HapticDevice {
public:
    /// For a run that begins with it.
    /// @param positionGain base displacement per device displacement while the device runs
    ApproachDevice(const PlannedApproach& approach, double positionGain);
    /// For a device that takes over from another one.
    /// @param leadIn of the base, from where it is to where the approach starts, world [m]
    /// @param start  where that device is, in the device's frame, while the base is where `leadIn`
    ///               begins
    ApproachDevice(DevicePath leadIn, const ApproachPlan& plan, double positionGain, Vector3 start);

    [[nodiscard]] DeviceSpecification specification() const noexcept override {
        return kSensesOnly;
    }
    DeviceState advance(double timeStep) noexcept override;
    void observe(const TickOutput& output) noexcept override;

    /// Any thread; wait-free.
    [[nodiscard]] ApproachPhase phase() const noexcept { return phase_; }
    /// Whether the force has reached the setpoint. Any thread; wait-free.
    [[nodiscard]] bool hasEngaged() const noexcept { return engaged_; }
    /// Whether the descent ended where the tip had no equilibrium. Any thread; wait-free.
    [[nodiscard]] bool isBlocked() const noexcept { return blocked_; }
    /// Whether the force of the dwell has been measured. Any thread; wait-free.
    [[nodiscard]] bool hasMeasured() const noexcept { return measured_; }
    /// That force above the baseline, along z [N]. Any thread; wait-free.
    [[nodiscard]] double measuredForce() const noexcept { return measuredForce_; }
    /// Its standard deviation by noise [N]. Any thread; wait-free.
    [[nodiscard]] double measuredDeviation() const noexcept { return measuredDeviation_; }

private:
    [[nodiscard]] Vector3 nextBase(double timeStep) noexcept;

    DevicePath leadIn_;
    SetpointApproach approach_;
    double positionGain_;
    Vector3 start_;               ///< of the device [m]
    double time_ = 0.0;           ///< along the lead-in [s]
    double force_ = 0.0;          ///< of the last tick, along z [N]
    bool hasEquilibrium_ = true;  ///< whether the tip had one in the last tick
    bool started_ = false;        ///< the first step only begins
    std::atomic<ApproachPhase> phase_ = ApproachPhase::Baseline;
    std::atomic<bool> engaged_ = false;
    std::atomic<bool> blocked_ = false;
    std::atomic<bool> measured_ = false;
    std::atomic<double> measuredForce_ = 0.0;
    std::atomic<double> measuredDeviation_ = 0.0;
};

}  // namespace asperity
