#pragma once

#include "vtkplugins/pictures/Color.h"

#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <QString>

class QPainter;
class QPainterPath;

namespace asperity {

// Marks on a map of heights, in pixels: seen on dark and on bright heights alike.

void strokeOverWhite(QPainter& painter, const Color& color, double width, const QPainterPath& path);
/// Small letters on a white plate. @param at the left end of their base line
void labelMark(QPainter& painter, const Color& color, const QPointF& at, const QString& text);
void drawTipMark(QPainter& painter, const QPointF& place);
/// Around a frame so small that the tip's mark would hide it stand corner brackets as well.
void drawFrameMark(QPainter& painter, const QRectF& frame);
void drawPathMark(QPainter& painter, const QPolygonF& path);

/// A length of the map's scale with its number, on a plate; see drawScaleBar().
struct ScaleBar {
    double length = 0.0;  ///< [m]
    double pixels = 0.0;  ///< on the screen
    QRectF plate;         ///< in the lower left corner of the map
};
/// @param map where it is drawn; @param width of what it shows [m]; @param painter with its font
[[nodiscard]] ScaleBar scaleBarOf(const QPainter& painter, const QRectF& map, double width);
void drawScaleBar(QPainter& painter, const ScaleBar& bar);

}  // namespace asperity
