#include "ui/measure/LineTool.h"

#include "ui/Theme.h"
#include "ui/panels/MapMarks.h"
#include "ui/panels/OverviewMap.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kEndReach = 8.0;       ///< of the pointer to an end [px]
constexpr double kNear = 5.0;           ///< of the pointer to the line [px]
constexpr double kEndRadius = 4.0;      ///< radius of an end [px]
constexpr double kStop = 5.0;           ///< half a cursor's bar [px]
constexpr double kToolLineWidth = 1.8;  ///< [px]

/// Distance of a point to a line's stretch [px].
double distanceTo(const QLineF& line, const QPointF& point) {
    const QPointF along = line.p2() - line.p1();
    const double square = QPointF::dotProduct(along, along);
    const double share =
        square > 0.0 ? std::clamp(QPointF::dotProduct(point - line.p1(), along) / square, 0.0, 1.0)
                     : 0.0;
    return QLineF(line.pointAt(share), point).length();
}

}  // namespace

void LineTool::setStops(const QVector<double>& shares) {
    stops_ = shares;
    Q_EMIT marksChanged();
}

void LineTool::paint(QPainter& painter, const OverviewMap& map) const {
    if (isEmpty()) {
        return;
    }
    const QLineF drawn = pixels(map);
    QPainterPath path;
    path.moveTo(drawn.p1());
    path.lineTo(drawn.p2());
    if (drawn.length() > 0.0) {
        const QPointF across = drawn.normalVector().unitVector().p2() - drawn.p1();
        for (const double share : stops_) {
            path.moveTo(drawn.pointAt(share) - kStop * across);
            path.lineTo(drawn.pointAt(share) + kStop * across);
        }
    }
    strokeOverWhite(painter, kLightPalette.blue, kToolLineWidth, path);
    painter.setPen(QPen(toQColor(kLightPalette.paper), 1.0));
    painter.setBrush(toQColor(kLightPalette.blue));
    painter.drawEllipse(drawn.p1(), kEndRadius, kEndRadius);  // where the profile begins: filled
    painter.setPen(QPen(toQColor(kLightPalette.blue), kToolLineWidth));
    painter.setBrush(toQColor(kLightPalette.paper));
    painter.drawEllipse(drawn.p2(), kEndRadius, kEndRadius);
}

bool LineTool::isEmptyShape(const QLineF& points) const { return !(points.length() > 0.0); }

LineTool::Grip LineTool::gripAt(const QPointF& pixel, const OverviewMap& map) const {
    const QLineF drawn = pixels(map);
    const double toFirst = QLineF(drawn.p1(), pixel).length();
    const double toSecond = QLineF(drawn.p2(), pixel).length();
    if (std::min(toFirst, toSecond) <= kEndReach) {
        return toFirst < toSecond ? Grip{-1, -1} : Grip{1, 1};
    }
    return distanceTo(drawn, pixel) <= kNear ? kWhole : kAnew;
}

/// Beside or above the other end, whichever is nearer.
QPointF LineTool::held(const QPointF& moving, const QPointF& fixed) const {
    const QPointF way = moving - fixed;
    return std::abs(way.x()) >= std::abs(way.y()) ? QPointF(moving.x(), fixed.y())
                                                  : QPointF(fixed.x(), moving.y());
}

Qt::CursorShape LineTool::handleCursor(const Grip& /*grip*/) const {
    return Qt::PointingHandCursor;
}

QString LineTool::hint() const {
    return tr("Drag: profile line, or one of its ends (Shift: horizontal or vertical)");
}

}  // namespace asperity
