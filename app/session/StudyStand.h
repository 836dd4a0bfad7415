#pragma once

#include "app/session/RunControl.h"
#include "core/haptics/coupling/ScaleGuard.h"
#include "ui/view/ViewOptions.h"

#include <memory>

namespace asperity {

/// What the window showed before a study, to be shown again after it.
class StudyStand {
public:
    /// There is a run; both outlive this.
    StudyStand(MainWindow& window, RunControl& runs);

    /// The scene with its knobs, device and view are there again, the tip waits above its place.
    void restore() const;

private:
    MainWindow& window_;
    RunControl& runs_;
    std::shared_ptr<const LoadedScene> scene_;
    Vector2 place_;  ///< of the base [m]
    Settings settings_;
    DeviceScale scale_;
    ViewOptions options_;
    bool hasSecondView_;
    double halfWidth_;  ///< of the large view [m]
    double azimuth_;    ///< likewise, see ViewCamera [rad]
    double elevation_;  ///< [rad]
};

}  // namespace asperity
