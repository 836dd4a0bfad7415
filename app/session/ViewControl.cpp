#include "app/session/ViewControl.h"

#include "ui/panels/CantileverPanel.h"
#include "ui/panels/ForcePanel.h"
#include "ui/panels/LoopStatusBar.h"
#include "ui/panels/OverviewPanel.h"
#include "ui/panels/StateBanner.h"
#include "ui/view/ContactShape.h"
#include "ui/view/ZoomView.h"
#include "ui/window/MainWindow.h"

#include <QPixmap>

namespace asperity {

namespace {

// Faster than the eye reads numbers, and half of what redrawing the panels costs.
constexpr int kFramesPerPanelFrame = 2;

}  // namespace

ViewControl::ViewControl(MainWindow& window, RunControl& runs) : window_(window), runs_(runs) {
    connect(&window, &MainWindow::pictureFileChosen, this, &ViewControl::savePicture);
}

void ViewControl::take(const TickSample& sample) {
    window_.forces().take(sample);
    window_.cantilever().take(sample);
    window_.banner().take(sample);
}

/// The frame shows the newest solution there is; the one it asks for is for a frame to come.
void ViewControl::solveHalfSpace(const Snapshot& latest) {
    HalfSpaceWorker* const worker = runs_.run()->halfSpace();
    if (worker != nullptr && latest.statistics.ticks > 0 &&
        isDrawable(latest.sample.output.model)) {
        worker->ask(latest.sample.output.model);
        const std::shared_ptr<const HalfSpaceAnswer> answer = worker->newest();
        window_.view().setHalfSpace(answer);
        window_.banner().setHalfSpace(answer.get());
    }
}

void ViewControl::show(double now) {
    LiveRun& run = *runs_.run();
    if (!run.loop().running()) {  // what is drawn while it stands still is not counted
        view_.rest();
        panels_.rest();
    }
    window_.banner().setEnergyGiven(run.energy().active());
    const Snapshot& latest = run.loop().snapshot();
    solveHalfSpace(latest);
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

void ViewControl::showEverywhere(const Snapshot& latest) {
    window_.view().showSnapshot(latest);
    window_.banner().show(latest);
    window_.forces().show(latest);
    window_.cantilever().show(latest);
    window_.overview().show(latest);
}

std::vector<ViewRate> ViewControl::rates() const {
    const double panels = panels_.overallRate();
    return {{"zoom", view_.overallRate()},
            {"forces", panels},
            {"cantilever", panels},
            {"overview", panels}};
}

void ViewControl::savePicture(const QString& file) {
    if (runs_.run() != nullptr) {
        runs_.fetch();
        showEverywhere(runs_.run()->loop().snapshot());
    }
    if (window_.grab().save(file)) {
        window_.tell(tr("Saved as %1").arg(file));
    } else {
        window_.complain(tr("%1: the picture cannot be written").arg(file));
    }
}

}  // namespace asperity
