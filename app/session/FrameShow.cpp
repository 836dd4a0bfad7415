#include "app/session/FrameShow.h"

#include "ui/panels/CantileverPanel.h"
#include "ui/panels/ForcePanel.h"
#include "ui/panels/LoopStatusBar.h"
#include "ui/panels/OverviewPanel.h"
#include "ui/panels/StateBanner.h"
#include "ui/view/ZoomView.h"
#include "ui/window/MainWindow.h"

namespace asperity {

namespace {

// Faster than the eye reads numbers, and half of what redrawing the panels costs.
constexpr int kFramesPerPanelFrame = 2;

}  // namespace

void FrameShow::take(const TickSample& sample) {
    window_.forces().take(sample);
    window_.cantilever().take(sample);
    window_.banner().take(sample);
}

void FrameShow::setHalfSpace(const std::shared_ptr<const HalfSpaceAnswer>& answer) {
    window_.view().setHalfSpace(answer);
    window_.banner().setHalfSpace(answer.get());
}

void FrameShow::setEnergyGiven(bool given) { window_.banner().setEnergyGiven(given); }

void FrameShow::show(const Snapshot& latest, double now) {
    frame_ = (frame_ + 1) % kFramesPerPanelFrame;
    if (frame_ == 0) {
        showEverywhere(latest);
        panels_.add(now);
    } else {
        window_.view().showSnapshot(latest);
        window_.banner().show(latest);
    }
    view_.add(now);
    window_.loopStatus().show(latest.statistics);
    window_.loopStatus().setFramesPerSecond(view_.rate());
}

void FrameShow::showEverywhere(const Snapshot& latest) {
    window_.view().showSnapshot(latest);
    window_.banner().show(latest);
    window_.forces().show(latest);
    window_.cantilever().show(latest);
    window_.overview().show(latest);
}

void FrameShow::rest() {
    view_.rest();
    panels_.rest();
}

std::vector<ViewRate> FrameShow::rates() const {
    const double panels = panels_.overallRate();
    return {{"zoom", view_.overallRate()},
            {"forces", panels},
            {"cantilever", panels},
            {"overview", panels}};
}

}  // namespace asperity
