#include "ui/plot/CurvePlot.h"

#include "ui/plot/PlotNavigation.h"
#include "ui/plot/QwtParts.h"

#include <QLabel>
#include <QToolButton>
#include <qwt_painter.h>
#include <qwt_plot.h>
#include <qwt_scale_draw.h>
#include <qwt_text.h>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr int kHistoryIntervals = 4000;  ///< of a history: zoomed in by ten, one a pixel
constexpr int kPieces = 400;             ///< that are drawn: about one a pixel
constexpr double kCurveWidth = 1.3;      ///< [px]
constexpr int kMinTickDistance = 14;     ///< [px]
constexpr int kMinTimeDistance = 46;     ///< of ticks of the time axis [px]

/// A label at an end of the horizontal axis would reach beyond the plot.
void dropEnds(std::vector<double>& ticks, const AxisRange& range) {
    constexpr double kEndShare = 0.04;
    const double room = kEndShare * (range.high - range.low);
    ticks.erase(std::remove_if(ticks.begin(), ticks.end(),
                               [&](double tick) {
                                   return tick < range.low + room || tick > range.high - room;
                               }),
                ticks.end());
}

QStringList headersOf(const CurvePlotSetup& setup) {
    QStringList headers;
    for (const CurvePlotSetup::Curve& curve : setup.curves) {
        headers << QStringLiteral("%1 [%2]").arg(curve.name, setup.unit);
    }
    return headers;
}

QString legendText(const CurvePlotSetup& setup, const QString& unit) {
    QString text = QStringLiteral("<b>%1</b> [%2]").arg(setup.title, unit);
    if (setup.curves.size() < 2) {
        return text;
    }
    for (const CurvePlotSetup::Curve& curve : setup.curves) {
        text += QStringLiteral("&nbsp; <span style='color:%1'><b>&#x2501;</b></span>&nbsp;%2")
                    .arg((theme::colors().*curve.color).name(), curve.name);
    }
    return text;
}

}  // namespace

class CurvePlot::Canvas {
public:
    Canvas(const CurvePlotSetup& setup, CurvePlot* owner);

    PlotNavigation& navigation() { return *navigation_; }
    [[nodiscard]] QWidget& area() { return *plot_->canvas(); }
    [[nodiscard]] const QString& reading() const { return cursor_->text(); }
    void showUnit(const QString& unit);
    /// Limits of the value axis, in the shown unit, and of the time axis.
    void showWindow(const AxisRange& values, const AxisRange& times);
    void showCurve(std::size_t index, const CurveHistory& history, double now, double factor);
    void showCursor();
    void showReset();
    void replot() { plot_->replot(); }

private:
    /// An axis as it is drawn.
    struct Axis {
        AxisRange range;
        int room = 0;  ///< for ticks
        bool operator==(const Axis& other) const {
            return range.low == other.range.low && range.high == other.range.high &&
                   room == other.room;
        }
    };

    void buildAxes(const CurvePlotSetup& setup);
    void buildItems(const CurvePlotSetup& setup);
    void color();
    void showAxis(int axis, Axis& shown, const Axis& wanted, NumberScaleDraw& labels,
                  const QString& unit);

    CurvePlotSetup setup_;
    QLabel* title_;
    QToolButton* reset_;
    QwtPlot* plot_;
    NumberScaleDraw* valueLabels_ = nullptr;  ///< owned by the plot
    NumberScaleDraw* timeLabels_ = nullptr;   ///< owned by the plot
    std::vector<PiecewiseCurve*> curves_;     ///< owned by the plot
    std::unique_ptr<PlotCursor> cursor_;
    PlotNavigation* navigation_ = nullptr;
    QString unit_;
    Axis values_;
    Axis times_;
};

CurvePlot::Canvas::Canvas(const CurvePlotSetup& setup, CurvePlot* owner)
    : setup_(setup)
    , title_(new QLabel(owner))
    , reset_(new QToolButton(owner))
    , plot_(new QwtPlot(owner)) {
    title_->setFont(theme::textFont(theme::kSmallSize));
    title_->setFixedHeight(title_->fontMetrics().height() + 1);
    title_->setMinimumWidth(1);
    QwtPainter::setRoundingAlignment(false);  // curves run smoothly between the pixels
    buildAxes(setup);
    buildItems(setup);
    cursor_ = std::make_unique<PlotCursor>(*plot_);
    navigation_ = new PlotNavigation(area(), AxisRange{-kSpan, 0.0});
    styleResetButton(*reset_, title_->height());
    QObject::connect(reset_, &QToolButton::clicked, navigation_, &PlotNavigation::reset);
    placeUnderTitle(*owner, *title_, *reset_, *plot_);
    theme::follow(owner, [this] { color(); });
}

void CurvePlot::Canvas::color() {
    for (std::size_t i = 0; i < curves_.size(); ++i) {
        curves_[i]->setPen(theme::colors().*setup_.curves[i].color, kCurveWidth, Qt::SolidLine);
    }
    title_->setText(legendText(setup_, unit_));
}

void CurvePlot::Canvas::buildAxes(const CurvePlotSetup& setup) {
    valueLabels_ = new NumberScaleDraw;
    plot_->setAxisScaleDraw(QwtPlot::yLeft, valueLabels_);
    timeLabels_ = new NumberScaleDraw;
    plot_->setAxisScaleDraw(QwtPlot::xBottom, timeLabels_);
    plot_->enableAxis(QwtPlot::xBottom, setup.timeLabels == TimeLabels::Shown);
    styleLivePlot(*plot_);
    valueLabels_->setMinimumExtent(valueLabelRoom());
}

void CurvePlot::Canvas::buildItems(const CurvePlotSetup& setup) {
    if (setup.zero == ZeroLine::Shown) {
        addZeroLine(*plot_);
    }
    for (std::size_t i = 0; i < setup.curves.size(); ++i) {
        curves_.push_back(new PiecewiseCurve);
        curves_.back()->setRenderHint(QwtPlotItem::RenderAntialiased);
        curves_.back()->attach(plot_);
    }
}

void CurvePlot::Canvas::showUnit(const QString& unit) {
    if (unit != unit_) {
        unit_ = unit;
        title_->setText(legendText(setup_, unit));
    }
}

void CurvePlot::Canvas::showAxis(int axis, Axis& shown, const Axis& wanted, NumberScaleDraw& labels,
                                 const QString& unit) {
    if (shown == wanted) {
        return;
    }
    shown = wanted;
    std::vector<double> ticks =
        axisTicks(wanted.range.low, wanted.range.high, std::max(1, wanted.room));
    labels.set(decimalsFor(ticks), unit);
    if (axis == QwtPlot::xBottom) {
        dropEnds(ticks, wanted.range);
    }
    plot_->setAxisScaleDiv(axis, divisions(wanted.range.low, wanted.range.high, ticks));
}

void CurvePlot::Canvas::showWindow(const AxisRange& values, const AxisRange& times) {
    showAxis(QwtPlot::yLeft, values_, {values, plot_->canvas()->height() / kMinTickDistance},
             *valueLabels_, {});
    showAxis(QwtPlot::xBottom, times_, {times, plot_->canvas()->width() / kMinTimeDistance},
             *timeLabels_, QStringLiteral("s"));
}

void CurvePlot::Canvas::showCurve(std::size_t index, const CurveHistory& history, double now,
                                  double factor) {
    QVector<QPointF> samples;
    const AxisRange& times = times_.range;
    for (const CurvePoint& point : history.points(now + times.low, now + times.high, kPieces)) {
        samples.append({point.time - now, point.value * factor});
    }
    curves_[index]->setSamples(samples);
}

void CurvePlot::Canvas::showCursor() {
    const std::optional<double> time = navigation_->cursor();
    QString text;
    for (std::size_t curve = 0; time && curve < curves_.size(); ++curve) {
        if (const std::optional<QPointF> sample = nearestSample(*curves_[curve], *time)) {
            const CurvePlotSetup::Curve& about = setup_.curves[curve];
            const std::string value =
                threeDigitText(sample->y(), SiScale{1.0, unit_.toStdString()});
            text += QStringLiteral("&nbsp; ") +
                    coloredReading(theme::colors().*about.color,
                                   about.name + QLatin1Char(' ') + QString::fromStdString(value));
        }
    }
    if (text.isEmpty()) {
        cursor_->hide();
    } else {
        cursor_->show(*time, QStringLiteral("%1 s").arg(*time, 0, 'f', 2) + text);
    }
}

void CurvePlot::Canvas::showReset() { reset_->setVisible(navigation_->isZoomed()); }

CurvePlot::CurvePlot(const CurvePlotSetup& setup, QWidget* parent)
    : QWidget(parent)
    , headers_(headersOf(setup))
    , zero_(setup.zero)
    , histories_(setup.curves.size(), CurveHistory(kSpan, kHistoryIntervals))
    , range_(setup.smallest)
    , scale_(setup.unit.toStdString(), setup.smallest)
    , canvas_(std::make_unique<Canvas>(setup, this)) {
    connect(&canvas_->navigation(), &PlotNavigation::windowChanged, this, &CurvePlot::refresh);
    connect(&canvas_->navigation(), &PlotNavigation::cursorMoved, this, &CurvePlot::refresh);
    new CopyablePlot(*this, [this] { return table(); });
    refresh();
}

CurvePlot::~CurvePlot() = default;

/// Each curve has times of its own: those of its peaks.
PlotTable CurvePlot::table() const {
    PlotTable table;
    for (std::size_t curve = 0; curve < histories_.size(); ++curve) {
        std::vector<double> times;
        std::vector<double> values;
        for (const CurvePoint& point : histories_[curve].points()) {
            times.push_back(point.time);
            values.push_back(point.value);
        }
        table.add(tr("time [s]"), times);
        table.add(headers_.at(static_cast<int>(curve)), values);
    }
    return table;
}

void CurvePlot::take(double time, const Values& values) noexcept {
    for (std::size_t curve = 0; curve < histories_.size(); ++curve) {
        histories_[curve].add(time, values[curve]);
    }
}

void CurvePlot::fitRange() {
    bool found = zero_ == ZeroLine::Shown;
    CurveExtent all;
    for (const CurveHistory& history : drawn()) {
        if (history.isEmpty()) {
            continue;
        }
        const CurveExtent one = history.extent();
        all = found ? CurveExtent{std::min(all.low, one.low), std::max(all.high, one.high)} : one;
        found = true;
    }
    range_.fit(all.low, all.high);
}

void CurvePlot::refresh() {
    fitRange();
    const PlotWindow& window = canvas_->navigation().fit({{-kSpan, 0.0}, range_.range()});
    shownTimes_ = window.x;
    // A range far from zero takes the prefix of its extent: 7012 nm and not 7.012 um.
    const double largest = std::max(std::abs(window.y.low), std::abs(window.y.high));
    const SiScale& scale = scale_.fit(std::min(largest, 50.0 * (window.y.high - window.y.low)));
    canvas_->showUnit(QString::fromStdString(scale.unit));
    canvas_->showWindow({window.y.low * scale.factor, window.y.high * scale.factor}, window.x);
    double now = 0.0;
    for (const CurveHistory& history : drawn()) {
        now = std::max(now, history.newestTime());
    }
    for (std::size_t curve = 0; curve < drawn().size(); ++curve) {
        canvas_->showCurve(curve, drawn()[curve], now, scale.factor);
    }
    canvas_->showCursor();
    canvas_->showReset();
    canvas_->replot();
}

void CurvePlot::clear() {
    for (CurveHistory& history : histories_) {
        history.clear();
    }
    refresh();
}

std::function<void()> CurvePlot::keptCurves() {
    return [this, histories = histories_, paused = paused_] {
        histories_ = histories;
        paused_ = paused;
        refresh();
    };
}

void CurvePlot::setPaused(bool paused) {
    if (paused != isPaused()) {
        paused_ = paused ? std::optional(histories_) : std::nullopt;
        refresh();
    }
}

QString CurvePlot::reading() const { return canvas_->reading(); }

bool CurvePlot::isZoomed() const { return canvas_->navigation().isZoomed(); }

QWidget& CurvePlot::canvas() { return canvas_->area(); }

}  // namespace asperity
