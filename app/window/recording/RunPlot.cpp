#include "app/window/recording/RunPlot.h"

#include "core/SiFormat.h"
#include "ui/plot/CopyablePlot.h"
#include "ui/plot/CurveHistory.h"
#include "ui/plot/PlotNavigation.h"
#include "ui/plot/QwtParts.h"
#include "ui/widgets/Steady.h"

#include <QLabel>
#include <QToolButton>
#include <qwt_plot.h>
#include <qwt_plot_marker.h>
#include <qwt_symbol.h>
#include <qwt_text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr std::size_t kMaxLines = 2;
constexpr double kLineWidth = 1.3;      ///< [px]
constexpr double kMomentWidth = 1.6;    ///< [px]
constexpr int kMomentDot = 7;           ///< [px]
constexpr double kMomentDepth = 500.0;  ///< z: above the lines, below the cursor
constexpr int kStretches = 2000;        ///< of a line that is drawn
constexpr int kRunMinTickHeight = 16;   ///< between ticks of the vertical axis [px]
constexpr int kRunMinTickWidth = 62;    ///< between those of the horizontal one [px]
constexpr double kRunMargin = 0.06;     ///< of the extent of the values, above and below

/// The extent of one coordinate of all points; none: no point is a number.
std::optional<AxisRange> extentOf(const std::vector<RunPlot::Line>& lines,
                                  double (*coordinate)(const QPointF&)) {
    AxisRange range{std::numeric_limits<double>::infinity(),
                    -std::numeric_limits<double>::infinity()};
    for (const RunPlot::Line& line : lines) {
        for (const QPointF& point : line.points) {
            if (std::isfinite(point.x()) && std::isfinite(point.y())) {
                const double value = coordinate(point);
                range = {std::min(range.low, value), std::max(range.high, value)};
            }
        }
    }
    return range.low <= range.high ? std::optional(range) : std::nullopt;
}

double xOf(const QPointF& point) { return point.x(); }
double yOf(const QPointF& point) { return point.y(); }

AxisRange widened(const std::optional<AxisRange>& range, double smallest, double margin) {
    if (!range) {
        return {-0.5 * smallest, 0.5 * smallest};
    }
    const double half = (0.5 + margin) * std::max(range->high - range->low, smallest);
    const double middle = 0.5 * (range->low + range->high);
    return {middle - half, middle + half};
}

/// A range far from zero takes the prefix of its extent.
SiScale scaleOf(const AxisRange& range, const QString& unit) {
    const double largest = std::max(std::abs(range.low), std::abs(range.high));
    const double magnitude = std::min(largest, 50.0 * (range.high - range.low));
    // Seconds are read as such, not in ms.
    return unit == QStringLiteral("s") ? SiScale{1.0, "s"}
                                       : siScaleFor(magnitude, unit.toStdString());
}

QVector<QPointF> scaled(QVector<QPointF> points, double x, double y) {
    for (QPointF& point : points) {
        point = {x * point.x(), y * point.y()};
    }
    return points;
}

}  // namespace

class RunPlot::Canvas {
public:
    Canvas(const RunPlotSetup& setup, RunPlot* owner);

    [[nodiscard]] PlotNavigation& navigation() { return *navigation_; }
    [[nodiscard]] QWidget& area() { return *plot_->canvas(); }
    [[nodiscard]] const QString& reading() const { return reading_->text(); }
    void showAxes(const PlotWindow& window);
    /// An empty plot has no numbers.
    void showNumbers(bool shown);
    void showLines(const std::vector<Line>& lines, const PlotWindow& window);
    void showMoment(const std::optional<QPointF>& moment);
    void showReading(const std::vector<Line>& lines);
    void showTitle();
    void replot() {
        reset_->setVisible(navigation_->isZoomed());
        plot_->replot();
    }

private:
    void colorMoment();
    void showAxis(int axis, NumberScaleDraw& labels, const AxisRange& range, const SiScale& scale,
                  int room);

    RunPlotSetup setup_;
    QLabel* title_;
    QToolButton* reset_;
    QwtPlot* plot_;
    NumberScaleDraw* xLabels_;  ///< owned by the plot
    NumberScaleDraw* yLabels_;  ///< owned by the plot
    std::array<PiecewiseCurve*, kMaxLines> curves_{};
    QwtPlotMarker* line_;
    QwtPlotMarker* dot_;
    std::unique_ptr<PlotCursor> reading_;
    PlotNavigation* navigation_;
    SiScale x_;
    SiScale y_;
};

RunPlot::Canvas::Canvas(const RunPlotSetup& setup, RunPlot* owner)
    : setup_(setup)
    , title_(new QLabel(owner))
    , reset_(new QToolButton(owner))
    , plot_(new QwtPlot(owner))
    , xLabels_(new NumberScaleDraw)
    , yLabels_(new NumberScaleDraw)
    , line_(new QwtPlotMarker)
    , dot_(new QwtPlotMarker) {
    title_->setFont(theme::textFont(theme::kSmallSize));
    title_->setFixedHeight(title_->fontMetrics().height() + 1);
    title_->setMinimumWidth(1);
    plot_->setAxisScaleDraw(QwtPlot::yLeft, yLabels_);
    plot_->setAxisScaleDraw(QwtPlot::xBottom, xLabels_);
    styleLivePlot(*plot_);
    yLabels_->setMinimumExtent(valueLabelRoom());
    addZeroLine(*plot_);
    for (PiecewiseCurve*& curve : curves_) {
        curve = new PiecewiseCurve;
        curve->setRenderHint(QwtPlotItem::RenderAntialiased);
        curve->attach(plot_);
    }
    line_->setLineStyle(QwtPlotMarker::VLine);
    for (QwtPlotMarker* const marker : {line_, dot_}) {
        marker->setZ(kMomentDepth);
        marker->attach(plot_);
    }
    reading_ = std::make_unique<PlotCursor>(*plot_);
    navigation_ = new PlotNavigation(area());
    styleResetButton(*reset_, title_->height());
    QObject::connect(reset_, &QToolButton::clicked, navigation_, &PlotNavigation::reset);
    owner->setToolTip(setup.toolTip + QLatin1Char('\n') + PlotNavigation::help());
    placeUnderTitle(*owner, *title_, *reset_, *plot_);
}

void RunPlot::Canvas::showAxis(int axis, NumberScaleDraw& labels, const AxisRange& range,
                               const SiScale& scale, int room) {
    const double low = scale.factor * range.low;
    const double high = scale.factor * range.high;
    const std::vector<double> ticks = axisTicks(low, high, std::max(1, room));
    labels.set(decimalsFor(ticks),
               axis == QwtPlot::xBottom ? QString::fromStdString(scale.unit) : QString());
    plot_->setAxisScaleDiv(axis, divisions(low, high, ticks));
}

void RunPlot::Canvas::showAxes(const PlotWindow& window) {
    x_ = scaleOf(window.x, setup_.xUnit);
    y_ = scaleOf(window.y, setup_.yUnit);
    showAxis(QwtPlot::yLeft, *yLabels_, window.y, y_,
             plot_->canvas()->height() / kRunMinTickHeight);
    showAxis(QwtPlot::xBottom, *xLabels_, window.x, x_,
             plot_->canvas()->width() / kRunMinTickWidth);
}

void RunPlot::Canvas::showNumbers(bool shown) {
    for (NumberScaleDraw* const labels : {xLabels_, yLabels_}) {
        labels->enableComponent(QwtAbstractScaleDraw::Labels, shown);
    }
}

/// Of rising times, only what is in sight.
void RunPlot::Canvas::showLines(const std::vector<Line>& lines, const PlotWindow& window) {
    for (std::size_t i = 0; i < kMaxLines; ++i) {
        QVector<QPointF> drawn;
        if (i < lines.size()) {
            const QVector<QPointF>& points = lines[i].points;
            int from = 0;
            int to = points.size();
            if (setup_.order == RunPlotSetup::Order::Rising) {
                const auto isBefore = [](const QPointF& point, double x) { return point.x() < x; };
                const auto low =
                    std::lower_bound(points.begin(), points.end(), window.x.low, isBefore);
                const auto high = std::lower_bound(low, points.end(), window.x.high, isBefore);
                from = std::max(static_cast<int>(low - points.begin()) - 1, 0);
                to = std::min(static_cast<int>(high - points.begin()) + 1, to);
            }
            drawn = scaled(thinned(points, from, to, kStretches), x_.factor, y_.factor);
            curves_[i]->setPen(theme::colors().*lines[i].color, kLineWidth, Qt::SolidLine);
        }
        curves_[i]->setSamples(drawn);
    }
}

void RunPlot::Canvas::colorMoment() {
    const QColor color = theme::colors().marker;
    line_->setLinePen(color, kMomentWidth, Qt::SolidLine);
    dot_->setSymbol(new QwtSymbol(QwtSymbol::Ellipse, color, QPen(theme::colors().paper),
                                  QSize(kMomentDot, kMomentDot)));
}

void RunPlot::Canvas::showMoment(const std::optional<QPointF>& moment) {
    line_->setVisible(moment.has_value());
    dot_->setVisible(moment && std::isfinite(moment->y()));
    if (moment) {
        colorMoment();
        line_->setXValue(x_.factor * moment->x());
        dot_->setValue(x_.factor * moment->x(), y_.factor * moment->y());
    }
}

void RunPlot::Canvas::showReading(const std::vector<Line>& lines) {
    const std::optional<double> position = navigation_->cursor();
    if (!position || setup_.order != RunPlotSetup::Order::Rising) {
        reading_->hide();
        return;
    }
    QString text;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (const auto sample = nearestSample(*curves_[i], x_.factor * *position)) {
            const std::string value = threeDigitText(sample->y(), SiScale{1.0, y_.unit});
            text += QStringLiteral("&nbsp; ") +
                    coloredReading(theme::colors().*lines[i].color, QString::fromStdString(value));
        }
    }
    reading_->show(x_.factor * *position, QStringLiteral("%1 %2")
                                                  .arg(x_.factor * *position, 0, 'f', 3)
                                                  .arg(QString::fromStdString(x_.unit)) +
                                              text);
}

void RunPlot::Canvas::showTitle() {
    const QString text = QStringLiteral("<b>%1</b> [%2]")
                             .arg(setup_.title.toHtmlEscaped(), QString::fromStdString(y_.unit));
    if (text != title_->text()) {
        title_->setText(text);
    }
}

RunPlot::RunPlot(const RunPlotSetup& setup, QWidget* parent)
    : QWidget(parent), setup_(setup), canvas_(std::make_unique<Canvas>(setup, this)) {
    connect(&canvas_->navigation(), &PlotNavigation::windowChanged, this, [this] { draw(); });
    connect(&canvas_->navigation(), &PlotNavigation::cursorMoved, this, [this] { draw(); });
    new CopyablePlot(*this, [this] { return table(); });
    theme::follow(this, [this] { draw(); });
}

RunPlot::~RunPlot() = default;

void RunPlot::setLines(const std::vector<Line>& lines) {
    lines_ = lines;
    canvas_->navigation().reset();  // what was looked at is of other lines
    draw();
}

void RunPlot::setMoment(const std::optional<QPointF>& moment) {
    moment_ = moment;
    canvas_->showMoment(moment_);
    canvas_->replot();
}

void RunPlot::draw() {
    const bool rises = setup_.order == RunPlotSetup::Order::Rising;
    const PlotWindow whole{widened(extentOf(lines_, xOf), 1e-12, rises ? 0.0 : kRunMargin),
                           widened(extentOf(lines_, yOf), setup_.smallest, kRunMargin)};
    const PlotWindow& window = canvas_->navigation().fit(whole);
    canvas_->showAxes(window);
    canvas_->showNumbers(extentOf(lines_, xOf).has_value());
    canvas_->showLines(lines_, window);
    canvas_->showMoment(moment_);
    canvas_->showReading(lines_);
    canvas_->showTitle();
    canvas_->replot();
}

PlotTable RunPlot::table() const {
    PlotTable table;
    for (const Line& line : lines_) {
        std::vector<double> xs;
        std::vector<double> ys;
        for (const QPointF& point : line.points) {
            xs.push_back(point.x());
            ys.push_back(point.y());
        }
        table.add(QStringLiteral("%1 [%2]").arg(setup_.xName, setup_.xUnit), xs);
        table.add(QStringLiteral("%1 [%2]").arg(line.name, setup_.yUnit), ys);
    }
    return table;
}

QString RunPlot::reading() const { return canvas_->reading(); }

QWidget& RunPlot::canvas() { return canvas_->area(); }

void RunPlot::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    draw();
}

}  // namespace asperity
