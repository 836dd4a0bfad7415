#pragma once

#include "core/scene/Marker.h"
#include "ui/panels/MapTool.h"

#include <vector>

namespace asperity {

/// Named places on the whole scan. While it is active a double click sets one, and a drag moves
/// one.
class MarkerTool : public MapTool {
    Q_OBJECT

public:
    using MapTool::MapTool;

    void setMarkers(const std::vector<Marker>& markers);
    /// Drawn in strong colors; -1: none.
    void setSelected(int row);

    void paint(QPainter& painter, const OverviewMap& map) const override;
    void press(const MapPointer& pointer, const OverviewMap& map) override;
    void drag(const MapPointer& pointer, const OverviewMap& map) override;
    void release(const MapPointer& pointer, const OverviewMap& map) override;
    void doubleClick(const MapPointer& pointer, const OverviewMap& map) override;
    [[nodiscard]] Qt::CursorShape cursor(const MapPointer& pointer,
                                         const OverviewMap& map) const override;
    [[nodiscard]] QString hint() const override;

Q_SIGNALS:
    void markerWanted(QPointF place);         ///< [m]
    void moveWanted(int row, QPointF place);  ///< [m]
    void markerPressed(int row);

private:
    [[nodiscard]] int markerAt(const MapPointer& pointer, const OverviewMap& map) const;

    std::vector<Marker> markers_;
    int selected_ = -1;
    int held_ = -1;    ///< that a drag moves
    QPointF pressed_;  ///< pixel
    bool moved_ = false;
};

}  // namespace asperity
