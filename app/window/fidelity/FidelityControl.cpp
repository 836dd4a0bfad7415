#include "app/window/fidelity/FidelityControl.h"

#include "app/loading/SceneLoader.h"
#include "app/window/fidelity/FidelityPanel.h"
#include "core/scene/ModelChoices.h"
#include "core/words/ModelWords.h"
#include "ui/shell/Menus.h"
#include "ui/widgets/ShownText.h"

#include <QAction>

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

FidelityControl::FidelityControl(Stage& stage)
    : Feature(stage)
    , panel_(new FidelityPanel(&host_.widget()))
    , study_({.progressed = [this](double share) { panel_->setMeasuring(share); },
              .finished =
                  [this](const TradeOff& study) {
                      panel_->setMeasuring(std::nullopt);
                      panel_->showTradeOff(study);
                  },
              .failed =
                  [this](const std::exception_ptr& reason) {
                      panel_->setMeasuring(std::nullopt);
                      host_.complain(reasonOf(reason));
                  },
              .canceled = [this] { panel_->setMeasuring(std::nullopt); }}) {
    host_.addWindow(*panel_);
    connect(&runs_, &RunControl::changesAllowed, panel_, &QWidget::setEnabled);
    addEntry();
    connectInputs();
    connect(&runs_, &RunControl::begun, this, &FidelityControl::showScene);
    connect(&runs_, &RunControl::modelFitted, this, &FidelityControl::showModel);
    connect(&edits_, &SceneEdits::changed, this, &FidelityControl::showModel);
}

void FidelityControl::addEntry() {
    const QAction& entry =
        host_.menus().add({MenuName::View, 3, 10}, "fidelity",
                          {.text = tr("&Fidelity…"),
                           .tip = tr("Terms of the model with their errors and costs"),
                           .shortcuts = {tr("F6")}});
    connect(&entry, &QAction::triggered, this, [this] { host_.toggle(*panel_); });
}

void FidelityControl::connectInputs() {
    FidelityPanel& panel = *panel_;
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
    panel_->setMeasuring(0.0);
}

/// What a study before found, or is about to, is of another scene.
void FidelityControl::showScene() {
    const Scene& scene = runs_.run()->scene();
    study_.cancel();
    if (std::exchange(picked_, std::nullopt) != scene.description.choices) {
        panel_->showTradeOff(std::nullopt);
    }
    panel_->refuseMeasuring(
        canBeStudied(scene) ? QString()
                            : tr("A scan of more than 2048 × 2048 pixels cannot be measured during "
                                 "the run: use asperity tradeoff"));
    showModel();
}

/// The choices as they are to be; what they are worth as it is.
void FidelityControl::showModel() {
    if (const SceneDescription* const scene = edits_.wanted()) {
        panel_->showModel(runs_.loaded().needs, scene->choices, 1.0 / scene->tickRate);
    }
}

ModelFitControl::ModelFitControl(Stage& stage)
    : Feature(stage)
    , work_({.progressed = [](double /*share*/) {},
             .finished = [this](LoadedScene& fitted) { fitted_ = std::move(fitted); },
             .failed =
                 [this](const std::exception_ptr& reason) {
                     host_.complain(tr("The model keeps everything: %1").arg(reasonOf(reason)));
                 }}) {
    stage.onFrame(FrameStep::Act, [this](double /*elapsed*/) { advance(); });
    connect(&runs_, &RunControl::begun, this, &ModelFitControl::begin);
}

void ModelFitControl::begin() {
    work_.cancel();
    fitted_.reset();
    const LiveRun& run = *runs_.run();
    const RequiredTerms& needs = run.loaded().needs;
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
    if (fitted_ && !runs_.isRecorded() && runs_.run()->mayAdoptModel() &&
        runs_.adoptModel(*fitted_)) {
        fitted_.reset();
    }
}

}  // namespace asperity
