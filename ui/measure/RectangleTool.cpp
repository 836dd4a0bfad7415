#include "ui/measure/RectangleTool.h"

#include "ui/Theme.h"
#include "ui/panels/MapMarks.h"
#include "ui/panels/OverviewMap.h"

#include <QLineF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kSideReach = 6.0;   ///< of the pointer to a side [px]
constexpr double kCornerSize = 3.0;  ///< half a corner's square [px]
constexpr double kSideWidth = 2.0;   ///< whole, for sharp sides [px]

QRectF between(const QLineF& points) { return QRectF(points.p1(), points.p2()).normalized(); }

}  // namespace

QRectF RectangleTool::rectangle() const { return between(points()); }

void RectangleTool::setRectangle(const QRectF& rectangle) {
    setPoints({rectangle.topLeft(), rectangle.bottomRight()});
}

void RectangleTool::paint(QPainter& painter, const OverviewMap& map) const {
    if (isEmpty()) {
        return;
    }
    const QRectF drawn = between(pixels(map)).toRect();  // on whole pixels: sharp sides
    QPainterPath path;
    path.addRect(drawn);
    strokeOverWhite(painter, kLightPalette.green, kSideWidth, path);
    painter.setPen(QPen(toQColor(kLightPalette.paper), 1.0));
    painter.setBrush(toQColor(kLightPalette.green));
    for (const QPointF& corner :
         {drawn.topLeft(), drawn.topRight(), drawn.bottomLeft(), drawn.bottomRight()}) {
        painter.drawRect(QRectF(corner - QPointF(kCornerSize, kCornerSize), QSizeF(6.0, 6.0)));
    }
}

bool RectangleTool::isEmptyShape(const QLineF& points) const { return between(points).isEmpty(); }

RectangleTool::Grip RectangleTool::gripAt(const QPointF& pixel, const OverviewMap& map) const {
    const QLineF drawn = pixels(map);
    if (!between(drawn)
             .adjusted(-kSideReach, -kSideReach, kSideReach, kSideReach)
             .contains(pixel)) {
        return kAnew;
    }
    const auto side = [](double place, double first, double second) {
        const double toFirst = std::abs(place - first);
        const double toSecond = std::abs(place - second);
        return std::min(toFirst, toSecond) > kSideReach ? 0 : toFirst < toSecond ? -1 : 1;
    };
    const Grip grip{side(pixel.x(), drawn.x1(), drawn.x2()),
                    side(pixel.y(), drawn.y1(), drawn.y2())};
    return grip.x == 0 && grip.y == 0 ? kWhole : grip;
}

/// A square as large as the longer way.
QPointF RectangleTool::held(const QPointF& moving, const QPointF& fixed) const {
    const QPointF way = moving - fixed;
    const double side = std::max(std::abs(way.x()), std::abs(way.y()));
    return fixed + QPointF(std::copysign(side, way.x()), std::copysign(side, way.y()));
}

Qt::CursorShape RectangleTool::handleCursor(const Grip& grip) const {
    if (!grip.isCorner()) {
        return grip.x == 0 ? Qt::SizeVerCursor : Qt::SizeHorCursor;
    }
    const bool rises = points().dx() * points().dy() > 0.0;
    return (grip.x == grip.y) == rises ? Qt::SizeBDiagCursor : Qt::SizeFDiagCursor;
}

QString RectangleTool::hint() const {
    return tr("Drag: rectangle, or its corners, sides and inside (Shift: square)");
}

}  // namespace asperity
