#include "app/window/device/DemonstrationControl.h"

#include "app/window/live/EngageBar.h"
#include "app/window/live/LivePanels.h"
#include "ui/shell/Menus.h"

#include <QAction>
#include <QApplication>
#include <QEvent>

#include <utility>

namespace asperity {

namespace {

constexpr double kAway = 1.5;       // out of the sample's reach between two cycles [s]
constexpr double kInContact = 2.0;  // at the setpoint [s]

bool isUsers(const QEvent& event) {
    switch (event.type()) {
    case QEvent::MouseButtonPress:
    case QEvent::Wheel:
    case QEvent::KeyPress:
    case QEvent::ShortcutOverride:  // all that is known of a key that is a shortcut
    case QEvent::TouchBegin:
        return true;
    default:
        return false;
    }
}

}  // namespace

DemonstrationControl::DemonstrationControl(Stage& stage)
    : Feature(stage), devices_(stage.get<DeviceControl>()), engaging_(stage.get<EngageControl>()) {
    atStart_ = &host_.menus().add(
        {MenuName::Help, 0, 15}, "demonstrationAtStart",
        {.text = tr("&Demonstration at the start"),
         .tip = tr("Without a file or a session, the program opens a polystyrene scene and moves "
                   "the tip by itself until mouse or keyboard take over"),
         .isCheckable = true,
         .keptAs = QStringLiteral("demonstration/atStart")});
    atStart_->setChecked(true);
    connect(&runs_, &RunControl::begun, this, [this] {
        end();
        if (std::exchange(isWanted_, false) && atStart_->isChecked()) {
            begin();
        }
    });
    connect(&runs_, &RunControl::ending, this, &DemonstrationControl::end);
    connect(&engaging_, &EngageControl::engaged, this, [this] { go(Step::InContact); });
    connect(&engaging_, &EngageControl::failed, this, &DemonstrationControl::end);
    stage.onFrame(FrameStep::Act, [this](double elapsed) { advance(elapsed); });
}

void DemonstrationControl::beginWithNextRun() {
    isWanted_ = true;
    QApplication::instance()->installEventFilter(this);
}

void DemonstrationControl::begin() {
    isPlaying_ = true;
    QApplication::instance()->installEventFilter(this);
    live_.setDemonstration(true);
    go(Step::Away);
}

/// An approach ends where the tip is; a withdrawal goes on to its end, out of harm's way.
void DemonstrationControl::end() {
    QApplication::instance()->removeEventFilter(this);
    if (!std::exchange(isPlaying_, false)) {
        return;
    }
    live_.setDemonstration(false);
    if (engaging_.isEngaging()) {
        devices_.release();
    }
}

bool DemonstrationControl::eventFilter(QObject* watched, QEvent* event) {
    if (watched->isWidgetType() && isUsers(*event)) {
        isWanted_ = false;
        end();
    }
    return Feature::eventFilter(watched, event);
}

void DemonstrationControl::go(Step step) {
    step_ = step;
    inStep_ = 0.0;
}

/// An operator's hand is never moved, and a path or a recording has the tip for itself.
bool DemonstrationControl::mayGoOn() const {
    return runs_.tipRefusal().isEmpty() && runs_.fixedBy().isEmpty() &&
           !runs_.run()->device().specification().rendersForce();
}

void DemonstrationControl::advance(double elapsed) {
    if (!isPlaying_) {
        return;
    }
    if (!mayGoOn()) {
        end();
        return;
    }
    if (!runs_.run()->loop().running()) {
        return;
    }
    inStep_ += elapsed;
    const Vector2 here = runs_.run()->basePosition().head<2>();
    switch (step_) {
    case Step::Away:
        if (inStep_ >= kAway) {
            go(Step::Approaching);
            engaging_.engage(live_.engage().setpoint(), here);
        }
        break;
    case Step::InContact:
        if (inStep_ >= kInContact) {
            go(Step::Withdrawing);
            engaging_.withdraw();
        }
        break;
    case Step::Withdrawing:
        if (!devices_.isTraveling()) {
            go(Step::Away);
        }
        break;
    case Step::Approaching:
        break;
    }
}

}  // namespace asperity
