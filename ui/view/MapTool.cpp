#include "ui/view/MapTool.h"

#include "ui/widgets/ShownText.h"
#include "ui/widgets/Theme.h"
#include "vtkplugins/pictures/Ticks.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kRing = 5.0;    ///< radius of the tip's mark [px]
constexpr double kArm = 9.5;     ///< how far its cross reaches [px]
constexpr double kBorder = 1.0;  ///< of white around a line [px]

constexpr double kScaleBarShare = 0.34;  ///< of the width of a map, at most

constexpr double kMinFrame = 30.0;  ///< width that reaches beyond the tip's mark [px]
constexpr double kBracket = 7.0;    ///< arm of a corner bracket [px]

constexpr double kLabelOpacity = 0.75;  ///< of the white behind a label

/// Both sides of each corner: not a whole rectangle, which would pass for the frame.
QPainterPath cornerBrackets(const QRectF& around) {
    QPainterPath path;
    for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) {
            const QPointF corner =
                around.center() + 0.5 * QPointF(x * around.width(), y * around.height());
            path.moveTo(corner - QPointF(x * kBracket, 0.0));
            path.lineTo(corner);
            path.lineTo(corner - QPointF(0.0, y * kBracket));
        }
    }
    return path;
}

}  // namespace

Qt::CursorShape MapTool::cursor(const MapPointer& /*pointer*/, const OverviewMap& /*map*/) const {
    return Qt::CrossCursor;
}

QString MapTool::hint() const { return {}; }

void strokeOverWhite(QPainter& painter, const Color& color, double width,
                     const QPainterPath& path) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(toQColor(kLightPalette.paper), width + 2.0 * kBorder));
    painter.drawPath(path);
    painter.setPen(QPen(toQColor(color), width));
    painter.drawPath(path);
}

void labelMark(QPainter& painter, const Color& color, const QPointF& at, const QString& text) {
    painter.setFont(theme::textFont(theme::kSmallSize));
    QColor plate = toQColor(kLightPalette.paper);
    plate.setAlphaF(kLabelOpacity);
    painter.fillRect(QRectF(painter.fontMetrics().boundingRect(text))
                         .translated(at)
                         .adjusted(-2.0, 0.0, 2.0, 0.0),
                     plate);
    painter.setPen(toQColor(color));
    painter.drawText(at, text);
}

void drawTipMark(QPainter& painter, const QPointF& position) {
    QPainterPath mark;
    mark.addEllipse(position, kRing, kRing);
    for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
        mark.moveTo(position + kRing * way);
        mark.lineTo(position + kArm * way);
    }
    strokeOverWhite(painter, kLightPalette.marker, 2.0, mark);
}

void drawFrameMark(QPainter& painter, const QRectF& frame) {
    QPainterPath path;
    path.addRect(frame);
    strokeOverWhite(painter, kLightPalette.zoom, 1.6, path);
    QRectF around(0.0, 0.0, std::max(frame.width(), kMinFrame),
                  std::max(frame.height(), kMinFrame));
    around.moveCenter(frame.center());
    around.moveTo(std::floor(around.x()) + 0.5, std::floor(around.y()) + 0.5);  // sharp lines
    if (around.size() != frame.size()) {
        strokeOverWhite(painter, kLightPalette.zoom, 1.6, cornerBrackets(around));
    }
}

void drawPathMark(QPainter& painter, const QPolygonF& path) {
    QPainterPath line;
    line.addPolygon(path);
    strokeOverWhite(painter, kLightPalette.path, 1.2, line);
}

ScaleBar scaleBarOf(const QPainter& painter, const QRectF& map, double width) {
    const double length = niceBelow(kScaleBarShare * width);
    const double pixels = length / width * map.width();
    const QFontMetrics metrics = painter.fontMetrics();
    const QString text = siText(length, "m");
    const double plateWidth =
        std::max(pixels, static_cast<double>(metrics.horizontalAdvance(text))) + 12.0;
    return {.length = length,
            .pixels = pixels,
            .plate = QRectF(map.left() + 5.0, map.bottom() - metrics.height() - 13.0, plateWidth,
                            metrics.height() + 8.0)};
}

void drawScaleBar(QPainter& painter, const ScaleBar& bar) {
    QColor paper = theme::colors().paper;
    paper.setAlphaF(0.82);
    painter.setPen(Qt::NoPen);
    painter.setBrush(paper);
    painter.drawRoundedRect(bar.plate, 3.0, 3.0);
    painter.setPen(theme::colors().ink);
    painter.drawText(bar.plate.adjusted(0.0, 1.0, 0.0, -5.0), Qt::AlignCenter,
                     siText(bar.length, "m"));
    painter.fillRect(QRectF(bar.plate.center().x() - (bar.pixels / 2.0), bar.plate.bottom() - 5.0,
                            bar.pixels, 2.0),
                     theme::colors().ink);
}

}  // namespace asperity
