#include "app/window/device/EngageControl.h"

#include "app/window/live/EngageBar.h"
#include "app/window/live/LivePanels.h"
#include "core/words/BudgetWords.h"
#include "core/words/SceneWords.h"
#include "ui/widgets/ReadingBudget.h"
#include "ui/widgets/ShownText.h"

#include <cmath>
#include <utility>

namespace asperity {

namespace {

constexpr double kErrorPeriod = 0.25;  // over which a shown error is taken [s]

/// Returns how an approach ended. One step may carry the tip past the setpoint, by a jump or on a
/// stiff sample: the force is the one that was there.
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

/// Returns the units in which a setpoint can be typed on the scene's probe.
std::vector<SetpointUnit> setpointUnits(const Scene& scene) {
    const double deflection = shownDeflectionPerForce(scene.belief.cantilever);
    std::vector<SetpointUnit> units{{QStringLiteral("nN"), 1e9},
                                    {QStringLiteral("nm"), 1e9 * deflection}};
    const std::optional<double> invOls = scene.description.detector.invOls;
    units.push_back(invOls ? SetpointUnit{QStringLiteral("V"), deflection / *invOls}
                           : SetpointUnit{QStringLiteral("V"), 0.0,
                                          QObject::tr("The probe gives no sensitivity of the "
                                                      "detector (Scene page, InvOLS)")});
    return units;
}

}  // namespace

EngageControl::EngageControl(Stage& stage) : Feature(stage), devices_(stage.get<DeviceControl>()) {
    stage.onTick([this](const TickSample& sample) { take(sample); });
    stage.onFrame(FrameStep::Move, [this](double /*elapsed*/) { advance(); });
    EngageBar& bar = live_.engage();
    connect(&bar, &EngageBar::engageChosen, this, [this] {
        if (runs_.run() != nullptr) {
            engage(live_.engage().setpoint(), runs_.run()->basePosition().head<2>());
        }
    });
    connect(&bar, &EngageBar::withdrawChosen, this, &EngageControl::withdraw);
    connect(&bar, &EngageBar::setpointChanged, this, &EngageControl::setSetpoint);
    connect(&bar, &EngageBar::holdChosen, this, &EngageControl::chooseHold);
    connect(&devices_, &DeviceControl::heightWanted, this, &EngageControl::holdHeight);
    connect(&runs_, &RunControl::ending, this, &EngageControl::forget);
    connect(&runs_, &RunControl::begun, this, &EngageControl::showSetpoint);
    // The tip of the new run waits above the sample.
    connect(&runs_, &RunControl::rebuilt, this, [this] {
        if (std::exchange(wasHeld_, false) && holdRefusal().isEmpty()) {
            engage(live_.engage().setpoint(), runs_.run()->basePosition().head<2>());
        }
    });
    connect(&edits_, &SceneEdits::changed, this, &EngageControl::showSetpoint);
    connect(&runs_, &RunControl::recordingShown, this, [this] { live_.engage().showError({}); });
}

void EngageControl::forget() {
    engaging_ = withdrawing_ = false;
    freeForce_ = 0.0;
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
    if (runs_.showsRecording()) {  // its setpoint is not that of the run
        return;
    }
    if (const SceneDescription* const scene = edits_.wanted()) {
        live_.engage().setSetpoint(scene->setpoint);
        holdSetpoint();
    }
    if (LiveRun* const run = runs_.run()) {
        live_.engage().setUnits(setpointUnits(run->scene()));
        live_.engage().setUsualRamp(
            usualRamp(run->scene(), run->basePosition().head<2>(), live_.engage().setpoint()));
    }
}

/// Another force is held within another range. A path has a load of its own.
void EngageControl::holdSetpoint() {
    const FeedbackDevice* const feedback = devices_.feedback();
    if (feedback != nullptr && !devices_.followsPath() &&
        feedback->setpoint() != live_.engage().setpoint()) {
        hold();
    }
}

void EngageControl::engage(double setpoint, const Vector2& position) {
    asked_ = setpoint;
    devices_.engage(asked_, position, live_.engage().ramp());
    engaging_ = true;
    withdrawing_ = false;
}

void EngageControl::withdraw() {
    if (runs_.run() != nullptr) {
        engaging_ = false;
        withdrawing_ = true;
        devices_.withdraw(live_.engage().ramp());
        host_.tell(tr("Withdrawing"));
    }
}

HeldForce EngageControl::held(double setpoint) const {
    return {.setpoint = setpoint, .freeForce = freeForce_, .gain = gain_};
}

void EngageControl::setGain(double gain) {
    gain_ = gain;
    if (FeedbackDevice* const feedback = devices_.feedback()) {
        feedback->hold(feedback->setpoint(), gain_);
    }
}

QString EngageControl::holdRefusal() const {
    if (runs_.run()->coupling().coupled() != nullptr) {
        return tr("The operator holds the tip with the force-feedback device");
    }
    return runs_.run()->settings().positionControl == PositionControl::Tip
               ? tr("Tip position control holds the height of the tip: switch it off to hold a "
                    "force (Device menu)")
               : QString();
}

void EngageControl::hold() { devices_.hold(held(live_.engage().setpoint())); }

void EngageControl::chooseHold(bool force) {
    if (runs_.run() == nullptr) {
        return;
    }
    if (!force) {
        holdHeight();
        return;
    }
    if (const QString why = holdRefusal(); !why.isEmpty()) {
        live_.engage().setHoldsForce(false);
        host_.tell(why);
        return;
    }
    const TipRegion region = runs_.run()->loop().snapshot().sample.output.region();
    if (region == TipRegion::Far) {
        host_.tell(tr("The force will be held once the tip has engaged"));
    } else if (!devices_.followsPath()) {
        hold();
    }
}

void EngageControl::holdHeight() {
    live_.engage().setHoldsForce(false);
    if (devices_.feedback() != nullptr) {
        devices_.release();
        host_.tell(tr("The height is held: the force follows from it (Hold: force holds the force "
                      "again)"));
    }
}

void EngageControl::followWithdrawal() {
    if (!withdrawing_ || devices_.isTraveling()) {
        return;
    }
    withdrawing_ = false;
    const TipRegion region = runs_.run()->loop().snapshot().sample.output.region();
    host_.tell(region == TipRegion::Far ? tr("Withdrawn")
                                        : tr("Not withdrawn: the tip was taken by hand"));
}

void EngageControl::followApproach() {
    const ApproachDevice* const approach = devices_.approaching();
    if (!engaging_ || approach == nullptr) {
        engaging_ = false;
        return;
    }
    const ApproachPhase phase = approach->phase();
    const bool isMeasured = phase == ApproachPhase::Dwell && approach->hasMeasured();
    if (!isMeasured && phase != ApproachPhase::Done) {
        return;
    }
    engaging_ = false;
    const QString words = wordsOn(runs_.run()->scene(), *approach, siText(asked_, "N"));
    if (!isMeasured) {
        devices_.release();
        host_.tell(words);
        Q_EMIT failed();
        return;
    }
    freeForce_ = approach->freeForce();
    const QString whyNot = holdRefusal();
    if (live_.engage().holdsForce() && whyNot.isEmpty()) {
        hold();  // the setpoint may be another one by now
    } else {
        devices_.release();
    }
    host_.tell(words);
    Q_EMIT engaged();
}

void EngageControl::take(const TickSample& sample) {
    const FeedbackDevice* const feedback = devices_.feedback();
    if (feedback == nullptr) {
        errorTime_ = squares_ = 0.0;
        errorCount_ = 0;
        return;
    }
    const double error = feedback->errorOf(sample.output);
    squares_ += error * error;
    errorTime_ += sample.input.timeStep;
    ++errorCount_;
}

void EngageControl::followHold() {
    const FeedbackDevice* const feedback = devices_.feedback();
    wasHeld_ = feedback != nullptr;
    if (feedback == nullptr) {
        live_.engage().showError({});
        state_ = FeedbackState::Holding;
        return;
    }
    if (const QString why = holdRefusal(); !why.isEmpty()) {
        holdHeight();
        host_.tell(why);
        return;
    }
    if (errorTime_ >= kErrorPeriod) {
        const double rms = std::sqrt(squares_ / static_cast<double>(errorCount_));
        live_.engage().showError(QStringLiteral("± ") + siText(rms, "N"));
        errorTime_ = squares_ = 0.0;
        errorCount_ = 0;
    }
    const FeedbackState state = feedback->state();
    if (state == std::exchange(state_, state) || state == FeedbackState::Holding) {
        return;
    }
    host_.tell(state == FeedbackState::ContactLost
                   ? tr("Contact lost: the tip descends until it finds the sample")
                   : tr("End of the z range: the force cannot be held here"));
}

void EngageControl::advance() {
    followWithdrawal();
    const QString hidden = runs_.tipRefusal();
    const bool isCoupled = runs_.run()->coupling().coupled() != nullptr;
    live_.engage().setRefusals(hidden.isEmpty() && isCoupled
                                   ? tr("The operator approaches with the force-feedback device")
                                   : hidden,
                               hidden);
    followApproach();
    followHold();
}

}  // namespace asperity
