#include "app/session/StudyViews.h"

#include "ui/panels/OverviewMap.h"
#include "ui/panels/OverviewPanel.h"
#include "ui/view/ZoomView.h"
#include "ui/window/MainWindow.h"
#include "ui/window/SecondView.h"
#include "ui/window/ViewOptionsMenu.h"
#include "ui/window/WindowMenus.h"

#include <QAction>

#include <algorithm>
#include <numbers>

namespace asperity {

namespace {

constexpr double kTurn = std::numbers::pi / 12.0;  // of the view, a step [rad]
constexpr double kTargetRoom = 1.3;       // half of the view's width, in distances of a target
constexpr double kTargetRoomAbove = 1.2;  // the same in heights, in a view much wider than high
constexpr double kUsualRadii = 2.4;       // the same at least, in tip radii

/// Wide enough that start and target of every trial are seen, and the same for all of a study.
double halfWidthFor(const Study& study) {
    double farthest = 0.0;
    for (const Vector2& target : study.targets) {
        farthest = std::max(farthest, target.cwiseAbs().maxCoeff());
    }
    double highest = study.startHeight;
    for (const StudyTask& task : study.tasks) {
        highest = std::max(highest, task.kind == TaskKind::Above ? task.farthest : 0.0);
    }
    return std::max(
        {kTargetRoom * farthest, kTargetRoomAbove * highest, kUsualRadii * study.scene.tip.radius});
}

}  // namespace

StudyViews::StudyViews(MainWindow& window) : window_(window) {
    window.overview().map().addTool(mark_);
}

/// They draw what the study allows: the second view always draws the deformation.
void StudyViews::begin(const Study& study) {
    halfWidth_ = halfWidthFor(study);
    window_.view().resetCamera();
    ViewOptions options = window_.menus().viewOptions().options();
    options.deformation = study.aids.deformation;
    options.trueTip = false;
    window_.menus().viewOptions().setOptions(options);
    window_.view().setOptions(options);
    if (!options.deformation) {
        window_.menus().secondView->setChecked(false);
    }
}

void StudyViews::showTrial(const Vector3& target) {
    window_.view().setHalfWidth(halfWidth_);
    showTarget(target);
}

void StudyViews::turn(int right, int up) {
    ZoomView& view = window_.view();
    const double elevation = view.camera().elevation() + up * kTurn;
    view.setDirection(view.camera().azimuth() + right * kTurn,
                      std::clamp(elevation, 0.0, 0.5 * std::numbers::pi));
}

void StudyViews::showTarget(const std::optional<Vector3>& target) {
    window_.view().setTarget(target);
    window_.second().space().setTarget(target);
    mark_.setTarget(target ? std::optional(QPointF(target->x(), target->y())) : std::nullopt);
}

}  // namespace asperity
