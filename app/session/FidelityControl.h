#pragma once

#include "app/session/BackgroundWork.h"
#include "app/session/RunControl.h"
#include "core/studies/TradeOffStudy.h"

namespace asperity {

/// Speed against accuracy of the scene shown: terms overruled, a way for the tick picked, a study
/// beside the run.
class FidelityControl : public QObject {
public:
    FidelityControl(MainWindow& window, RunControl& runs);

private:
    void connectInputs();
    void chooseModel(const SceneDescription& choices);
    void pickOptions(const ForceModelOptions& options);
    void measure();
    void showScene();

    MainWindow& window_;
    RunControl& runs_;
    BackgroundWork<TradeOff> study_;
};

/// Whether the scan is small enough to be copied for a study.
[[nodiscard]] bool canBeStudied(const Scene& scene) noexcept;

}  // namespace asperity
