#include "app/session/EngageControl.h"

#include "core/SiFormat.h"
#include "ui/panels/EngageBar.h"
#include "ui/window/MainWindow.h"

namespace asperity {

EngageControl::EngageControl(MainWindow& window, RunControl& runs, DeviceControl& devices)
    : window_(window), runs_(runs), devices_(devices) {
    EngageBar& bar = window.engage();
    connect(&bar, &EngageBar::engageChosen, this, &EngageControl::engage);
    connect(&bar, &EngageBar::withdrawChosen, this, &EngageControl::withdraw);
    connect(&runs, &RunControl::ending, this, [this, &bar] {
        engaging_ = false;
        setpoint_ = bar.setpoint();
    });
    connect(&runs, &RunControl::begun, this,
            [&runs, &bar] { bar.setSetpoint(runs.run()->scene().description.setpoint); });
    // The same scene changed: the user's setpoint stays.
    connect(&runs, &RunControl::rebuilt, this, [this, &bar] { bar.setSetpoint(setpoint_); });
}

void EngageControl::engage() {
    if (runs_.run() != nullptr) {
        asked_ = window_.engage().setpoint();
        devices_.engage(asked_);
        engaging_ = true;
    }
}

void EngageControl::withdraw() {
    if (runs_.run() != nullptr) {
        engaging_ = false;
        devices_.withdraw();
        window_.tell(tr("Withdrawing"));
    }
}

void EngageControl::advance() {
    window_.engage().setRefusal(runs_.run()->coupling().coupled() != nullptr
                                    ? tr("The operator approaches with the force-feedback device")
                                    : QString());
    const ApproachDevice* const approach = devices_.approaching();
    if (!engaging_ || approach == nullptr) {
        engaging_ = false;
        return;
    }
    const ApproachPhase phase = approach->phase();
    if (phase == ApproachPhase::Dwell || phase == ApproachPhase::Done) {
        engaging_ = false;
        devices_.releaseApproach();
        const QString words = phase == ApproachPhase::Dwell
                                  ? tr("Engaged at %1")
                                  : tr("Not engaged: the force did not reach %1");
        window_.tell(words.arg(QString::fromStdString(formatSi(asked_, "N"))));
    }
}

}  // namespace asperity
