#pragma once

#include "app/runs/LiveRun.h"
#include "core/haptics/ApproachDevice.h"
#include "core/haptics/DevicePilot.h"
#include "hardware/driver/DeviceDriver.h"
#include "hardware/hid/HidapiTransport.h"

#include <functional>
#include <optional>

namespace asperity {

/// Which device moves the tip of a run, and what the user does with mouse and keyboard meanwhile.
/// Displacements and velocities are those of the device.
class ActiveDevice {
public:
    /// A new run begins with mouse and keyboard. `run` outlives its use here.
    void attach(LiveRun& run);
    void detach() { run_ = nullptr; }

    /// A device takes the tip; the present device stays where that one cannot have it.
    /// @throw Error why it cannot: no way to HID devices at all, or no scale at which it holds
    void use(const DeviceDriver& driver);
    /// Goes to where the path begins, well above the sample, and follows it.
    void follow(const DevicePath& path);

    /// Goes to where the approach begins, well above the sample, and approaches.
    void approach(const PlannedApproach& approach);
    /// Approaches where the base is, from right above the sample, and stays at the setpoint.
    void engage(double setpoint);
    /// The approach that has the tip; null: none has.
    [[nodiscard]] const ApproachDevice* approaching() const {
        return isOurs() ? approach_ : nullptr;
    }

    /// Of the device that has the tip; null: a path has it, or a device that was taken elsewhere.
    [[nodiscard]] const DeviceDriver* driver() const { return isOurs() ? driver_ : nullptr; }
    [[nodiscard]] bool followsPath() const { return isOurs() && driver_ == nullptr; }
    /// Whether it is hardware: a device whose axes are not those of the screen.
    [[nodiscard]] bool isHardware() const;

    /// What mouse and keyboard do; nothing while a device has the tip that they do not pilot, or
    /// the run pauses. A device's handle is moved so far that its tip goes this way.
    void displace(const Vector3& displacement);
    /// Moves the tip up and down by steps that grow with its distance from the sample.
    /// @param fineStep one notch near the sample, displacement as of displace() [m]
    void lift(double notches, double fineStep);
    void setVelocity(const Vector3& velocity);
    void travelTo(const Vector2& place);
    /// Returns whether the tip still moves to the place of travelTo() or along pilotAlong().
    [[nodiscard]] bool isTraveling() const { return pilot_.traveling(); }
    /// In the place of mouse and keyboard: pilots the base along a path, as well as the device can.
    void pilotAlong(const DevicePath& path) { pilot_.follow(path); }

    /// Moves the device on by a frame. @param halfWidth of the view: the scale of what is seen [m]
    void advance(double seconds, double halfWidth);

private:
    void take(const DeviceDriver* driver, const LiveRun::MakeDevice& make);
    /// The way to HID devices. @throw Error when there is none
    [[nodiscard]] HidTransport& hid();
    /// Whether the run has the device that it got here.
    [[nodiscard]] bool isOurs() const { return run_ != nullptr && device_ == &run_->device(); }
    /// The device that mouse and keyboard pilot here; null: none, or the run pauses.
    [[nodiscard]] PilotedDevice* piloted() const;
    /// Device displacement per displacement that mouse and keyboard ask for.
    [[nodiscard]] double reach() const;
    /// From the present place of the base to the start of a path.
    [[nodiscard]] DevicePath leadIn(const Vector3& start);
    using MakeLeadIn = std::function<DevicePath()>;
    /// @param makeLeadIn is called while the loop rests
    void approachBy(const MakeLeadIn& makeLeadIn, const ApproachPlan& plan);
    /// Of the tip that mouse and keyboard pilot, above first contact where they send it [m].
    [[nodiscard]] double pilotedHeight() const;

    LiveRun* run_ = nullptr;
    std::optional<HidapiTransport> transport_;
    DevicePilot pilot_{Vector3::Zero()};        ///< where mouse and keyboard pilot it
    const HapticDevice* device_ = nullptr;      ///< that was taken last; only compared
    const DeviceDriver* driver_ = nullptr;      ///< its own; null: it follows a path
    const ApproachDevice* approach_ = nullptr;  ///< it as an approach; null: it is none
};

}  // namespace asperity
