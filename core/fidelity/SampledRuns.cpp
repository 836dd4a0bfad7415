#include "core/fidelity/SampledRuns.h"

namespace asperity {

namespace {

constexpr int kTicksAPath = 120;
constexpr double kSlowTick = 1e-3;  // [s]

}  // namespace

SampledRuns::SampledRuns(Scene& scene) : scene_(scene) {
    const SceneModel reference = scene.model;
    setModel(scene, usualModel(scene.description));  // the runs are the same whatever the reference
    const double duration = kTicksAPath * scene.timeStep();
    const Vector2 size(scene.surface.sizeX(), scene.surface.sizeY());
    const auto record = [&](const HandPath& path) {
        runs_.push_back(recordRun(scene, path, duration));
    };
    record(approachPath(scene, {.duration = duration}));
    last_ = runModel(scene, runs_);
    slow_ = tickTime() > kSlowTick;
    if (slow_) {
        return;
    }
    for (const Vector2& share : {Vector2(0.31, 0.62), Vector2(0.71, 0.27)}) {
        const Vector2 place = share.cwiseProduct(size);
        record(approachPath(scene, {.duration = duration, .place = place}));
    }
    record(rasterPath(scene, {.duration = duration}));
    refer(reference);
}

double SampledRuns::error(const SceneModel& model) {
    last_ = runWith(model);
    return share(last_, reference_);
}

double SampledRuns::difference(const SceneModel& a, const SceneModel& b) {
    last_ = runWith(a);
    return share(last_, runWith(b));
}

void SampledRuns::refer(const SceneModel& model) {
    reference_ = runWith(model);
    last_ = reference_;
}

double SampledRuns::share(const ModelRun& a, const ModelRun& b) const {
    const double scale = forceScale(reference_);
    return scale > 0.0 ? differenceOf(a, b).rms / scale : 0.0;
}

ModelRun SampledRuns::runWith(const SceneModel& model) const {
    setModel(scene_, model);
    return runModel(scene_, runs_);
}

}  // namespace asperity
