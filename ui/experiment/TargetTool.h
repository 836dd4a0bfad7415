#pragma once

#include "ui/panels/MapTool.h"

#include <optional>

namespace asperity {

/// Where the tip shall be, as a green cross-hair on the whole scan.
class TargetTool : public MapTool {
    Q_OBJECT

public:
    using MapTool::MapTool;

    /// World [m]; none: there is no target.
    void setTarget(const std::optional<QPointF>& target);
    [[nodiscard]] const std::optional<QPointF>& target() const { return target_; }

    void paint(QPainter& painter, const OverviewMap& map) const override;

private:
    std::optional<QPointF> target_;  ///< [m]
};

}  // namespace asperity
