#pragma once

#include "app/session/BackgroundWork.h"
#include "app/session/RunControl.h"
#include "app/session/SceneEdits.h"
#include "core/studies/TradeOffStudy.h"

namespace asperity {

/// Speed against accuracy of the scene shown: terms overruled, a way for the tick picked, a study
/// beside the run.
class FidelityControl : public QObject {
public:
    FidelityControl(MainWindow& window, RunControl& runs, SceneEdits& edits);

private:
    void connectInputs();
    void pickOptions(const ForceModelOptions& options);
    void measure();
    void showScene();
    void showModel();

    MainWindow& window_;
    RunControl& runs_;
    SceneEdits& edits_;
    std::optional<ModelChoices> picked_;  ///< in the chart: it stays over the scene with these
    BackgroundWork<TradeOff> study_;
};

/// Whether the scan is small enough to be copied for a study.
[[nodiscard]] bool canBeStudied(const Scene& scene) noexcept;

}  // namespace asperity
