#pragma once

#include "app/session/ActiveDevice.h"
#include "app/session/RunControl.h"

#include <string>
#include <vector>

namespace asperity {

class HeldKeys;

/// Which device has the tip, as the window shows and a user chooses it, and what mouse, keys and
/// the Device menu do meanwhile.
class DeviceControl : public QObject {
    Q_OBJECT

public:
    DeviceControl(MainWindow& window, RunControl& runs);

    /// The device follows a path of the base from its start. There is a run.
    void follow(const DevicePath& path);
    /// The device approaches, from where the approach begins. There is a run.
    void approach(const PlannedApproach& approach);
    /// Approaches where the tip is, up to a setpoint [N], and stays there. There is a run.
    void engage(double setpoint);
    /// Goes up from the sample, out of its reach. There is a run.
    void withdraw();
    /// Returns whether the tip still moves by itself: after withdraw() or a click on the overview.
    [[nodiscard]] bool isTraveling() const { return device_.isTraveling(); }
    /// The approach that has the tip; null: none has.
    [[nodiscard]] const ApproachDevice* approaching() const { return device_.approaching(); }
    /// Mouse and keyboard take the tip where an approach has it.
    void releaseApproach();
    /// A user pilots the simulated device along a path of the base from its start. There is a run.
    void pilotDevice(const DevicePath& path);
    /// Once a frame, before its ticks: moves the device on [s]. There is a run.
    void advance(double seconds);
    /// Whether a device has the tip whose axes are not those of the screen.
    [[nodiscard]] bool hasHardware() const { return device_.isHardware(); }
    /// Of the device that has the tip; null: a path has it.
    [[nodiscard]] const DeviceDriver* driver() const { return device_.driver(); }

Q_SIGNALS:
    /// The user wants the device to follow a path.
    void pathWanted();

private:
    void attach();
    /// Notes which device drives the tip, for the same scene changed.
    void detach();
    void takeUp();
    void choose(int index);
    void use(const DeviceDriver& driver);
    void travelTo(const Vector2& place);
    void turnKnob(const QString& column, double value);
    void chooseGuide(FixtureKind kind);
    /// Turns the axes of a device with the view, where that is wanted.
    void turnAxes(double seconds);
    void followDelay();
    void show();
    void tell();

    MainWindow& window_;
    RunControl& runs_;
    ActiveDevice device_;
    HeldKeys* keys_;
    std::vector<const DeviceDriver*> list_;  ///< as the window shows it; null: a path
    std::string told_;                       ///< last words on the device
    const DeviceDriver* before_ = nullptr;   ///< of the last one; null: none
    DeviceScale scaleBefore_;
};

}  // namespace asperity
