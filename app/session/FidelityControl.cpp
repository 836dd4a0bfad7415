#include "app/session/FidelityControl.h"

#include "core/Error.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/ModelChoices.h"
#include "ui/panels/FidelityPanel.h"
#include "ui/window/MainWindow.h"

#include <utility>

namespace asperity {

namespace {

constexpr long kMaxPixels = 2048L * 2048L;

/// Force errors are those of `asperity tradeoff`; times are of fewer rounds, so that it takes
/// seconds, and pictures are not shown.
constexpr TradeOffPlan kPlan{.duration = 2.0, .rounds = 3, .patches = 1};

/// @throw Error where no model can be made of the choices
void requireModel(const SceneDescription& scene) {
    checkScene(scene);
    static_cast<void>(believedSystem(scene, usualModel(scene)));
}

}  // namespace

bool canBeStudied(const Scene& scene) noexcept {
    const auto& grid = scene.surface.grid();
    return static_cast<long>(grid.columns) * grid.rows <= kMaxPixels;
}

FidelityControl::FidelityControl(MainWindow& window, RunControl& runs)
    : window_(window)
    , runs_(runs)
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
}

void FidelityControl::connectInputs() {
    FidelityPanel& panel = window_.fidelity();
    const auto change = [this](const std::function<SceneDescription(SceneDescription)>& choose) {
        if (runs_.run() != nullptr) {
            chooseModel(choose(runs_.run()->scene().description));
        }
    };
    const auto choose = [change](const std::function<ModelChoices(const ModelChoices&)>& choice) {
        change([&choice](SceneDescription scene) {
            scene.choices = choice(scene.choices);
            return scene;
        });
    };
    connect(&panel, &FidelityPanel::termChosen, this,
            [choose](ModelTerm term, std::optional<bool> on) {
                choose([&](const ModelChoices& now) { return withChoice(now, term, on); });
            });
    connect(&panel, &FidelityPanel::toleranceChosen, this, [change](double share) {
        change([share](SceneDescription scene) {
            scene.tolerance = share;
            return scene;
        });
    });
    connect(&panel, &FidelityPanel::automaticRequested, this, [change] {
        change([](SceneDescription scene) {
            scene.choices = allAutomatic(scene.choices);
            scene.tolerance = defaultScene().tolerance;
            return scene;
        });
    });
    connect(&panel, &FidelityPanel::optionsPicked, this, &FidelityControl::pickOptions);
    connect(&panel, &FidelityPanel::measureRequested, this, &FidelityControl::measure);
    connect(&panel, &FidelityPanel::stopRequested, this, [this] { study_.cancel(); });
}

void FidelityControl::chooseModel(const SceneDescription& choices) {
    try {
        requireModel(choices);
        runs_.run()->requireHolding(choices);
    } catch (const Error& error) {
        window_.complain(QString::fromUtf8(error.what()));
        showScene();
        return;
    }
    runs_.rebuild([&choices](LoadedScene scene) { return withChoices(std::move(scene), choices); });
}

/// The chart stays: it is of the same scene, whatever its tick.
void FidelityControl::pickOptions(const ForceModelOptions& options) {
    if (runs_.run() != nullptr) {
        const std::optional<TradeOff> study = window_.fidelity().tradeOff();
        SceneDescription scene = runs_.run()->scene().description;
        scene.choices = withForce(scene.choices, options);
        chooseModel(scene);
        window_.fidelity().showTradeOff(study);
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
    window_.fidelity().showTradeOff(std::nullopt);
    window_.fidelity().refuseMeasuring(
        canBeStudied(scene) ? QString()
                            : tr("A scan of more than 2048 × 2048 pixels cannot be measured during "
                                 "the run: use asperity tradeoff"));
    window_.fidelity().showModel(runs_.run()->loaded().needs, scene.description.choices);
}

}  // namespace asperity
