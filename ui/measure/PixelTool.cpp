#include "ui/measure/PixelTool.h"

#include "ui/Theme.h"
#include "ui/panels/MapMarks.h"
#include "ui/panels/OverviewMap.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace asperity {

namespace {

constexpr double kOutline = 1.0;      ///< [px]
constexpr double kMark = 2.0;         ///< width of a pixel's frame [px]
constexpr double kLeastMark = 9.0;    ///< side of a pixel's frame [px]
constexpr QPointF kLabel(4.0, 12.0);  ///< from the upper left corner of the map [px]

QPainterPath frameOf(const QRectF& around) {
    QPainterPath path;
    path.addRect(around);
    return path;
}

}  // namespace

void PixelTool::setPart(const std::optional<MappedPart>& part) {
    if (!part || !part_ || part->region != part_->region || part->pixels != part_->pixels) {
        pixel_.reset();
    }
    part_ = part;
    Q_EMIT marksChanged();
}

void PixelTool::setPixel(const std::optional<QPoint>& pixel) {
    pixel_ = pixel;
    Q_EMIT marksChanged();
}

std::optional<QPoint> PixelTool::pixelAt(const QPointF& place) const {
    if (!part_ || !part_->region.contains(place)) {
        return std::nullopt;
    }
    const QPointF from = place - part_->region.topLeft();
    const auto entry = [](double share, int count) {
        return std::clamp(static_cast<int>(share * count), 0, count - 1);
    };
    return QPoint(entry(from.x() / part_->region.width(), part_->pixels.width()),
                  entry(1.0 - (from.y() / part_->region.height()), part_->pixels.height()));
}

void PixelTool::paint(QPainter& painter, const OverviewMap& map) const {
    if (!part_) {
        return;
    }
    const QRectF& region = part_->region;
    const QRectF drawn =
        QRectF(map.toPixel(region.topLeft()), map.toPixel(region.bottomRight())).normalized();
    if (drawn.size() != map.mapRect().size()) {
        strokeOverWhite(painter, kLightPalette.ink, kOutline, frameOf(drawn.toRect()));
    }
    paintPixel(painter, map);
    if (!part_->label.isEmpty()) {
        labelMark(painter, kLightPalette.ink, drawn.topLeft() + kLabel, part_->label);
    }
}

void PixelTool::paintPixel(QPainter& painter, const OverviewMap& map) const {
    if (!pixel_) {
        return;
    }
    const QRectF& region = part_->region;
    const QSizeF pitch(region.width() / part_->pixels.width(),
                       region.height() / part_->pixels.height());
    const QPointF middle(region.left() + (pixel_->x() + 0.5) * pitch.width(),
                         region.bottom() - (pixel_->y() + 0.5) * pitch.height());
    const QPointF corner(0.5 * pitch.width(), 0.5 * pitch.height());
    QRectF drawn = QRectF(map.toPixel(middle - corner), map.toPixel(middle + corner)).normalized();
    const double widen = 0.5 * std::max(0.0, kLeastMark - std::min(drawn.width(), drawn.height()));
    drawn.adjust(-widen, -widen, widen, widen);
    strokeOverWhite(painter, kLightPalette.blue, kMark, frameOf(drawn));
}

void PixelTool::press(const MapPointer& pointer, const OverviewMap& /*map*/) {
    const std::optional<QPoint> pixel = pixelAt(pointer.place);
    if (pixel && pixel != pixel_) {
        setPixel(pixel);
        Q_EMIT pixelChosen(*pixel);
    }
}

void PixelTool::drag(const MapPointer& pointer, const OverviewMap& map) { press(pointer, map); }

Qt::CursorShape PixelTool::cursor(const MapPointer& pointer, const OverviewMap& /*map*/) const {
    return pixelAt(pointer.place) ? Qt::PointingHandCursor : Qt::ForbiddenCursor;
}

QString PixelTool::hint() const { return tr("Click: the force curve of that pixel"); }

}  // namespace asperity
