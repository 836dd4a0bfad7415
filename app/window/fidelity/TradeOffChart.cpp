#include "app/window/fidelity/TradeOffChart.h"

#include "ui/plot/CopyablePlot.h"
#include "ui/plot/QwtParts.h"
#include "ui/widgets/Theme.h"

#include <QHelpEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QStackedLayout>
#include <QToolTip>
#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_plot_marker.h>
#include <qwt_scale_engine.h>
#include <qwt_scale_map.h>
#include <qwt_symbol.h>
#include <qwt_text.h>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr int kReach = 24;           ///< of a click [px]
constexpr int kPointSize = 8;        ///< [px]
constexpr int kChoiceRingSize = 17;  ///< [px]
constexpr double kRingWidth = 2.0;   ///< [px]
constexpr double kFrontWidth = 1.3;  ///< of the line that joins the front [px]
constexpr double kMicroseconds = 1e6;
constexpr double kNanonewtonsPerNewton = 1e9;

struct Range {
    double low = 1.0;
    double high = 10.0;
};

/// A logarithmic axis around these values.
Range rangeAround(double least, double largest) {
    const double margin = std::max(1.25, std::pow(largest / least, 0.08));
    return {least / margin, largest * margin};
}

/// 1, 2, 5 of each decade where there are few of them, else each decade.
QwtScaleDiv divisions(const Range& range) {
    const bool fine = range.high / range.low < 1e3;
    QList<double> ticks;
    for (double decade = std::pow(10.0, std::floor(std::log10(range.low))); decade < range.high;
         decade *= 10.0) {
        for (const double step : {1.0, 2.0, 5.0}) {
            const double tick = step * decade;
            if ((fine || step == 1.0) && tick >= range.low && tick <= range.high) {
                ticks << tick;
            }
        }
    }
    return QwtScaleDiv(range.low, range.high, {}, {}, ticks);
}

QwtText axisTitle(const QString& text) {
    QwtText title(text);
    title.setFont(theme::textFont(theme::kSmallSize));
    return title;
}

QwtSymbol* dot(const QColor& color) {
    return new QwtSymbol(QwtSymbol::Ellipse, color, QPen(theme::colors().paper),
                         {kPointSize, kPointSize});
}

}  // namespace

std::vector<int> frontOf(const std::vector<TradeOffPoint>& points) {
    std::vector<int> front;
    for (int i = 0; i < static_cast<int>(points.size()); ++i) {
        if (points[static_cast<std::size_t>(i)].onFront) {
            front.push_back(i);
        }
    }
    std::sort(front.begin(), front.end(), [&points](int a, int b) {
        return points[static_cast<std::size_t>(a)].time < points[static_cast<std::size_t>(b)].time;
    });
    return front;
}

class TradeOffChart::Plot {
public:
    explicit Plot(TradeOffChart* owner);

    void show(const TradeOffPoints& shown, const QString& hint);
    void ring(int index);
    [[nodiscard]] QwtPlotCanvas& canvas() const { return *canvas_; }
    [[nodiscard]] QPoint positionOf(int index) const;

private:
    void buildAxes();
    void buildItems();
    void color();
    void showRanges(const TradeOffPoints& shown);
    void number(const std::vector<int>& front);

    QStackedLayout* layers_;
    QLabel* hint_;
    QwtPlot* plot_;
    QwtPlotCanvas* canvas_;
    QwtPlotGrid* grid_ = nullptr;  // items are owned by the plot
    QwtPlotCurve* others_ = nullptr;
    QwtPlotCurve* front_ = nullptr;
    QwtPlotMarker* ring_ = nullptr;
    std::vector<QwtPlotMarker*> numbers_;
    QVector<QPointF> dots_;  ///< [us, nN]
};

TradeOffChart::Plot::Plot(TradeOffChart* owner)
    : layers_(new QStackedLayout(owner))
    , hint_(new QLabel(owner))
    , plot_(new QwtPlot(owner))
    , canvas_(new QwtPlotCanvas(plot_)) {
    hint_->setObjectName(QStringLiteral("chartHint"));
    hint_->setAlignment(Qt::AlignCenter);
    hint_->setWordWrap(true);
    layers_->addWidget(hint_);
    layers_->addWidget(plot_);
    canvas_->setFrameStyle(QFrame::NoFrame);
    canvas_->setCursor(Qt::PointingHandCursor);
    plot_->setCanvas(canvas_);
    buildAxes();
    buildItems();
    theme::follow(owner, [this] { color(); });
}

void TradeOffChart::Plot::buildAxes() {
    plot_->enableAxis(QwtPlot::yRight);
    plot_->setAxisTitle(QwtPlot::xBottom, axisTitle(TradeOffChart::tr("median of a tick [µs]")));
    plot_->setAxisTitle(QwtPlot::yLeft, axisTitle(TradeOffChart::tr("rms force error [nN]")));
    plot_->setAxisTitle(QwtPlot::yRight, axisTitle(TradeOffChart::tr("of the force [%]")));
    for (const int axis : {QwtPlot::xBottom, QwtPlot::yLeft, QwtPlot::yRight}) {
        plot_->setAxisScaleEngine(axis, new QwtLogScaleEngine);
        plot_->setAxisFont(axis, theme::textFont(theme::kSmallSize));
    }
    plot_->plotLayout()->setAlignCanvasToScales(true);
}

void TradeOffChart::Plot::buildItems() {
    grid_ = new QwtPlotGrid;
    grid_->attach(plot_);
    others_ = new QwtPlotCurve;
    others_->setStyle(QwtPlotCurve::NoCurve);
    front_ = new QwtPlotCurve;
    for (QwtPlotCurve* curve : {others_, front_}) {
        curve->setRenderHint(QwtPlotItem::RenderAntialiased);
        curve->attach(plot_);
    }
    ring_ = new QwtPlotMarker;
    ring_->setRenderHint(QwtPlotItem::RenderAntialiased);
    ring_->attach(plot_);
}

void TradeOffChart::Plot::color() {
    const ThemeColors& colors = theme::colors();
    plot_->setCanvasBackground(colors.paper);
    colorAxes(*plot_, colors.muted, colors.muted);
    for (const int axis : {QwtPlot::xBottom, QwtPlot::yLeft, QwtPlot::yRight}) {
        QwtText title = plot_->axisTitle(axis);
        title.setColor(colors.muted);
        plot_->setAxisTitle(axis, title);
    }
    grid_->setPen(colors.faint, 0.0, Qt::SolidLine);
    others_->setSymbol(dot(colors.tip));
    front_->setPen(colors.accent, kFrontWidth, Qt::SolidLine);
    front_->setSymbol(dot(colors.accent));
    ring_->setSymbol(new QwtSymbol(QwtSymbol::Ellipse, Qt::NoBrush, QPen(colors.orange, kRingWidth),
                                   {kChoiceRingSize, kChoiceRingSize}));
    for (QwtPlotMarker* number : numbers_) {
        QwtText label = number->label();
        label.setColor(colors.accent);
        number->setLabel(label);
    }
    plot_->replot();
}

void TradeOffChart::Plot::show(const TradeOffPoints& shown, const QString& hint) {
    hint_->setText(hint);
    layers_->setCurrentIndex(shown.points.empty() ? 0 : 1);
    const double floor = kNoticedShare * shown.forceScale;
    dots_.clear();
    QVector<QPointF> others;
    for (const TradeOffPoint& point : shown.points) {
        dots_ << QPointF(kMicroseconds * point.time,
                         kNanonewtonsPerNewton * std::max(point.error, floor));
        if (!point.onFront) {
            others << dots_.back();
        }
    }
    others_->setSamples(others);
    number(frontOf(shown.points));
    if (!dots_.isEmpty()) {
        showRanges(shown);
    }
    plot_->replot();
}

void TradeOffChart::Plot::showRanges(const TradeOffPoints& shown) {
    const auto [fastest, slowest] = std::minmax_element(
        dots_.begin(), dots_.end(), [](auto& a, auto& b) { return a.x() < b.x(); });
    const auto [best, worst] = std::minmax_element(dots_.begin(), dots_.end(),
                                                   [](auto& a, auto& b) { return a.y() < b.y(); });
    const Range error = rangeAround(best->y(), worst->y());
    const double percent = 100.0 / (kNanonewtonsPerNewton * shown.forceScale);
    plot_->setAxisScaleDiv(QwtPlot::xBottom, divisions(rangeAround(fastest->x(), slowest->x())));
    plot_->setAxisScaleDiv(QwtPlot::yLeft, divisions(error));
    plot_->setAxisScaleDiv(QwtPlot::yRight, divisions({percent * error.low, percent * error.high}));
}

/// Joins the front and numbers it on its lower left, where no point can be.
void TradeOffChart::Plot::number(const std::vector<int>& front) {
    for (QwtPlotMarker* marker : numbers_) {
        marker->detach();
        delete marker;
    }
    numbers_.clear();
    QVector<QPointF> joined;
    for (const int index : front) {
        joined << dots_[index];
        QwtText text(QString::number(joined.size()));
        text.setFont(theme::boldFont());
        text.setColor(theme::colors().accent);
        numbers_.push_back(new QwtPlotMarker);
        numbers_.back()->setValue(joined.back());
        numbers_.back()->setLabel(text);
        numbers_.back()->setLabelAlignment(Qt::AlignLeft | Qt::AlignBottom);
        numbers_.back()->setSpacing(kPointSize / 2);
        numbers_.back()->attach(plot_);
    }
    front_->setSamples(joined);
}

void TradeOffChart::Plot::ring(int index) {
    ring_->setVisible(index >= 0);
    if (index >= 0) {
        ring_->setValue(dots_[index]);
    }
    plot_->replot();
}

QPoint TradeOffChart::Plot::positionOf(int index) const {
    const QwtScaleMap x = plot_->canvasMap(QwtPlot::xBottom);
    const QwtScaleMap y = plot_->canvasMap(QwtPlot::yLeft);
    return QPointF(x.transform(dots_[index].x()), y.transform(dots_[index].y())).toPoint();
}

TradeOffChart::TradeOffChart(QWidget* parent)
    : QWidget(parent), plot_(std::make_unique<Plot>(this)) {
    plot_->canvas().installEventFilter(this);
    new CopyablePlot(*this, [this] { return table(); });
    setPoints({}, {});
}

TradeOffChart::~TradeOffChart() = default;

void TradeOffChart::setPoints(const TradeOffPoints& points, const QString& hint) {
    shown_ = points;
    plot_->show(shown_, hint);
    setCurrent(-1);
}

PlotTable TradeOffChart::table() const {
    QStringList names;
    std::vector<double> times;
    std::vector<double> errors;
    for (const TradeOffPoint& point : shown_.points) {
        names << point.name;
        times.push_back(point.time);
        errors.push_back(point.error);
    }
    PlotTable table;
    table.add(tr("configuration"), names);
    table.add(tr("median of a tick [s]"), times);
    table.add(tr("rms force error [N]"), errors);
    return table;
}

void TradeOffChart::setCurrent(int index) {
    current_ = index;
    plot_->ring(index);
}

QWidget& TradeOffChart::canvas() const { return plot_->canvas(); }

QPoint TradeOffChart::positionOf(int index) const { return plot_->positionOf(index); }

int TradeOffChart::nearest(const QPoint& position) const {
    int found = -1;
    int least = kReach * kReach;
    for (int i = 0; i < static_cast<int>(shown_.points.size()); ++i) {
        const QPoint offset = positionOf(i) - position;
        if (QPoint::dotProduct(offset, offset) < least) {
            least = QPoint::dotProduct(offset, offset);
            found = i;
        }
    }
    return found;
}

QString TradeOffChart::textOf(int index) const {
    const TradeOffPoint& point = shown_.points[static_cast<std::size_t>(index)];
    return tr("%1: %2 µs, %3 nN")
        .arg(point.name)
        .arg(kMicroseconds * point.time, 0, 'g', 3)
        .arg(kNanonewtonsPerNewton * point.error, 0, 'g', 3);
}

bool TradeOffChart::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseButtonRelease) {
        const auto* click = static_cast<QMouseEvent*>(event);
        const int index = nearest(click->pos());
        if (click->button() == Qt::LeftButton && index >= 0) {
            Q_EMIT picked(index);
        }
    } else if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const int index = nearest(help->pos());
        QToolTip::showText(help->globalPos(), index < 0 ? toolTip() : textOf(index));
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace asperity
