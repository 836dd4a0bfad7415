#include "ui/measure/ShapeTool.h"

#include "ui/panels/OverviewMap.h"

#include <algorithm>

namespace asperity {

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
    return isEmpty() ? kAnew : gripAt(pointer.pixel, map);
}

void ShapeTool::press(const MapPointer& pointer, const OverviewMap& map) {
    grip_ = gripOf(pointer, map);
    pressedDown_ = true;
    pressedPixel_ = pointer.pixel;
    pressed_ = map.onScan(pointer.place);
    before_ = grip_.anew ? QLineF(pressed_, pressed_) : points_;
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
    const QPointF place = map.onScan(pointer.place);
    const bool firstX = grip_.x < 0;
    const bool firstY = grip_.y < 0;
    const QPointF fixed(firstX ? before_.x2() : before_.x1(), firstY ? before_.y2() : before_.y1());
    QPointF moving(grip_.x == 0 ? before_.x2() : place.x(),
                   grip_.y == 0 ? before_.y2() : place.y());
    if (pointer.modifiers.testFlag(Qt::ShiftModifier) && grip_.isCorner()) {
        moving = map.onScan(held(moving, fixed));
    }
    return {firstX ? moving.x() : fixed.x(), firstY ? moving.y() : fixed.y(),
            firstX ? fixed.x() : moving.x(), firstY ? fixed.y() : moving.y()};
}

void ShapeTool::drag(const MapPointer& pointer, const OverviewMap& map) {
    const bool isClick = QLineF(pressedPixel_, pointer.pixel).length() < kMinDrag;
    if (!pressedDown_ || (grip_.anew && isClick)) {
        return;
    }
    const QLineF next =
        grip_.moves() ? moved(pointer.place - pressed_, map.scanSize()) : resized(pointer, map);
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
    if (grip.anew) {
        return Qt::CrossCursor;
    }
    return grip.moves() ? Qt::SizeAllCursor : handleCursor(grip);
}

}  // namespace asperity
