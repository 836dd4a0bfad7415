#include "ui/experiment/TargetTool.h"

#include "ui/panels/MapMarks.h"
#include "ui/panels/OverviewMap.h"
#include "vtkplugins/pictures/Palette.h"

#include <QPainter>
#include <QPainterPath>

namespace asperity {

namespace {

constexpr double kRadius = 6.0;  // [px]
constexpr double kArm = 11.0;    // [px]

}  // namespace

void TargetTool::setTarget(const std::optional<QPointF>& target) {
    target_ = target;
    Q_EMIT marksChanged();
}

void TargetTool::paint(QPainter& painter, const OverviewMap& map) const {
    if (!target_) {
        return;
    }
    const QPointF center = map.toPixel(*target_);
    QPainterPath path;
    path.addEllipse(center, kRadius, kRadius);
    for (const QPointF& arm : {QPointF(kArm, 0.0), QPointF(0.0, kArm)}) {
        path.moveTo(center - arm);
        path.lineTo(center + arm);
    }
    strokeOverWhite(painter, kLightPalette.target, 2.4, path);
    labelMark(painter, kLightPalette.ink, center + QPointF(kArm + 3.0, -kRadius), tr("target"));
}

}  // namespace asperity
