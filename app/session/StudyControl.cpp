#include "app/session/StudyControl.h"

#include "app/session/StudyWords.h"
#include "core/Error.h"
#include "core/experiment/TrialRun.h"
#include "ui/CoreWords.h"
#include "ui/experiment/StudyForm.h"
#include "ui/experiment/TrialPanel.h"
#include "ui/panels/OverviewMap.h"
#include "ui/panels/OverviewPanel.h"
#include "ui/view/ZoomView.h"
#include "ui/window/MainWindow.h"
#include "ui/window/SecondView.h"
#include "ui/window/ViewOptionsMenu.h"
#include "ui/window/WindowLayout.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QStackedWidget>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace asperity {

namespace {

constexpr double kTurn = std::numbers::pi / 12.0;  // of the view, a step [rad]
constexpr double kRoom = 1.3;  // of the view, in distances of the farthest target

StudyForm* newForm(QStackedWidget& page) {
    auto* form = new StudyForm(&page);
    page.addWidget(form);
    return form;
}

/// Wide enough that start and target of every trial are seen.
double halfWidthFor(const Study& study, double usual) {
    double farthest = 0.0;
    for (const Vector2& target : study.targets) {
        farthest = std::max(farthest, target.cwiseAbs().maxCoeff());
    }
    return std::max(usual, kRoom * farthest);
}

}  // namespace

StudyControl::StudyControl(MainWindow& window, RunControl& runs, DeviceControl& devices,
                           SceneEdits& edits)
    : window_(window)
    , runs_(runs)
    , devices_(devices)
    , edits_(edits)
    , page_(new QStackedWidget(&window))
    , panel_(new TrialPanel(page_))
    , results_(window)
    , choice_(window, *newForm(*page_), results_) {
    page_->addWidget(panel_);
    page_->setToolTip(tr("Positioning experiments with people"));
    window.addTool(page_, tr("Study"));
    window.overview().map().addTool(mark_);
    connect(window.menus().study, &QAction::triggered, this, &StudyControl::open);
    connect(window.menus().trial, &QAction::triggered, this, &StudyControl::press);
    connect(&choice_, &StudyChoice::opened, this, &StudyControl::begin);
    connect(panel_, &TrialPanel::actionChosen, this, &StudyControl::press);
    connect(panel_, &TrialPanel::strikeOutChosen, this, &StudyControl::strikeOut);
    connect(panel_, &TrialPanel::pauseChosen, this, &StudyControl::pause);
    connect(panel_, &TrialPanel::leaveChosen, this, &StudyControl::leave);
    connect(panel_, &TrialPanel::turnChosen, this, &StudyControl::turnView);
    connect(panel_, &TrialPanel::resultsChosen, this,
            [this] { results_.show([study = study_](const auto& read) { read(study->folder); }); });
    connect(&runs, &RunControl::ending, this, &StudyControl::drop);
    show();
}

void StudyControl::open() {
    if (study_ == nullptr) {
        choice_.show();
    }
    window_.showTool(page_);
    window_.layout().showCards();  // the whole scan is there, where the target is marked
}

void StudyControl::begin(const std::shared_ptr<OpenStudy>& study) {
    if (runs_.run() == nullptr || study_ != nullptr) {
        return;
    }
    edits_.cancel();  // what is on its way would take the place of a trial
    study_ = study;
    before_.emplace(window_, runs_);
    runs_.fix(tr("A study is under way: it fixes scene and knobs; leave it first"));
    fixViews();
    panel_->forgetResult();
    if (study->person.isNew() && study->study.training > 0.0) {
        plan_ = *study->person.next();
        placeTrial();
        turnKnobs(false);
        trainingEnds_ = monotonicSeconds() + study->study.training;
        phase_ = StudyPhase::Training;
    } else {
        makeReady();
    }
    window_.view().setHalfWidth(halfWidthFor(study->study, window_.view().halfWidth()));
    driver_ = devices_.driver();
    window_.view().setFocus();
    show();
}

/// They draw what the study allows: the second view always draws the deformation.
void StudyControl::fixViews() {
    ViewOptions options = window_.menus().viewOptions().options();
    options.deformation = study_->study.aids.deformation;
    options.trueTip = false;
    window_.menus().viewOptions().setOptions(options);
    window_.view().setOptions(options);
    if (!options.deformation) {
        window_.menus().secondView->setChecked(false);
    }
}

void StudyControl::press() {
    switch (phase_) {
    case StudyPhase::Ready:
        beginTrial();
        break;
    case StudyPhase::Trial:
        endTrial({});
        break;
    case StudyPhase::Training:
    case StudyPhase::Result:
    case StudyPhase::Paused:
        makeReady();
        break;
    case StudyPhase::Finished:
        leave();
        break;
    case StudyPhase::Choosing:
        break;
    }
    show();
}

/// The next trial waits for the button, with the tip at its start.
void StudyControl::makeReady() {
    const std::optional<PlannedTrial> next = study_->person.next();
    if (!next) {
        phase_ = StudyPhase::Finished;
        showTarget(std::nullopt);
        return;
    }
    plan_ = *next;
    placeTrial();
    turnKnobs(true);
    refusal_.clear();
    phase_ = StudyPhase::Ready;
}

void StudyControl::placeTrial() {
    LoadedScene scene = study_->scenes.of(plan_.material, plan_.lever);
    places_ = placesOf(study_->study, scene.scene, plan_);
    // Its scale is for devices in millimeters; one that only senses has the scene's.
    const Settings& own = study_->study.scene.settings;
    scene.scene.description.settings.positionGain = own.positionGain;
    scene.scene.description.settings.forceGain = own.forceGain;
    scene.scene.settings.positionGain = own.positionGain;
    scene.scene.settings.forceGain = own.forceGain;
    const Settings settings = scene.scene.settings;
    runs_.place(std::move(scene), places_.start, settings);
    showTarget(places_.target);
}

void StudyControl::turnKnobs(bool clutched) {
    const Study& study = study_->study;
    const bool isCoupled = runs_.run()->coupling().coupled() != nullptr;
    runs_.turn([&](Settings& settings) {
        settings.clutched = clutched;
        settings.forcesOn = study.aids.forces;
        if (isCoupled) {
            settings.positionGain = study.scale.positionGain;
            settings.forceGain = study.scale.forceGain;
            settings.guide.kind = study.aids.guide;
            settings.guide.point = places_.target;
            settings.guide.axis = Vector3::UnitZ();
        }
    });
}

QString StudyControl::refusal() const {
    const LiveRun& run = *runs_.run();
    const Settings& settings = run.settings();
    const Study& study = study_->study;
    const Snapshot& latest = runs_.run()->loop().snapshot();
    const Fault fault = latest.sample.output.fault;
    if (latest.statistics.ticks == 0) {
        return tr("The tip is on its way to the start: press once more.");
    }
    if (results_.isBusy()) {
        return tr("The results are being drawn.");
    }
    if (fault != Fault::None) {
        return tr("%1: reset the fault first.").arg(coreWords(nameOf(fault)));
    }
    if (devices_.driver() != driver_) {
        return tr("The device is another one than at the beginning: leave the study, choose the "
                  "device, and go on.");
    }
    if (run.coupling().coupled() != nullptr && (settings.positionGain != study.scale.positionGain ||
                                                settings.forceGain != study.scale.forceGain)) {
        return tr("The device cannot be held at the study's scale.");
    }
    return {};
}

void StudyControl::beginTrial() {
    refusal_ = refusal();
    if (!refusal_.isEmpty()) {
        return;
    }
    try {
        turnKnobs(false);
        runs_.fetch();  // those before the trial belong to nobody
        recording_ = std::make_unique<RunRecording>(
            RecordingPlace{.folder = study_->folder.begin(plan_)}, *runs_.run());
        trial_.emplace(plan_, places_.target, runs_.run()->loop().snapshot());
        isPressed_ = false;
        phase_ = StudyPhase::Trial;
    } catch (const std::exception& error) {
        drop();
        window_.complain(QString::fromUtf8(error.what()));
    }
}

void StudyControl::take(const TickSample& sample) {
    const bool isDown = sample.input.device.holds(sample.input.settings.trialButton);
    isPressed_ = isPressed_ || (isDown && !buttonWasDown_);
    buttonWasDown_ = isDown;
    if (trial_) {
        trial_->take(sample);
        recording_->take(sample);
    }
}

void StudyControl::advance() {
    if (study_ == nullptr) {
        return;
    }
    if (trial_) {
        watchTrial();
    }
    if (std::exchange(isPressed_, false)) {
        press();
    }
    if (phase_ == StudyPhase::Training && monotonicSeconds() >= trainingEnds_) {
        press();
    }
    if (std::exchange(wasDrawing_, results_.isBusy()) != results_.isBusy()) {
        show();
    }
    showTime();
}

void StudyControl::watchTrial() {
    const Snapshot frame = runs_.run()->loop().snapshot();
    runs_.fetch();  // all ticks up to the frame
    trial_->show(frame);
    const Study& study = study_->study;
    if (trial_->fault() != Fault::None) {
        endTrial({});
    } else if (study.aids.forces && !runs_.run()->settings().forcesOn) {
        endTrial({.struckOut = tr("forces were switched off").toStdString()});
    } else if (trial_->time() >= study.timeLimit) {
        endTrial({.timedOut = true});
    }
}

/// The tip stays where it is, so that the result can be seen.
void StudyControl::endTrial(const TrialEnd& end) {
    TrialEnd how = end;
    turnKnobs(true);
    try {
        RecordingThread& recording = recording_->thread();
        if (recording.end() != RecordingEnd::None && how.struckOut.empty()) {
            how.struckOut = tr("its recording is not whole").toStdString();
        }
        recording.finish();
        const DoneTrial done = trial_->end(how);
        study_->folder.keep(done);
        showResult(done.record);
        phase_ = StudyPhase::Result;
    } catch (const std::exception& error) {
        phase_ = StudyPhase::Paused;
        window_.complain(
            tr("The trial is not kept, and comes again: %1").arg(QString::fromUtf8(error.what())));
    }
    drop();
    show();
}

void StudyControl::drop() {
    trial_.reset();
    recording_.reset();
}

void StudyControl::strikeOut(const QString& why) {
    try {
        study_->folder.strikeOut(plan_, why.toStdString());
        const auto& trials = study_->folder.trials();
        showResult(*std::ranges::find(trials, plan_, &TrialRecord::plan));
    } catch (const Error& error) {
        window_.complain(QString::fromUtf8(error.what()));
    }
    show();
}

void StudyControl::pause() {
    if (phase_ == StudyPhase::Paused) {
        press();
        return;
    }
    if (trial_) {
        endTrial({.struckOut = tr("paused").toStdString()});
    }
    turnKnobs(true);
    phase_ = StudyPhase::Paused;
    show();
}

void StudyControl::leave() {
    if (trial_) {
        endTrial({.struckOut = tr("left").toStdString()});
    }
    showTarget(std::nullopt);
    before_->restore();
    before_.reset();
    study_.reset();
    phase_ = StudyPhase::Choosing;
    runs_.fix({});
    choice_.show();
    show();
}

void StudyControl::turnView(int right, int up) {
    ZoomView& view = window_.view();
    const double elevation = view.camera().elevation() + up * kTurn;
    view.setDirection(view.camera().azimuth() + right * kTurn,
                      std::clamp(elevation, 0.0, 0.5 * std::numbers::pi));
}

void StudyControl::showTarget(const std::optional<Vector3>& target) {
    window_.view().setTarget(target);
    window_.second().space().setTarget(target);
    mark_.setTarget(target ? std::optional(QPointF(target->x(), target->y())) : std::nullopt);
}

void StudyControl::show() {
    const bool isOn = study_ != nullptr;
    page_->setCurrentIndex(isOn ? 1 : 0);
    window_.menus().refuse(*window_.menus().trial,
                           isOn ? QString() : tr("No study is under way: Run > Study"));
    if (isOn) {
        panel_->showStage(stageWords(*study_, plan_, phase_, refusal_, results_.isBusy()));
    }
}

void StudyControl::showTime() {
    QString time;
    if (trial_) {
        time = tr("%1 s").arg(trial_->time(), 0, 'f', 1);
    } else if (phase_ == StudyPhase::Training) {
        time = tr("%1 s left").arg(std::ceil(trainingEnds_ - monotonicSeconds()), 0, 'f', 0);
    }
    panel_->showTime(time);
}

void StudyControl::showResult(const TrialRecord& record) {
    panel_->showResult(resultWords(record));
}

}  // namespace asperity
