#include "ui/experiment/TrialPanel.h"

#include "ui/Theme.h"
#include "ui/measure/PageParts.h"
#include "ui/measure/ReadingGrid.h"
#include "ui/panels/Card.h"

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

constexpr double kLarge = 1.35;    // letters of the task, of the usual ones
constexpr int kActionWidth = 170;  // [px]
constexpr int kActionHeight = 46;  // [px]
constexpr int kBarHeight = 6;      // [px]

QLabel* newLabel(const char* name, const QString& toolTip) {
    auto* label = new QLabel;
    label->setObjectName(QString::fromLatin1(name));
    label->setToolTip(toolTip);
    return label;
}

void enlarge(QLabel& label) {
    QFont font = label.font();
    font.setPointSizeF(kLarge * font.pointSizeF());
    font.setBold(true);
    label.setFont(font);
}

}  // namespace

TrialPanel::TrialPanel(QWidget* parent)
    : QWidget(parent)
    , place_(captionLabel(QString(), this))
    , progress_(new QProgressBar(this))
    , task_(newLabel("trialTask", tr("What is to be done, and on which material")))
    , instruction_(newLabel("trialInstruction", tr("What comes next")))
    , action_(pushButton(QString(), "trialAction",
                         tr("The same button begins and ends a trial: Enter, or the device's "
                            "trial_button"),
                         Qt::NoFocus))
    , time_(newLabel("trialTime", tr("Since the trial, or the training, began")))
    , resultName_(captionLabel(QString(), this))
    , readings_(new ReadingGrid(this))
    , note_(newLabel("trialNote", tr("Why that trial does not count")))
    , strikeOut_(pushButton(
          tr("Strike out…"), "strikeOut",
          tr("The trial does not count, for a reason that is kept, and comes again"), Qt::NoFocus))
    , pause_(pushButton(QString(), "pauseStudy",
                        tr("A trial that is under way ends, does not count, and comes again"),
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
    place_->setObjectName(QStringLiteral("trialPlace"));
    place_->setWordWrap(true);
    place_->setToolTip(tr("How far the participant is"));
    progress_->setTextVisible(false);
    progress_->setFixedHeight(theme::scaled(kBarHeight));
    progress_->setToolTip(place_->toolTip());
    enlarge(*task_);
    task_->setWordWrap(true);
    instruction_->setWordWrap(true);
    auto* part = new QWidget(this);
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(place_);
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
    readings_->add("trialShare", tr("of the way"),
                   tr("The error in percent of the way from start to target"));
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
    auto* leave =
        pushButton(tr("Leave the study"), "leaveStudy",
                   tr("Ends it here and gives the window back; it can go on later"), Qt::NoFocus);
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
    place_->setText(stage.place);
    progress_->setRange(0, stage.count);
    progress_->setValue(stage.done);
    task_->setText(stage.task);
    instruction_->setText(stage.instruction);
    action_->setText(stage.action);
    action_->setEnabled(!stage.action.isEmpty());
    pause_->setEnabled(stage.canPause);
    pause_->setText(stage.isPaused ? tr("Go on") : tr("Pause"));
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

}  // namespace asperity
