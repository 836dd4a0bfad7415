#include "app/session/StudyControl.h"

#include "app/session/StudyWords.h"
#include "core/Error.h"
#include "core/experiment/TrialRun.h"
#include "ui/CoreWords.h"
#include "ui/experiment/StudyForm.h"
#include "ui/experiment/TrialPanel.h"
#include "ui/view/ZoomView.h"
#include "ui/window/MainWindow.h"
#include "ui/window/WindowLayout.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QApplication>
#include <QStackedWidget>

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

/// For so long after each change the button does nothing: it may have been pressed for the one
/// before [s].
constexpr double kSettle = 0.5;

StudyForm* newForm(QStackedWidget& page) {
    auto* form = new StudyForm(&page);
    page.addWidget(form);
    return form;
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
    , choice_(window, *newForm(*page_), results_)
    , views_(window) {
    page_->addWidget(panel_);
    page_->setToolTip(tr("Positioning experiments with people"));
    window.addTool(page_, tr("Study"));
    connect(window.menus().study, &QAction::triggered, this, &StudyControl::open);
    connect(window.menus().trial, &QAction::triggered, this, &StudyControl::press);
    connect(&choice_, &StudyChoice::opened, this, &StudyControl::begin);
    connect(panel_, &TrialPanel::actionChosen, this, &StudyControl::press);
    connect(panel_, &TrialPanel::strikeOutChosen, this, &StudyControl::strikeOut);
    connect(panel_, &TrialPanel::pauseChosen, this, &StudyControl::pause);
    connect(panel_, &TrialPanel::leaveChosen, this, &StudyControl::leave);
    connect(panel_, &TrialPanel::turnChosen, this,
            [this](int right, int up) { views_.turn(right, up); });
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
    if (!study->study.aids.forces) {
        runs_.keepForcesOff();
    }
    views_.begin(study->study);
    panel_->forgetResult();
    last_.reset();
    isPressed_ = false;
    if (study->person.isNew() && study->study.training > 0.0) {
        plan_ = *study->person.next();
        placeTrial();
        turnKnobs(false);
        trainingEnds_ = monotonicSeconds() + study->study.training;
        enter(StudyPhase::Training);
    } else {
        makeReady();
    }
    driver_ = devices_.driver();
    window_.view().setFocus();
    show();
    warnOfDevice();
}

void StudyControl::enter(StudyPhase phase) {
    phase_ = phase;
    changed_ = monotonicSeconds();
}

std::string StudyControl::deviceKey() const { return driver_ != nullptr ? driver_->key : "path"; }

void StudyControl::warnOfDevice() {
    for (const TrialRecord& trial : study_->folder.trials()) {
        if (trial.plan.participant == study_->person.participant() && trial.device != deviceKey()) {
            window_.complain(
                tr("Participant %1 did trials of this study with another device (%2; now: %3). To "
                   "go on with that one, leave the study and choose it first.")
                    .arg(trial.plan.participant)
                    .arg(QString::fromStdString(trial.device),
                         QString::fromStdString(deviceKey())));
            return;
        }
    }
}

void StudyControl::press() {
    const bool isQuestion = QApplication::activeModalWidget() != nullptr;
    if (isQuestion || monotonicSeconds() - changed_ < kSettle) {
        return;
    }
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
        enter(StudyPhase::Finished);
        views_.forgetTarget();
        return;
    }
    plan_ = *next;
    placeTrial();
    turnKnobs(true);
    refusal_.clear();
    enter(StudyPhase::Ready);
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
    views_.showTrial(places_.target);
}

void StudyControl::turnKnobs(bool clutched) {
    const Study& study = study_->study;
    const bool isCoupled = runs_.run()->coupling().coupled() != nullptr;
    runs_.turn([&](Settings& settings) {
        settings.clutched = clutched;
        settings.forcesOn = settings.forcesOn && study.aids.forces;  // on by hand alone
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
    if (study.aids.forces && !settings.forcesOn) {
        return tr("Forces are off: switch them on above first.");
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
        last_.reset();
        enter(StudyPhase::Trial);
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
        makeReady();
        show();
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
        DoneTrial done = trial_->end(how);
        done.record.device = deviceKey();
        study_->folder.keep(done);
        last_ = done.record.counts() ? std::optional(plan_) : std::nullopt;
        showResult(done.record);
        enter(StudyPhase::Result);
    } catch (const std::exception& error) {
        enter(StudyPhase::Paused);
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
    if (!last_ || results_.isBusy()) {
        return;
    }
    try {
        study_->folder.strikeOut(*last_, why.toStdString());
        const auto& trials = study_->folder.trials();
        showResult(*std::ranges::find(trials, *last_, &TrialRecord::plan));
        last_.reset();
        if (phase_ == StudyPhase::Ready || phase_ == StudyPhase::Finished) {
            makeReady();  // that trial comes first
        }
    } catch (const Error& error) {
        window_.complain(QString::fromUtf8(error.what()));
    }
    show();
}

void StudyControl::pause() {
    if (phase_ == StudyPhase::Paused) {
        makeReady();
        show();
        return;
    }
    if (trial_) {
        endTrial({.struckOut = tr("paused").toStdString()});
    }
    turnKnobs(true);
    enter(StudyPhase::Paused);
    show();
}

void StudyControl::leave() {
    if (trial_) {
        endTrial({.struckOut = tr("left").toStdString()});
    }
    views_.forgetTarget();
    before_->restore();
    before_.reset();
    study_.reset();
    enter(StudyPhase::Choosing);
    runs_.fix({});
    choice_.show();
    show();
}

void StudyControl::show() {
    const bool isOn = study_ != nullptr;
    page_->setCurrentIndex(isOn ? 1 : 0);
    window_.menus().refuse(*window_.menus().trial,
                           isOn ? QString() : tr("No study is under way: Run > Study"));
    if (isOn) {
        panel_->showStage(stageWords(*study_, {.phase = phase_,
                                               .trial = plan_,
                                               .refusal = refusal_,
                                               .isDrawing = results_.isBusy(),
                                               .canStrikeOut = last_.has_value()}));
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
