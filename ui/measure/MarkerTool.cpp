#include "ui/measure/MarkerTool.h"

#include "ui/Theme.h"
#include "ui/panels/MapMarks.h"
#include "ui/panels/OverviewMap.h"

#include <QLineF>
#include <QPainter>
#include <QPainterPath>

#include <utility>

namespace asperity {

namespace {

constexpr double kMarkerReach = 8.0;  ///< of the pointer to a marker [px]
constexpr double kArm = 5.0;          ///< half a marker's cross [px]

QPointF placeOf(const Marker& marker) { return {marker.x, marker.y}; }

/// A cross that is no plus: those are the tip's.
QPainterPath crossAt(const QPointF& center) {
    QPainterPath path;
    for (const QPointF& arm : {QPointF(kArm, kArm), QPointF(kArm, -kArm)}) {
        path.moveTo(center - arm);
        path.lineTo(center + arm);
    }
    return path;
}

}  // namespace

void MarkerTool::setMarkers(const std::vector<Marker>& markers) {
    markers_ = markers;
    held_ = -1;
    Q_EMIT marksChanged();
}

void MarkerTool::setSelected(int row) {
    selected_ = row;
    Q_EMIT marksChanged();
}

void MarkerTool::paint(QPainter& painter, const OverviewMap& map) const {
    for (std::size_t i = 0; i < markers_.size(); ++i) {
        const bool selected = static_cast<int>(i) == selected_;
        const Color& color = selected ? kLightPalette.force : kLightPalette.ink;
        const QPointF center = map.toPixel(placeOf(markers_[i]));
        strokeOverWhite(painter, color, selected ? 2.6 : 1.8, crossAt(center));
        labelMark(painter, color, center + QPointF(kArm + 4.0, 4.0),
                  QString::fromStdString(markers_[i].name));
    }
}

int MarkerTool::markerAt(const MapPointer& pointer, const OverviewMap& map) const {
    int nearest = -1;
    double distance = kMarkerReach;
    for (std::size_t i = 0; i < markers_.size(); ++i) {
        const double one = QLineF(map.toPixel(placeOf(markers_[i])), pointer.pixel).length();
        if (one <= distance) {
            distance = one;
            nearest = static_cast<int>(i);
        }
    }
    return nearest;
}

void MarkerTool::press(const MapPointer& pointer, const OverviewMap& map) {
    held_ = markerAt(pointer, map);
    pressed_ = pointer.pixel;
    moved_ = false;
    if (held_ >= 0) {
        Q_EMIT markerPressed(held_);
    }
}

void MarkerTool::drag(const MapPointer& pointer, const OverviewMap& map) {
    moved_ = moved_ || QLineF(pressed_, pointer.pixel).length() >= kMinDrag;
    if (held_ >= 0 && moved_) {
        const QPointF place = map.onScan(pointer.place);
        Marker& marker = markers_[static_cast<std::size_t>(held_)];
        marker.x = place.x();
        marker.y = place.y();
        Q_EMIT marksChanged();
    }
}

/// One change of the scene for a whole drag.
void MarkerTool::release(const MapPointer& pointer, const OverviewMap& map) {
    drag(pointer, map);
    const int row = std::exchange(held_, -1);
    if (row >= 0 && moved_) {
        Q_EMIT moveWanted(row, placeOf(markers_[static_cast<std::size_t>(row)]));
    }
}

void MarkerTool::doubleClick(const MapPointer& pointer, const OverviewMap& map) {
    if (map.mapRect().contains(pointer.pixel) && markerAt(pointer, map) < 0) {
        Q_EMIT markerWanted(pointer.place);
    }
}

Qt::CursorShape MarkerTool::cursor(const MapPointer& pointer, const OverviewMap& map) const {
    return markerAt(pointer, map) >= 0 ? Qt::SizeAllCursor : Qt::CrossCursor;
}

QString MarkerTool::hint() const { return tr("Double click: set a marker; drag: move one"); }

}  // namespace asperity
