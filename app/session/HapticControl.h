#pragma once

#include "app/session/RunControl.h"
#include "app/session/SceneEdits.h"

namespace asperity {

/// The page that shows all knobs of the haptics with device, force, energy and loop, and turns
/// them.
class HapticControl : public QObject {
    Q_OBJECT

public:
    HapticControl(MainWindow& window, RunControl& runs, SceneEdits& edits);

    /// Once a frame. There is a run.
    void show();

private:
    void turn(const QString& column, double value);
    void setRate(double rate);
    void showRate();
    void showDevice(LiveRun& run);

    MainWindow& window_;
    RunControl& runs_;
    SceneEdits& edits_;
    Settings shown_;
    int frame_ = 0;  ///< since the readings were shown
};

}  // namespace asperity
