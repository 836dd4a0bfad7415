#pragma once

#include "ui/measure/ShapeTool.h"

#include <QRectF>

namespace asperity {

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
