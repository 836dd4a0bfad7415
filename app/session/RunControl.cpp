#include "app/session/RunControl.h"

#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/scene/SettingFields.h"
#include "core/words/SceneWords.h"
#include "ui/panels/ControlBar.h"
#include "ui/panels/StateBanner.h"
#include "ui/view/ZoomView.h"
#include "ui/window/MainWindow.h"
#include "ui/window/WindowMenus.h"

#include <QAction>

namespace asperity {

namespace {

/// What the window calls the scene.
QString titleOf(const SampleDescription& sample) {
    const std::filesystem::path file = sample.file;
    return QString::fromStdString(sample.shape ? sampleName(sample)
                                               : printable(file.filename().string()));
}

}  // namespace

RunControl::RunControl(MainWindow& window) : window_(window) {
    ControlBar& controls = window.controls();
    connect(&controls, &ControlBar::runningChosen, this,
            [this](bool running) { running ? start() : pause(); });
    connect(&controls, &ControlBar::forcesChosen, this, &RunControl::setForces);
    const auto resetFault = [this] { turn([](Settings& settings) { ++settings.rearms; }); };
    connect(&window.banner(), &StateBanner::rearmRequested, this, resetFault);
    WindowMenus& menus = window.menus();
    connect(menus.resetFault, &QAction::triggered, this, resetFault);
    connect(menus.forcesOff, &QAction::triggered, this, [this] { setForces(false); });
    connect(menus.startPause, &QAction::triggered, this, [this] {
        if (run_) {
            run_->loop().running() ? pause() : start();
        }
    });
    connect(menus.tipControl, &QAction::triggered, this, [this](bool tip) {
        turn([tip](Settings& settings) {
            settings.positionControl = tip ? PositionControl::Tip : PositionControl::Base;
        });
    });
    connect(menus.clutch, &QAction::triggered, this, [this](bool clutched) {
        turn([clutched](Settings& settings) { settings.clutched = clutched; });
    });
}

void RunControl::use(LoadedScene scene, const std::optional<Vector2>& place) {
    const bool isOnScan = place && scene.scene.surface.contains(place->x(), place->y());
    const Vector3 above = isOnScan ? waitingPlace(scene.scene, *place) : startPlace(scene.scene);
    Settings settings = scene.scene.settings;
    settings.forcesOn = run_ ? forcesMayAct() : window_.controls().forcesOn();
    end();
    begin(std::move(scene), above, settings);
    start();
}

bool RunControl::forcesMayAct() {
    const bool hasFault = run_->loop().snapshot().sample.output.fault != Fault::None;
    return run_->settings().forcesOn && (!hasFault || run_->awaitsDevice());
}

void RunControl::begin(LoadedScene scene, const Vector3& start, const Settings& settings) {
    run_ = std::make_unique<LiveRun>(std::move(scene), start);
    run_->setSettings(settings);
    const QString title = titleOf(run_->scene().description.sample);
    window_.showScene(&run_->scene(), title);
    window_.tell(title);
    showKnobs();
    Q_EMIT begun();
}

void RunControl::replace(LoadedScene scene, const std::optional<Vector2>& place) {
    const bool running = run_->loop().running();
    const Vector2 here = run_->basePosition().head<2>();
    Settings settings = run_->sensingSettings();
    settings.forcesOn = forcesMayAct();
    const Vector3 above = waitingPlace(scene.scene, place.value_or(here));
    rebuild(std::move(scene), above, settings);
    running ? start() : pause();
}

void RunControl::rebuild(LoadedScene scene, const Vector3& start, const Settings& settings) {
    const double halfWidth = window_.view().halfWidth();
    end();
    begin(std::move(scene), start, settings);
    window_.view().setHalfWidth(halfWidth);
    Q_EMIT rebuilt();
}

void RunControl::place(LoadedScene scene, const Vector3& start, const Settings& settings) {
    Settings safe = settings;
    safe.forcesOn = settings.forcesOn && forcesMayAct();
    rebuild(std::move(scene), start, safe);
    this->start();
}

bool RunControl::adoptModel(const LoadedScene& fitted) {
    HapticLoop& loop = run_->loop();
    const bool running = loop.running();
    loop.stop();
    fetch();  // a tick that no frame has shown may have touched the sample, or failed
    const bool adopts = run_->mayAdoptModel();
    if (adopts) {
        run_->adoptModel(fitted);
    }
    if (running) {
        loop.start();
    }
    if (adopts) {
        Q_EMIT modelFitted();
    }
    return adopts;
}

void RunControl::leave() {
    if (run_) {
        run_->loop().stop();
        fetch();
        Q_EMIT ending();
    }
    window_.showScene(nullptr, {});
}

void RunControl::end() {
    leave();
    run_.reset();
}

void RunControl::start() {
    if (run_) {
        run_->loop().start();
        window_.controls().setRunning(true);
        window_.banner().setPaused(false);
        Q_EMIT started();
    }
}

void RunControl::pause() {
    if (run_) {
        run_->loop().stop();
        window_.controls().setRunning(false);
        window_.banner().setPaused(true);
    }
}

void RunControl::turn(const std::function<void(Settings&)>& knobs) {
    if (!run_) {
        return;
    }
    Settings settings = run_->settings();
    knobs(settings);
    QString refusal;
    try {
        checkButtons(settings);
        run_->setSettings(settings);
    } catch (const Error& error) {
        refusal = QString::fromUtf8(error.what());
    }
    showKnobs();
    if (!refusal.isEmpty()) {
        window_.complain(refusal);
    }
}

void RunControl::setForces(bool on) {
    if (on && run_ && forcesStayOff_) {  // off they may always go
        window_.controls().setForcesOn(run_->settings().forcesOn);
        window_.tell(fixedBy_);
        return;
    }
    window_.controls().setForcesOn(on);
    const bool before = run_ && run_->settings().forcesOn;
    turn([on](Settings& settings) { settings.forcesOn = on; });
    if (run_ && run_->settings().forcesOn != before) {
        window_.tell(on ? tr("Forces are on")
                        : tr("Forces are off; the button above switches them on again"));
    }
}

std::vector<TickSample> RunControl::shownTicks() {
    if (recorded_) {
        return {recordedTicks_.begin(), recordedTicks_.end()};
    }
    const auto& last = run_->blackBox().samples();
    return {last.begin(), last.end()};
}

void RunControl::showRecorded(std::span<const TickSample> ticks, bool goesOn) {
    constexpr std::size_t kMost = 10'000;
    if (!goesOn) {
        recordedTicks_.clear();
    }
    recordedTicks_.insert(recordedTicks_.end(), ticks.begin(), ticks.end());
    if (recordedTicks_.size() > kMost) {
        const auto old = static_cast<std::ptrdiff_t>(recordedTicks_.size() - kMost);
        recordedTicks_.erase(recordedTicks_.begin(), recordedTicks_.begin() + old);
    }
    recorded_ = Snapshot{.sample = ticks.back(),
                         .memory = {},
                         .statistics = run_->loop().snapshot().statistics,
                         .trueTip = std::nullopt};
}

void RunControl::showLive() {
    recorded_.reset();
    recordedTicks_.clear();
}

void RunControl::refuseTip(const QString& why) {
    tipRefusal_ = why;
    window_.refuseTip(why);
}

void RunControl::fix(const QString& why) {
    fixedBy_ = why;
    forcesStayOff_ = false;
    window_.fix(why);
}

void RunControl::showKnobs() {
    const Settings& settings = run_->settings();
    ControlBar& controls = window_.controls();
    controls.setForcesOn(settings.forcesOn);
    controls.setKnobs(settings);
    WindowMenus& menus = window_.menus();
    menus.tipControl->setChecked(settings.positionControl == PositionControl::Tip);
    menus.clutch->setChecked(settings.clutched);
    menus.setGuide(settings.guide.kind);
}

}  // namespace asperity
