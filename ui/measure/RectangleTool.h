#pragma once

#include "ui/panels/MapTool.h"

#include <QRectF>

namespace asperity {

/// A rectangle on the whole scan, drawn by dragging; its corners and sides can be dragged, and its
/// inside moves it whole. Shift makes it a square. It stays on the scan. As world x, y [m] its
/// top() is the smallest y.
class RectangleTool : public MapTool {
    Q_OBJECT

public:
    using MapTool::MapTool;

    /// Empty: nothing is drawn.
    void setRectangle(const QRectF& rectangle);
    [[nodiscard]] const QRectF& rectangle() const { return rectangle_; }

    void paint(QPainter& painter, const OverviewMap& map) const override;
    void press(const MapPointer& pointer, const OverviewMap& map) override;
    void drag(const MapPointer& pointer, const OverviewMap& map) override;
    void release(const MapPointer& pointer, const OverviewMap& map) override;
    [[nodiscard]] Qt::CursorShape cursor(const MapPointer& pointer,
                                         const OverviewMap& map) const override;
    [[nodiscard]] QString hint() const override;

Q_SIGNALS:
    /// The user draws or moves it [m].
    void rectangleDrawn(QRectF rectangle);

private:
    /// Which sides a drag moves; -1 and 1: the lower and the upper one, 2: both, 0: none.
    struct Grip {
        int x = 0;
        int y = 0;
        bool anew = false;

        [[nodiscard]] bool moves() const { return x == 2 && y == 2; }
    };

    [[nodiscard]] Grip gripAt(const MapPointer& pointer, const OverviewMap& map) const;
    [[nodiscard]] QRectF moved(const QPointF& way, const QSizeF& scan) const;
    [[nodiscard]] QRectF resized(const MapPointer& pointer, const OverviewMap& map) const;

    QRectF rectangle_;
    Grip grip_;
    bool pressedDown_ = false;
    QPointF pressedPixel_;
    QPointF pressed_;  ///< place [m]
    QRectF before_;    ///< the rectangle when the button went down
};

}  // namespace asperity
