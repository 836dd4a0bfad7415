#include "ui/playback/PlaybackPage.h"

#include "ui/measure/ReadingGrid.h"
#include "ui/panels/Card.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace asperity {

namespace {

constexpr double kLeastForce = 0.2e-9;       ///< extent of a force axis [N]
constexpr double kLeastDifference = 10e-12;  ///< of that of a difference [N]
constexpr int kPlotHeight = 92;              ///< least [px]
constexpr int kMarkWidth = 40;               ///< beside a name, as theme::scaled() takes it

RunPlotSetup forceSetup() {
    return {.title = PlaybackPage::tr("Force over time"),
            .xName = PlaybackPage::tr("time"),
            .xUnit = QStringLiteral("s"),
            .yUnit = QStringLiteral("N"),
            .smallest = kLeastForce,
            .toolTip = PlaybackPage::tr("Estimated force along the normal of the surface; the line "
                                        "is at the moment that is shown")};
}

RunPlotSetup differenceSetup() {
    return {.title = PlaybackPage::tr("Second − first run"),
            .xName = PlaybackPage::tr("time"),
            .xUnit = QStringLiteral("s"),
            .yUnit = QStringLiteral("N"),
            .smallest = kLeastDifference,
            .toolTip = PlaybackPage::tr("Normal force of the second run minus that of the first "
                                        "one, at equal time since the start of each")};
}

RunPlotSetup distanceSetup() {
    return {.title = PlaybackPage::tr("Force over indentation"),
            .xName = PlaybackPage::tr("indentation"),
            .xUnit = QStringLiteral("m"),
            .yUnit = QStringLiteral("N"),
            .smallest = kLeastForce,
            .order = RunPlotSetup::Order::Any,
            .toolTip = PlaybackPage::tr("Estimated force along the normal of the surface. Left of "
                                        "zero: the gap between tip and surface; right of it: the "
                                        "indentation; the dot is the moment that is shown")};
}

}  // namespace

PlaybackPage::PlaybackPage(QWidget* parent)
    : QWidget(parent)
    , bar_(new PlaybackBar(this))
    , force_(new RunPlot(forceSetup(), this))
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
        tr("For how long both runs go on; ticks of the first run that count, and those "
           "left out because of a fault or without a number"));
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
        (QStringList(tr("In what the runs differ, first → second:")) << differs).join('\n'));
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
