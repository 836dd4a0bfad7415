#pragma once

#include "ui/measure/ShapeTool.h"

#include <QVector>

namespace asperity {

/// A line on the whole scan. Shift keeps it horizontal or vertical.
class LineTool : public ShapeTool {
    Q_OBJECT

public:
    using ShapeTool::ShapeTool;

    /// World [m]; of no length: nothing is drawn.
    [[nodiscard]] const QLineF& line() const { return points(); }
    /// Marks a place on the line, such as a cursor's. @param shares of its length, 0..1
    void setStops(const QVector<double>& shares);

    void paint(QPainter& painter, const OverviewMap& map) const override;
    [[nodiscard]] QString hint() const override;

private:
    [[nodiscard]] bool isEmptyShape(const QLineF& points) const override;
    [[nodiscard]] Grip gripAt(const QPointF& pixel, const OverviewMap& map) const override;
    [[nodiscard]] QPointF held(const QPointF& moving, const QPointF& fixed) const override;
    [[nodiscard]] Qt::CursorShape handleCursor(const Grip& grip) const override;

    QVector<double> stops_;
};

}  // namespace asperity
