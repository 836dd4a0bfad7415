#pragma once

#include "vtkplugins/pictures/Palette.h"

#include <QObject>
#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <QString>

class QPainter;
class QPainterPath;

namespace asperity {

class OverviewMap;

/// A shorter drag is a click [px].
inline constexpr double kMinDrag = 4.0;

/// Position of the mouse on the whole scan, and the keys that are held.
struct MapPointer {
    QPointF pixel;     ///< of the map
    QPointF position;  ///< world [m]; also beside the scan
    Qt::KeyboardModifiers modifiers;
};

/// Tool that draws its marks on the whole scan and, while it is active, receives what the left
/// button does there.
class MapTool : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// In the map's pixels, clipped to the scan.
    virtual void paint(QPainter& painter, const OverviewMap& map) const = 0;

    virtual void press(const MapPointer& /*pointer*/, const OverviewMap& /*map*/) {}
    virtual void drag(const MapPointer& /*pointer*/, const OverviewMap& /*map*/) {}
    virtual void release(const MapPointer& /*pointer*/, const OverviewMap& /*map*/) {}
    virtual void doubleClick(const MapPointer& /*pointer*/, const OverviewMap& /*map*/) {}
    /// While no button is held: what a press here would do.
    [[nodiscard]] virtual Qt::CursorShape cursor(const MapPointer& pointer,
                                                 const OverviewMap& map) const;
    /// Returns what the mouse does while the tool is active, for the tool tip of the map.
    [[nodiscard]] virtual QString hint() const;

Q_SIGNALS:
    void marksChanged();  ///< they are to be drawn again
};

// Marks on a map of heights, in pixels: seen on dark and on bright heights alike.

void strokeOverWhite(QPainter& painter, const Color& color, double width, const QPainterPath& path);
/// Small letters on a white plate. @param at the left end of their base line
void labelMark(QPainter& painter, const Color& color, const QPointF& at, const QString& text);
void drawTipMark(QPainter& painter, const QPointF& position);
/// A frame so small that the tip's mark would hide it gets corner brackets as well.
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
