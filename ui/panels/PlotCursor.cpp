#include "ui/panels/PlotCursor.h"

#include "ui/Theme.h"

#include <QTextDocumentFragment>
#include <qwt_plot.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_marker.h>
#include <qwt_plot_textlabel.h>
#include <qwt_text.h>

#include <cmath>

namespace asperity {

namespace {

constexpr double kAboveCurves = 1000.0;  ///< z of what is drawn last
constexpr int kCursorOpacity = 215;      ///< of the paper behind the text, of 255

}  // namespace

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
