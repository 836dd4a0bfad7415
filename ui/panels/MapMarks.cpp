#include "ui/panels/MapMarks.h"

#include "ui/Theme.h"

#include <QPainter>
#include <QPainterPath>

namespace asperity {

namespace {

constexpr double kRing = 5.0;    ///< radius of the tip's mark [px]
constexpr double kArm = 9.5;     ///< how far its cross reaches [px]
constexpr double kBorder = 1.0;  ///< of white around a line [px]

void strokeOverWhite(QPainter& painter, QRgb colour, double width, const QPainterPath& path) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(theme::kPaper), width + 2.0 * kBorder));
    painter.drawPath(path);
    painter.setPen(QPen(QColor(colour), width));
    painter.drawPath(path);
}

}  // namespace

void drawTipMark(QPainter& painter, const QPointF& place) {
    QPainterPath mark;
    mark.addEllipse(place, kRing, kRing);
    for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
        mark.moveTo(place + kRing * way);
        mark.lineTo(place + kArm * way);
    }
    strokeOverWhite(painter, theme::kMarker, 2.0, mark);
}

void drawFrameMark(QPainter& painter, const QRectF& frame) {
    QPainterPath path;
    path.addRect(frame);
    strokeOverWhite(painter, theme::kZoom, 1.6, path);
}

void drawPathMark(QPainter& painter, const QPolygonF& path) {
    QPainterPath line;
    line.addPolygon(path);
    strokeOverWhite(painter, theme::kInk, 1.2, line);
}

}  // namespace asperity
