#include "ui/panels/CurvePlot.h"

#include "ui/panels/AxisTicks.h"
#include "ui/panels/QwtParts.h"

#include <QLabel>
#include <QVBoxLayout>
#include <qwt_painter.h>
#include <qwt_plot.h>
#include <qwt_scale_draw.h>
#include <qwt_text.h>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr int kIntervals = 400;       ///< of a history: about one a pixel
constexpr double kCurveWidth = 1.3;   ///< [px]
constexpr int kMinTickDistance = 14;  ///< [px]

class TimeScaleDraw : public QwtScaleDraw {
public:
    [[nodiscard]] QwtText label(double value) const override {
        return QStringLiteral("%1 s").arg(value);
    }
};

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

    void showUnit(const QString& unit);
    /// Limits of the value axis, in the shown unit.
    void showRange(const AxisRange& range);
    void showCurve(std::size_t index, const CurveHistory& history, double now, double factor);
    void replot() { plot_->replot(); }

private:
    void buildAxes(const CurvePlotSetup& setup);
    void buildItems(const CurvePlotSetup& setup);
    void color();

    CurvePlotSetup setup_;
    QLabel* title_;
    QwtPlot* plot_;
    NumberScaleDraw* valueLabels_ = nullptr;  ///< owned by the plot
    std::vector<PiecewiseCurve*> curves_;     ///< owned by the plot
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
    plot_->setAxisScaleDraw(QwtPlot::xBottom, new TimeScaleDraw);
    plot_->setAxisScaleDiv(QwtPlot::xBottom, divisions(-kSpan, 0.0, {-8.0, -6.0, -4.0, -2.0}));
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

void CurvePlot::Canvas::showRange(const AxisRange& range) {
    const auto room =
        static_cast<std::size_t>(std::max(1, plot_->canvas()->height() / kMinTickDistance));
    if (range.low == range_.low && range.high == range_.high && room == tickRoom_) {
        return;
    }
    range_ = range;
    tickRoom_ = room;
    const std::vector<double> ticks = axisTicks(range.low, range.high, static_cast<int>(room));
    valueLabels_->set(decimalsFor(ticks));
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
