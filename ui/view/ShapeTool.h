#pragma once

#include "ui/view/MapTool.h"

#include <QLineF>
#include <QRectF>
#include <QSizeF>

namespace asperity {

/// A shape between two points of the whole scan, drawn by dragging; its handles can be dragged, and
/// the rest of it moves it whole. It stays on the scan.
class ShapeTool : public MapTool {
    Q_OBJECT

public:
    using MapTool::MapTool;

    /// Nothing is drawn.
    void clear();
    [[nodiscard]] bool isEmpty() const { return isEmptyShape(points_); }

    void press(const MapPointer& pointer, const OverviewMap& map) override;
    void drag(const MapPointer& pointer, const OverviewMap& map) override;
    void release(const MapPointer& pointer, const OverviewMap& map) override;
    [[nodiscard]] Qt::CursorShape cursor(const MapPointer& pointer,
                                         const OverviewMap& map) const override;

Q_SIGNALS:
    /// The user draws or moves it.
    void drawn();

protected:
    /// Coordinates that a drag moves; -1 and 1: the first and the second point's, 2: both, 0:
    /// none.
    struct Grip {
        int x = 0;
        int y = 0;
        bool isNew = false;

        [[nodiscard]] bool moves() const { return x == 2 && y == 2; }
        [[nodiscard]] bool isCorner() const { return x != 0 && y != 0; }
    };
    static constexpr Grip kWhole{2, 2, false};
    static constexpr Grip kNewShape{1, 1, true};

    /// World [m], in the order in which they were drawn.
    [[nodiscard]] const QLineF& points() const { return points_; }
    [[nodiscard]] QLineF pixels(const OverviewMap& map) const;
    /// Without drawn().
    void setPoints(const QLineF& points);

    [[nodiscard]] virtual bool isEmptyShape(const QLineF& points) const = 0;
    /// Returns the grip at a pixel. The shape is not empty.
    [[nodiscard]] virtual Grip gripAt(const QPointF& pixel, const OverviewMap& map) const = 0;
    /// Returns the position to which Shift constrains a point that moves.
    [[nodiscard]] virtual QPointF held(const QPointF& moving, const QPointF& fixed) const = 0;
    [[nodiscard]] virtual Qt::CursorShape handleCursor(const Grip& grip) const = 0;

private:
    [[nodiscard]] Grip gripOf(const MapPointer& pointer, const OverviewMap& map) const;
    [[nodiscard]] QLineF moved(const QPointF& way, const QSizeF& scan) const;
    [[nodiscard]] QLineF resized(const MapPointer& pointer, const OverviewMap& map) const;
    QLineF points_;
    Grip grip_;
    bool pressedDown_ = false;
    QPointF pressedPixel_;
    QPointF pressed_;  ///< position [m]
    QLineF before_;    ///< the points when the button went down
};

/// A rectangle on the whole scan; its handles are its corners and sides. Shift makes it a square.
class RectangleTool : public ShapeTool {
    Q_OBJECT

public:
    using ShapeTool::ShapeTool;

    /// World x, y [m]: its top() is the smallest y. Empty: nothing is drawn.
    [[nodiscard]] QRectF rectangle() const;
    /// One that was not drawn here; empty: nothing is drawn.
    void setRectangle(const QRectF& rectangle);

    void paint(QPainter& painter, const OverviewMap& map) const override;
    [[nodiscard]] QString hint() const override;

private:
    [[nodiscard]] bool isEmptyShape(const QLineF& points) const override;
    [[nodiscard]] Grip gripAt(const QPointF& pixel, const OverviewMap& map) const override;
    [[nodiscard]] QPointF held(const QPointF& moving, const QPointF& fixed) const override;
    [[nodiscard]] Qt::CursorShape handleCursor(const Grip& grip) const override;
};

}  // namespace asperity
