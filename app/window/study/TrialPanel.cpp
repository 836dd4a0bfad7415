#include "app/window/study/TrialPanel.h"

#include "ui/widgets/Card.h"
#include "ui/widgets/PageParts.h"
#include "ui/widgets/ShownText.h"
#include "ui/widgets/Theme.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace asperity {

namespace {

constexpr double kLargeText = 1.35;  // letters of the task, of the usual ones
constexpr int kActionWidth = 170;    // [px]
constexpr int kActionHeight = 46;    // [px]
constexpr int kBarHeight = 6;        // [px]

QLabel* newLabel(const char* name, const QString& toolTip) {
    auto* label = new QLabel;
    label->setObjectName(QString::fromLatin1(name));
    label->setToolTip(toolTip);
    return label;
}

void enlarge(QLabel& label) {
    QFont font = label.font();
    font.setPointSizeF(kLargeText * font.pointSizeF());
    font.setBold(true);
    label.setFont(font);
}

QString wordsOf(const std::string& name) { return QString::fromStdString(name).replace('_', ' '); }

QString noteOf(const TrialRecord& record) {
    if (record.fault != Fault::None) {
        return TrialPanel::tr("does not count: %1").arg(coreWords(nameOf(record.fault)));
    }
    if (!record.struckOut.empty()) {
        return TrialPanel::tr("struck out: %1").arg(QString::fromStdString(record.struckOut));
    }
    return record.timedOut ? TrialPanel::tr("the time was over") : QString();
}

/// "Task B on polystyrene", with the lever where there are several.
QString taskTitle(const Study& study, const PlannedTrial& trial) {
    const QString title = TrialPanel::tr("Task %1 on %2")
                              .arg(QString::fromLatin1(keyOf(study.tasks.at(trial.task).kind)),
                                   wordsOf(study.materials.at(trial.material).name));
    return study.levers.size() == 1 ? title
                                    : TrialPanel::tr("%1, lever %2")
                                          .arg(title, wordsOf(study.levers.at(trial.lever).name));
}

/// What is to be done at the target.
QString taskSentence(TaskKind kind) {
    switch (kind) {
    case TaskKind::Above:
        return TrialPanel::tr("Hold the tip at the green cross-hair, above the surface.");
    case TaskKind::On:
        return TrialPanel::tr("Bring the tip onto the surface, at the green cross-hair.");
    case TaskKind::Below:
        return TrialPanel::tr("Press the tip into the surface, down to the green cross-hair.");
    }
    return {};
}

/// "Participant 1, trial 3 of 24", with the attempt where it is not the first.
QString headingOf(const ParticipantStudy& person, const PlannedTrial& trial) {
    const int ofPerson = (trial.number - 1) % person.count() + 1;
    const QString heading = TrialPanel::tr("Participant %1  ·  trial %2 of %3")
                                .arg(person.participant())
                                .arg(ofPerson)
                                .arg(person.count());
    return trial.attempt == 1 ? heading
                              : TrialPanel::tr("%1  ·  attempt %2").arg(heading).arg(trial.attempt);
}

}  // namespace

TrialPanel::TrialPanel(QWidget* parent)
    : QWidget(parent)
    , heading_(captionLabel(QString(), this))
    , progress_(new QProgressBar(this))
    , task_(newLabel("trialTask", tr("The task and the material")))
    , instruction_(newLabel("trialInstruction", tr("The next step")))
    , action_(pushButton(QString(), "trialAction",
                         tr("The same button begins and ends a trial: Enter, or the device's "
                            "trial_button"),
                         Qt::NoFocus))
    , time_(newLabel("trialTime", tr("Since the trial, or the training, began")))
    , resultName_(captionLabel(QString(), this))
    , readings_(new ReadingGrid(this))
    , note_(newLabel("trialNote", tr("Why that trial does not count")))
    , strikeOut_(pushButton(tr("Strike out…"), "strikeOut",
                            tr("The trial does not count, for a recorded reason, and is repeated"),
                            Qt::NoFocus))
    , pause_(pushButton(QString(), "pauseStudy",
                        tr("A trial in progress ends, does not count, and is repeated"),
                        Qt::NoFocus))
    , results_(pushButton(tr("Results…"), "studyResults",
                          tr("Figures and tables of all trials so far"), Qt::NoFocus)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 6, 8, 6);
    row->setSpacing(12);
    row->addWidget(newTask(), 1);
    row->addWidget(newAction());
    row->addWidget(newResult());
    row->addWidget(newTurning());
    connect(action_, &QPushButton::clicked, this, &TrialPanel::actionChosen);
    connect(strikeOut_, &QPushButton::clicked, this, &TrialPanel::askWhy);
    connect(pause_, &QPushButton::clicked, this, &TrialPanel::pauseChosen);
}

QWidget* TrialPanel::newTask() {
    heading_->setObjectName(QStringLiteral("trialPlace"));
    heading_->setWordWrap(true);
    heading_->setToolTip(tr("How far the participant is"));
    progress_->setTextVisible(false);
    progress_->setFixedHeight(theme::scaled(kBarHeight));
    progress_->setToolTip(heading_->toolTip());
    enlarge(*task_);
    task_->setWordWrap(true);
    instruction_->setWordWrap(true);
    auto* part = new QWidget(this);
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(heading_);
    column->addWidget(progress_);
    column->addWidget(task_);
    column->addWidget(instruction_);
    column->addStretch(1);
    return part;
}

QWidget* TrialPanel::newAction() {
    action_->setFixedWidth(theme::scaled(kActionWidth));
    action_->setMinimumHeight(theme::scaled(kActionHeight));
    time_->setAlignment(Qt::AlignHCenter);
    enlarge(*time_);
    auto* part = new QWidget(this);
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(action_);
    column->addWidget(time_);
    column->addStretch(1);
    return part;
}

QWidget* TrialPanel::newResult() {
    readings_->add("trialError", tr("error"), tr("From the target to the tip at the end"));
    readings_->add("trialShare", tr("of the travel"),
                   tr("The error in percent of the distance from start to target"));
    readings_->add("trialDuration", tr("time"), tr("From beginning to end"));
    readings_->add("trialForce", tr("largest force"), tr("On the tip, as estimated"));
    note_->setWordWrap(true);
    auto* part = new QWidget(this);
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(3);
    column->addWidget(resultName_);
    column->addWidget(readings_);
    column->addWidget(note_);
    column->addWidget(strikeOut_);
    column->addStretch(1);
    return part;
}

QWidget* TrialPanel::newTurning() {
    auto* part = new QWidget(this);
    auto* grid = new QGridLayout(part);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(2);
    const auto addArrow = [&](Qt::ArrowType arrow, const char* name, int row, int column, int right,
                              int up) {
        auto* button = new QToolButton(part);
        button->setArrowType(arrow);
        button->setAutoRepeat(true);
        button->setFocusPolicy(Qt::NoFocus);
        button->setObjectName(QString::fromLatin1(name));
        button->setToolTip(tr("Turns the view"));
        connect(button, &QToolButton::clicked, this,
                [this, right, up] { Q_EMIT turnChosen(right, up); });
        grid->addWidget(button, row, column, Qt::AlignCenter);
    };
    addArrow(Qt::UpArrow, "turnUp", 0, 1, 0, 1);
    addArrow(Qt::LeftArrow, "turnLeft", 1, 0, -1, 0);
    grid->addWidget(captionLabel(tr("view"), part), 1, 1, Qt::AlignCenter);
    addArrow(Qt::RightArrow, "turnRight", 1, 2, 1, 0);
    addArrow(Qt::DownArrow, "turnDown", 2, 1, 0, -1);
    auto* leave = pushButton(
        tr("Leave the study"), "leaveStudy",
        tr("Ends the study and restores the window; it can be continued later"), Qt::NoFocus);
    connect(results_, &QPushButton::clicked, this, &TrialPanel::resultsChosen);
    connect(leave, &QPushButton::clicked, this, &TrialPanel::leaveChosen);
    auto* buttons = new QVBoxLayout;
    buttons->setSpacing(3);
    buttons->addWidget(pause_);
    buttons->addWidget(results_);
    buttons->addWidget(leave);
    grid->addLayout(buttons, 0, 3, 3, 1);
    grid->setRowStretch(3, 1);
    return part;
}

void TrialPanel::showStage(const TrialStage& stage) {
    heading_->setText(stage.heading);
    progress_->setRange(0, stage.count);
    progress_->setValue(stage.done);
    task_->setText(stage.task);
    instruction_->setText(stage.instruction);
    action_->setText(stage.action);
    action_->setEnabled(!stage.action.isEmpty());
    pause_->setEnabled(stage.canPause);
    pause_->setText(stage.isPaused ? tr("Continue") : tr("Pause"));
    strikeOut_->setEnabled(stage.canStrikeOut);
    results_->setEnabled(stage.canShowResults);
}

void TrialPanel::showTime(const QString& time) { time_->setText(time); }

void TrialPanel::showResult(const TrialResult& result) {
    resultName_->setText(result.name.isEmpty() ? tr("no result yet") : result.name);
    readings_->set("trialError", result.error);
    readings_->set("trialShare", result.share);
    readings_->set("trialDuration", result.time);
    readings_->set("trialForce", result.force);
    note_->setText(result.note);
    note_->setVisible(!result.note.isEmpty());
}

void TrialPanel::askWhy() {
    auto* dialog = new QInputDialog(window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setObjectName(QStringLiteral("strikeOutDialog"));
    dialog->setWindowTitle(tr("Strike out the trial"));
    dialog->setLabelText(tr("Why does the trial not count?"));
    connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString& why) {
        if (!why.simplified().isEmpty()) {
            Q_EMIT strikeOutChosen(why.simplified());
        }
    });
    dialog->open();
}

TrialStage stageWords(const OpenStudy& study, const StudyMoment& moment) {
    const StudyPhase phase = moment.phase;
    const ParticipantStudy& person = study.person;
    const QString task = taskSentence(study.study.tasks.at(moment.trial.task).kind);
    TrialStage stage{.heading = headingOf(person, moment.trial),
                     .done = person.done(),
                     .count = person.count(),
                     .task = taskTitle(study.study, moment.trial),
                     .canPause = phase != StudyPhase::Finished && phase != StudyPhase::Training,
                     .isPaused = phase == StudyPhase::Paused,
                     .canStrikeOut =
                         moment.canStrikeOut && phase != StudyPhase::Trial && !moment.isDrawing,
                     .canShowResults = phase != StudyPhase::Trial && !moment.isDrawing};
    switch (phase) {
    case StudyPhase::Training:
        stage.heading = TrialPanel::tr("Participant %1  ·  training").arg(person.participant());
        stage.task = TrialPanel::tr("Try the program");
        stage.instruction =
            TrialPanel::tr("Move the tip to the green cross-hair and back, touch the surface, turn "
                           "the view. Nothing is saved.");
        stage.action = TrialPanel::tr("Go to the trials  (Enter)");
        break;
    case StudyPhase::Ready:
        stage.instruction =
            moment.refusal.isEmpty()
                ? TrialPanel::tr(
                      "%1 The clock starts with Enter; until then the tip does not move.")
                      .arg(task)
                : moment.refusal;
        stage.action = TrialPanel::tr("Begin  (Enter)");
        break;
    case StudyPhase::Trial:
        stage.instruction = TrialPanel::tr("%1 Press Enter when you are satisfied.").arg(task);
        stage.action = TrialPanel::tr("Done  (Enter)");
        break;
    case StudyPhase::Result:
        stage.instruction = TrialPanel::tr("The tip stays where it was at the end.");
        stage.action = TrialPanel::tr("Next trial  (Enter)");
        break;
    case StudyPhase::Paused:
        stage.instruction = TrialPanel::tr("The study is paused.");
        stage.action = TrialPanel::tr("Continue  (Enter)");
        break;
    case StudyPhase::Finished:
        stage.heading =
            TrialPanel::tr("Participant %1  ·  all trials are done").arg(person.participant());
        stage.task = TrialPanel::tr("Thank you");
        stage.instruction = TrialPanel::tr("Results shows the outcome of all trials.");
        stage.action = TrialPanel::tr("Leave the study  (Enter)");
        break;
    case StudyPhase::Choosing:
        break;
    }
    return stage;
}

namespace {

/// Deviations of noise: the largest of a trial's ten thousand ticks seldom exceeds so many.
constexpr double kAboveNoise = 5.0;

QString largestForceText(double force, double noise) {
    return force > kAboveNoise * noise
               ? siText(force, "N")
               : TrialPanel::tr("none above noise (%1)").arg(siText(noise, "N"));
}

}  // namespace

TrialResult resultWords(const TrialRecord& record, double noise) {
    return {.name = TrialPanel::tr("last trial: %1")
                        .arg(record.counts() ? TrialPanel::tr("it counts")
                                             : TrialPanel::tr("it is repeated")),
            .error = siText(record.error, "m"),
            .share = QStringLiteral("%1 %").arg(record.errorPercent, 0, 'f', 1),
            .time = QStringLiteral("%1 s").arg(record.time, 0, 'f', 1),
            .force = largestForceText(record.largestForce, noise),
            .note = noteOf(record)};
}

}  // namespace asperity
