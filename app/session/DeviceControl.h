#pragma once

#include "app/session/ActiveDevice.h"
#include "app/session/RunControl.h"

#include <string>
#include <vector>

namespace asperity {

class HeldKeys;

/// Which device has the tip, as the window shows and a person chooses it, and what mouse, keys and
/// the Hand menu do meanwhile.
class DeviceControl : public QObject {
    Q_OBJECT

public:
    DeviceControl(MainWindow& window, RunControl& runs);

    /// The device follows a path of the base from its start. There is a run.
    void follow(const DevicePath& path);
    /// A person at the simulated device leads the base along a path from its start. There is a run.
    void leadDevice(const DevicePath& path);
    /// Once a frame, before its ticks: moves the device on [s]. There is a run.
    void advance(double seconds);

Q_SIGNALS:
    /// The person wants the device to follow a path.
    void pathWanted();

private:
    void attach();
    /// Notes which device leads, for the same scene changed.
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
    std::string told_;                       ///< what the device said last
    const DeviceDriver* before_ = nullptr;   ///< of the device that led last; null: none did
    DeviceScale scaleBefore_;
};

}  // namespace asperity
