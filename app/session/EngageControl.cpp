#include "app/session/EngageControl.h"

#include "core/words/BudgetWords.h"
#include "ui/NumberText.h"
#include "ui/panels/EngageBar.h"
#include "ui/panels/ReadingBudget.h"
#include "ui/window/MainWindow.h"

namespace asperity {

namespace {

/// How an approach ended. One step may carry the tip past the setpoint, by a jump or on a stiff
/// sample: the force is the one that was there.
QString wordsOn(const Scene& scene, const ApproachDevice& approach, const QString& setpoint) {
    if (approach.hasEngaged()) {
        const Budget force =
            shownForce(&scene, approach.measuredForce(), approach.measuredDeviation());
        return QObject::tr("Engaged at %1 (setpoint %2)")
            .arg(QString::fromStdString(budgetText(force, "N")), setpoint);
    }
    return approach.isBlocked()
               ? QObject::tr("Not engaged: no equilibrium of tip and cantilever below here")
               : QObject::tr("Not engaged: the force did not reach %1").arg(setpoint);
}

}  // namespace

EngageControl::EngageControl(MainWindow& window, RunControl& runs, DeviceControl& devices,
                             SceneEdits& edits)
    : window_(window), runs_(runs), devices_(devices), edits_(edits) {
    EngageBar& bar = window.engage();
    connect(&bar, &EngageBar::engageChosen, this, &EngageControl::engage);
    connect(&bar, &EngageBar::withdrawChosen, this, &EngageControl::withdraw);
    connect(&bar, &EngageBar::setpointChanged, this, &EngageControl::setSetpoint);
    connect(&runs, &RunControl::ending, this, [this] { engaging_ = withdrawing_ = false; });
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
        withdrawing_ = false;
    }
}

void EngageControl::withdraw() {
    if (runs_.run() != nullptr) {
        engaging_ = false;
        withdrawing_ = true;
        devices_.withdraw();
        window_.tell(tr("Withdrawing"));
    }
}

void EngageControl::followWithdrawal() {
    if (!withdrawing_ || devices_.isTraveling()) {
        return;
    }
    withdrawing_ = false;
    const TipRegion region = runs_.run()->loop().snapshot().sample.output.region();
    window_.tell(region == TipRegion::Far ? tr("Withdrawn")
                                          : tr("Not withdrawn: the tip was taken by hand"));
}

void EngageControl::advance() {
    followWithdrawal();
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
    const bool isMeasured = phase == ApproachPhase::Dwell && approach->hasMeasured();
    if (isMeasured || phase == ApproachPhase::Done) {
        engaging_ = false;
        const QString words = wordsOn(runs_.run()->scene(), *approach, siText(asked_, "N"));
        devices_.releaseApproach();  // and with it the approach ends
        window_.tell(words);
    }
}

}  // namespace asperity
