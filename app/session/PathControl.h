#pragma once

#include "app/session/DeviceControl.h"
#include "core/haptics/DevicePath.h"

#include <filesystem>
#include <functional>
#include <string>

namespace asperity {

/// Which paths the device follows: planned ones, those of files, those of recordings.
class PathControl : public QObject {
public:
    PathControl(MainWindow& window, RunControl& runs, DeviceControl& devices);

    /// The device follows a path of the base from its start. There is a run.
    void follow(const DevicePath& path);

private:
    void choose(int index);
    void approach(const PlannedApproach& approach);
    using ReadPath = std::function<DevicePath(const std::filesystem::path&)>;
    /// @param whyFar why the path may leave the scan by far
    bool followFile(const QString& file, const ReadPath& read, const std::string& whyFar);
    void replayRecording(const std::filesystem::path& forceLog);

    MainWindow& window_;
    RunControl& runs_;
    DeviceControl& devices_;
};

}  // namespace asperity
