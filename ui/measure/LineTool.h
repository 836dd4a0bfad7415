#pragma once

#include "ui/panels/MapTool.h"

#include <QLineF>

#include <optional>

namespace asperity {

/// A line on the whole scan, drawn by dragging; its ends can be dragged, and the line between them
/// moves it whole. Shift keeps it horizontal or vertical. It stays on the scan.
class LineTool : public MapTool {
    Q_OBJECT

public:
    using MapTool::MapTool;

    /// World [m]; none: nothing is drawn.
    void setLine(const std::optional<QLineF>& line);
    [[nodiscard]] const std::optional<QLineF>& line() const { return line_; }
    /// Marks a place on the line, such as a cursor's. @param shares of its length, 0..1
    void setStops(const QVector<double>& shares);

    void paint(QPainter& painter, const OverviewMap& map) const override;
    void press(const MapPointer& pointer, const OverviewMap& map) override;
    void drag(const MapPointer& pointer, const OverviewMap& map) override;
    void release(const MapPointer& pointer, const OverviewMap& map) override;
    [[nodiscard]] Qt::CursorShape cursor(const MapPointer& pointer,
                                         const OverviewMap& map) const override;
    [[nodiscard]] QString hint() const override;

Q_SIGNALS:
    /// The user draws or moves it [m].
    void lineDrawn(QLineF line);

private:
    /// What a drag moves.
    enum class Grip { Nothing, New, First, Second, Whole };

    [[nodiscard]] Grip gripAt(const MapPointer& pointer, const OverviewMap& map) const;
    void show(const QLineF& line);

    std::optional<QLineF> line_;
    QVector<double> stops_;
    Grip grip_ = Grip::Nothing;
    QPointF pressedPixel_;
    QPointF pressed_;  ///< place [m]
    QLineF before_;    ///< the line when the button went down
};

}  // namespace asperity
