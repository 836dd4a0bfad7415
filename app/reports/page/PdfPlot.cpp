#include "app/reports/page/PdfPlot.h"

#include "app/reports/page/PdfStyle.h"
#include "core/PrintableText.h"

#include <QFontMetricsF>
#include <QPaintDevice>
#include <QPolygonF>

namespace asperity {

namespace {

QColor colorOf(PlotInk ink) { return colorForQt(kLightPalette.*rowOf(ink)->color); }

void paintLine(QPainter& painter, const DrawnLine& line) {
    QPolygonF points;
    for (const PlotPoint& point : line.points) {
        points << QPointF(point.x, point.y);
    }
    painter.setPen(QPen(colorOf(line.ink), line.width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter.drawPolyline(points);
}

/// @param font whose size is that on the device, as the painter's scale acts on what it measures
void paintText(QPainter& painter, const DrawnText& text, const QFont& font) {
    const QString shown = QString::fromStdString(printable(text.text));
    const double width = QFontMetricsF(font, painter.device()).horizontalAdvance(shown);
    const double shift = text.anchor == TextAnchor::Middle ? 0.5
                         : text.anchor == TextAnchor::End  ? 1.0
                                                           : 0.0;
    painter.save();
    painter.translate(text.place.x, text.place.y);
    painter.rotate(text.upward ? -90.0 : 0.0);
    const double unit = 72.0 / painter.device()->logicalDpiX();
    painter.scale(unit, unit);
    painter.setPen(colorOf(text.ink));
    painter.setFont(font);
    painter.drawText(QPointF(-shift * width, 0.0), shown);
    painter.restore();
}

}  // namespace

void paintPlot(QPainter& painter, const PlotDrawing& drawing) {
    for (const DrawnLine& line : drawing.lines) {
        paintLine(painter, line);
    }
    for (const DrawnRing& ring : drawing.rings) {
        painter.setPen(QPen(colorOf(ring.ink), PlotDrawing::kRingWidth));
        painter.drawEllipse(QPointF(ring.place.x, ring.place.y), PlotDrawing::kRingRadius,
                            PlotDrawing::kRingRadius);
    }
    const QFont font = PdfStyle::text(PlotDrawing::kTextSize);
    for (const DrawnText& text : drawing.texts) {
        paintText(painter, text, font);
    }
}

}  // namespace asperity
