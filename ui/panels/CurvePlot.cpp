#include "ui/panels/CurvePlot.h"

#include "ui/Theme.h"
#include "ui/panels/AxisTicks.h"

#include <QLabel>
#include <QVBoxLayout>
#include <qwt_painter.h>
#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_plot_marker.h>
#include <qwt_scale_div.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_widget.h>
#include <qwt_text.h>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr int kIntervals = 400;       ///< of a history: about one a pixel
constexpr double kCurveWidth = 1.3;   ///< [px]
constexpr int kTickLength = 4;        ///< [px]
constexpr int kMinTickDistance = 14;  ///< [px]
constexpr int kMinCanvasHeight = 40;  ///< [px]
constexpr int kMaxLabelDigits = 6;    ///< letters of a label for which room is kept

/// A curve in pieces: a value that is not a number parts two of them.
class PiecewiseCurve : public QwtPlotCurve {
public:
    // NOLINTNEXTLINE(readability-function-size): the parameters are Qwt's
    void drawSeries(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
                    const QRectF& canvas, int from, int to) const override {
        const int last = to < 0 ? static_cast<int>(dataSize()) - 1 : to;
        int begin = from;
        for (int i = from; i <= last + 1; ++i) {
            const bool atEnd = i == last + 1;
            if (!atEnd && !std::isnan(sample(i).y())) {
                continue;
            }
            if (i > begin) {
                QwtPlotCurve::drawSeries(painter, xMap, yMap, canvas, begin, i - 1);
            }
            begin = i + 1;
        }
    }
};

/// Numbers with the same count of decimals at every tick.
class ValueScaleDraw : public QwtScaleDraw {
public:
    void setDecimals(int decimals) {
        if (decimals_ != decimals) {
            decimals_ = decimals;
            invalidateCache();
        }
    }
    [[nodiscard]] QwtText label(double value) const override {
        return QString::number(value, 'f', decimals_);
    }

private:
    int decimals_ = 0;
};

class TimeScaleDraw : public QwtScaleDraw {
public:
    [[nodiscard]] QwtText label(double value) const override {
        return QStringLiteral("%1 s").arg(value);
    }
};

int decimalsFor(const std::vector<double>& ticks) {
    const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
    return std::clamp(static_cast<int>(-std::floor(std::log10(step) + 1e-9)), 0, 9);
}

QwtScaleDiv divisions(double low, double high, const std::vector<double>& ticks) {
    return QwtScaleDiv(low, high, {}, {}, QList<double>(ticks.begin(), ticks.end()));
}

QString legendText(const CurvePlotSetup& setup, const QString& unit) {
    QString text = QStringLiteral("<b>%1</b> [%2]").arg(setup.title, unit);
    if (setup.curves.size() < 2) {
        return text;
    }
    for (const CurvePlotSetup::Curve& curve : setup.curves) {
        text += QStringLiteral("&nbsp; <span style='color:%1'><b>&#x2501;</b></span>&nbsp;%2")
                    .arg(QColor(curve.color).name(), curve.name);
    }
    return text;
}

}  // namespace

class CurvePlot::Canvas {
public:
    Canvas(const CurvePlotSetup& setup, CurvePlot* owner);

    void showUnit(const QString& unit);
    /// Limits of the value axis, in the shown unit.
    void showRange(const AxisRange& range);
    void showCurve(std::size_t index, const CurveHistory& history, double now, double factor);
    void replot() { plot_->replot(); }

private:
    void buildAxes(const CurvePlotSetup& setup);
    void buildItems(const CurvePlotSetup& setup);

    CurvePlotSetup setup_;
    QLabel* title_;
    QwtPlot* plot_;
    ValueScaleDraw* valueLabels_ = nullptr;  ///< owned by the plot
    std::vector<PiecewiseCurve*> curves_;    ///< owned by the plot
    QString unit_;
    AxisRange range_;
    std::size_t tickRoom_ = 0;
};

CurvePlot::Canvas::Canvas(const CurvePlotSetup& setup, CurvePlot* owner)
    : setup_(setup), title_(new QLabel(owner)), plot_(new QwtPlot(owner)) {
    title_->setFont(theme::textFont(theme::kSmallSize));
    title_->setFixedHeight(title_->fontMetrics().height() + 1);
    title_->setMinimumWidth(1);
    QwtPainter::setRoundingAlignment(false);  // curves run smoothly between the pixels
    buildAxes(setup);
    buildItems(setup);
    auto* layout = new QVBoxLayout(owner);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(1);
    layout->addWidget(title_);
    layout->addWidget(plot_, 1);
}

void CurvePlot::Canvas::buildAxes(const CurvePlotSetup& setup) {
    auto* canvas = new QwtPlotCanvas(plot_);
    canvas->setFrameStyle(QFrame::NoFrame);
    canvas->setPaintAttribute(QwtPlotCanvas::BackingStore, false);  // every frame is a new one
    plot_->setCanvas(canvas);
    plot_->setCanvasBackground(QColor(theme::kPaper));
    plot_->setMinimumSize(120, kMinCanvasHeight);
    plot_->plotLayout()->setAlignCanvasToScales(true);
    plot_->plotLayout()->setSpacing(0);

    valueLabels_ = new ValueScaleDraw;
    plot_->setAxisScaleDraw(QwtPlot::yLeft, valueLabels_);
    plot_->setAxisScaleDraw(QwtPlot::xBottom, new TimeScaleDraw);
    plot_->setAxisScaleDiv(QwtPlot::xBottom, divisions(-kSpan, 0.0, {-8.0, -6.0, -4.0, -2.0}));
    plot_->enableAxis(QwtPlot::xBottom, setup.timeLabels == TimeLabels::Shown);
    for (const int axis : {QwtPlot::yLeft, QwtPlot::xBottom}) {
        plot_->setAxisFont(axis, theme::textFont(theme::kSmallSize - 1));
        QPalette palette;
        palette.setColor(QPalette::WindowText, theme::kFaint);
        palette.setColor(QPalette::Text, theme::kMuted);
        plot_->axisWidget(axis)->setPalette(palette);
        plot_->axisWidget(axis)->setMargin(0);
        QwtScaleDraw* draw = plot_->axisScaleDraw(axis);
        draw->setTickLength(QwtScaleDiv::MajorTick, kTickLength);
        draw->setSpacing(2);
    }
    const QFontMetrics metrics(theme::textFont(theme::kSmallSize - 1));
    valueLabels_->setMinimumExtent(kMaxLabelDigits * metrics.horizontalAdvance(QLatin1Char('0')) +
                                   kTickLength + 2);
}

void CurvePlot::Canvas::buildItems(const CurvePlotSetup& setup) {
    auto* grid = new QwtPlotGrid;
    grid->setPen(QColor(theme::kFaint), 0.0, Qt::SolidLine);
    grid->attach(plot_);
    if (setup.zero == ZeroLine::Shown) {
        auto* zero = new QwtPlotMarker;
        zero->setLineStyle(QwtPlotMarker::HLine);
        zero->setLinePen(QColor(theme::kMuted), 0.0, Qt::SolidLine);
        zero->attach(plot_);
    }
    for (const CurvePlotSetup::Curve& curve : setup.curves) {
        curves_.push_back(new PiecewiseCurve);
        curves_.back()->setPen(QColor(curve.color), kCurveWidth, Qt::SolidLine);
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

void CurvePlot::Canvas::showRange(const AxisRange& range) {
    const auto room =
        static_cast<std::size_t>(std::max(1, plot_->canvas()->height() / kMinTickDistance));
    if (range.low == range_.low && range.high == range_.high && room == tickRoom_) {
        return;
    }
    range_ = range;
    tickRoom_ = room;
    const std::vector<double> ticks = axisTicks(range.low, range.high, static_cast<int>(room));
    valueLabels_->setDecimals(decimalsFor(ticks));
    plot_->setAxisScaleDiv(QwtPlot::yLeft, divisions(range.low, range.high, ticks));
}

void CurvePlot::Canvas::showCurve(std::size_t index, const CurveHistory& history, double now,
                                  double factor) {
    QVector<QPointF> samples;
    for (const CurvePoint& point : history.points()) {
        samples.append({point.time - now, point.value * factor});
    }
    curves_[index]->setSamples(samples);
}

CurvePlot::CurvePlot(const CurvePlotSetup& setup, QWidget* parent)
    : QWidget(parent)
    , zero_(setup.zero)
    , histories_(setup.curves.size(), CurveHistory(kSpan, kIntervals))
    , range_(setup.smallest)
    , scale_(setup.unit.toStdString(), setup.smallest)
    , canvas_(std::make_unique<Canvas>(setup, this)) {
    refresh();
}

CurvePlot::~CurvePlot() = default;

void CurvePlot::take(double time, const Values& values) noexcept {
    for (std::size_t curve = 0; curve < histories_.size(); ++curve) {
        histories_[curve].add(time, values[curve]);
    }
}

void CurvePlot::fitRange() {
    bool found = zero_ == ZeroLine::Shown;
    CurveExtent all;
    for (const CurveHistory& history : histories_) {
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
    const AxisRange& range = range_.range();
    // A range far from zero takes the prefix of its extent: 7012 nm and not 7.012 um.
    const double largest = std::max(std::abs(range.low), std::abs(range.high));
    const SiScale& scale = scale_.fit(std::min(largest, 50.0 * (range.high - range.low)));
    canvas_->showUnit(QString::fromStdString(scale.unit));
    canvas_->showRange({range.low * scale.factor, range.high * scale.factor});
    double now = 0.0;
    for (const CurveHistory& history : histories_) {
        now = std::max(now, history.newestTime());
    }
    for (std::size_t curve = 0; curve < histories_.size(); ++curve) {
        canvas_->showCurve(curve, histories_[curve], now, scale.factor);
    }
    canvas_->replot();
}

void CurvePlot::clear() {
    for (CurveHistory& history : histories_) {
        history.clear();
    }
    refresh();
}

}  // namespace asperity
