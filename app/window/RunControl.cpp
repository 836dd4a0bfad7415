#include "app/window/RunControl.h"

#include "app/window/live/ControlBar.h"
#include "app/window/live/LivePanels.h"
#include "app/window/live/StateBanner.h"
#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/io/TextValue.h"
#include "core/scene/SettingFields.h"
#include "core/words/SceneWords.h"
#include "ui/shell/Host.h"
#include "ui/shell/Menus.h"
#include "ui/view/ContactPlot.h"
#include "ui/view/SecondView.h"
#include "ui/view/ZoomView.h"

#include <QAction>
#include <QStandardPaths>

#include <algorithm>

namespace asperity {

namespace {

/// Returns the name of the scene in the window's title.
QString titleOf(const SampleDescription& sample) {
    const std::filesystem::path file = sample.file;
    return QString::fromStdString(sample.shape ? sampleName(sample)
                                               : printable(file.filename().string()));
}

/// Two surfaces with the same key are the same piece of a sample, whatever was done to its heights.
std::string scanKey(const Scene& scene) {
    const BSplineSurface::Grid& grid = scene.surface.grid();
    return sampleName(scene.description.sample) + " " + exactText(grid.pitchX) + " " +
           exactText(grid.pitchY) + " " + std::to_string(grid.columns) + " " +
           std::to_string(grid.rows);
}

}  // namespace

RunControl::RunControl(Host& host, LivePanels& live) : host_(host), live_(live) {
    ControlBar& controls = live_.controls();
    connect(&controls, &ControlBar::runningChosen, this,
            [this](bool running) { running ? start() : pause(); });
    connect(&controls, &ControlBar::forcesChosen, this, &RunControl::setForces);
    connect(&live_.banner(), &StateBanner::rearmRequested, this, &RunControl::resetFault);
    addEntries();
}

void RunControl::addEntries() {
    Menus& menus = host_.menus();
    const auto changes = [this] { return changeRefusal(); };
    QAction& startPause = menus.add({MenuName::Run, 0, 10}, "startPause",
                                    {.text = tr("Start or &pause"),
                                     .tip = tr("Start the run, or pause it"),
                                     .shortcuts = {tr("Space")},
                                     .refusal = changes});
    forcesOff_ =
        &menus.add({MenuName::Run, 0, 20}, "forcesOff",
                   {.text = tr("&Forces off"), .tip = tr("Switch the forces on the device off")});
    const QAction& reset = menus.add(
        {MenuName::Run, 0, 30}, "resetFault",
        {.text = tr("Reset fa&ult"),
         .tip = tr("Reset the fault: forces act again"),
         .refusal = [this] {
             const bool isFaulty =
                 run_ != nullptr && run_->loop().snapshot().sample.output.fault != Fault::None;
             return isFaulty ? QString() : tr("There is no fault to reset");
         }});
    tipControl_ = &menus.add({MenuName::Device, 0, 10}, "tipControl",
                             {.text = tr("&Tip position control"),
                              .tip = tr("The device commands the tip: the expected deflection is "
                                        "added to the base"),
                              .isCheckable = true,
                              .refusal = changes});
    clutch_ = &menus.add({MenuName::Device, 0, 20}, "clutch",
                         {.text = tr("&Clutch"),
                          .tip = tr("Move the device while the tip stays; the force ramps up "
                                    "again afterwards"),
                          .shortcuts = {tr("C")},
                          .isCheckable = true,
                          .refusal = changes});
    for (QAction* const action : {&startPause, forcesOff_}) {
        action->setShortcutContext(Qt::ApplicationShortcut);
    }
    connect(&reset, &QAction::triggered, this, &RunControl::resetFault);
    connect(forcesOff_, &QAction::triggered, this, [this] { setForces(false); });
    connect(&startPause, &QAction::triggered, this, [this] {
        if (run_) {
            run_->loop().running() ? pause() : start();
        }
    });
    connect(tipControl_, &QAction::triggered, this, [this](bool tip) {
        turn([tip](Settings& settings) {
            settings.positionControl = tip ? PositionControl::Tip : PositionControl::Base;
        });
    });
    connect(clutch_, &QAction::triggered, this, [this](bool clutched) {
        turn([clutched](Settings& settings) { settings.clutched = clutched; });
    });
}

void RunControl::resetFault() {
    turn([](Settings& settings) { ++settings.rearms; });
}

QString RunControl::showRefusal() const {
    return run_ != nullptr ? QString() : tr("Open a scan or a scene first");
}

QString RunControl::changeRefusal() const { return run_ != nullptr ? fixedBy_ : showRefusal(); }

QString RunControl::moveRefusal() const {
    const QString fixed = changeRefusal();
    return fixed.isEmpty() ? tipRefusal_ : fixed;
}

void RunControl::setEmergencyStop(bool active) {
    forcesOff_->setShortcut(active ? QKeySequence(Qt::Key_Escape) : QKeySequence());
    live_.setEmergencyStop(active);
}

void RunControl::use(LoadedScene scene, const std::optional<Vector2>& tip) {
    const bool isOnScan = tip && scene.scene.surface.contains(tip->x(), tip->y());
    const Vector3 above =
        isOnScan ? waitingPosition(scene.scene, *tip) : startPosition(scene.scene);
    Settings settings = scene.scene.settings;
    settings.forcesOn = run_ ? forcesMayAct() : live_.controls().forcesOn();
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
    const std::string scan = scanKey(run_->scene());
    isOnOtherScan_ = std::exchange(scan_, scan) != scan;
    const QString title = titleOf(run_->scene().description.sample);
    live_.showScene(&run_->scene(), title);
    host_.tell(title);
    showKnobs();
    Q_EMIT begun();
}

void RunControl::replace(LoadedScene scene, const std::optional<Vector2>& tip) {
    const bool running = run_->loop().running();
    const Vector2 here = run_->basePosition().head<2>();
    Settings settings = run_->sensingSettings();
    settings.forcesOn = forcesMayAct();
    const Vector3 above = waitingPosition(scene.scene, tip.value_or(here));
    rebuild(std::move(scene), above, settings);
    running ? start() : pause();
}

void RunControl::rebuild(LoadedScene scene, const Vector3& start, const Settings& settings) {
    const double halfWidth = live_.view().halfWidth();
    ContactPlot& section = live_.second().section();
    const std::optional<double> sectionHalfWidth = section.chosenHalfWidth();
    end();
    begin(std::move(scene), start, settings);
    live_.view().setHalfWidth(halfWidth);
    if (sectionHalfWidth) {
        section.setHalfWidth(*sectionHalfWidth);
    }
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
        leaveRecording();
        run_->loop().stop();
        fetch();
        Q_EMIT ending();
    }
    live_.showScene(nullptr, {});
}

void RunControl::end() {
    leave();
    run_.reset();
}

void RunControl::start() {
    if (run_) {
        leaveRecording();
        run_->loop().start();
        live_.controls().setRunning(true);
        live_.banner().setPaused(false);
        Q_EMIT started();
    }
}

void RunControl::pause() {
    if (run_) {
        run_->loop().stop();
        live_.controls().setRunning(false);
        live_.banner().setPaused(true);
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
        host_.complain(refusal);
    }
}

void RunControl::setForces(bool on) {
    if (on && run_ && forcesStayOff_) {  // off they may always go
        live_.controls().setForcesOn(run_->settings().forcesOn);
        host_.tell(fixedBy_);
        return;
    }
    live_.controls().setForcesOn(on);
    const bool before = run_ && run_->settings().forcesOn;
    turn([on](Settings& settings) { settings.forcesOn = on; });
    if (run_ && run_->settings().forcesOn != before) {
        host_.tell(on ? tr("Forces are on")
                      : tr("Forces are off; the button above switches them on again"));
    }
}

void RunControl::fetch() {
    run_->fetch([this](const TickSample& sample) {
        steady_.take(sample);
        sink_(sample);
    });
}

const Snapshot& RunControl::shown() {
    if (recording_) {
        return recording_->snapshot(run_->loop().snapshot().statistics);
    }
    latest_ = run_->loop().snapshot();
    steady_.apply(latest_.sample.output);
    return latest_;
}

std::vector<TickSample> RunControl::shownTicks() {
    if (recording_) {
        return recording_->ticks();
    }
    const auto& last = run_->blackBox().samples();
    return {last.begin(), last.end()};
}

void RunControl::showRecording(std::shared_ptr<const LoadedScene> loaded,
                               const std::filesystem::path& input, const TickSample& first) {
    const bool wasRunning = recording_ ? wasRunning_ : run_->loop().running();
    leaveRecording();
    wasRunning_ = wasRunning;
    pause();
    fetch();
    isOnOtherScan_ = scanKey(loaded->scene) != scan_;
    for (auto setAside = setAsides_.rbegin(); setAside != setAsides_.rend(); ++setAside) {
        putBacks_.insert(putBacks_.begin(), (*setAside)());
    }
    Q_EMIT sceneLeaving();
    recording_.emplace(std::move(loaded), input, first);
    if (recording_->loaded() != run_->shared()) {
        live_.showScene(&scene(), titleOf(scene().description.sample));
    }
    refuseTip(tr("A recording is shown: go back to the live tip first"));
    Q_EMIT recordingShown();
}

void RunControl::showRecorded(std::span<const TickSample> ticks, bool goesOn) {
    recording_->take(ticks, goesOn);
}

void RunControl::leaveRecording() {
    if (!recording_) {
        return;
    }
    Q_EMIT sceneLeaving();
    // The panels have its scene until they have another one.
    const std::optional<ShownRecording> left = std::exchange(recording_, std::nullopt);
    const QString title = titleOf(run_->scene().description.sample);
    if (left->loaded() == run_->shared()) {
        host_.setTitle(title);
    } else {
        live_.showScene(&run_->scene(), title);
    }
    refuseTip({});
    Q_EMIT liveShown();
    for (const auto& putBack : std::exchange(putBacks_, {})) {
        putBack();
    }
}

void RunControl::showLive() {
    if (recording_) {
        leaveRecording();
        if (wasRunning_) {
            start();
        }
    }
}

void RunControl::refuseTip(const QString& why) {
    tipRefusal_ = why;
    live_.refuseTip(why);
}

void RunControl::fix(const QString& why) {
    fixedBy_ = why;
    forcesStayOff_ = false;
    live_.fix(why);
    Q_EMIT changesAllowed(why.isEmpty());
}

void RunControl::showKnobs() {
    const Settings& settings = run_->settings();
    ControlBar& controls = live_.controls();
    controls.setForcesOn(settings.forcesOn);
    controls.setKnobs(settings);
    tipControl_->setChecked(settings.positionControl == PositionControl::Tip);
    clutch_->setChecked(settings.clutched);
    Q_EMIT knobsShown();
}

std::filesystem::path userFolder() {
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return std::filesystem::path(documents.toStdString()) / "Asperity";
}

}  // namespace asperity
