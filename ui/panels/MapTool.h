#pragma once

#include <QObject>
#include <QPointF>
#include <QString>

class QPainter;

namespace asperity {

class OverviewMap;

/// A shorter drag is a click [px].
inline constexpr double kMinDrag = 4.0;

/// Where the mouse is on the whole scan, and which keys are held.
struct MapPointer {
    QPointF pixel;  ///< of the map
    QPointF place;  ///< world [m]; also beside the scan
    Qt::KeyboardModifiers modifiers;
};

/// What draws its marks on the whole scan and, while it is the active one, gets what the left
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
    /// What the mouse does while the tool is active, for the tool tip of the map.
    [[nodiscard]] virtual QString hint() const;

Q_SIGNALS:
    void marksChanged();  ///< they are to be drawn anew
};

}  // namespace asperity
