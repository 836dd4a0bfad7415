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

constexpr double kReach = 6.0;      ///< of the pointer to a side [px]
constexpr double kMinDrag = 4.0;    ///< a shorter one is a click [px]
constexpr double kHandle = 3.0;     ///< half a corner's square [px]
constexpr double kLineWidth = 2.0;  ///< whole, for sharp sides [px]

QRectF drawnOn(const OverviewMap& map, const QRectF& rectangle) {
    return QRectF(map.toPixel(rectangle.topLeft()), map.toPixel(rectangle.bottomRight()))
        .normalized();
}

/// From a corner that stays to one that moves; as a square it is as large as the longer way.
QRectF between(const QPointF& fixed, const QPointF& moving, bool square) {
    QPointF way = moving - fixed;
    if (square) {
        const double side = std::max(std::abs(way.x()), std::abs(way.y()));
        way = {std::copysign(side, way.x()), std::copysign(side, way.y())};
    }
    return QRectF(fixed, fixed + way).normalized();
}

}  // namespace

void RectangleTool::setRectangle(const QRectF& rectangle) {
    rectangle_ = rectangle;
    Q_EMIT marksChanged();
}

void RectangleTool::paint(QPainter& painter, const OverviewMap& map) const {
    if (rectangle_.isEmpty()) {
        return;
    }
    const QRectF drawn = drawnOn(map, rectangle_).toRect();  // on whole pixels: sharp sides
    QPainterPath path;
    path.addRect(drawn);
    strokeOverWhite(painter, kLightPalette.green, kLineWidth, path);
    painter.setPen(QPen(toQColor(kLightPalette.paper), 1.0));
    painter.setBrush(toQColor(kLightPalette.green));
    for (const QPointF& corner :
         {drawn.topLeft(), drawn.topRight(), drawn.bottomLeft(), drawn.bottomRight()}) {
        painter.drawRect(QRectF(corner - QPointF(kHandle, kHandle), QSizeF(6.0, 6.0)));
    }
}

RectangleTool::Grip RectangleTool::gripAt(const MapPointer& pointer, const OverviewMap& map) const {
    const Grip anew{0, 0, true};
    if (rectangle_.isEmpty()) {
        return anew;
    }
    const QRectF drawn = drawnOn(map, rectangle_);
    const QRectF reach = drawn.adjusted(-kReach, -kReach, kReach, kReach);
    if (!reach.contains(pointer.pixel)) {
        return anew;
    }
    const auto side = [](double place, double low, double high) {
        const double toLow = std::abs(place - low);
        const double toHigh = std::abs(place - high);
        return std::min(toLow, toHigh) > kReach ? 0 : toLow < toHigh ? -1 : 1;
    };
    const int x = side(pointer.pixel.x(), drawn.left(), drawn.right());
    const int y = -side(pointer.pixel.y(), drawn.top(), drawn.bottom());  // pixels count downwards
    return x == 0 && y == 0 ? Grip{2, 2, false} : Grip{x, y, false};
}

void RectangleTool::press(const MapPointer& pointer, const OverviewMap& map) {
    grip_ = gripAt(pointer, map);
    pressedDown_ = true;
    pressedPixel_ = pointer.pixel;
    pressed_ = map.onScan(pointer.place);
    before_ = rectangle_;
}

QRectF RectangleTool::moved(const QPointF& way, const QSizeF& scan) const {
    return before_.translated(
        std::clamp(way.x(), -before_.left(), scan.width() - before_.right()),
        std::clamp(way.y(), -before_.top(), scan.height() - before_.bottom()));
}

QRectF RectangleTool::resized(const MapPointer& pointer, const OverviewMap& map) const {
    const QPointF place = map.onScan(pointer.place);
    const bool square = pointer.modifiers.testFlag(Qt::ShiftModifier);
    if (grip_.anew) {
        return between(pressed_, place, square).intersected(QRectF(QPointF(), map.scanSize()));
    }
    const QPointF fixed(grip_.x < 0 ? before_.right() : before_.left(),
                        grip_.y < 0 ? before_.bottom() : before_.top());
    const QPointF moving(grip_.x == 0 ? before_.right() : place.x(),
                         grip_.y == 0 ? before_.bottom() : place.y());
    const bool corner = grip_.x != 0 && grip_.y != 0;
    return between(fixed, moving, square && corner).intersected(QRectF(QPointF(), map.scanSize()));
}

void RectangleTool::drag(const MapPointer& pointer, const OverviewMap& map) {
    const bool isClick = QLineF(pressedPixel_, pointer.pixel).length() < kMinDrag;
    if (!pressedDown_ || (grip_.anew && isClick)) {
        return;
    }
    const QRectF next =
        grip_.moves() ? moved(pointer.place - pressed_, map.scanSize()) : resized(pointer, map);
    if (!next.isEmpty() && next != rectangle_) {
        setRectangle(next);
        Q_EMIT rectangleDrawn(next);
    }
}

void RectangleTool::release(const MapPointer& pointer, const OverviewMap& map) {
    drag(pointer, map);
    pressedDown_ = false;
}

Qt::CursorShape RectangleTool::cursor(const MapPointer& pointer, const OverviewMap& map) const {
    const Grip grip = gripAt(pointer, map);
    if (grip.anew) {
        return Qt::CrossCursor;
    }
    if (grip.moves()) {
        return Qt::SizeAllCursor;
    }
    if (grip.x == 0 || grip.y == 0) {
        return grip.x == 0 ? Qt::SizeVerCursor : Qt::SizeHorCursor;
    }
    return grip.x == grip.y ? Qt::SizeBDiagCursor : Qt::SizeFDiagCursor;
}

QString RectangleTool::hint() const {
    return tr("Drag: rectangle, or its corners, sides and inside (Shift: square)");
}

}  // namespace asperity
