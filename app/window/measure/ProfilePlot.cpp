#include "app/window/measure/ProfilePlot.h"

#include "ui/plot/CopyablePlot.h"
#include "ui/plot/PlotNavigation.h"
#include "ui/plot/QwtParts.h"
#include "ui/widgets/Theme.h"

#include <QVBoxLayout>
#include <qwt_plot.h>
#include <qwt_plot_legenditem.h>
#include <qwt_plot_marker.h>
#include <qwt_plot_zoneitem.h>
#include <qwt_text.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace asperity {

namespace {

constexpr double kMinHeights = 0.1e-9;  ///< extent of the height axis [m]
constexpr double kEmptyLength = 1e-6;   ///< of the distance axis without a profile [m]
constexpr double kMargin = 0.06;        ///< of the heights' extent, above and below
constexpr double kCurveWidth = 1.2;     ///< [px]
constexpr double kSelectedWidth = 2.0;  ///< [px]
constexpr double kSelectedZ = 30.0;     ///< above the others
constexpr int kMinTickHeight = 16;      ///< between ticks of the height axis [px]
constexpr int kMinTickWidth = 70;       ///< between those of the distance axis [px]
constexpr int kZoneOpacity = 46;        ///< of a stretch, of 255
constexpr int kLegendOpacity = 200;     ///< of the paper behind the legend, of 255

double lengthOf(const ProfileCurve& curve) {
    return curve.points.isEmpty() ? 0.0 : curve.points.last().x();
}

double longestOf(const QVector<ProfileCurve>& curves) {
    double longest = 0.0;
    for (const ProfileCurve& curve : curves) {
        longest = std::max(longest, lengthOf(curve));
    }
    return longest;
}

AxisRange heightsOf(const QVector<ProfileCurve>& curves) {
    AxisRange range{std::numeric_limits<double>::infinity(),
                    -std::numeric_limits<double>::infinity()};
    for (const ProfileCurve& curve : curves) {
        for (const QPointF& point : curve.points) {
            if (std::isfinite(point.y())) {
                range = {std::min(range.low, point.y()), std::max(range.high, point.y())};
            }
        }
    }
    if (!(range.low <= range.high)) {
        return {0.0, kMinHeights};
    }
    const double extent = std::max(range.high - range.low, kMinHeights);
    const double middle = 0.5 * (range.low + range.high);
    const double half = (0.5 + kMargin) * extent;
    return {middle - half, middle + half};
}

}  // namespace

class ProfilePlot::Canvas {
public:
    explicit Canvas(ProfilePlot* owner);

    [[nodiscard]] PlotNavigation& navigation() { return *navigation_; }
    [[nodiscard]] PlotHandles& handles() { return *handles_; }
    [[nodiscard]] QWidget& area() { return *plot_->canvas(); }
    void showAxes(const PlotWindow& window, const SiScale& distance, const SiScale& height);
    void showCurves(const QVector<ProfileCurve>& curves, int selected, const SiScale& distance,
                    const SiScale& height);
    void showCursors(const Cursors& cursors, double factor, bool visible);
    void showStretches(const std::optional<Stretches>& stretches, double factor);
    void showReading(const SiScale& distance, const SiScale& height);
    void replot() { plot_->replot(); }

private:
    void color();
    void showAxis(int axis, NumberScaleDraw& labels, const AxisRange& range, const SiScale& scale,
                  int room);

    QwtPlot* plot_;
    NumberScaleDraw* heightLabels_;    ///< owned by the plot
    NumberScaleDraw* distanceLabels_;  ///< owned by the plot
    std::vector<std::unique_ptr<PiecewiseCurve>> curves_;
    std::vector<int> colors_;  ///< of the curves
    const PiecewiseCurve* selected_ = nullptr;
    QwtPlotLegendItem* legend_;
    std::array<QwtPlotMarker*, 2> cursors_{};
    std::array<QwtPlotZoneItem*, 2> stretches_{};
    std::unique_ptr<PlotCursor> reading_;
    PlotNavigation* navigation_;
    PlotHandles* handles_;
};

ProfilePlot::Canvas::Canvas(ProfilePlot* owner)
    : plot_(new QwtPlot(owner))
    , heightLabels_(new NumberScaleDraw)
    , distanceLabels_(new NumberScaleDraw)
    , legend_(new QwtPlotLegendItem) {
    plot_->setAxisScaleDraw(QwtPlot::yLeft, heightLabels_);
    plot_->setAxisScaleDraw(QwtPlot::xBottom, distanceLabels_);
    styleLivePlot(*plot_);
    heightLabels_->setMinimumExtent(valueLabelRoom());
    for (QwtPlotZoneItem*& stretch : stretches_) {
        stretch = new QwtPlotZoneItem;
        stretch->setOrientation(Qt::Vertical);
        stretch->setItemAttribute(QwtPlotItem::Legend, false);
        stretch->attach(plot_);
    }
    legend_->setAlignment(Qt::AlignTop | Qt::AlignHCenter);
    legend_->setFont(theme::textFont(theme::kSmallSize));
    legend_->setBorderRadius(0.0);
    legend_->setMargin(0);
    legend_->attach(plot_);
    for (QwtPlotMarker*& cursor : cursors_) {
        cursor = new QwtPlotMarker;
        cursor->setLineStyle(QwtPlotMarker::VLine);
        cursor->setItemAttribute(QwtPlotItem::Legend, false);
        cursor->attach(plot_);
    }
    reading_ = std::make_unique<PlotCursor>(*plot_);
    navigation_ = new PlotNavigation(area());
    handles_ = new PlotHandles(area(), *navigation_);
    plot_->setToolTip(QObject::tr("Heights along the lines\nDrag A and B, "
                                  "or the edges of the stretches\n") +
                      PlotNavigation::help());
    auto* layout = new QVBoxLayout(owner);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(plot_);
    theme::follow(owner, [this] { color(); });
}

void ProfilePlot::Canvas::color() {
    const ThemeColors& colors = theme::colors();
    const std::array<QColor, 2> zones = {colors.green, colors.orange};
    const std::array<QString, 2> names = {QStringLiteral("A"), QStringLiteral("B")};
    for (std::size_t i = 0; i < 2; ++i) {
        QColor fill = zones[i];
        fill.setAlpha(kZoneOpacity);
        stretches_[i]->setBrush(fill);
        stretches_[i]->setPen(zones[i], 1.0, Qt::SolidLine);
        QwtText name(names[i]);
        name.setFont(theme::boldFont(theme::kSmallSize));
        name.setColor(colors.ink);
        cursors_[i]->setLabel(name);
        cursors_[i]->setLinePen(colors.ink, 1.0, Qt::SolidLine);
    }
    legend_->setTextPen(colors.ink);
    QColor paper = colors.paper;
    paper.setAlpha(kLegendOpacity);
    legend_->setBackgroundBrush(paper);
    legend_->setBorderPen(Qt::NoPen);
    for (std::size_t i = 0; i < curves_.size(); ++i) {
        const double width = curves_[i].get() == selected_ ? kSelectedWidth : kCurveWidth;
        curves_[i]->setPen(seriesColor(colors, static_cast<std::size_t>(colors_[i])), width,
                           Qt::SolidLine);
    }
}

void ProfilePlot::Canvas::showAxis(int axis, NumberScaleDraw& labels, const AxisRange& range,
                                   const SiScale& scale, int room) {
    const double low = scale.factor * range.low;
    const double high = scale.factor * range.high;
    const std::vector<double> ticks = axisTicks(low, high, std::max(1, room));
    labels.set(decimalsFor(ticks), QString::fromStdString(scale.unit));
    plot_->setAxisScaleDiv(axis, divisions(low, high, ticks));
}

void ProfilePlot::Canvas::showAxes(const PlotWindow& window, const SiScale& distance,
                                   const SiScale& height) {
    showAxis(QwtPlot::yLeft, *heightLabels_, window.y, height,
             plot_->canvas()->height() / kMinTickHeight);
    showAxis(QwtPlot::xBottom, *distanceLabels_, window.x, distance,
             plot_->canvas()->width() / kMinTickWidth);
}

void ProfilePlot::Canvas::showCurves(const QVector<ProfileCurve>& curves, int selected,
                                     const SiScale& distance, const SiScale& height) {
    while (curves_.size() > static_cast<std::size_t>(curves.size())) {
        curves_.pop_back();
    }
    while (curves_.size() < static_cast<std::size_t>(curves.size())) {
        curves_.push_back(std::make_unique<PiecewiseCurve>());
        curves_.back()->setRenderHint(QwtPlotItem::RenderAntialiased);
        curves_.back()->setLegendAttribute(QwtPlotCurve::LegendShowLine);
        curves_.back()->attach(plot_);
    }
    selected_ = selected < 0 ? nullptr : curves_[static_cast<std::size_t>(selected)].get();
    colors_.clear();
    for (std::size_t i = 0; i < curves_.size(); ++i) {
        const ProfileCurve& curve = curves[static_cast<int>(i)];
        QVector<QPointF> shown;
        shown.reserve(curve.points.size());
        for (const QPointF& point : curve.points) {
            shown.append({distance.factor * point.x(), height.factor * point.y()});
        }
        curves_[i]->setSamples(shown);
        curves_[i]->setTitle(curve.name);
        curves_[i]->setZ(curves_[i].get() == selected_ ? kSelectedZ : kSelectedZ - 1.0);
        colors_.push_back(curve.color);
    }
    legend_->setVisible(curves.size() > 1);
    color();
}

void ProfilePlot::Canvas::showCursors(const Cursors& cursors, double factor, bool visible) {
    for (std::size_t i = 0; i < 2; ++i) {
        cursors_[i]->setXValue(factor * cursors[i]);
        // On the side with more room: at an end of the line the other side is outside.
        const QwtInterval shown = plot_->axisInterval(QwtPlot::xBottom);
        const bool isOnTheRight =
            cursors_[i]->xValue() > 0.5 * (shown.minValue() + shown.maxValue());
        cursors_[i]->setLabelAlignment(Qt::AlignTop |
                                       (isOnTheRight ? Qt::AlignLeft : Qt::AlignRight));
        cursors_[i]->setVisible(visible);
    }
}

void ProfilePlot::Canvas::showStretches(const std::optional<Stretches>& stretches, double factor) {
    for (std::size_t i = 0; i < 2; ++i) {
        stretches_[i]->setVisible(stretches.has_value());
        if (stretches) {
            const PlotStretch& stretch = (*stretches)[i];
            stretches_[i]->setInterval(factor * std::min(stretch.from, stretch.to),
                                       factor * std::max(stretch.from, stretch.to));
        }
    }
}

void ProfilePlot::Canvas::showReading(const SiScale& distance, const SiScale& height) {
    const std::optional<double> position = navigation_->cursor();
    const std::optional<QPointF> sample =
        position && selected_ != nullptr ? nearestSample(*selected_, distance.factor * *position)
                                         : std::nullopt;
    if (!sample) {
        reading_->hide();
        return;
    }
    const auto text = [](double value, const SiScale& scale) {
        return QString::fromStdString(scaledText(value, SiScale{1.0, scale.unit}, 2));
    };
    reading_->show(sample->x(), QObject::tr("%1 &nbsp; height %2")
                                    .arg(text(sample->x(), distance), text(sample->y(), height)));
}

ProfilePlot::ProfilePlot(QWidget* parent)
    : QWidget(parent), canvas_(std::make_unique<Canvas>(this)) {
    connect(&canvas_->navigation(), &PlotNavigation::windowChanged, this, &ProfilePlot::draw);
    connect(&canvas_->navigation(), &PlotNavigation::cursorMoved, this, &ProfilePlot::draw);
    connect(&canvas_->handles(), &PlotHandles::dragged, this, &ProfilePlot::drag);
    new CopyablePlot(*this, [this] { return table(); });
    draw();
}

ProfilePlot::~ProfilePlot() = default;

void ProfilePlot::setCurves(const QVector<ProfileCurve>& curves, int selected) {
    const bool other = longestOf(curves) != longestOf(curves_);
    curves_ = curves;
    selected_ = selected;
    if (other) {
        canvas_->navigation().reset();  // what was looked at is of other lines
    }
    draw();
}

PlotTable ProfilePlot::table() const {
    PlotTable table;
    for (const ProfileCurve& curve : curves_) {
        std::vector<double> distances;
        std::vector<double> heights;
        for (const QPointF& point : curve.points) {
            distances.push_back(point.x());
            heights.push_back(point.y());
        }
        const QString of = curves_.size() > 1 ? QStringLiteral(", ") + curve.name : QString();
        table.add(tr("distance%1 [m]").arg(of), distances);
        table.add(tr("height%1 [m]").arg(of), heights);
    }
    return table;
}

double ProfilePlot::selectedLength() const {
    return selected_ < 0 ? 0.0 : lengthOf(curves_[selected_]);
}

void ProfilePlot::setCursors(const Cursors& distances) {
    cursors_ = distances;
    draw();
}

void ProfilePlot::setStretches(const std::optional<Stretches>& stretches) {
    stretches_ = stretches;
    draw();
}

void ProfilePlot::drag(int handle, double distance) {
    if (handle < 2) {
        Q_EMIT cursorDragged(handle, distance);
    } else {
        Q_EMIT stretchDragged((handle - 2) / 2, (handle - 2) % 2, distance);
    }
}

void ProfilePlot::draw() {
    const double longest = longestOf(curves_);
    const PlotWindow& window = canvas_->navigation().fit(
        {{0.0, longest > 0.0 ? longest : kEmptyLength}, heightsOf(curves_)});
    const SiScale distance = siScaleFor(std::max(std::abs(window.x.high), 1e-9), "m");
    const SiScale height =
        siScaleFor(std::max({std::abs(window.y.low), std::abs(window.y.high), 1e-9}), "m");
    const bool isSelected = selectedLength() > 0.0;
    canvas_->showAxes(window, distance, height);
    canvas_->showCurves(curves_, selected_, distance, height);
    canvas_->showCursors(cursors_, distance.factor, isSelected);
    canvas_->showStretches(isSelected ? stretches_ : std::nullopt, distance.factor);
    canvas_->showReading(distance, height);
    QVector<double> handles;
    if (isSelected) {
        handles << cursors_[0] << cursors_[1];
        if (stretches_) {
            for (const PlotStretch& stretch : *stretches_) {
                handles << stretch.from << stretch.to;
            }
        }
    }
    canvas_->handles().setPositions(handles);
    canvas_->replot();
}

QWidget& ProfilePlot::canvas() { return canvas_->area(); }

double ProfilePlot::pixelOf(double distance) const {
    return canvas_->navigation().pixelOf(distance);
}

}  // namespace asperity
