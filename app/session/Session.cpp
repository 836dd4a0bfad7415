#include "app/session/Session.h"

#include "app/program/DataFolder.h"
#include "app/session/PathChecks.h"
#include "core/Error.h"
#include "core/PathText.h"
#include "core/PrintableText.h"
#include "core/io/scene/HandPathFile.h"
#include "core/io/scene/SceneFile.h"
#include "ui/HeldKeys.h"
#include "ui/panels/ControlBar.h"
#include "ui/panels/OverviewPanel.h"
#include "ui/panels/StateBanner.h"
#include "ui/view/ContactShape.h"
#include "ui/view/ZoomView.h"
#include "ui/window/MainWindow.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>

#include <algorithm>
#include <utility>

namespace asperity {

namespace {

constexpr int kFramePeriod = 25;       // [ms]
constexpr double kLongestFrame = 0.1;  // that a held key moves the hand for [s]

}  // namespace

Session::Session(MainWindow& window)
    : window_(window)
    , show_(window)
    , keys_(new HeldKeys(&window.view()))
    , recordings_(standardRecordingsFolder()) {
    fillChoices();
    connectControls();
    connectMenus();
    connectHandMenu();
    connectViews();
    connectLoader();
    connectFidelity();
    qApp->installEventFilter(this);
    frames_.setTimerType(Qt::PreciseTimer);
    connect(&frames_, &QTimer::timeout, this, &Session::onFrame);
    frames_.start(kFramePeriod);
}

Session::~Session() { endRun(); }

// Forces go off whatever has the focus: a spin box, a menu, a message.
bool Session::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride) {
        if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
            setForces(false);
            cancelOpen();
        }
    }
    return QObject::eventFilter(watched, event);
}

void Session::fillChoices() {
    ControlBar& controls = window_.controls();
    controls.setHands({tr("Mouse and keyboard"), tr("Scripted path"), tr("SpaceMouse"),
                       tr("Simulated device"), tr("WoodenHaptics")});
    controls.setPaths({tr("Approach"), tr("Raster"), tr("Scratch")});
    for (const std::filesystem::path& file : dataFiles("materials")) {
        try {
            SceneDescription scene = defaultScene();
            scene.sample.material = readMaterialFile(file);
            scene.truth.material = scene.sample.material;
            checkScene(scene);
            materials_.push_back(scene.sample.material);
        } catch (const Error& error) {
            window_.tell(QString::fromUtf8(error.what()));
        }
    }
}

void Session::connectControls() {
    ControlBar& controls = window_.controls();
    connect(&controls, &ControlBar::runningChosen, this,
            [this](bool running) { running ? start() : pause(); });
    connect(&controls, &ControlBar::forcesChosen, this, &Session::setForces);
    connect(&controls, &ControlBar::materialChosen, this, &Session::chooseMaterial);
    connect(&controls, &ControlBar::handChosen, this, &Session::chooseHand);
    connect(&controls, &ControlBar::pathChosen, this, &Session::choosePath);
    connect(&controls, &ControlBar::knobTurned, this, &Session::turnKnob);
    connect(&controls, &ControlBar::recordingChosen, this, &Session::record);
    connect(&window_.banner(), &StateBanner::rearmRequested, this, &Session::takeBackFault);
}

void Session::connectMenus() {
    WindowMenus& menus = window_.menus();
    connect(menus.startPause, &QAction::triggered, this, [this] {
        if (run_) {
            run_->loop().running() ? pause() : start();
        }
    });
    connect(menus.forcesOff, &QAction::triggered, this, [this] { setForces(false); });
    connect(menus.takeBackFault, &QAction::triggered, this, &Session::takeBackFault);
    connect(menus.record, &QAction::triggered, this, &Session::record);
    connect(menus.saveLastSeconds, &QAction::triggered, this, [this] {
        if (run_) {
            fetchTicks();
            run_->blackBox().freeze();
        }
    });
    connect(&window_, &MainWindow::openRequested, this, [this](const QString& file) {
        const std::string text = file.toStdString();
        open(pathFromText(text).value_or(text));
    });
    connect(&window_, &MainWindow::pathFileChosen, this,
            [this](const QString& file) { followFile(file, readHandPath); });
    connect(&window_, &MainWindow::recordingChosen, this,
            [this](const QString& file) { repeatRecording(file.toStdString()); });
    connect(&window_, &MainWindow::pictureFileChosen, this, &Session::savePicture);
}

void Session::use(LoadedScene scene) {
    const Vector3 place = startPlace(scene.scene);
    Settings settings = scene.scene.settings;
    settings.forcesOn = !run_ || forcesMayAct();
    begin(std::move(scene), place, settings);
    start();
}

bool Session::forcesMayAct() {
    return run_->settings().forcesOn && run_->loop().snapshot().sample.output.fault == Fault::None;
}

void Session::begin(LoadedScene scene, const Vector3& start, const Settings& settings) {
    endRun();
    run_ = std::make_unique<LiveRun>(std::move(scene), start);
    run_->setSettings(settings);
    hand_.attach(*run_);
    const SampleDescription& sample = run_->scene().description.sample;
    const std::filesystem::path file = sample.file;
    const QString name = QString::fromStdString(sample.shape ? sampleName(sample)
                                                             : printable(file.filename().string()));
    window_.showScene(&run_->scene(), name);
    window_.tell(name);
    showKnobs();
    showFidelity();
    Q_EMIT sceneShown();
}

void Session::showKnobs() {
    const SampleMaterial& own = run_->scene().description.sample.material;
    if (std::find(materials_.begin(), materials_.end(), own) == materials_.end()) {
        materials_.push_back(own);
    }
    QStringList names;
    for (const SampleMaterial& material : materials_) {
        names.push_back(QString::fromStdString(material.name).replace('_', ' '));
    }
    ControlBar& controls = window_.controls();
    controls.setMaterials(names);
    controls.setMaterial(static_cast<int>(std::find(materials_.begin(), materials_.end(), own) -
                                          materials_.begin()));
    showHand();
}

void Session::endRun() {
    saveRun();
    window_.showScene(nullptr, {});
    hand_.detach();
    run_.reset();
}

void Session::start() {
    if (run_) {
        run_->loop().start();
        window_.controls().setRunning(true);
        window_.banner().setPaused(false);
    }
}

void Session::pause() {
    if (run_) {
        run_->loop().stop();
        window_.controls().setRunning(false);
        window_.banner().setPaused(true);
    }
}

void Session::changeSettings(const std::function<void(Settings&)>& change) {
    if (run_) {
        Settings settings = run_->settings();
        change(settings);
        QString refusal;
        try {
            run_->setSettings(settings);
        } catch (const Error& error) {
            refusal = QString::fromUtf8(error.what());
        }
        showHand();  // a knob that is refused goes back
        if (!refusal.isEmpty()) {
            window_.complain(refusal);
        }
    }
}

void Session::setForces(bool on) {
    window_.controls().setForcesOn(on);
    changeSettings([on](Settings& settings) { settings.forcesOn = on; });
}

void Session::takeBackFault() {
    changeSettings([](Settings& settings) { ++settings.rearms; });
}

void Session::chooseMaterial(int index) {
    if (!run_) {
        return;
    }
    const SampleMaterial& material = materials_.at(static_cast<std::size_t>(index));
    SceneDescription changed = run_->scene().description;
    changed.sample.material = material;
    try {
        requireHolding(changed);
    } catch (const Error& error) {
        window_.complain(QString::fromUtf8(error.what()));
        showKnobs();
        return;
    }
    rebuild([&material](LoadedScene scene) { return withMaterial(std::move(scene), material); });
}

void Session::rebuild(const std::function<LoadedScene(LoadedScene)>& change) {
    const bool running = run_->loop().running();
    const double halfWidth = window_.view().halfWidth();
    const Vector2 place = run_->basePosition().head<2>();
    Settings settings = run_->sensingSettings();
    settings.forcesOn = forcesMayAct();
    const LedDevice device = ledDevice();
    saveRun();
    window_.showScene(nullptr, {});
    hand_.detach();
    LoadedScene scene = change(LiveRun::release(std::move(run_)));
    const Vector3 start = waitingPlace(scene.scene, place);
    begin(std::move(scene), start, settings);
    window_.view().setHalfWidth(halfWidth);
    takeUp(device);
    running ? this->start() : pause();
}

void Session::onFrame() {
    const double now = monotonicSeconds();
    const double elapsed = std::min(now - std::exchange(lastFrame_, now), kLongestFrame);
    if (run_) {
        moveHand(elapsed);
        followDelay();
        fetchTicks();
        saveLastSeconds();
        tellOfRecovered();
        if (!run_->loop().running()) {
            show_.rest();
        }
        show_.setEnergyGiven(run_->energy().active());
        const Snapshot& latest = run_->loop().snapshot();
        solveHalfSpace(latest);
        show_.show(latest, now);
        if (recording_ && recording_->end() != RecordingEnd::None) {
            finishRecording();
        }
    }
}

/// The frame shows the newest solution there is; the one it asks for is for a frame to come.
void Session::solveHalfSpace(const Snapshot& latest) {
    HalfSpaceWorker* const worker = run_->halfSpace();
    if (worker != nullptr && latest.statistics.ticks > 0 &&
        isDrawable(latest.sample.output.model)) {
        worker->ask(latest.sample.output.model);
        show_.setHalfSpace(worker->newest());
    }
}

void Session::fetchTicks() {
    run_->fetch([this](const TickSample& sample) {
        show_.take(sample);
        if (recording_ && sample.time > recordedAfter_) {
            recording_->take(sample);
        }
    });
}

}  // namespace asperity
