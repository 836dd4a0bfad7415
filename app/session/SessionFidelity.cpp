// What a session makes of the fidelity panel: terms overruled, a way for the tick picked, a study.

#include "app/session/FidelityStudy.h"
#include "app/session/Session.h"
#include "core/Error.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/ModelChoices.h"
#include "ui/panels/FidelityPanel.h"
#include "ui/window/MainWindow.h"

#include <utility>

namespace asperity {

namespace {

/// @throw Error where no model can be made of the choices
void requireModel(const SceneDescription& scene) {
    checkScene(scene);
    static_cast<void>(believedSystem(scene, usualModel(scene)));
}

}  // namespace

void Session::connectFidelity() {
    FidelityPanel& panel = window_.fidelity();
    const auto change = [this](const std::function<SceneDescription(SceneDescription)>& choose) {
        if (run_) {
            chooseModel(choose(run_->scene().description));
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
    connect(&panel, &FidelityPanel::automaticRequested, this, [choose] { choose(allAutomatic); });
    connect(&panel, &FidelityPanel::tierPicked, this, &Session::pickTier);
    connect(&panel, &FidelityPanel::measureRequested, this, &Session::measureFidelity);
    connect(&panel, &FidelityPanel::stopRequested, this, [this] { study_.cancel(); });
    connect(&study_, &FidelityStudy::progressed, &panel,
            [&panel](double fraction) { panel.setMeasuring(fraction); });
    connect(&study_, &FidelityStudy::finished, this,
            [this](const std::shared_ptr<const TradeOff>& study) {
                window_.fidelity().setMeasuring(std::nullopt);
                if (study) {
                    window_.fidelity().showTradeOff(*study);
                }
            });
    connect(&study_, &FidelityStudy::failed, this, [this](const std::exception_ptr& reason) {
        window_.fidelity().setMeasuring(std::nullopt);
        window_.complain(reasonOf(reason));
    });
}

void Session::chooseModel(const SceneDescription& choices) {
    try {
        requireModel(choices);
        requireHolding(choices);
    } catch (const Error& error) {
        window_.complain(QString::fromUtf8(error.what()));
        showFidelity();
        return;
    }
    rebuild([&choices](LoadedScene scene) { return withChoices(std::move(scene), choices); });
}

/// The chart stays: it is of the same scene, whatever its tick.
void Session::pickTier(const ForceModelOptions& tier) {
    if (run_) {
        const std::optional<TradeOff> study = window_.fidelity().tradeOff();
        SceneDescription scene = run_->scene().description;
        scene.choices = withForce(scene.choices, tier);
        chooseModel(scene);
        window_.fidelity().showTradeOff(study);
    }
}

void Session::measureFidelity() {
    if (!run_ || study_.isBusy()) {
        return;
    }
    if (!canBeStudied(run_->scene())) {
        window_.complain(tr("A scan of more than 2048 × 2048 pixels is not measured beside the "
                            "run; asperity tradeoff does it."));
        return;
    }
    study_.start(std::make_unique<Scene>(run_->scene()));
    window_.fidelity().setMeasuring(0.0);
}

/// What a study before found, or is about to, is of another scene.
void Session::showFidelity() {
    const Scene& scene = run_->scene();
    study_.cancel();
    window_.fidelity().showTradeOff(std::nullopt);
    window_.fidelity().showModel(run_->loaded().needs, scene.description.choices);
}

}  // namespace asperity
