#include "ui/view/ShapeTool.h"

#include "ui/view/OverviewMap.h"
#include "ui/widgets/Theme.h"

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

namespace {}  // namespace

void ShapeTool::setPoints(const QLineF& points) {
    points_ = points;
    Q_EMIT marksChanged();
}

void ShapeTool::clear() { setPoints({}); }

QLineF ShapeTool::pixels(const OverviewMap& map) const {
    return {map.toPixel(points_.p1()), map.toPixel(points_.p2())};
}

ShapeTool::Grip ShapeTool::gripOf(const MapPointer& pointer, const OverviewMap& map) const {
    return isEmpty() ? kNewShape : gripAt(pointer.pixel, map);
}

void ShapeTool::press(const MapPointer& pointer, const OverviewMap& map) {
    grip_ = gripOf(pointer, map);
    pressedDown_ = true;
    pressedPixel_ = pointer.pixel;
    pressed_ = map.onScan(pointer.position);
    before_ = grip_.isNew ? QLineF(pressed_, pressed_) : points_;
}

/// As far as both points stay on the scan.
QLineF ShapeTool::moved(const QPointF& way, const QSizeF& scan) const {
    const auto allowed = [](double one, double other, double size, double wish) {
        return std::clamp(wish, -std::min(one, other), size - std::max(one, other));
    };
    return before_.translated(allowed(before_.x1(), before_.x2(), scan.width(), way.x()),
                              allowed(before_.y1(), before_.y2(), scan.height(), way.y()));
}

QLineF ShapeTool::resized(const MapPointer& pointer, const OverviewMap& map) const {
    const QPointF position = map.onScan(pointer.position);
    const bool firstX = grip_.x < 0;
    const bool firstY = grip_.y < 0;
    const QPointF fixed(firstX ? before_.x2() : before_.x1(), firstY ? before_.y2() : before_.y1());
    QPointF moving(grip_.x == 0 ? before_.x2() : position.x(),
                   grip_.y == 0 ? before_.y2() : position.y());
    if (pointer.modifiers.testFlag(Qt::ShiftModifier) && grip_.isCorner()) {
        moving = map.onScan(held(moving, fixed));
    }
    return {firstX ? moving.x() : fixed.x(), firstY ? moving.y() : fixed.y(),
            firstX ? fixed.x() : moving.x(), firstY ? fixed.y() : moving.y()};
}

void ShapeTool::drag(const MapPointer& pointer, const OverviewMap& map) {
    const bool isClick = QLineF(pressedPixel_, pointer.pixel).length() < kMinDrag;
    if (!pressedDown_ || (grip_.isNew && isClick)) {
        return;
    }
    const QLineF next =
        grip_.moves() ? moved(pointer.position - pressed_, map.scanSize()) : resized(pointer, map);
    if (!isEmptyShape(next) && next != points_) {
        setPoints(next);
        Q_EMIT drawn();
    }
}

void ShapeTool::release(const MapPointer& pointer, const OverviewMap& map) {
    drag(pointer, map);
    pressedDown_ = false;
}

Qt::CursorShape ShapeTool::cursor(const MapPointer& pointer, const OverviewMap& map) const {
    const Grip grip = gripOf(pointer, map);
    if (grip.isNew) {
        return Qt::CrossCursor;
    }
    return grip.moves() ? Qt::SizeAllCursor : handleCursor(grip);
}

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
        return kNewShape;
    }
    const auto side = [](double position, double first, double second) {
        const double toFirst = std::abs(position - first);
        const double toSecond = std::abs(position - second);
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
