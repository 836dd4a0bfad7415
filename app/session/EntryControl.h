#pragma once

#include "app/session/DeviceControl.h"
#include "app/session/RunControl.h"
#include "app/session/SceneEdits.h"

namespace asperity {

/// Which entries of the menus can work now: the others are disabled, and their tool tips say why.
class EntryControl {
public:
    /// @param window, runs, devices, edits outlive this
    EntryControl(MainWindow& window, const RunControl& runs, const DeviceControl& devices,
                 const SceneEdits& edits);

    /// Once a frame.
    void show();

private:
    void showThoseOfARun();
    void showThoseOfADevice();
    void showThoseOfTheScene();

    MainWindow& window_;
    const RunControl& runs_;
    const DeviceControl& devices_;
    const SceneEdits& edits_;
};

}  // namespace asperity
