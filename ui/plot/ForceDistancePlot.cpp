#include "ui/plot/ForceDistancePlot.h"

#include "ui/plot/PlotNavigation.h"
#include "ui/plot/QwtParts.h"
#include "ui/widgets/Theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <qwt_painter.h>
#include <qwt_plot.h>
#include <qwt_plot_marker.h>
#include <qwt_symbol.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr double kMinForces = 0.2e-9;      ///< extent of the force axis [N]
constexpr double kMinDistances = 0.5e-9;   ///< extent of the distance axis [m]
constexpr double kMinDistanceUnit = 1e-9;  ///< distances are in nm or larger units [m]
constexpr double kRetractWidth = 1.4;      ///< of a retract curve [px]
constexpr double kApproachWidth = 3.0;     ///< shows on both sides of a retract curve upon it [px]
constexpr int kMinHeight = 72;             ///< of the plot [px]
constexpr int kMinTickHeight = 14;         ///< between ticks of the force axis [px]
constexpr int kMinTickWidth = 52;          ///< between those of the distance axis [px]
constexpr int kPointRingSize = 7;          ///< [px]
constexpr double kMeasuredWidth = 1.8;     ///< of a measured curve [px]
/// Of the shown distances: a sample farther from the cursor is not read.
constexpr double kReadReach = 0.03;
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

/// Around a jump of the force; the mark owns it.
QwtSymbol* newRing(const QColor& color) {
    return new QwtSymbol(QwtSymbol::Ellipse, QBrush(theme::colors().paper),
                         QPen(color, kRetractWidth), {kPointRingSize, kPointRingSize});
}

QString legendText(const QString& unit) {
    const BranchColors colors = branchColors(0);
    const BranchNames names = branchNames();
    const auto entry = [](const QColor& color, const QString& name) {
        return QStringLiteral("&nbsp; <span style='color:%1'><b>&#x2501;</b></span>&nbsp;%2")
            .arg(color.name(), name);
    };
    return QStringLiteral("<b>F</b> [%1]").arg(unit) + entry(colors.approach, names.approach) +
           entry(colors.retract, names.retract);
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
    void showCycles(const std::vector<DrawnCycle>& cycles, const DrawnMeasurement& measured,
                    const SiScale& force, const SiScale& distance);
    /// @param name of the measured curve
    void showCursor(const QString& name, const AxisRange& distances, const SiScale& force,
                    const SiScale& distance);
    [[nodiscard]] PlotNavigation& navigation() { return *navigation_; }
    [[nodiscard]] QWidget& area() { return *plot_->canvas(); }
    [[nodiscard]] const QString& reading() const { return cursor_->text(); }

private:
    /// What draws one cycle; owned by the plot.
    struct Items {
        PiecewiseCurve* approach = nullptr;
        PiecewiseCurve* retract = nullptr;
        QwtPlotMarker* snapIn = nullptr;
        QwtPlotMarker* pullOff = nullptr;
    };

    [[nodiscard]] Items newItems();
    [[nodiscard]] PiecewiseCurve* newCurve();
    void color();

    QHBoxLayout* heading_;
    QLabel* legend_;
    QToolButton* reset_;
    QwtPlot* plot_;
    NumberScaleDraw* forceLabels_;     ///< owned by the plot
    NumberScaleDraw* distanceLabels_;  ///< owned by the plot
    std::array<Items, kMaxCycles> items_;
    Items measured_;
    std::unique_ptr<PlotCursor> cursor_;
    PlotNavigation* navigation_;
    QString unit_;  ///< of the forces
};

ForceDistancePlot::Canvas::Canvas(ForceDistancePlot* owner)
    : heading_(new QHBoxLayout)
    , legend_(new QLabel(owner))
    , reset_(new QToolButton(owner))
    , plot_(new QwtPlot(owner))
    , forceLabels_(new NumberScaleDraw)
    , distanceLabels_(new NumberScaleDraw) {
    legend_->setFont(theme::textFont(theme::kSmallSize));
    legend_->setMinimumWidth(1);
    legend_->setToolTip(enlargeTip());
    heading_->setSpacing(4);
    heading_->addWidget(legend_, 1);
    heading_->addWidget(reset_);
    QwtPainter::setRoundingAlignment(false);  // curves run smoothly between the pixels
    plot_->setAxisScaleDraw(QwtPlot::yLeft, forceLabels_);
    plot_->setAxisScaleDraw(QwtPlot::xBottom, distanceLabels_);
    styleLivePlot(*plot_);
    forceLabels_->setMinimumExtent(valueLabelRoom());
    keepEndRoom(*plot_);
    addZeroLine(*plot_);
    for (int age = kMaxCycles - 1; age >= 0; --age) {  // the newest is drawn last
        items_[static_cast<std::size_t>(age)] = newItems();
    }
    measured_.approach = newCurve();
    measured_.retract = newCurve();
    cursor_ = std::make_unique<PlotCursor>(*plot_);
    navigation_ = new PlotNavigation(area());
    styleResetButton(*reset_, legend_->sizeHint().height());
    QObject::connect(reset_, &QToolButton::clicked, navigation_, &PlotNavigation::reset);
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
        items_[age].retract->setPen(colors.retract, kRetractWidth, Qt::SolidLine);
        items_[age].snapIn->setSymbol(newRing(colors.approach));
        items_[age].pullOff->setSymbol(newRing(colors.retract));
    }
    measured_.approach->setPen(theme::colors().ink, kMeasuredWidth, Qt::SolidLine);
    measured_.retract->setPen(theme::colors().muted, kMeasuredWidth, Qt::SolidLine);
    legend_->setText(legendText(unit_));
}

PiecewiseCurve* ForceDistancePlot::Canvas::newCurve() {
    auto* item = new PiecewiseCurve;
    item->setRenderHint(QwtPlotItem::RenderAntialiased);
    item->attach(plot_);
    return item;
}

ForceDistancePlot::Canvas::Items ForceDistancePlot::Canvas::newItems() {
    const Items items{newCurve(), newCurve(), new QwtPlotMarker, new QwtPlotMarker};
    for (QwtPlotMarker* const ring : {items.snapIn, items.pullOff}) {
        ring->setRenderHint(QwtPlotItem::RenderAntialiased);
        ring->attach(plot_);
    }
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
                                           const DrawnMeasurement& measured, const SiScale& force,
                                           const SiScale& distance) {
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
    const auto mark = [&](QwtPlotMarker& ring, const std::optional<QPointF>& point) {
        ring.setVisible(point.has_value());
        ring.setValue(placed(point.value_or(QPointF())));
    };
    for (std::size_t age = 0; age < items_.size(); ++age) {
        const DrawnCycle cycle = age < cycles.size() ? cycles[age] : DrawnCycle();
        show(*items_[age].approach, cycle.approach);
        show(*items_[age].retract, cycle.retract);
        mark(*items_[age].snapIn, cycle.snapIn);
        mark(*items_[age].pullOff, cycle.pullOff);
    }
    show(*measured_.approach, measured.approach);
    show(*measured_.retract, measured.retract);
    reset_->setVisible(navigation_->isZoomed());
    plot_->replot();
}

void ForceDistancePlot::Canvas::showCursor(const QString& name, const AxisRange& distances,
                                           const SiScale& force, const SiScale& distance) {
    const std::optional<double> position = navigation_->cursor();
    if (!position) {
        cursor_->hide();
        return;
    }
    const double x = distance.factor * *position;
    const double reach = kReadReach * distance.factor * (distances.high - distances.low);
    const auto read = [&](const PiecewiseCurve& curve, const QString& what) {
        const std::optional<QPointF> sample = nearestSample(curve, x);
        const bool isThere = sample && std::abs(sample->x() - x) <= reach;
        return isThere ? QStringLiteral("&nbsp; ") +
                             coloredReading(curve.pen().color(),
                                            what + QLatin1Char(' ') +
                                                QString::fromStdString(threeDigitText(
                                                    sample->y(), SiScale{1.0, force.unit})))
                       : QString();
    };
    const BranchNames names = branchNames();
    QStringList lines;
    for (const Items& items : items_) {
        lines << read(*items.approach, names.approach) + read(*items.retract, names.retract);
    }
    lines << read(*measured_.approach, name) + read(*measured_.retract, names.retract);
    lines.removeAll(QString());
    const QString head = QString::fromStdString(scaledText(*position, distance, 2));
    cursor_->show(x, (QStringList{head} + lines).join(lines.size() > 1 ? "<br>" : ""));
}

ForceDistancePlot::ForceDistancePlot(QWidget* parent)
    : QWidget(parent)
    , forces_(kMinForces)
    , distances_(kMinDistances)
    , forceScale_("N", kMinForces)
    , distanceScale_("m", kMinDistanceUnit)
    , canvas_(std::make_unique<Canvas>(this)) {
    connect(&canvas_->navigation(), &PlotNavigation::windowChanged, this, &ForceDistancePlot::draw);
    connect(&canvas_->navigation(), &PlotNavigation::cursorMoved, this, &ForceDistancePlot::draw);
    new CopyablePlot(*this, [this] { return table(); });
    setCycles({}, {});
}

ForceDistancePlot::~ForceDistancePlot() = default;

void ForceDistancePlot::fitRanges(const AxisRange& distances) {
    distances_.fit(distances.low, distances.high);
    AxisRange forces;  // zero is always in sight
    const auto hold = [&forces](const QVector<QPointF>& points, const AxisRange& within) {
        for (const QPointF& point : points) {
            if (point.x() >= within.low && point.x() <= within.high) {
                forces.low = std::fmin(forces.low, point.y());
                forces.high = std::fmax(forces.high, point.y());
            }
        }
    };
    constexpr double kAnywhere = std::numeric_limits<double>::infinity();
    for (const DrawnCycle& cycle : cycles_) {
        hold(cycle.approach, {-kAnywhere, kAnywhere});
        hold(cycle.retract, {-kAnywhere, kAnywhere});
    }
    hold(measured_.approach, distances_.range());
    hold(measured_.retract, distances_.range());
    forces_.fit(forces.low, forces.high);
}

void ForceDistancePlot::setCycles(const std::vector<DrawnCycle>& newestFirst,
                                  const AxisRange& distances, const DrawnMeasurement& measured) {
    cycles_ = newestFirst;
    measured_ = measured;
    fitRanges(distances);
    draw();
}

void ForceDistancePlot::draw() {
    const PlotWindow& window = canvas_->navigation().fit({distances_.range(), forces_.range()});
    const auto largest = [](const AxisRange& range) {
        return std::max(std::abs(range.low), std::abs(range.high));
    };
    const SiScale& force = forceScale_.fit(largest(window.y));
    const SiScale& distance = distanceScale_.fit(largest(window.x));
    canvas_->showAxes(window.y, force, window.x, distance);
    canvas_->showCursor(measured_.name, window.x, force, distance);
    canvas_->showCycles(cycles_, measured_, force, distance);
}

PlotTable ForceDistancePlot::table() const {
    PlotTable table;
    const auto add = [&table](const QString& branch, const QVector<QPointF>& points) {
        std::vector<double> distances;
        std::vector<double> forces;
        for (const QPointF& point : points) {
            distances.push_back(point.x());
            forces.push_back(point.y());
        }
        table.add(tr("distance, %1 [m]").arg(branch), distances);
        table.add(tr("force, %1 [N]").arg(branch), forces);
    };
    const BranchNames names = branchNames();
    for (std::size_t age = 0; age < cycles_.size(); ++age) {
        const QString number = QStringLiteral(" %1").arg(age + 1);
        add(names.approach + number, cycles_[age].approach);
        add(names.retract + number, cycles_[age].retract);
    }
    if (!measured_.name.isEmpty()) {
        const QString of = tr("%1 of %2");
        add(of.arg(names.approach, measured_.name), measured_.approach);
        add(of.arg(names.retract, measured_.name), measured_.retract);
    }
    return table;
}

void ForceDistancePlot::forgetRange() {
    distances_ = SteadyRange(kMinDistances);
    canvas_->navigation().reset();
}

QString ForceDistancePlot::reading() const { return canvas_->reading(); }

bool ForceDistancePlot::isZoomed() const { return canvas_->navigation().isZoomed(); }

QWidget& ForceDistancePlot::canvas() { return canvas_->area(); }

QHBoxLayout& ForceDistancePlot::heading() { return canvas_->heading(); }

}  // namespace asperity
