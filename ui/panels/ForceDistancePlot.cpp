#include "ui/panels/ForceDistancePlot.h"

#include "ui/Theme.h"
#include "ui/panels/AxisTicks.h"
#include "ui/panels/QwtParts.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <qwt_painter.h>
#include <qwt_plot.h>
#include <qwt_plot_marker.h>
#include <qwt_symbol.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity {

namespace {

constexpr double kMinForces = 0.2e-9;      ///< extent of the force axis [N]
constexpr double kMinDistances = 0.5e-9;   ///< extent of the distance axis [m]
constexpr double kMinDistanceUnit = 1e-9;  ///< distances are in nm or larger units [m]
constexpr double kCurveWidth = 1.4;        ///< of a retract curve [px]
constexpr double kApproachWidth = 3.0;     ///< shows on both sides of a retract curve upon it [px]
constexpr int kMinHeight = 72;             ///< of the plot [px]
constexpr int kMinTickHeight = 14;         ///< between ticks of the force axis [px]
constexpr int kMinTickWidth = 52;          ///< between those of the distance axis [px]
constexpr int kRingSize = 7;               ///< [px]
/// Share of paper in the colors of the newest cycle and of the older ones.
constexpr std::array<double, ForceDistancePlot::kMaxCycles> kFaintness = {0.0, 0.45, 0.62, 0.74};

QColor faded(const QColor& full, double paper) {
    const QColor& background = theme::colors().paper;
    const auto mix = [paper](int from, int to) {
        return static_cast<int>(std::lround(from + paper * (to - from)));
    };
    return {mix(full.red(), background.red()), mix(full.green(), background.green()),
            mix(full.blue(), background.blue())};
}

QString legendText(const QString& unit) {
    const BranchColors colors = branchColors(0);
    const auto entry = [](const QColor& color, const QString& name) {
        return QStringLiteral("&nbsp; <span style='color:%1'><b>&#x2501;</b></span>&nbsp;%2")
            .arg(color.name(), name);
    };
    return QStringLiteral("<b>F</b> [%1]").arg(unit) +
           entry(colors.approach, QWidget::tr("approach")) +
           entry(colors.retract, QWidget::tr("retract"));
}

}  // namespace

BranchColors branchColors(int age) {
    const auto index =
        static_cast<std::size_t>(std::clamp(age, 0, ForceDistancePlot::kMaxCycles - 1));
    return {faded(theme::colors().blue, kFaintness[index]),
            faded(theme::colors().orange, kFaintness[index])};
}

class ForceDistancePlot::Canvas {
public:
    explicit Canvas(ForceDistancePlot* owner);

    [[nodiscard]] QHBoxLayout& heading() { return *heading_; }
    void showAxes(const AxisRange& forces, const SiScale& force, const AxisRange& distances,
                  const SiScale& distance);
    void showCycles(const std::vector<DrawnCycle>& cycles, const SiScale& force,
                    const SiScale& distance);

private:
    /// What draws one cycle; owned by the plot.
    struct Items {
        PiecewiseCurve* approach = nullptr;
        PiecewiseCurve* retract = nullptr;
        QwtPlotMarker* pullOff = nullptr;
    };

    [[nodiscard]] Items newItems();
    void color();

    QHBoxLayout* heading_;
    QLabel* legend_;
    QwtPlot* plot_;
    NumberScaleDraw* forceLabels_;     ///< owned by the plot
    NumberScaleDraw* distanceLabels_;  ///< owned by the plot
    std::array<Items, kMaxCycles> items_;
    QString unit_;  ///< of the forces
};

ForceDistancePlot::Canvas::Canvas(ForceDistancePlot* owner)
    : heading_(new QHBoxLayout)
    , legend_(new QLabel(owner))
    , plot_(new QwtPlot(owner))
    , forceLabels_(new NumberScaleDraw)
    , distanceLabels_(new NumberScaleDraw) {
    legend_->setFont(theme::textFont(theme::kSmallSize));
    legend_->setMinimumWidth(1);
    heading_->setSpacing(4);
    heading_->addWidget(legend_, 1);
    QwtPainter::setRoundingAlignment(false);  // curves run smoothly between the pixels
    plot_->setAxisScaleDraw(QwtPlot::yLeft, forceLabels_);
    plot_->setAxisScaleDraw(QwtPlot::xBottom, distanceLabels_);
    styleLivePlot(*plot_);
    forceLabels_->setMinimumExtent(valueLabelRoom());
    addZeroLine(*plot_);
    for (int age = kMaxCycles - 1; age >= 0; --age) {  // the newest is drawn last
        items_[static_cast<std::size_t>(age)] = newItems();
    }
    auto* layout = new QVBoxLayout(owner);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(1);
    layout->addLayout(heading_);
    plot_->setMinimumHeight(kMinHeight);
    layout->addWidget(plot_, 1);
    theme::follow(owner, [this] { color(); });
}

void ForceDistancePlot::Canvas::color() {
    for (std::size_t age = 0; age < items_.size(); ++age) {
        const BranchColors colors = branchColors(static_cast<int>(age));
        items_[age].approach->setPen(colors.approach, kApproachWidth, Qt::SolidLine);
        items_[age].retract->setPen(colors.retract, kCurveWidth, Qt::SolidLine);
        items_[age].pullOff->setSymbol(
            new QwtSymbol(QwtSymbol::Ellipse, QBrush(theme::colors().paper),
                          QPen(colors.retract, kCurveWidth), {kRingSize, kRingSize}));
    }
    legend_->setText(legendText(unit_));
}

ForceDistancePlot::Canvas::Items ForceDistancePlot::Canvas::newItems() {
    const auto curve = [this] {
        auto* item = new PiecewiseCurve;
        item->setRenderHint(QwtPlotItem::RenderAntialiased);
        item->attach(plot_);
        return item;
    };
    const Items items{curve(), curve(), new QwtPlotMarker};
    items.pullOff->setRenderHint(QwtPlotItem::RenderAntialiased);
    items.pullOff->attach(plot_);
    return items;
}

void ForceDistancePlot::Canvas::showAxes(const AxisRange& forces, const SiScale& force,
                                         const AxisRange& distances, const SiScale& distance) {
    const auto show = [this](int axis, NumberScaleDraw& labels, const AxisRange& range,
                             double factor, const QString& unit, int room) {
        const double low = factor * range.low;
        const double high = factor * range.high;
        const std::vector<double> ticks = axisTicks(low, high, std::max(1, room));
        labels.set(decimalsFor(ticks), unit);
        plot_->setAxisScaleDiv(axis, divisions(low, high, ticks));
    };
    unit_ = QString::fromStdString(force.unit);
    legend_->setText(legendText(unit_));
    show(QwtPlot::yLeft, *forceLabels_, forces, force.factor, {},
         plot_->canvas()->height() / kMinTickHeight);
    show(QwtPlot::xBottom, *distanceLabels_, distances, distance.factor,
         QString::fromStdString(distance.unit), plot_->canvas()->width() / kMinTickWidth);
}

void ForceDistancePlot::Canvas::showCycles(const std::vector<DrawnCycle>& cycles,
                                           const SiScale& force, const SiScale& distance) {
    const auto placed = [&](const QPointF& point) {
        return QPointF(distance.factor * point.x(), force.factor * point.y());
    };
    const auto show = [&](PiecewiseCurve& item, const QVector<QPointF>& points) {
        QVector<QPointF> shown;
        shown.reserve(points.size());
        for (const QPointF& point : points) {
            shown.append(placed(point));
        }
        item.setSamples(shown);
    };
    for (std::size_t age = 0; age < items_.size(); ++age) {
        const DrawnCycle cycle = age < cycles.size() ? cycles[age] : DrawnCycle();
        show(*items_[age].approach, cycle.approach);
        show(*items_[age].retract, cycle.retract);
        items_[age].pullOff->setVisible(cycle.pullOff.has_value());
        items_[age].pullOff->setValue(placed(cycle.pullOff.value_or(QPointF())));
    }
    plot_->replot();
}

ForceDistancePlot::ForceDistancePlot(QWidget* parent)
    : QWidget(parent)
    , forces_(kMinForces)
    , distances_(kMinDistances)
    , forceScale_("N", kMinForces)
    , distanceScale_("m", kMinDistanceUnit)
    , canvas_(std::make_unique<Canvas>(this)) {
    setCycles({}, {});
}

ForceDistancePlot::~ForceDistancePlot() = default;

void ForceDistancePlot::fitRanges(const std::vector<DrawnCycle>& cycles,
                                  const AxisRange& distances) {
    distances_.fit(distances.low, distances.high);
    AxisRange forces;  // zero is always in sight
    for (const DrawnCycle& cycle : cycles) {
        for (const QVector<QPointF>* const points : {&cycle.approach, &cycle.retract}) {
            for (const QPointF& point : *points) {
                forces.low = std::fmin(forces.low, point.y());
                forces.high = std::fmax(forces.high, point.y());
            }
        }
    }
    forces_.fit(forces.low, forces.high);
}

void ForceDistancePlot::setCycles(const std::vector<DrawnCycle>& newestFirst,
                                  const AxisRange& distances) {
    fitRanges(newestFirst, distances);
    const auto largest = [](const AxisRange& range) {
        return std::max(std::abs(range.low), std::abs(range.high));
    };
    const SiScale& force = forceScale_.fit(largest(forces_.range()));
    const SiScale& distance = distanceScale_.fit(largest(distances_.range()));
    canvas_->showAxes(forces_.range(), force, distances_.range(), distance);
    canvas_->showCycles(newestFirst, force, distance);
}

void ForceDistancePlot::forgetRange() { distances_ = SteadyRange(kMinDistances); }

QHBoxLayout& ForceDistancePlot::heading() { return canvas_->heading(); }

}  // namespace asperity
