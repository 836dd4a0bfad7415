#include "core/studies/TradeOffStudy.h"

#include "core/scene/Scene.h"
#include "core/studies/RateStudy.h"
#include "core/studies/SurfaceStudy.h"
#include "core/studies/TickStudy.h"

#include <cstddef>

namespace asperity {

namespace {

/// Restores a scene's model and rate in the end.
class SceneKept {
public:
    explicit SceneKept(Scene& scene)
        : scene_(scene), model_(scene.model), tickRate_(scene.description.tickRate) {}
    SceneKept(const SceneKept&) = delete;
    SceneKept& operator=(const SceneKept&) = delete;
    ~SceneKept() {
        scene_.description.tickRate = tickRate_;
        setModel(scene_, model_);
    }

    [[nodiscard]] const ForceModelOptions& model() const { return model_; }

private:
    Scene& scene_;
    ForceModelOptions model_;
    double tickRate_;
};

/// The scene's own model with both models from signals to force.
std::vector<ForceModelOptions> decouplingModels(const ForceModelOptions& model) {
    ForceModelOptions planar = ofForce(model);
    planar.decoupling = DecouplingModel::Planar;
    ForceModelOptions estimating = planar;
    estimating.decoupling = DecouplingModel::Estimator;
    return {planar, estimating};
}

void measureTicks(TickStudy& study, std::vector<ForceModelOptions> models,
                  const std::vector<ForceModelOptions>& decouplings, TradeOff& result) {
    const auto count = static_cast<std::ptrdiff_t>(models.size());
    models.insert(models.end(), decouplings.begin(), decouplings.end());
    const std::vector<TickResult> all = study.measured(models);
    result.ticks.assign(all.begin(), all.begin() + count);
    result.decouplings.assign(all.begin() + count, all.end());
    result.timeResolution = study.timeResolution();
    study.describe(result.reference);
    markFront(result.ticks, result.ofTicks());
}

}  // namespace

TradeOff studyTradeOff(Scene& scene, const TradeOffPlan& plan, Progress* progress) {
    const SceneKept before(scene);
    TradeOff result;
    ProgressPart ticking(progress, 0.0, 0.8);
    std::vector<ForceModelOptions> models = tickModels(scene);
    TickStudy ticks(scene, plan, &ticking);
    models.push_back(ofForce(ticks.model()));
    measureTicks(ticks, models, decouplingModels(before.model()), result);
    setModel(scene, ticks.model());
    ProgressPart drawing(progress, 0.8, 0.95);
    studySurfaces(scene, ticks.reference().states, plan, &drawing, result);
    markFront(result.frames, result.ofFrames());
    setModel(scene, before.model());
    result.rates = studyRates(scene, plan.duration, progress);
    reportTo(progress, 1.0);
    return result;
}

}  // namespace asperity
