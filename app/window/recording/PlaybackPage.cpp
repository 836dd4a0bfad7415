#include "app/window/recording/PlaybackPage.h"

#include "ui/widgets/Card.h"
#include "ui/widgets/FlowLayout.h"
#include "ui/widgets/NumberBox.h"
#include "ui/widgets/PageParts.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace asperity {

namespace {

constexpr std::array<double, 3> kSpeeds{0.1, 1.0, 10.0};  ///< recorded seconds a second
constexpr int kSlowSpeed = 0;                             ///< of kSpeeds
constexpr int kUsualSpeed = 1;                            ///< same
constexpr int kPages = 50;  ///< of a run: how far Page Up and a click beside the handle go

struct StepWords {
    const char* name;
    const char* objectName;
    const char* toolTip;
    const char* lack;  ///< why it does not work
};

constexpr std::array<StepWords, kPlaybackSteps> kStepWords{
    {{QT_TRANSLATE_NOOP("asperity::PlaybackBar", "Start"), "stepStart",
      QT_TRANSLATE_NOOP("asperity::PlaybackBar", "First tick of the recording"), ""},
     {QT_TRANSLATE_NOOP("asperity::PlaybackBar", "Snap-in"), "stepSnapIn",
      QT_TRANSLATE_NOOP("asperity::PlaybackBar", "First tick of the first contact"),
      QT_TRANSLATE_NOOP("asperity::PlaybackBar", "The tip never came into contact")},
     {QT_TRANSLATE_NOOP("asperity::PlaybackBar", "Deepest"), "stepDeepest",
      QT_TRANSLATE_NOOP("asperity::PlaybackBar", "Largest indentation"),
      QT_TRANSLATE_NOOP("asperity::PlaybackBar", "The tip never came into contact")},
     {QT_TRANSLATE_NOOP("asperity::PlaybackBar", "Pull-off"), "stepPullOff",
      QT_TRANSLATE_NOOP("asperity::PlaybackBar", "Just before the tip came off for the last time"),
      QT_TRANSLATE_NOOP("asperity::PlaybackBar", "The tip never came off")},
     {QT_TRANSLATE_NOOP("asperity::PlaybackBar", "End"), "stepEnd",
      QT_TRANSLATE_NOOP("asperity::PlaybackBar", "Last tick of the recording"), ""}}};

QString noRun() { return PlaybackBar::tr("Choose a recording first: Run > Look at a recording…"); }

/// Disables what cannot work and says why; empty: it works.
void refuse(QWidget& control, const QString& reason, const QString& toolTip) {
    control.setEnabled(reason.isEmpty());
    control.setToolTip(reason.isEmpty() ? toolTip : reason);
}

constexpr double kMinForceStep = 0.2e-9;   ///< extent of a force axis [N]
constexpr double kMinDifference = 10e-12;  ///< of that of a difference [N]
constexpr int kPlotHeight = 92;            ///< least [px]
constexpr int kMarkWidth = 40;             ///< beside a name, as theme::scaled() takes it

RunPlotSetup runForceSetup() {
    return {.title = PlaybackPage::tr("Force over time"),
            .xName = PlaybackPage::tr("time"),
            .xUnit = QStringLiteral("s"),
            .yUnit = QStringLiteral("N"),
            .smallest = kMinForceStep,
            .toolTip = PlaybackPage::tr("Estimated force along the normal of the surface; the line "
                                        "is at the moment that is shown")};
}

RunPlotSetup differenceSetup() {
    return {.title = PlaybackPage::tr("Second − first run"),
            .xName = PlaybackPage::tr("time"),
            .xUnit = QStringLiteral("s"),
            .yUnit = QStringLiteral("N"),
            .smallest = kMinDifference,
            .toolTip = PlaybackPage::tr("Normal force of the second run minus that of the first "
                                        "one, at equal time since the start of each")};
}

RunPlotSetup distanceSetup() {
    return {.title = PlaybackPage::tr("Force over indentation"),
            .xName = PlaybackPage::tr("indentation"),
            .xUnit = QStringLiteral("m"),
            .yUnit = QStringLiteral("N"),
            .smallest = kMinForceStep,
            .order = RunPlotSetup::Order::Any,
            .toolTip = PlaybackPage::tr("Estimated force along the normal of the surface. Left of "
                                        "zero: the gap between tip and surface; right of it: the "
                                        "indentation; the dot is the moment that is shown")};
}

}  // namespace

PlaybackBar::PlaybackBar(QWidget* parent)
    : QWidget(parent)
    , play_(pageButton({}, "playRecording", {}, this))
    , time_(new QSlider(Qt::Horizontal, this))
    , speed_(new ChoiceBox(this))
    , replay_(pageButton({}, "replayLast", {}, this))
    , compare_(pageButton(tr("Compare with…"), "compareRuns", {}, this))
    , alone_(pageButton(tr("Stop comparing"), "stopComparing",
                        tr("Shows the recording alone again"), this))
    , back_(pageButton(tr("Back to the live tip"), "backToLive", {}, this)) {
    play_->setCheckable(true);
    time_->setObjectName(QStringLiteral("recordingTime"));
    speed_->setObjectName(QStringLiteral("recordingSpeed"));
    speed_->setNames({tr("0.1×"), tr("1×"), tr("10×")});
    speed_->setCurrentIndex(kUsualSpeed);
    speed_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    buildSteps();
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(3);
    rows->addWidget(timeRow());
    rows->addWidget(stepRow());
    connect(play_, &QToolButton::toggled, this, &PlaybackBar::playingChosen);
    connect(time_, &QSlider::valueChanged, this, &PlaybackBar::tickChosen);
    connect(compare_, &QToolButton::clicked, this, &PlaybackBar::compareRequested);
    connect(alone_, &QToolButton::clicked, this, &PlaybackBar::endComparisonRequested);
    connect(back_, &QToolButton::clicked, this, &PlaybackBar::backRequested);
    setPlaying(false);
    setComparing(false);
    setRun(0, {});
}

void PlaybackBar::buildSteps() {
    for (std::size_t i = 0; i < kPlaybackSteps; ++i) {
        buttons_[i] = pageButton(tr(kStepWords[i].name), kStepWords[i].objectName, {}, this);
        connect(buttons_[i], &QToolButton::clicked, this, [this, i] {
            if (steps_[i]) {
                Q_EMIT tickChosen(*steps_[i]);
            }
        });
    }
}

QWidget* PlaybackBar::timeRow() {
    auto* bar = new QWidget(this);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    row->addWidget(play_);
    row->addWidget(time_, 1);
    row->addWidget(speed_);
    return bar;
}

QWidget* PlaybackBar::stepRow() {
    auto* bar = new QWidget(this);
    auto* row = new FlowLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    for (QToolButton* const button : buttons_) {
        row->addWidget(button);
    }
    row->addStretch();
    for (QToolButton* const button : {replay_, compare_, alone_, back_}) {
        row->addWidget(button);
    }
    return bar;
}

void PlaybackBar::setRun(int ticks, const Steps& steps) {
    steps_ = steps;
    const QString lack = ticks > 0 ? QString() : noRun();
    const QSignalBlocker quiet(time_);
    time_->setRange(0, std::max(ticks - 1, 0));
    time_->setPageStep(std::max(ticks / kPages, 1));
    refuse(*time_, lack, tr("Moment of the recording that is shown; arrow keys: tick by tick"));
    refuse(*play_, lack, tr("Play the recording, or pause it"));
    refuse(*speed_, lack, tr("How fast it plays"));
    refuse(*compare_, lack, tr("Overlay a second run, and show the difference of the forces"));
    refuse(*back_, ticks > 0 ? QString() : tr("The live tip is shown"),
           tr("Leave the recording and continue the live run"));
    for (std::size_t i = 0; i < kPlaybackSteps; ++i) {
        const QString missing = steps[i] ? QString() : tr(kStepWords[i].lack);
        refuse(*buttons_[i], lack.isEmpty() ? missing : lack, tr(kStepWords[i].toolTip));
    }
}

void PlaybackBar::setTick(int tick) {
    if (!time_->isSliderDown()) {
        const QSignalBlocker quiet(time_);
        time_->setValue(tick);
    }
}

void PlaybackBar::setPlaying(bool playing) {
    const QSignalBlocker quiet(play_);
    play_->setChecked(playing);
    play_->setText(playing ? tr("Pause") : tr("Play"));
}

double PlaybackBar::speed() const {
    return kSpeeds.at(static_cast<std::size_t>(std::max(speed_->currentIndex(), 0)));
}

void PlaybackBar::setSlow(bool slow) { speed_->setCurrentIndex(slow ? kSlowSpeed : kUsualSpeed); }

void PlaybackBar::addReplay(QAction& entry) { replay_->setDefaultAction(&entry); }

void PlaybackBar::setComparing(bool comparing) { alone_->setVisible(comparing); }

PlaybackPage::PlaybackPage(QWidget* parent)
    : QWidget(parent)
    , bar_(new PlaybackBar(this))
    , force_(new RunPlot(runForceSetup(), this))
    , difference_(new RunPlot(differenceSetup(), this))
    , distance_(new RunPlot(distanceSetup(), this))
    , readings_(new ReadingGrid(this))
    , comparison_(new ReadingGrid(this))
    , names_(captionLabel({}, this))
    , differs_(captionLabel({}, this)) {
    setToolTip(tr("A recorded run: any moment of it in all views, and beside another run"));
    buildReadings();
    auto* numbers = new QVBoxLayout;
    numbers->setSpacing(6);
    numbers->addWidget(readings_);
    numbers->addWidget(comparison_);
    numbers->addStretch(1);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(10);
    for (RunPlot* const plot : {force_, difference_, distance_}) {
        plot->setMinimumHeight(kPlotHeight);
        middle->addWidget(plot, plot == force_ ? 3 : 2);
    }
    middle->addLayout(numbers);
    names_->setObjectName(QStringLiteral("comparedRuns"));
    names_->setTextFormat(Qt::RichText);
    names_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    differs_->setObjectName(QStringLiteral("runsDiffer"));
    differs_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    differs_->setTextFormat(Qt::PlainText);
    differs_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 4, 6, 4);
    column->setSpacing(4);
    column->addWidget(bar_);
    column->addWidget(names_);
    column->addWidget(differs_);
    column->addLayout(middle, 1);
    theme::follow(this, [this] { showNames(); });
    setRun(0, {}, {});
}

void PlaybackPage::buildReadings() {
    readings_->add("recordingMoment", tr("time"), tr("Of the moment that is shown, in the run"));
    readings_->add(
        "recordingForce", tr("normal force"),
        tr("Estimated, along the normal of the surface ± one standard deviation, by noise, "
           "model and calibration together"));
    readings_->add("recordingDistance", tr("distance"),
                   tr("Indentation, or the gap between tip and surface"));
    readings_->add("recordingState", tr("state"), tr("Where the tip is"));
    comparison_->add("differenceMean", tr("mean difference"),
                     tr("Of the normal forces, second run minus first"));
    comparison_->add("differenceRms", tr("rms difference"),
                     tr("Root of the mean square of the differences"));
    comparison_->add("differenceLargest", tr("largest"),
                     tr("In magnitude, and its time in the first run"));
    comparison_->add(
        "differenceOverlap", tr("compared"),
        tr("Common duration of both runs; ticks of the first run that were compared, and "
           "those left out because of a fault or without a number"));
}

void PlaybackPage::setRun(int ticks, const PlaybackBar::Steps& steps, const Curves& curves) {
    curves_ = curves;
    bar_->setRun(ticks, steps);
    for (const char* const reading :
         {"recordingMoment", "recordingForce", "recordingDistance", "recordingState"}) {
        readings_->set(reading, {});
    }
    for (RunPlot* const plot : {force_, difference_, distance_}) {
        plot->setMoment(std::nullopt);
    }
    setComparison(std::nullopt);
}

void PlaybackPage::showMoment(int tick, const Readings& readings, double time, double indentation,
                              double force) {
    bar_->setTick(tick);
    readings_->set("recordingMoment", readings.time);
    readings_->set("recordingForce", readings.force);
    readings_->set("recordingDistance", readings.distance);
    readings_->set("recordingState", readings.state);
    force_->setMoment(QPointF(time, force));
    difference_->setMoment(QPointF(time, qQNaN()));
    distance_->setMoment(QPointF(indentation, force));
}

void PlaybackPage::setComparison(const std::optional<Comparison>& comparison) {
    other_ = comparison;
    bar_->setComparing(other_.has_value());
    readings_->setVisible(!other_);  // the banner and the force panel have them, too
    comparison_->setVisible(other_.has_value());
    difference_->setVisible(other_.has_value());
    names_->setVisible(other_.has_value());
    differs_->setVisible(other_.has_value());
    if (other_) {
        comparison_->set("differenceMean", other_->mean);
        comparison_->set("differenceRms", other_->rms);
        comparison_->set("differenceLargest", other_->largest);
        comparison_->set("differenceOverlap", other_->overlap);
    }
    showNames();
    showDifferences();
    showLines();
}

/// Once for all plots, so that each name has half the page.
void PlaybackPage::showNames() {
    if (!other_) {
        return;
    }
    const auto entry = [this](const QColor& color, const QString& name) {
        const int room = width() / 2 - theme::scaled(kMarkWidth);
        return QStringLiteral("<span style='color:%1'><b>&#x2501;</b></span>&nbsp;%2")
            .arg(color.name(),
                 names_->fontMetrics().elidedText(name, Qt::ElideMiddle, room).toHtmlEscaped());
    };
    names_->setText(entry(theme::colors().blue, other_->name) + QStringLiteral("&nbsp; &nbsp; ") +
                    entry(theme::colors().orange, other_->other.name));
    names_->setToolTip(tr("First run: %1\nSecond run: %2").arg(other_->name, other_->other.name));
}

void PlaybackPage::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    showNames();
    showDifferences();
}

/// In one line: the tool tip has them all.
void PlaybackPage::showDifferences() {
    if (!other_) {
        return;
    }
    const QStringList& differs = other_->differs;
    const QString text = differs.isEmpty() ? tr("Scan and parameters of both runs are the same")
                                           : differs.join(QStringLiteral("   ·   "));
    differs_->setText(differs_->fontMetrics().elidedText(text, Qt::ElideRight,
                                                         width() - theme::scaled(kMarkWidth)));
    differs_->setToolTip(
        (QStringList(tr("Differences of the runs, first → second:")) << differs).join('\n'));
}

void PlaybackPage::showLines() {
    std::vector<RunPlot::Line> overTime;
    std::vector<RunPlot::Line> overDistance;
    std::vector<RunPlot::Line> differences;
    if (!curves_.force.isEmpty()) {
        const QString name = other_ ? other_->name : curves_.name;
        overTime.push_back({name, &ThemeColors::blue, curves_.force});
        overDistance.push_back({name, &ThemeColors::blue, curves_.distance});
    }
    if (other_) {
        overTime.push_back({other_->other.name, &ThemeColors::orange, other_->other.force});
        overDistance.push_back({other_->other.name, &ThemeColors::orange, other_->other.distance});
        differences.push_back({tr("difference"), &ThemeColors::green, other_->difference});
    }
    force_->setLines(overTime);
    distance_->setLines(overDistance);
    difference_->setLines(differences);
}

}  // namespace asperity
