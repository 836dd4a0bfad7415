#include "ui/measure/TouchMarks.h"

#include "ui/Theme.h"
#include "ui/panels/MapMarks.h"
#include "ui/panels/OverviewMap.h"

#include <QFontMetricsF>
#include <QPainter>

namespace asperity {

namespace {

constexpr double kDot = 3.0;          ///< radius [px]
constexpr double kSelectedDot = 5.0;  ///< [px]
/// More numbers than this would hide one another; the dots stay.
constexpr int kMaxNumbers = 150;

}  // namespace

void TouchMarks::setTouches(const QVector<MarkedTouch>& touches) {
    touches_ = touches;
    Q_EMIT marksChanged();
}

void TouchMarks::setSelected(const QSet<int>& numbers) {
    selected_ = numbers;
    Q_EMIT marksChanged();
}

void TouchMarks::setShown(bool shown) {
    shown_ = shown;
    Q_EMIT marksChanged();
}

void TouchMarks::paint(QPainter& painter, const OverviewMap& map) const {
    if (!shown_) {
        return;
    }
    for (const MarkedTouch& touch : touches_) {
        if (!selected_.contains(touch.number)) {
            paintOne(painter, map, touch);
        }
    }
    for (const MarkedTouch& touch : touches_) {
        if (selected_.contains(touch.number)) {
            paintOne(painter, map, touch);
        }
    }
}

void TouchMarks::paintOne(QPainter& painter, const OverviewMap& map,
                          const MarkedTouch& touch) const {
    const bool selected = selected_.contains(touch.number);
    const QPointF center = map.toPixel(touch.place);
    const double radius = selected ? kSelectedDot : kDot;
    const Color& color = selected ? kLightPalette.force : kLightPalette.ink;
    painter.setPen(QPen(toQColor(kLightPalette.paper), 1.0));
    painter.setBrush(toQColor(color));
    painter.drawEllipse(center, radius, radius);
    if (selected || touches_.size() <= kMaxNumbers) {
        // Between two arms of the tip's mark, which stays where the tip touched.
        const double below = QFontMetricsF(theme::textFont(theme::kSmallSize)).ascent();
        labelMark(painter, color, center + QPointF(radius + 3.0, radius + 1.0 + below),
                  QString::number(touch.number));
    }
}

}  // namespace asperity
