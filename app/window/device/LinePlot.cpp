#include "app/window/device/LinePlot.h"

#include "core/SiFormat.h"
#include "ui/plot/CurveHistory.h"
#include "ui/plot/QwtParts.h"
#include "ui/widgets/Theme.h"

#include <QLabel>
#include <QToolButton>
#include <qwt_plot.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace asperity {

namespace {

constexpr double kWayMargin = 0.06;         ///< of the values' extent, above and below
constexpr double kWayWidth = 1.3;           ///< of a curve [px]
constexpr int kWayStretches = 2000;         ///< of a curve that is drawn: more than pixels
constexpr int kWayMinTickHeight = 16;       ///< between ticks of the value axis [px]
constexpr int kWayMinTickWidth = 70;        ///< between those of the distance axis [px]
constexpr double kWayMinLength = 1e-12;     ///< least extent of the distance axis [m]
constexpr double kWayLeastExtent = 1e-24;   ///< of the value axis, where nothing else is [unit]
constexpr double kWayRoundingShare = 1e-9;  ///< of the values: a finer axis shows their rounding
constexpr std::array<QColor ThemeColors::*, 2> kWayColors = {&ThemeColors::blue,
                                                             &ThemeColors::orange};

std::array<QString, 2> namesOfWays() { return {QObject::tr("trace"), QObject::tr("retrace")}; }

bool isOnWay(const QPointF& point) { return std::isfinite(point.x()) && std::isfinite(point.y()); }

/// The extent of the values of both ways; none: no value is a number.
std::optional<AxisRange> valuesOfWays(const LinePlot::Ways& ways) {
    AxisRange range{std::numeric_limits<double>::infinity(),
                    -std::numeric_limits<double>::infinity()};
    for (const QVector<QPointF>* const way : {&ways.trace, &ways.retrace}) {
        for (const QPointF& point : *way) {
            if (isOnWay(point)) {
                range = {std::min(range.low, point.y()), std::max(range.high, point.y())};
            }
        }
    }
    return range.low <= range.high ? std::optional(range) : std::nullopt;
}

AxisRange valueAxisOf(const AxisRange& values, double smallest) {
    const double rounding =
        kWayRoundingShare * std::max(std::abs(values.low), std::abs(values.high));
    const double extent = std::max({values.high - values.low, smallest, rounding, kWayLeastExtent});
    const double middle = 0.5 * values.low + 0.5 * values.high;
    const double half = (0.5 + kWayMargin) * extent;
    return {middle - half, middle + half};
}

/// A range far from zero takes the prefix of its extent: 7012 nm and not 7.012 um.
SiScale scaleOfWays(const AxisRange& range, const QString& unit) {
    const double largest = std::max(std::abs(range.low), std::abs(range.high));
    return siScaleFor(std::min(largest, 50.0 * (range.high - range.low)), unit.toStdString());
}

/// The part of a way that is in sight, in whichever direction it goes.
QVector<QPointF> wayWithin(const QVector<QPointF>& way, const AxisRange& distances) {
    int from = 0;
    int to = 0;
    for (int i = 0; i + 1 < way.size(); ++i) {
        const auto [low, high] = std::minmax({way[i].x(), way[i + 1].x()});
        if (low <= distances.high && high >= distances.low) {
            from = to == 0 ? i : from;
            to = i + 2;
        }
    }
    return thinned(way, from, to, kWayStretches);
}

/// The sample next to a distance; none: the way has no value there, or has not come there yet.
std::optional<QPointF> sampleOfWay(const QwtPlotCurve& curve, double distance) {
    for (int i = 1; i < static_cast<int>(curve.dataSize()); ++i) {
        const QPointF one = curve.sample(i - 1);
        const QPointF other = curve.sample(i);
        if ((one.x() - distance) * (other.x() - distance) <= 0.0) {
            const bool isOther = std::abs(other.x() - distance) < std::abs(one.x() - distance);
            const QPointF nearest = isOther ? other : one;
            return isOnWay(nearest) ? std::optional(nearest) : std::nullopt;
        }
    }
    return std::nullopt;
}

}  // namespace

LinePlot::LinePlot(const Setup& setup, QWidget* parent)
    : QWidget(parent)
    , setup_(setup)
    , title_(new QLabel(this))
    , reset_(new QToolButton(this))
    , plot_(new QwtPlot(this))
    , valueLabels_(new NumberScaleDraw)
    , distanceLabels_(new NumberScaleDraw) {
    title_->setFont(theme::textFont(theme::kSmallSize));
    title_->setFixedHeight(title_->fontMetrics().height() + 1);
    title_->setMinimumWidth(1);
    plot_->setAxisScaleDraw(QwtPlot::yLeft, valueLabels_);
    plot_->setAxisScaleDraw(QwtPlot::xBottom, distanceLabels_);
    styleLivePlot(*plot_);
    valueLabels_->setMinimumExtent(valueLabelRoom());
    for (PiecewiseCurve*& curve : curves_) {
        curve = new PiecewiseCurve;
        curve->setRenderHint(QwtPlotItem::RenderAntialiased);
        curve->attach(plot_);
    }
    reading_ = std::make_unique<PlotCursor>(*plot_);
    navigation_ = new PlotNavigation(canvas());
    styleResetButton(*reset_, title_->height());
    connect(reset_, &QToolButton::clicked, navigation_, &PlotNavigation::reset);
    connect(navigation_, &PlotNavigation::windowChanged, this, &LinePlot::draw);
    connect(navigation_, &PlotNavigation::cursorMoved, this, [this] {
        showReading();
        plot_->replot();
    });
    setToolTip(tr("%1 along the line, forward (trace) and backward (retrace)").arg(setup.title) +
               QLatin1Char('\n') + PlotNavigation::help());
    placeUnderTitle(*this, *title_, *reset_, *plot_);
    new CopyablePlot(*this, [this] { return table(); });
    theme::follow(this, [this] { draw(); });
}

LinePlot::~LinePlot() = default;

void LinePlot::setWays(const Ways& ways, double length) {
    const bool isOther = length != length_;
    ways_ = ways;
    length_ = length;
    if (isOther) {
        navigation_->reset();  // what was looked at is of another line
    }
    draw();
}

PlotTable LinePlot::table() const {
    PlotTable table;
    const auto add = [&table](const QString& distance, const QString& value, const auto& way) {
        std::vector<double> distances;
        std::vector<double> values;
        for (const QPointF& point : way) {
            distances.push_back(point.x());
            values.push_back(point.y());
        }
        table.add(distance, distances);
        table.add(value, values);
    };
    add(tr("distance [m]"), tr("%1, trace [%2]").arg(setup_.title, setup_.unit), ways_.trace);
    add(tr("distance back [m]"), tr("%1, retrace [%2]").arg(setup_.title, setup_.unit),
        ways_.retrace);
    return table;
}

QString LinePlot::reading() const { return reading_->text(); }

QWidget& LinePlot::canvas() { return *plot_->canvas(); }

void LinePlot::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    draw();  // the ticks suit the size
}

void LinePlot::draw() {
    const std::optional<AxisRange> values = valuesOfWays(ways_);
    shown_ = navigation_->fit({{0.0, std::max(kWayMinLength, length_)},
                               valueAxisOf(values.value_or(AxisRange{}), setup_.smallest)});
    showAxes(values.has_value());
    showWays();
    showReading();
    showTitle();
    reset_->setVisible(navigation_->isZoomed());
    plot_->replot();
}

void LinePlot::showAxes(bool numbered) {
    value_ = scaleOfWays(shown_.y, setup_.unit);
    distance_ = scaleOfWays(shown_.x, QStringLiteral("m"));
    showAxis(QwtPlot::yLeft, *valueLabels_, shown_.y, value_);
    showAxis(QwtPlot::xBottom, *distanceLabels_, shown_.x, distance_);
    for (NumberScaleDraw* const labels : {valueLabels_, distanceLabels_}) {
        labels->enableComponent(QwtAbstractScaleDraw::Labels, numbered);
    }
}

void LinePlot::showAxis(int axis, NumberScaleDraw& labels, const AxisRange& range,
                        const SiScale& scale) {
    const bool isDistance = axis == QwtPlot::xBottom;
    const int room = isDistance ? plot_->canvas()->width() / kWayMinTickWidth
                                : plot_->canvas()->height() / kWayMinTickHeight;
    const double low = scale.factor * range.low;
    const double high = scale.factor * range.high;
    const std::vector<double> ticks = axisTicks(low, high, std::max(1, room));
    // The unit of the values stands in the title.
    labels.set(decimalsFor(ticks), isDistance ? QString::fromStdString(scale.unit) : QString());
    plot_->setAxisScaleDiv(axis, divisions(low, high, ticks));
}

void LinePlot::showWays() {
    const std::array<const QVector<QPointF>*, 2> both = {&ways_.trace, &ways_.retrace};
    for (std::size_t i = 0; i < both.size(); ++i) {
        QVector<QPointF> drawn = wayWithin(*both[i], shown_.x);
        for (QPointF& point : drawn) {
            // Infinity parts two pieces, too.
            const double value = isOnWay(point) ? value_.factor * point.y() : std::nan("");
            point = {distance_.factor * point.x(), value};
        }
        curves_[i]->setPen(theme::colors().*kWayColors[i], kWayWidth, Qt::SolidLine);
        curves_[i]->setSamples(drawn);
    }
}

void LinePlot::showReading() {
    const std::optional<double> position = navigation_->cursor();
    const double distance = distance_.factor * position.value_or(0.0);
    QString text;
    for (std::size_t i = 0; position && i < curves_.size(); ++i) {
        if (const std::optional<QPointF> sample = sampleOfWay(*curves_[i], distance)) {
            const std::string value = threeDigitText(sample->y(), SiScale{1.0, value_.unit});
            text += QStringLiteral("&nbsp; ") + coloredReading(theme::colors().*kWayColors[i],
                                                               namesOfWays()[i] + QLatin1Char(' ') +
                                                                   QString::fromStdString(value));
        }
    }
    if (text.isEmpty()) {
        reading_->hide();
    } else {
        const std::string at = scaledText(distance, SiScale{1.0, distance_.unit}, 2);
        reading_->show(distance, QString::fromStdString(at) + text);
    }
}

void LinePlot::showTitle() {
    QString text = QStringLiteral("<b>%1</b> [%2]")
                       .arg(setup_.title.toHtmlEscaped(), QString::fromStdString(value_.unit));
    for (std::size_t i = 0; i < kWayColors.size(); ++i) {
        text += QStringLiteral("&nbsp; <span style='color:%1'><b>&#x2501;</b></span>&nbsp;%2")
                    .arg((theme::colors().*kWayColors[i]).name(), namesOfWays()[i]);
    }
    title_->setText(text);
}

}  // namespace asperity
