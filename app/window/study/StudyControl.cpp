#include "app/window/study/StudyControl.h"

#include "app/window/live/LivePanels.h"
#include "app/window/live/OverviewPanel.h"
#include "app/window/study/StudyChoice.h"
#include "app/window/study/TrialPanel.h"
#include "core/Error.h"
#include "core/experiment/TrialRun.h"
#include "core/haptics/DevicePath.h"
#include "hardware/driver/DeviceDriver.h"
#include "ui/shell/Menus.h"
#include "ui/shell/WindowLayout.h"
#include "ui/view/MapTool.h"
#include "ui/view/OverviewMap.h"
#include "ui/view/SecondView.h"
#include "ui/view/ViewOptionsMenu.h"
#include "ui/view/ZoomView.h"
#include "ui/widgets/ShownText.h"
#include "vtkplugins/pictures/Palette.h"

#include <QAction>
#include <QApplication>
#include <QPainter>
#include <QPainterPath>
#include <QStackedWidget>

#include <algorithm>
#include <cmath>
#include <numbers>
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

StudyControl::StudyControl(Stage& stage)
    : Feature(stage)
    , page_(new QStackedWidget(&host_.widget()))
    , panel_(new TrialPanel(page_))
    , results_(host_)
    , choice_(host_, *newForm(*page_), results_)
    , views_(live_) {
    stage.onTick([this](const TickSample& sample) { take(sample); });
    stage.onFrame(FrameStep::Move, [this](double /*elapsed*/) { advance(); });
    page_->addWidget(panel_);
    page_->setToolTip(tr("Positioning experiments with people"));
    host_.addTool(page_, tr("Study"));
    addEntries();
    connect(&choice_, &StudyChoice::opened, this, &StudyControl::begin);
    connect(panel_, &TrialPanel::actionChosen, this, &StudyControl::press);
    connect(panel_, &TrialPanel::strikeOutChosen, this, &StudyControl::strikeOut);
    connect(panel_, &TrialPanel::pauseChosen, this, &StudyControl::pause);
    connect(panel_, &TrialPanel::leaveChosen, this, &StudyControl::leave);
    connect(panel_, &TrialPanel::turnChosen, this,
            [this](int right, int up) { views_.turn(right, up); });
    connect(panel_, &TrialPanel::resultsChosen, this,
            [this] { results_.show([study = study_](const auto& read) { read(study->folder); }); });
    connect(&runs_, &RunControl::ending, this, &StudyControl::drop);
    host_.askBeforeClosing([this] {
        return study_ == nullptr || phase_ == StudyPhase::Finished
                   ? QString()
                   : tr("A study is under way: all trials that have ended are kept; one in "
                        "progress "
                        "is repeated when the study is continued.");
    });
    show();
}

void StudyControl::open() {
    if (study_ == nullptr) {
        choice_.show();
    }
    host_.showTool(page_);
    host_.showCards();  // the whole scan is there, where the target is marked
}

void StudyControl::begin(const std::shared_ptr<OpenStudy>& study) {
    if (runs_.run() == nullptr || study_ != nullptr) {
        return;
    }
    edits_.cancel();  // what is on its way would replace a trial
    study_ = study;
    before_.emplace(live_, runs_);
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
    driver_ = runs_.driver();
    live_.view().setFocus();
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
            host_.complain(
                tr("Participant %1 did trials of this study with another device (%2; now: %3). To "
                   "continue with that one, leave the study and choose it first.")
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
    positions_ = positionsOf(study_->study, scene.scene, plan_);
    // Its scale is for devices in millimeters; one that only senses has the scene's.
    const Settings& own = study_->study.scene.settings;
    scene.scene.description.settings.positionGain = own.positionGain;
    scene.scene.description.settings.forceGain = own.forceGain;
    scene.scene.settings.positionGain = own.positionGain;
    scene.scene.settings.forceGain = own.forceGain;
    const Settings settings = scene.scene.settings;
    runs_.place(std::move(scene), positions_.start, settings);
    views_.showTrial(positions_.target);
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
            settings.guide.point = positions_.target;
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
        return tr("The tip is still moving to the start: press again.");
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
    if (runs_.driver() != driver_) {
        return tr("The device has changed since the beginning: leave the study, choose the first "
                  "device, and continue.");
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
            RecordingTarget{.folder = study_->folder.begin(plan_)}, *runs_.run());
        trial_.emplace(plan_, positions_.target, runs_.run()->loop().snapshot());
        last_.reset();
        enter(StudyPhase::Trial);
    } catch (const std::exception& error) {
        drop();
        host_.complain(QString::fromUtf8(error.what()));
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
            how.struckOut = tr("its recording is incomplete").toStdString();
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
        host_.complain(
            tr("The trial was not saved and is repeated: %1").arg(QString::fromUtf8(error.what())));
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
        host_.complain(QString::fromUtf8(error.what()));
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

void StudyControl::addEntries() {
    Menus& menus = host_.menus();
    const QAction& study =
        menus.add({MenuName::Run, 2, 10}, "study",
                  {.text = tr("Stud&y…"),
                   .tip = tr("Positioning experiments with people: tasks, trials, results"),
                   .refusal = [this] { return runs_.showRefusal(); }});
    QAction& trial = menus.add(
        {MenuName::Run, 2, 20}, "trial",
        {.text = tr("&Begin or end a trial"),
         .tip = tr("Starts the trial of the study, or ends it at the present tip position"),
         .shortcuts = {Qt::Key_Return, Qt::Key_Enter},
         .refusal = [this] {
             return study_ != nullptr ? QString() : tr("No study is running: Run > Study…");
         }});
    trial.setAutoRepeat(false);
    connect(&study, &QAction::triggered, this, &StudyControl::open);
    connect(&trial, &QAction::triggered, this, &StudyControl::press);
}

void StudyControl::show() {
    const bool isOn = study_ != nullptr;
    page_->setCurrentIndex(isOn ? 1 : 0);
    host_.menus().refresh();
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
    const Snapshot& now = runs_.run()->loop().snapshot();
    const double noise = std::sqrt(now.sample.output.estimate.covariance.norm());
    panel_->showResult(resultWords(record, noise));
}

namespace {

constexpr double kRadius = 6.0;      // [px]
constexpr double kTargetArm = 11.0;  // [px]

constexpr double kTurn = std::numbers::pi / 12.0;  // of the view, a step [rad]
constexpr double kTargetRoom = 1.3;       // half of the view's width, in distances of a target
constexpr double kTargetRoomAbove = 1.2;  // the same in heights, in a view much wider than high
constexpr double kUsualRadii = 2.4;       // the same at least, in tip radii

/// Wide enough that start and target of every trial are seen, and the same for all of a study.
double halfWidthFor(const Study& study) {
    double farthest = 0.0;
    for (const Vector2& target : study.targets) {
        farthest = std::max(farthest, target.cwiseAbs().maxCoeff());
    }
    double highest = study.startHeight;
    for (const StudyTask& task : study.tasks) {
        highest = std::max(highest, task.kind == TaskKind::Above ? task.farthest : 0.0);
    }
    return std::max(
        {kTargetRoom * farthest, kTargetRoomAbove * highest, kUsualRadii * study.scene.tip.radius});
}

}  // namespace

void TargetTool::setTarget(const std::optional<QPointF>& target) {
    target_ = target;
    Q_EMIT marksChanged();
}

void TargetTool::paint(QPainter& painter, const OverviewMap& map) const {
    if (!target_) {
        return;
    }
    const QPointF center = map.toPixel(*target_);
    QPainterPath path;
    path.addEllipse(center, kRadius, kRadius);
    for (const QPointF& arm : {QPointF(kTargetArm, 0.0), QPointF(0.0, kTargetArm)}) {
        path.moveTo(center - arm);
        path.lineTo(center + arm);
    }
    strokeOverWhite(painter, kLightPalette.target, 2.4, path);
    labelMark(painter, kLightPalette.ink, center + QPointF(kTargetArm + 3.0, -kRadius),
              tr("target"));
}

StudyViews::StudyViews(LivePanels& live) : live_(live) { live_.overview().map().addTool(mark_); }

/// They draw what the study allows: the second view always draws the deformation.
void StudyViews::begin(const Study& study) {
    halfWidth_ = halfWidthFor(study);
    live_.view().resetCamera();
    ViewOptions options = live_.viewOptions().options();
    options.deformation = study.aids.deformation;
    options.trueTip = false;
    live_.viewOptions().setOptions(options);
    live_.view().setOptions(options);
    if (!options.deformation) {
        live_.secondEntry().setChecked(false);
    }
}

void StudyViews::showTrial(const Vector3& target) {
    live_.view().setHalfWidth(halfWidth_);
    showTarget(target);
}

void StudyViews::turn(int right, int up) {
    ZoomView& view = live_.view();
    const double elevation = view.camera().elevation() + up * kTurn;
    view.setDirection(view.camera().azimuth() + right * kTurn,
                      std::clamp(elevation, 0.0, 0.5 * std::numbers::pi));
}

void StudyViews::showTarget(const std::optional<Vector3>& target) {
    live_.view().setTarget(target);
    live_.second().space().setTarget(target);
    mark_.setTarget(target ? std::optional(QPointF(target->x(), target->y())) : std::nullopt);
}

SavedView::SavedView(LivePanels& live, RunControl& runs)
    : live_(live)
    , runs_(runs)
    , scene_(runs.run()->shared())
    , position_(runs.run()->basePosition().head<2>())
    , settings_(runs.run()->sensingSettings())
    , scale_{.positionGain = runs.run()->settings().positionGain,
             .forceGain = runs.run()->settings().forceGain}
    , options_(live_.viewOptions().options())
    , hasSecondView_(live_.secondEntry().isChecked())
    , halfWidth_(live_.view().halfWidth())
    , azimuth_(live_.view().camera().azimuth())
    , elevation_(live_.view().camera().elevation()) {}

void SavedView::restore() const {
    runs_.place(LoadedScene(*scene_), waitingPosition(scene_->scene, position_), settings_);
    if (runs_.run()->coupling().coupled() != nullptr) {
        runs_.turn([this](Settings& settings) {
            settings.positionGain = scale_.positionGain;
            settings.forceGain = scale_.forceGain;
        });
    }
    live_.viewOptions().setOptions(options_);
    live_.view().setOptions(options_);
    live_.secondEntry().setChecked(hasSecondView_);
    live_.view().setHalfWidth(halfWidth_);
    live_.view().setDirection(azimuth_, elevation_);
}

}  // namespace asperity
