#include "app/session/FidelityControl.h"

#include "core/scene/ModelChoices.h"
#include "core/words/ModelWords.h"
#include "ui/CoreWords.h"
#include "ui/panels/FidelityPanel.h"
#include "ui/panels/PercentText.h"
#include "ui/window/MainWindow.h"

#include <utility>

namespace asperity {

namespace {

constexpr long kMaxPixels = 2048L * 2048L;

/// Force errors are those of `asperity tradeoff`; times are of fewer rounds, so that it takes
/// seconds, and pictures are not shown.
constexpr TradeOffPlan kPlan{.duration = 2.0, .rounds = 3, .patches = 1};

/// What the history calls a term's choice.
QString nameOf(ModelTerm term, std::optional<bool> on) {
    return FidelityControl::tr("Model: %1 %2")
        .arg(coreWords(nameOf(term)),
             !on ? FidelityControl::tr("automatic")
                 : (*on ? FidelityControl::tr("on") : FidelityControl::tr("off")));
}

}  // namespace

bool canBeStudied(const Scene& scene) noexcept {
    const auto& grid = scene.surface.grid();
    return static_cast<long>(grid.columns) * grid.rows <= kMaxPixels;
}

FidelityControl::FidelityControl(MainWindow& window, RunControl& runs, SceneEdits& edits)
    : window_(window)
    , runs_(runs)
    , edits_(edits)
    , study_({.progressed = [&window](double share) { window.fidelity().setMeasuring(share); },
              .finished =
                  [&window](const TradeOff& study) {
                      window.fidelity().setMeasuring(std::nullopt);
                      window.fidelity().showTradeOff(study);
                  },
              .failed =
                  [&window](const std::exception_ptr& reason) {
                      window.fidelity().setMeasuring(std::nullopt);
                      window.complain(reasonOf(reason));
                  },
              .canceled = [&window] { window.fidelity().setMeasuring(std::nullopt); }}) {
    connectInputs();
    connect(&runs, &RunControl::begun, this, &FidelityControl::showScene);
    connect(&runs, &RunControl::modelFitted, this, &FidelityControl::showModel);
    connect(&edits, &SceneEdits::changed, this, &FidelityControl::showModel);
}

void FidelityControl::connectInputs() {
    FidelityPanel& panel = window_.fidelity();
    const auto change = [this](const QString& name, const QString& number, const auto& choose) {
        if (const SceneDescription* const now = edits_.wanted()) {
            SceneDescription next = *now;
            choose(next);
            edits_.change(name, next, number);
        }
    };
    connect(&panel, &FidelityPanel::termChosen, this,
            [change](ModelTerm term, std::optional<bool> on) {
                change(nameOf(term, on), {}, [&](SceneDescription& scene) {
                    scene.choices = withChoice(scene.choices, term, on);
                });
            });
    connect(&panel, &FidelityPanel::toleranceChosen, this, [change](double share) {
        change(tr("Tolerance: %1 %").arg(percentText(share)), QStringLiteral("tolerance"),
               [share](SceneDescription& scene) { scene.tolerance = share; });
    });
    connect(&panel, &FidelityPanel::automaticRequested, this, [change] {
        change(tr("Model: all automatic"), {}, [](SceneDescription& scene) {
            scene.choices = allAutomatic(scene.choices);
            scene.tolerance = defaultScene().tolerance;
        });
    });
    connect(&panel, &FidelityPanel::optionsPicked, this, &FidelityControl::pickOptions);
    connect(&panel, &FidelityPanel::measureRequested, this, &FidelityControl::measure);
    connect(&panel, &FidelityPanel::stopRequested, this, [this] { study_.cancel(); });
}

/// The chart stays: it is of the same scene, whatever its tick.
void FidelityControl::pickOptions(const ForceModelOptions& options) {
    if (const SceneDescription* const now = edits_.wanted()) {
        SceneDescription next = *now;
        next.choices = withForce(now->choices, options);
        picked_ = next.choices;
        edits_.change(tr("Model: %1").arg(coreWords(nameOf(options))), next);
    }
}

void FidelityControl::measure() {
    if (runs_.run() == nullptr || study_.isBusy() || !canBeStudied(runs_.run()->scene())) {
        return;
    }
    const Scene& scene = runs_.run()->scene();
    // A copy: the study changes its model.
    study_.start([own = std::make_shared<Scene>(scene)](Progress& progress) {
        return studyTradeOff(*own, kPlan, &progress);
    });
    window_.fidelity().setMeasuring(0.0);
}

/// What a study before found, or is about to, is of another scene.
void FidelityControl::showScene() {
    const Scene& scene = runs_.run()->scene();
    study_.cancel();
    if (std::exchange(picked_, std::nullopt) != scene.description.choices) {
        window_.fidelity().showTradeOff(std::nullopt);
    }
    window_.fidelity().refuseMeasuring(
        canBeStudied(scene) ? QString()
                            : tr("A scan of more than 2048 × 2048 pixels cannot be measured during "
                                 "the run: use asperity tradeoff"));
    showModel();
}

/// The choices as they are to be; what they are worth as it is.
void FidelityControl::showModel() {
    if (const SceneDescription* const scene = edits_.wanted()) {
        window_.fidelity().showModel(runs_.run()->loaded().needs, scene->choices);
    }
}

}  // namespace asperity
