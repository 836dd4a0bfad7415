#pragma once

#include "app/window/Stage.h"
#include "app/window/device/DeviceControl.h"
#include "core/haptics/DevicePath.h"

#include <filesystem>
#include <functional>
#include <string>

namespace asperity {

/// Paths that the device follows: planned ones, those of files, those of recordings.
class PathControl : public Feature {
public:
    explicit PathControl(Stage& stage);

    /// The device follows a path of the base from its start. There is a run.
    void follow(const DevicePath& path);
    /// The same of a path from a CSV file; says in the window why it cannot be followed.
    void followFile(const QString& file);
    /// The device follows the base of a recorded run, too. @param forceLog its table of ticks
    void replayRecording(const std::filesystem::path& forceLog);

private:
    void addEntries();
    void choose(int index);
    void approach(const PlannedApproach& approach);
    using ReadPath = std::function<DevicePath(const std::filesystem::path&)>;
    /// @param whyFar why the path may leave the scan by far
    bool followFile(const QString& file, const ReadPath& read, const std::string& whyFar);

    DeviceControl& devices_;
};

/// Brings the tip to the sample up to the setpoint that the window shows, and away from it.
class EngageControl : public Feature {
    Q_OBJECT

public:
    explicit EngageControl(Stage& stage);

    /// Once a frame: gives the tip back to mouse and keyboard once it has engaged. There is a run.
    void advance();

private:
    void followWithdrawal();
    void engage();
    void withdraw();
    void setSetpoint(double force);
    void showSetpoint();

    DeviceControl& devices_;
    bool engaging_ = false;
    bool withdrawing_ = false;
    double asked_ = 0.0;  ///< setpoint of the present approach [N]
};

}  // namespace asperity
