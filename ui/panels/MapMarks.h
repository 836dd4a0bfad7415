#pragma once

#include <QPointF>
#include <QPolygonF>
#include <QRectF>

class QPainter;

namespace asperity {

// Marks on a map of heights, in pixels: seen on dark and on bright heights alike.

void drawTipMark(QPainter& painter, const QPointF& place);
/// Around a frame so small that the tip's mark would hide it stand corner brackets as well.
void drawFrameMark(QPainter& painter, const QRectF& frame);
void drawPathMark(QPainter& painter, const QPolygonF& path);

}  // namespace asperity
