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

constexpr double kReach = 8.0;      ///< of the pointer to an end [px]
constexpr double kNear = 5.0;       ///< of the pointer to the line [px]
constexpr double kMinDrag = 4.0;    ///< a shorter one is a click [px]
constexpr double kHandle = 4.0;     ///< radius of an end [px]
constexpr double kStop = 5.0;       ///< half a cursor's bar [px]
constexpr double kLineWidth = 1.8;  ///< [px]

/// Distance of a point to a line's stretch [px].
double distanceTo(const QLineF& line, const QPointF& point) {
    const QPointF along = line.p2() - line.p1();
    const double square = QPointF::dotProduct(along, along);
    const double share =
        square > 0.0 ? std::clamp(QPointF::dotProduct(point - line.p1(), along) / square, 0.0, 1.0)
                     : 0.0;
    return QLineF(line.pointAt(share), point).length();
}

/// Beside or above the other end, whichever is nearer.
QPointF straightened(const QPointF& moving, const QPointF& fixed) {
    const QPointF way = moving - fixed;
    return std::abs(way.x()) >= std::abs(way.y()) ? QPointF(moving.x(), fixed.y())
                                                  : QPointF(fixed.x(), moving.y());
}

QPointF endPlace(const MapPointer& pointer, const QPointF& fixed, const OverviewMap& map) {
    const QPointF place = map.onScan(pointer.place);
    return pointer.modifiers.testFlag(Qt::ShiftModifier) ? straightened(place, fixed) : place;
}

/// Moved as far as both ends stay on the scan.
QLineF moved(const QLineF& line, const QPointF& way, const QSizeF& scan) {
    const auto room = [](double one, double other, double size, double wish) {
        return std::clamp(wish, -std::min(one, other), size - std::max(one, other));
    };
    return line.translated(room(line.x1(), line.x2(), scan.width(), way.x()),
                           room(line.y1(), line.y2(), scan.height(), way.y()));
}

}  // namespace

void LineTool::setLine(const std::optional<QLineF>& line) {
    line_ = line;
    Q_EMIT marksChanged();
}

void LineTool::setStops(const QVector<double>& shares) {
    stops_ = shares;
    Q_EMIT marksChanged();
}

void LineTool::paint(QPainter& painter, const OverviewMap& map) const {
    if (!line_) {
        return;
    }
    const QLineF drawn(map.toPixel(line_->p1()), map.toPixel(line_->p2()));
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
    strokeOverWhite(painter, kLightPalette.blue, kLineWidth, path);
    painter.setPen(QPen(toQColor(kLightPalette.paper), 1.0));
    painter.setBrush(toQColor(kLightPalette.blue));
    painter.drawEllipse(drawn.p1(), kHandle, kHandle);  // where the profile begins: filled
    painter.setPen(QPen(toQColor(kLightPalette.blue), kLineWidth));
    painter.setBrush(toQColor(kLightPalette.paper));
    painter.drawEllipse(drawn.p2(), kHandle, kHandle);
}

LineTool::Grip LineTool::gripAt(const MapPointer& pointer, const OverviewMap& map) const {
    if (!line_) {
        return Grip::New;
    }
    const QLineF drawn(map.toPixel(line_->p1()), map.toPixel(line_->p2()));
    const double toFirst = QLineF(drawn.p1(), pointer.pixel).length();
    const double toSecond = QLineF(drawn.p2(), pointer.pixel).length();
    if (std::min(toFirst, toSecond) <= kReach) {
        return toFirst < toSecond ? Grip::First : Grip::Second;
    }
    return distanceTo(drawn, pointer.pixel) <= kNear ? Grip::Whole : Grip::New;
}

void LineTool::press(const MapPointer& pointer, const OverviewMap& map) {
    grip_ = gripAt(pointer, map);
    pressedPixel_ = pointer.pixel;
    pressed_ = map.onScan(pointer.place);
    before_ = line_.value_or(QLineF());
}

void LineTool::drag(const MapPointer& pointer, const OverviewMap& map) {
    switch (grip_) {
    case Grip::Nothing:
        return;
    case Grip::New:
        if (QLineF(pressedPixel_, pointer.pixel).length() >= kMinDrag) {
            show({pressed_, endPlace(pointer, pressed_, map)});
        }
        return;
    case Grip::First:
        show({endPlace(pointer, before_.p2(), map), before_.p2()});
        return;
    case Grip::Second:
        show({before_.p1(), endPlace(pointer, before_.p1(), map)});
        return;
    case Grip::Whole:
        show(moved(before_, pointer.place - pressed_, map.scanSize()));
        return;
    }
}

void LineTool::release(const MapPointer& pointer, const OverviewMap& map) {
    drag(pointer, map);
    grip_ = Grip::Nothing;
}

void LineTool::show(const QLineF& line) {
    if (line.length() > 0.0 && (!line_ || *line_ != line)) {
        setLine(line);
        Q_EMIT lineDrawn(line);
    }
}

Qt::CursorShape LineTool::cursor(const MapPointer& pointer, const OverviewMap& map) const {
    switch (gripAt(pointer, map)) {
    case Grip::First:
    case Grip::Second:
        return Qt::PointingHandCursor;
    case Grip::Whole:
        return Qt::SizeAllCursor;
    default:
        return Qt::CrossCursor;
    }
}

QString LineTool::hint() const {
    return tr("Drag: profile line, or one of its ends (Shift: horizontal or vertical)");
}

}  // namespace asperity
