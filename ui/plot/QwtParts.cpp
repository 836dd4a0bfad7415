#include "ui/plot/QwtParts.h"

#include "ui/widgets/Theme.h"

#include <QHBoxLayout>
#include <QTextDocumentFragment>
#include <QToolButton>
#include <QVBoxLayout>
#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_plot_marker.h>
#include <qwt_plot_textlabel.h>
#include <qwt_scale_widget.h>
#include <qwt_text.h>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr int kPlotTickLength = 4;    ///< [px]
constexpr int kMinCanvasHeight = 40;  ///< [px]
constexpr int kUnitDigits = 3;        ///< same of a unit behind it
constexpr int kMaxLabelDigits = 7;    ///< letters of a label for which room is kept

constexpr double kAboveCurves = 1000.0;  ///< z of what is drawn last
constexpr int kCursorOpacity = 215;      ///< of the paper behind the text, of 255

}  // namespace

// NOLINTNEXTLINE(readability-function-size): the parameters are Qwt's
void PiecewiseCurve::drawSeries(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
                                const QRectF& canvas, int from, int to) const {
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

void NumberScaleDraw::set(int decimals, const QString& unit) {
    if (decimals_ != decimals || unit_ != unit) {
        decimals_ = decimals;
        unit_ = unit;
        invalidateCache();
    }
}

QwtText NumberScaleDraw::label(double value) const {
    const QString number = QString::number(value, 'f', decimals_);
    return unit_.isEmpty() ? number : number + QLatin1Char(' ') + unit_;
}

int decimalsFor(const std::vector<double>& ticks) {
    const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
    return std::clamp(static_cast<int>(-std::floor(std::log10(step) + 1e-9)), 0, 9);
}

QwtScaleDiv divisions(double low, double high, const std::vector<double>& ticks) {
    return QwtScaleDiv(low, high, {}, {}, QList<double>(ticks.begin(), ticks.end()));
}

void styleLivePlot(QwtPlot& plot) {
    auto* canvas = new QwtPlotCanvas(&plot);
    canvas->setFrameStyle(QFrame::NoFrame);
    canvas->setPaintAttribute(QwtPlotCanvas::BackingStore, false);  // every frame is a new one
    plot.setCanvas(canvas);
    plot.setMinimumSize(120, kMinCanvasHeight);
    plot.plotLayout()->setAlignCanvasToScales(true);
    plot.plotLayout()->setSpacing(0);
    for (const int axis : {QwtPlot::yLeft, QwtPlot::xBottom}) {
        plot.setAxisFont(axis, theme::textFont(theme::kTickSize));
        plot.axisWidget(axis)->setMargin(0);
        QwtScaleDraw* draw = plot.axisScaleDraw(axis);
        draw->setTickLength(QwtScaleDiv::MajorTick, kPlotTickLength);
        draw->setSpacing(2);
    }
    auto* grid = new QwtPlotGrid;
    grid->attach(&plot);
    theme::follow(&plot, [&plot, grid] {
        const ThemeColors& colors = theme::colors();
        plot.setCanvasBackground(colors.paper);
        grid->setPen(colors.faint, 0.0, Qt::SolidLine);
        colorAxes(plot, colors.faint, colors.muted);
        plot.replot();
    });
}

void colorAxes(QwtPlot& plot, const QColor& lines, const QColor& numbers) {
    QPalette palette;
    palette.setColor(QPalette::WindowText, lines);
    palette.setColor(QPalette::Text, numbers);
    for (int axis = 0; axis < QwtPlot::axisCnt; ++axis) {
        plot.axisWidget(axis)->setPalette(palette);
    }
}

void addZeroLine(QwtPlot& plot) {
    auto* zero = new QwtPlotMarker;
    zero->setLineStyle(QwtPlotMarker::HLine);
    zero->attach(&plot);
    theme::follow(&plot, [zero] { zero->setLinePen(theme::colors().muted, 0.0, Qt::SolidLine); });
}

void styleResetButton(QToolButton& button, int height) {
    button.setObjectName(QStringLiteral("resetZoom"));
    button.setText(QToolButton::tr("All"));
    button.setToolTip(QToolButton::tr("Shows all again (double click in the plot)"));
    button.setFont(theme::textFont(theme::kSmallSize));
    button.setFixedHeight(height);
    button.setFocusPolicy(Qt::TabFocus);  // a click leaves the keys to the view
    button.hide();
}

void placeUnderTitle(QWidget& owner, QWidget& title, QToolButton& reset, QwtPlot& plot) {
    title.setToolTip(enlargeTip());
    auto* heading = new QHBoxLayout;
    heading->setSpacing(4);
    heading->addWidget(&title, 1);
    heading->addWidget(&reset);
    auto* layout = new QVBoxLayout(&owner);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(1);
    layout->addLayout(heading);
    layout->addWidget(&plot, 1);
}

QString enlargeTip() {
    return QObject::tr("A double click on the title of the panel, or on its tab, enlarges it");
}

void keepEndRoom(QwtPlot& plot) {
    const QFontMetrics metrics(theme::textFont(theme::kTickSize));
    const int room =
        (kMaxLabelDigits + kUnitDigits) * metrics.horizontalAdvance(QLatin1Char('0')) / 2;
    plot.axisWidget(QwtPlot::xBottom)->setMinBorderDist(room, room);
}

double valueLabelRoom() {
    const QFontMetrics metrics(theme::textFont(theme::kTickSize));
    return kMaxLabelDigits * metrics.horizontalAdvance(QLatin1Char('0')) + kPlotTickLength + 2;
}

PlotCursor::PlotCursor(QwtPlot& plot) : line_(new QwtPlotMarker), label_(new QwtPlotTextLabel) {
    line_->setLineStyle(QwtPlotMarker::VLine);
    theme::follow(&plot,
                  [line = line_] { line->setLinePen(theme::colors().muted, 0.0, Qt::DashLine); });
    line_->setZ(kAboveCurves);
    line_->attach(&plot);
    label_->setMargin(0);
    label_->setZ(kAboveCurves);
    label_->attach(&plot);
    hide();
}

void PlotCursor::show(double x, const QString& text) {
    QwtText shown(text, QwtText::RichText);
    shown.setFont(theme::textFont(theme::kSmallSize));
    shown.setColor(theme::colors().ink);
    shown.setRenderFlags(Qt::AlignTop | Qt::AlignHCenter);
    QColor paper = theme::colors().paper;
    paper.setAlpha(kCursorOpacity);
    shown.setBackgroundBrush(paper);
    label_->setText(shown);
    label_->show();
    line_->setXValue(x);
    line_->show();
    text_ = QTextDocumentFragment::fromHtml(text).toPlainText();
}

void PlotCursor::hide() {
    line_->hide();
    label_->hide();
    text_.clear();
}

std::optional<QPointF> nearestSample(const QwtPlotCurve& curve, double x) {
    std::optional<QPointF> nearest;
    for (int i = 0; i < static_cast<int>(curve.dataSize()); ++i) {
        const QPointF sample = curve.sample(i);
        if (std::isfinite(sample.y()) &&
            (!nearest || std::abs(sample.x() - x) < std::abs(nearest->x() - x))) {
            nearest = sample;
        }
    }
    return nearest;
}

QString coloredReading(const QColor& color, const QString& text) {
    return QStringLiteral("<span style='color:%1; white-space:nowrap'>%2</span>")
        .arg(color.name(), text.toHtmlEscaped());
}

}  // namespace asperity
