#pragma once

#include "app/session/BackgroundWork.h"
#include "app/session/RunControl.h"

#include <optional>

namespace asperity {

class MainWindow;
class RecordingControl;

/// Finds out, beside a run that has begun with every term, what its scene requires of its model,
/// and gives the run the model of these terms once the tip feels nothing. So it does where the
/// setpoint is another than the one on which the terms were judged. A recording has one model from
/// its begin to its end.
class ModelFitControl : public QObject {
    Q_OBJECT

public:
    ModelFitControl(MainWindow& window, RunControl& runs, const RecordingControl& recordings);

    /// Once a frame. There is a run.
    void advance();

private:
    void begin();

    RunControl& runs_;
    const RecordingControl& recordings_;
    double setpoint_ = 0.0;              ///< for which terms are, or have been, judged [N]
    std::optional<LoadedScene> fitted_;  ///< that the run is to have
    BackgroundWork<LoadedScene> work_;
};

}  // namespace asperity
