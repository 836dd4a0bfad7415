#include "core/fidelity/SampledRuns.h"

#include <algorithm>
#include <utility>

namespace asperity {

namespace {

constexpr int kTicksAPath = 120;
constexpr double kSlowTick = 1e-3;  // [s]
/// Of the ticks: one in which a jump comes a little earlier is no other feeling.
constexpr double kAllButJumps = 0.97;
/// A force of the separate tip that is this share of those in contact is felt as well as these.
constexpr double kFaint = 0.1;

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
    std::vector<double> touching;
    std::vector<double> apart;
    for (std::size_t i = 0; i < reference_.states.size(); ++i) {
        const bool touches = reference_.states[i].contact.contactRadius > 0.0;
        (touches ? touching : apart).push_back((a.states[i].force - b.states[i].force).norm());
    }
    return scale > 0.0 ? std::max(quantile(std::move(touching), kAllButJumps) / scale,
                                  quantile(std::move(apart), kAllButJumps) / (kFaint * scale))
                       : 0.0;
}

ModelRun SampledRuns::runWith(const SceneModel& model) const {
    setModel(scene_, model);
    return runModel(scene_, runs_);
}

}  // namespace asperity
