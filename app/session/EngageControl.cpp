#include "app/session/EngageControl.h"

#include "ui/NumberText.h"
#include "ui/panels/EngageBar.h"
#include "ui/window/MainWindow.h"

namespace asperity {

EngageControl::EngageControl(MainWindow& window, RunControl& runs, DeviceControl& devices,
                             SceneEdits& edits)
    : window_(window), runs_(runs), devices_(devices), edits_(edits) {
    EngageBar& bar = window.engage();
    connect(&bar, &EngageBar::engageChosen, this, &EngageControl::engage);
    connect(&bar, &EngageBar::withdrawChosen, this, &EngageControl::withdraw);
    connect(&bar, &EngageBar::setpointChanged, this, &EngageControl::setSetpoint);
    connect(&runs, &RunControl::ending, this, [this] { engaging_ = false; });
    connect(&runs, &RunControl::begun, this, &EngageControl::showSetpoint);
    connect(&edits, &SceneEdits::changed, this, &EngageControl::showSetpoint);
}

void EngageControl::setSetpoint(double force) {
    if (const SceneDescription* const now = edits_.wanted()) {
        SceneDescription next = *now;
        next.setpoint = force;
        edits_.change(tr("Setpoint: %1").arg(siText(force, "N")), next,
                      QStringLiteral("setpoint_n"));
    }
}

void EngageControl::showSetpoint() {
    if (const SceneDescription* const scene = edits_.wanted()) {
        window_.engage().setSetpoint(scene->setpoint);
    }
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
    const QString hidden = runs_.tipRefusal();
    const bool isCoupled = runs_.run()->coupling().coupled() != nullptr;
    window_.engage().setRefusals(hidden.isEmpty() && isCoupled
                                     ? tr("The operator approaches with the force-feedback device")
                                     : hidden,
                                 hidden);
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
        window_.tell(words.arg(siText(asked_, "N")));
    }
}

}  // namespace asperity
