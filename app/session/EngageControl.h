#pragma once

#include "app/session/DeviceControl.h"

namespace asperity {

/// Brings the tip to the sample up to the setpoint that the window shows, and away from it.
class EngageControl : public QObject {
    Q_OBJECT

public:
    EngageControl(MainWindow& window, RunControl& runs, DeviceControl& devices);

    /// Once a frame: gives the tip back to mouse and keyboard once it has engaged. There is a run.
    void advance();

private:
    void engage();
    void withdraw();

    MainWindow& window_;
    RunControl& runs_;
    DeviceControl& devices_;
    bool engaging_ = false;
    double asked_ = 0.0;     ///< setpoint of the present approach [N]
    double setpoint_ = 0.0;  ///< that the window showed when the last run ended [N]
};

}  // namespace asperity
