#include "app/window/Stage.h"

#include "app/window/live/LivePanels.h"
#include "core/realtime/PacedThread.h"
#include "ui/shell/WorkInBackground.h"

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace asperity {

namespace {

constexpr double kMaxFrameTime = 0.1;  // that a held key moves the device for [s]

/// Returns whether an entry of a list is being typed, which Esc ends.
bool isTypedInList() {
    const auto* const line = qobject_cast<const QLineEdit*>(QApplication::focusWidget());
    const QWidget* const area = line == nullptr ? nullptr : line->parentWidget();
    return area != nullptr &&
           qobject_cast<const QAbstractItemView*>(area->parentWidget()) != nullptr;
}

}  // namespace

Stage::Stage(Host& host, LivePanels& live)
    : host_(host), live_(live), runs_(host, live), edits_(host, live, runs_) {
    runs_.setSink([this](const TickSample& sample) {
        for (const TickSink& take : takers_) {
            take(sample);
        }
    });
    listCloses_.setSingleShot(true);
    listCloses_.setInterval(0);
    frames_.setTimerType(Qt::PreciseTimer);
    connect(&frames_, &QTimer::timeout, this, &Stage::advance);
}

Stage::~Stage() {
    frames_.stop();
    runs_.end();
    while (!parts_.empty()) {
        parts_.pop_back();
    }
}

void Stage::onFrame(FrameStep step, std::function<void(double elapsed)> act) {
    const auto later = std::ranges::find_if(
        frameSteps_, [step](const auto& present) { return present.first > step; });
    frameSteps_.emplace(later, step, std::move(act));
}

void Stage::play(int period) {
    qApp->installEventFilter(this);
    frames_.start(period);
}

void* Stage::part(std::type_index type) const {
    const auto found = std::ranges::find(parts_, type, [](const auto& part) { return part.first; });
    if (found == parts_.end()) {
        throw std::logic_error(std::string("no such feature was added yet: ") + type.name());
    }
    return found->second.get();
}

bool Stage::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride) {
        if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
            stop();
            return closesList(*event);
        }
    }
    return QObject::eventFilter(watched, event);
}

/// Qt hides an open list as soon as Esc is offered as a shortcut, and then passes the key on to
/// what is below: to the dialog, which would close, or to a shortcut of the window.
/// @return whether the key has done its work
bool Stage::closesList(QEvent& escape) {
    QWidget* const popup = QApplication::activePopupWidget();
    if (popup != nullptr && qobject_cast<QMenu*>(popup) == nullptr) {
        listCloses_.start();
    }
    if (!listCloses_.isActive()) {
        return false;
    }
    escape.accept();
    return popup == nullptr;
}

/// What Esc does beside what the widget with the focus makes of it. The forces of a device with
/// motors go off whatever has the focus: a spin box, a menu, a message.
void Stage::stop() {
    const bool stopsForces = run() != nullptr && run()->device().specification().rendersForce();
    if (stopsForces) {
        runs_.setForces(false);
    }
    const QWidget* const active = QApplication::activeWindow();
    const bool closesTool =
        !stopsForces && active != nullptr && active->windowType() == Qt::Tool;  // by its shortcut
    const bool closesSomething = closesTool || (!stopsForces && host_.escapeCloses()) ||
                                 listCloses_.isActive() || isTypedInList() ||
                                 QApplication::activePopupWidget() != nullptr ||
                                 QApplication::activeModalWidget() != nullptr;
    if (!closesSomething && !live_.leaveTool()) {
        host_.works().cancel();
    }
}

void Stage::advance() {
    const double now = monotonicSeconds();
    const double elapsed = std::min(now - std::exchange(lastFrame_, now), kMaxFrameTime);
    bool areFetched = false;
    for (const auto& [step, act] : frameSteps_) {
        if (run() != nullptr && step > FrameStep::Move && !areFetched) {
            areFetched = true;
            runs_.fetch();
        }
        if (run() != nullptr) {
            act(elapsed);
        }
    }
    host_.menus().refresh();
}

QAction& Feature::addScanTool(QWidget* page, const QString& title, int rank, const char* name,
                              const MenuEntry& entry) {
    host_.addTool(page, title);
    QAction& action = host_.menus().add({MenuName::Measure, 0, rank}, name, entry);
    connect(&action, &QAction::triggered, this, [this, page] { showScanTool(host_, page); });
    return action;
}

Feature::Feature(Stage& stage)
    : stage_(stage)
    , host_(stage.host())
    , live_(stage.live())
    , runs_(stage.runs())
    , edits_(stage.edits()) {}

}  // namespace asperity
