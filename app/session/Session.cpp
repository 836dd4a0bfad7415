#include "app/session/Session.h"

#include "ui/panels/WorkInBackground.h"
#include "ui/window/MainWindow.h"

#include <QApplication>
#include <QKeyEvent>

#include <algorithm>
#include <utility>

namespace asperity {

namespace {

constexpr double kMaxFrameTime = 0.1;  // that a held key moves the device for [s]

}  // namespace

Session::Session(MainWindow& window, int framePeriod)
    : window_(window)
    , runs_(window)
    , edits_(window, runs_)
    , recordings_(window, runs_)
    , fits_(window, runs_, recordings_)
    , devices_(window, runs_)
    , scenes_(window, runs_, edits_)
    , files_(window, scenes_)
    , reports_(window, runs_)
    , materials_(window, runs_, edits_)
    , probes_(window, runs_, edits_)
    , scenePanel_(window, runs_, edits_)
    , fidelity_(window, runs_, edits_)
    , paths_(window, runs_, devices_)
    , engaging_(window, runs_, devices_, edits_)
    , studies_(window, runs_, devices_, edits_)
    , haptics_(window, runs_, edits_)
    , views_(window, runs_)
    , measuring_(window, runs_, edits_)
    , playback_(window, runs_, scenes_)
    , comparisons_(window, playback_)
    , colors_(window, runs_)
    , messages_(window, runs_)
    , clipboard_(window, runs_, views_)
    , exports_(window, runs_, views_)
    , help_(window)
    , saving_(window, runs_, edits_, scenes_, playback_)
    , bundles_(window, runs_, recordings_, views_)
    , entries_(window, runs_, devices_, edits_) {
    runs_.setSink([this](const TickSample& sample) {
        views_.take(sample);
        measuring_.take(sample);
        recordings_.take(sample);
        studies_.take(sample);
    });
    ForceMapControl& maps = measuring_.forceMaps();
    connect(&maps, &ForceMapControl::layerChanged, this,
            [this, &maps] { colors_.setForceMap(maps.layer()); });
    connect(&maps, &ForceMapControl::layerWanted, this, [this] { colors_.showForceMap(); });
    qApp->installEventFilter(this);
    frames_.setTimerType(Qt::PreciseTimer);
    connect(&frames_, &QTimer::timeout, this, &Session::advance);
    frames_.start(framePeriod);
}

Session::~Session() { runs_.end(); }

void Session::keepIn(const std::filesystem::path& folder) {
    saving_.keepIn(folder);
    files_.recent().leaveOut(folder);
}

bool Session::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride) {
        if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
            stop();
        }
    }
    return QObject::eventFilter(watched, event);
}

/// What Esc does beside what the widget with the focus makes of it. The forces of a device with
/// motors go off whatever has the focus: a spin box, a menu, a message.
void Session::stop() {
    const bool stopsForces = run() != nullptr && run()->device().specification().rendersForce();
    if (stopsForces) {
        runs_.setForces(false);
    }
    const QWidget* const active = QApplication::activeWindow();
    const bool closesTool =
        !stopsForces && active != nullptr && active->windowType() == Qt::Tool;  // by its shortcut
    const bool closesSomething = closesTool || (!stopsForces && window_.isPanelEnlarged()) ||
                                 QApplication::activePopupWidget() != nullptr ||
                                 QApplication::activeModalWidget() != nullptr;
    if (!closesSomething && !measuring_.leaveTool()) {
        window_.works().cancel();
    }
}

void Session::advance() {
    const double now = monotonicSeconds();
    const double elapsed = std::min(now - std::exchange(lastFrame_, now), kMaxFrameTime);
    if (run() != nullptr) {
        devices_.advance(elapsed);
        engaging_.advance();
        studies_.advance();
        runs_.fetch();
        recordings_.advance();
        fits_.advance();
        messages_.advance();
        playback_.advance(elapsed);
        views_.show(now);
        measuring_.show();
        haptics_.show();
    }
    entries_.show();
}

}  // namespace asperity
