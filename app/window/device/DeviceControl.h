#pragma once

#include "app/runs/LiveRun.h"
#include "app/window/Stage.h"
#include "app/window/live/EngageBar.h"
#include "core/haptics/DevicePath.h"
#include "core/haptics/SetpointApproach.h"
#include "core/haptics/ZFeedback.h"
#include "hardware/driver/DeviceDriver.h"
#include "hardware/hid/HidapiTransport.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

class QAction;

namespace asperity {

class HeldKeys;

/// Returns the ramp to a setpoint [N] that takes about four seconds on a scene, with its way back.
[[nodiscard]] Ramp usualRamp(const Scene& scene, const Vector2& position, double setpoint);

/// Force that a feedback holds.
struct HeldForce {
    double setpoint = 0.0;               ///< [N]
    double freeForce = 0.0;              ///< measured far from the sample [N]
    double gain = kDefaultFeedbackGain;  ///< of the feedback
};

/// The device that moves the tip of a run, with mouse and keyboard as the user's other means.
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
    /// @return time on the way to its start [s]
    double follow(const DevicePath& path);

    /// Goes to where the approach begins, well above the sample, and approaches.
    void approach(const PlannedApproach& approach);
    /// Approaches there (x, y) [m], from right above the sample, and stays at the setpoint.
    void engage(double setpoint, const Vector2& position, const Ramp& ramp);
    /// Rises straight up, out of the sample's reach.
    void rise(const Ramp& ramp);
    /// The approach that has the tip; null: none has.
    [[nodiscard]] const ApproachDevice* approaching() const {
        return isOurs() ? approach_ : nullptr;
    }
    /// Makes a path that begins where the base is [m].
    using MakePath = std::function<DevicePath(const Vector3& base)>;
    /// Follows a path from where the base is.
    void followFromHere(const MakePath& makePath);
    /// A feedback takes the tip's height, mouse and keyboard the rest.
    void hold(const HeldForce& force) { hold(force, nullptr); }
    /// The same with a path from where the base is; null: mouse and keyboard.
    void hold(const HeldForce& force, const MakePath& makePath);
    /// The feedback that holds the force; null: none does.
    [[nodiscard]] FeedbackDevice* feedback() const { return isOurs() ? feedback_ : nullptr; }

    /// Returns the driver that has the tip; null: a path has it, or a device taken elsewhere.
    [[nodiscard]] const DeviceDriver* driver() const { return isOurs() ? driver_ : nullptr; }
    [[nodiscard]] bool followsPath() const { return isOurs() && driver_ == nullptr; }
    /// Returns whether it is hardware: a device whose axes are not those of the screen.
    [[nodiscard]] bool isHardware() const;

    /// Moves the tip as mouse and keyboard ask, a device's handle as far as that takes. Nothing
    /// moves while the run pauses, or a device has the tip that they do not pilot.
    void displace(const Vector3& displacement);
    /// Moves the tip up and down by steps that grow with its distance from the sample.
    /// @param fineStep one notch near the sample, displacement as of displace() [m]
    void lift(double notches, double fineStep);
    void setVelocity(const Vector3& velocity);
    void travelTo(const Vector2& position);
    /// Returns whether the tip still moves to the goal of travelTo() or along pilotAlong().
    [[nodiscard]] bool isTraveling() const { return pilot_.traveling(); }
    /// Instead of mouse and keyboard: pilots the base along a path, as well as the device can.
    void pilotAlong(const DevicePath& path) { pilot_.follow(path); }

    /// Moves the device on by a frame. @param halfWidth of the view: the scale of what is seen [m]
    void advance(double seconds, double halfWidth);

private:
    void take(const DeviceDriver* driver, const LiveRun::MakeDevice& make);
    /// The way to HID devices. @throw Error when there is none
    [[nodiscard]] HidTransport& hid();
    /// Returns whether the run has the device that was taken here.
    [[nodiscard]] bool isOurs() const { return run_ != nullptr && device_ == &run_->device(); }
    /// The device that mouse and keyboard pilot here; null: none, or the run pauses.
    [[nodiscard]] PilotedDevice* piloted() const;
    /// Device displacement per displacement that mouse and keyboard ask for.
    [[nodiscard]] double reach() const;
    /// Returns the path from where the base is to the start of another one.
    [[nodiscard]] DevicePath leadIn(const Vector3& start);
    using MakeLeadIn = std::function<DevicePath()>;
    /// @param makeLeadIn is called while the loop rests
    void approachBy(const MakeLeadIn& makeLeadIn, const ApproachPlan& plan);
    /// Returns the height above first contact to which mouse and keyboard pilot the tip [m].
    [[nodiscard]] double pilotedHeight() const;

    LiveRun* run_ = nullptr;
    std::optional<HidapiTransport> transport_;
    DevicePilot pilot_{Vector3::Zero()};        ///< where mouse and keyboard pilot it
    const HapticDevice* device_ = nullptr;      ///< that was taken last; only compared
    const DeviceDriver* driver_ = nullptr;      ///< its own; null: it follows a path
    const ApproachDevice* approach_ = nullptr;  ///< it as an approach; null: it is none
    FeedbackDevice* feedback_ = nullptr;        ///< it as a feedback; null: it is none
};

/// Choice of the device that has the tip, with what mouse, keys and the Device menu do.
class DeviceControl : public Feature {
    Q_OBJECT

public:
    explicit DeviceControl(Stage& stage);

    /// The device follows a path of the base from its start. There is a run.
    /// @return time on the way there [s]
    double follow(const DevicePath& path);
    /// The device approaches, from where the approach begins. There is a run.
    void approach(const PlannedApproach& approach);
    /// Approaches there (x, y) [m], up to a setpoint [N], and stays there. There is a run.
    void engage(double setpoint, const Vector2& position, const Ramp& ramp);
    /// Goes up from the sample, out of its reach. There is a run.
    void withdraw(const Ramp& ramp);
    /// Returns whether the tip still moves by itself: after withdraw() or a click on the overview.
    [[nodiscard]] bool isTraveling() const { return device_.isTraveling(); }
    /// The approach that has the tip; null: none has.
    [[nodiscard]] const ApproachDevice* approaching() const { return device_.approaching(); }
    /// Mouse and keyboard take the tip where an approach, a path or a feedback has it; its height
    /// stays.
    void release();
    /// A feedback takes the tip's height, mouse and keyboard the rest. There is a run.
    void hold(const HeldForce& force);
    /// The same with a path from where the base is. There is a run.
    void hold(const HeldForce& force, const ActiveDevice::MakePath& makePath);
    /// The device follows a path from where the base is. There is a run.
    void followFromHere(const ActiveDevice::MakePath& makePath);
    /// The feedback that holds the force; null: none does.
    [[nodiscard]] FeedbackDevice* feedback() const { return device_.feedback(); }
    /// Returns whether the device follows a path, an approach included.
    [[nodiscard]] bool followsPath() const { return device_.followsPath(); }
    /// A user pilots the simulated device along a path of the base from its start. There is a run.
    void pilotDevice(const DevicePath& path);
    /// Once a frame, before its ticks: moves the device on [s]. There is a run.
    void advance(double seconds);
    /// Returns whether a device has the tip whose axes are not those of the screen.
    [[nodiscard]] bool hasHardware() const { return device_.isHardware(); }
    /// Returns the driver of the device that has the tip; null: a path has it.
    [[nodiscard]] const DeviceDriver* driver() const { return device_.driver(); }

Q_SIGNALS:
    /// The user wants the device to follow a path.
    void pathWanted();
    /// The user moves the tip up or down while a feedback holds it.
    void heightWanted();

private:
    void addEntries();
    void addGuides();
    [[nodiscard]] QString guideRefusal() const;
    void attach();
    /// Notes which device drives the tip, for the same scene changed.
    void detach();
    void takeUp();
    void choose(int index);
    void use(const DeviceDriver& driver);
    void travelTo(const Vector2& position);
    void lift(double notches);
    void turnKnob(const QString& column, double value);
    void chooseGuide(FixtureKind kind);
    /// Turns the axes of a device with the view, where that is wanted.
    void turnAxes(double seconds);
    void followDelay();
    /// Returns why the position gain cannot be turned; empty: it can.
    [[nodiscard]] QString gainRefusal() const;
    void show();
    void tell();

    ActiveDevice device_;
    HeldKeys* keys_;
    QAction* followsView_ = nullptr;
    std::map<FixtureKind, QAction*> guides_;
    std::vector<const DeviceDriver*> list_;  ///< as the window shows it; null: a path
    std::string told_;                       ///< last words on the device
    const DeviceDriver* before_ = nullptr;   ///< of the last one; null: none
    DeviceScale scaleBefore_;
};

}  // namespace asperity
