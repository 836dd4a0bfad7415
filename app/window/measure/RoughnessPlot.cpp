#include "app/window/measure/RoughnessPlot.h"

#include "core/SiFormat.h"
#include "ui/plot/PlotNavigation.h"
#include "ui/plot/QwtParts.h"
#include "ui/widgets/Theme.h"

#include <QVBoxLayout>
#include <qwt_plot.h>
#include <qwt_plot_curve.h>
#include <qwt_text.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr double kSpectrumMargin = 0.03;  ///< of an axis' extent, on both sides
constexpr double kTop = 1.08;             ///< of a histogram's axis, over its highest bin
constexpr int kTickHeight = 16;           ///< between ticks of the vertical axis [px]
constexpr int kTickWidth = 70;            ///< between those of the horizontal axis [px]
constexpr double kWideLabels = 1.4;       ///< room for powers of ten, over that of numbers
constexpr int kFillOpacity = 70;          ///< below a histogram, of 255
constexpr double kPerMicrometer = -6.0;   ///< 1/m in 1/µm, power of ten
constexpr double kNanometer4 = 36.0;      ///< m^4 in nm^4, power of ten

/// A power of ten as people write it: "0.01", "100", "10⁵".
QString powerText(double exponent) {
    static const QString kDigits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    const int whole = static_cast<int>(std::lround(exponent));
    if (std::abs(exponent - whole) > 1e-6 || std::abs(whole) < 4) {
        return QString::number(std::pow(10.0, exponent), 'g', 4);
    }
    QString text = whole < 0 ? QStringLiteral("10⁻") : QStringLiteral("10");
    for (const QChar digit : QString::number(std::abs(whole))) {
        text += kDigits.at(digit.digitValue());
    }
    return text;
}

/// Numbers at an axis of powers of ten, with a unit.
class PowerScaleDraw : public QwtScaleDraw {
public:
    explicit PowerScaleDraw(const QString& unit) : unit_(unit) {}
    [[nodiscard]] QwtText label(double value) const override { return powerText(value) + unit_; }

private:
    QString unit_;
};

/// Points of a plot with the units of its axes.
struct DrawnPoints {
    QVector<QPointF> points;
    SiScale x;
    SiScale y;
    PlotWindow whole;
};

/// The outline of the bins.
DrawnPoints histogramPoints(const QVector<QPointF>& bins) {
    DrawnPoints drawn{{}, {1e9, "nm"}, {100.0, "%"}, {{0.0, 1.0}, {0.0, 1.0}}};
    if (bins.isEmpty()) {
        return drawn;
    }
    constexpr double kOneHeight = 1e-10;  // width of the bar where all heights are the same [m]
    const double width = bins.size() > 1 ? bins[1].x() - bins[0].x() : kOneHeight;
    const double low = bins.first().x() - 0.5 * width;
    const double high = bins.last().x() + 0.5 * width;
    drawn.x = siScaleFor(std::max({std::abs(low), std::abs(high), 1e-12}), "m");
    double highest = 0.0;
    for (const QPointF& bin : bins) {
        const double y = drawn.y.factor * bin.y();
        highest = std::max(highest, y);
        drawn.points.append({drawn.x.factor * (bin.x() - 0.5 * width), y});
        drawn.points.append({drawn.x.factor * (bin.x() + 0.5 * width), y});
    }
    drawn.whole = {{drawn.x.factor * low, drawn.x.factor * high}, {0.0, kTop * highest}};
    return drawn;
}

AxisRange widened(double low, double high) {
    const double margin = kSpectrumMargin * std::max(high - low, 1.0);
    return {low - margin, high + margin};
}

/// Powers of ten of frequency and density.
DrawnPoints spectrumPoints(const QVector<QPointF>& rings) {
    DrawnPoints drawn{{}, {1.0, "/µm"}, {1.0, "nm⁴"}, {{-1.0, 3.0}, {-2.0, 6.0}}};
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const QPointF& ring : rings) {
        if (ring.x() > 0.0 && ring.y() > 0.0) {
            const double density = std::log10(ring.y()) + kNanometer4;
            low = std::min(low, density);
            high = std::max(high, density);
            drawn.points.append({std::log10(ring.x()) + kPerMicrometer, density});
        }
    }
    if (!drawn.points.isEmpty()) {
        drawn.whole = {widened(drawn.points.first().x(), drawn.points.last().x()),
                       widened(low, high)};
    }
    return drawn;
}

QString plotHelp(RoughnessPlot::Kind kind) {
    return kind == RoughnessPlot::Kind::Histogram
               ? QObject::tr("Histogram: share of the area over height\n")
               : QObject::tr("Power spectral density over spatial frequency, mean over all "
                             "directions; its integral over all waves is Sq²\n");
}

}  // namespace

class RoughnessPlot::Canvas {
public:
    Canvas(RoughnessPlot* owner, Kind kind);

    [[nodiscard]] PlotNavigation& navigation() { return *navigation_; }
    void show(const DrawnPoints& drawn);

private:
    void color();
    [[nodiscard]] std::vector<double> ticks(const AxisRange& range, int room) const;
    void showReading(const DrawnPoints& drawn);

    Kind kind_;
    QwtPlot* plot_;
    NumberScaleDraw* xLabels_ = nullptr;  ///< owned by the plot; null: powers of ten
    NumberScaleDraw* yLabels_ = nullptr;
    QwtPlotCurve* curve_;
    std::unique_ptr<PlotCursor> reading_;
    PlotNavigation* navigation_;
};

RoughnessPlot::Canvas::Canvas(RoughnessPlot* owner, Kind kind)
    : kind_(kind), plot_(new QwtPlot(owner)), curve_(new QwtPlotCurve) {
    QwtScaleDraw* vertical = nullptr;
    if (kind == Kind::Histogram) {
        xLabels_ = new NumberScaleDraw;
        yLabels_ = new NumberScaleDraw;
        vertical = yLabels_;
        plot_->setAxisScaleDraw(QwtPlot::xBottom, xLabels_);
    } else {
        vertical = new PowerScaleDraw(QStringLiteral(" nm⁴"));
        plot_->setAxisScaleDraw(QwtPlot::xBottom, new PowerScaleDraw(QStringLiteral(" /µm")));
    }
    plot_->setAxisScaleDraw(QwtPlot::yLeft, vertical);
    styleLivePlot(*plot_);
    vertical->setMinimumExtent(valueLabelRoom() * (kind == Kind::Histogram ? 1.0 : kWideLabels));
    curve_->setRenderHint(QwtPlotItem::RenderAntialiased, kind == Kind::Spectrum);
    curve_->attach(plot_);
    reading_ = std::make_unique<PlotCursor>(*plot_);
    navigation_ = new PlotNavigation(*plot_->canvas());
    plot_->setToolTip(plotHelp(kind) + PlotNavigation::help());
    auto* layout = new QVBoxLayout(owner);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(plot_);
    theme::follow(owner, [this] { color(); });
}

void RoughnessPlot::Canvas::color() {
    const QColor& line = theme::colors().blue;
    curve_->setPen(line, kind_ == Kind::Histogram ? 1.0 : 1.5, Qt::SolidLine);
    if (kind_ == Kind::Histogram) {
        QColor fill = line;
        fill.setAlpha(kFillOpacity);
        curve_->setBrush(fill);
    }
}

/// Whole powers of ten where two of them are in sight.
std::vector<double> RoughnessPlot::Canvas::ticks(const AxisRange& range, int room) const {
    std::vector<double> found = axisTicks(range.low, range.high, std::max(1, room));
    const double first = std::ceil(range.low);
    const int count = static_cast<int>(std::floor(range.high) - first) + 1;
    if (kind_ == Kind::Spectrum && count >= 2) {
        const int step = std::max(1, (count + room - 1) / std::max(1, room));
        found.clear();
        for (int i = 0; i < count; i += step) {
            found.push_back(first + i);
        }
    }
    return found;
}

void RoughnessPlot::Canvas::show(const DrawnPoints& drawn) {
    const PlotWindow& window = navigation_->fit(drawn.whole);
    const std::vector<double> across = ticks(window.x, plot_->canvas()->width() / kTickWidth);
    const std::vector<double> up = ticks(window.y, plot_->canvas()->height() / kTickHeight);
    if (xLabels_ != nullptr) {
        xLabels_->set(decimalsFor(across), QString::fromStdString(drawn.x.unit));
        yLabels_->set(decimalsFor(up), QString::fromStdString(drawn.y.unit));
    }
    plot_->setAxisScaleDiv(QwtPlot::xBottom, divisions(window.x.low, window.x.high, across));
    plot_->setAxisScaleDiv(QwtPlot::yLeft, divisions(window.y.low, window.y.high, up));
    curve_->setSamples(drawn.points);
    showReading(drawn);
    plot_->replot();
}

void RoughnessPlot::Canvas::showReading(const DrawnPoints& drawn) {
    const std::optional<double> position = navigation_->cursor();
    const std::optional<QPointF> sample =
        position ? nearestSample(*curve_, *position) : std::nullopt;
    if (!sample) {
        reading_->hide();
        return;
    }
    const auto text = [this](double value, const SiScale& scale) {
        const double shown = kind_ == Kind::Spectrum ? std::pow(10.0, value) : value;
        return QString::number(shown, 'g', 3) + QLatin1Char(' ') +
               QString::fromStdString(scale.unit);
    };
    reading_->show(sample->x(), text(sample->x(), drawn.x) + QStringLiteral(" &nbsp; ") +
                                    text(sample->y(), drawn.y));
}

RoughnessPlot::RoughnessPlot(Kind kind, QWidget* parent)
    : QWidget(parent), kind_(kind), canvas_(std::make_unique<Canvas>(this, kind)) {
    connect(&canvas_->navigation(), &PlotNavigation::windowChanged, this, &RoughnessPlot::draw);
    connect(&canvas_->navigation(), &PlotNavigation::cursorMoved, this, &RoughnessPlot::draw);
    new CopyablePlot(*this, [this] { return table(); });
    draw();
}

RoughnessPlot::~RoughnessPlot() = default;

void RoughnessPlot::setPoints(const QVector<QPointF>& points) {
    points_ = points;
    canvas_->navigation().reset();  // what was looked at is of other heights
    draw();
}

PlotTable RoughnessPlot::table() const {
    std::vector<double> x;
    std::vector<double> y;
    for (const QPointF& point : points_) {
        x.push_back(point.x());
        y.push_back(point.y());
    }
    const bool isHistogram = kind_ == Kind::Histogram;
    PlotTable table;
    table.add(isHistogram ? tr("height [m]") : tr("frequency [1/m]"), x);
    table.add(isHistogram ? tr("share of the area") : tr("power spectral density [m^4]"), y);
    return table;
}

void RoughnessPlot::draw() {
    canvas_->show(kind_ == Kind::Histogram ? histogramPoints(points_) : spectrumPoints(points_));
}

}  // namespace asperity
