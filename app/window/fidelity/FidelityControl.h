#pragma once

#include "app/window/LongWork.h"
#include "app/window/Stage.h"
#include "core/studies/TradeOffStudy.h"

#include <optional>

namespace asperity {

class FidelityPanel;

/// Speed against accuracy of the scene shown: terms overruled, a way for the tick picked, a study
/// beside the run.
class FidelityControl : public Feature {
public:
    explicit FidelityControl(Stage& stage);

private:
    void addEntry();
    void connectInputs();
    void pickOptions(const ForceModelOptions& options);
    void measure();
    void showScene();
    void showModel();

    FidelityPanel* panel_;
    std::optional<ModelChoices> picked_;  ///< in the chart: it stays over the scene with these
    BackgroundWork<TradeOff> study_;
};

/// Returns whether the scan is small enough to be copied for a study.
[[nodiscard]] bool canBeStudied(const Scene& scene) noexcept;

/// Finds out, beside a run that has begun with every term, what its scene requires of its model,
/// and gives the run the model of these terms once the tip feels nothing. So it does where the
/// setpoint is another than the one on which the terms were judged. A recording has one model from
/// its begin to its end.
class ModelFitControl : public Feature {
    Q_OBJECT

public:
    explicit ModelFitControl(Stage& stage);

    /// Once a frame. There is a run.
    void advance();

private:
    void begin();

    double setpoint_ = 0.0;              ///< for which terms are, or have been, judged [N]
    std::optional<LoadedScene> fitted_;  ///< that the run is to have
    BackgroundWork<LoadedScene> work_;
};

}  // namespace asperity
