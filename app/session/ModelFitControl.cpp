#include "app/session/ModelFitControl.h"

#include "app/loading/SceneLoader.h"
#include "app/session/RecordingControl.h"
#include "ui/window/MainWindow.h"

#include <utility>

namespace asperity {

ModelFitControl::ModelFitControl(MainWindow& window, RunControl& runs,
                                 const RecordingControl& recordings)
    : runs_(runs)
    , recordings_(recordings)
    , work_({.progressed = [](double /*share*/) {},
             .finished = [this](LoadedScene& fitted) { fitted_ = std::move(fitted); },
             .failed =
                 [&window](const std::exception_ptr& reason) {
                     window.complain(tr("The model keeps everything: %1").arg(reasonOf(reason)));
                 }}) {
    connect(&runs, &RunControl::begun, this, &ModelFitControl::begin);
}

void ModelFitControl::begin() {
    work_.cancel();
    fitted_.reset();
    const LiveRun& run = *runs_.run();
    const SceneNeeds& needs = run.loaded().needs;
    setpoint_ = run.scene().description.setpoint;
    if (needs.pending || (needs.measured && needs.setpoint != setpoint_)) {
        work_.start(
            [present = run.shared(), description = run.scene().description](Progress& progress) {
                return withDescription(*present, description, &progress);
            });
    }
}

void ModelFitControl::advance() {
    if (runs_.run()->scene().description.setpoint != setpoint_) {
        begin();
    }
    if (fitted_ && !recordings_.isWriting() && runs_.run()->mayAdoptModel() &&
        runs_.adoptModel(*fitted_)) {
        fitted_.reset();
    }
}

}  // namespace asperity
