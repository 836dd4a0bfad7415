#pragma once

#include "app/session/DeviceControl.h"
#include "app/session/SceneEdits.h"

namespace asperity {

/// Brings the tip to the sample up to the setpoint that the window shows, and away from it.
class EngageControl : public QObject {
    Q_OBJECT

public:
    EngageControl(MainWindow& window, RunControl& runs, DeviceControl& devices, SceneEdits& edits);

    /// Once a frame: gives the tip back to mouse and keyboard once it has engaged. There is a run.
    void advance();

private:
    void followWithdrawal();
    void engage();
    void withdraw();
    void setSetpoint(double force);
    void showSetpoint();

    MainWindow& window_;
    RunControl& runs_;
    DeviceControl& devices_;
    SceneEdits& edits_;
    bool engaging_ = false;
    bool withdrawing_ = false;
    double asked_ = 0.0;  ///< setpoint of the present approach [N]
};

}  // namespace asperity
