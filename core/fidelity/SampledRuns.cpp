#include "core/fidelity/SampledRuns.h"

#include "core/scene/BelievedModel.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace asperity {

namespace {

constexpr int kTicksAPath = 120;
/// Runs that take less are timed in turns; of others the reference need not run again [s].
constexpr double kQuickRuns = 0.02;
/// Of the ticks: one in which a jump comes a little earlier is no other feeling.
constexpr double kAllButJumps = 0.97;
/// A force of the separate tip that is this share of those in contact is felt as well as these.
constexpr double kFaint = 0.1;

}  // namespace

double forceShare(const ModelRun& run, const ModelRun& reference) {
    const double scale = forceScale(reference);
    std::vector<double> touching;
    std::vector<double> apart;
    for (std::size_t i = 0; i < reference.states.size(); ++i) {
        const bool touches = reference.states[i].contact.contactRadius > 0.0;
        const double error = (run.states[i].force - reference.states[i].force).norm();
        (touches ? touching : apart).push_back(error);
    }
    return scale > 0.0 ? std::max(quantile(std::move(touching), kAllButJumps) / scale,
                                  quantile(std::move(apart), kAllButJumps) / (kFaint * scale))
                       : 0.0;
}

SampledRuns::SampledRuns(Scene& scene, double longestTick, const Progress* progress)
    : scene_(scene), progress_(progress) {
    const ForceModelOptions reference = scene.model;
    setModel(scene, usualModel(scene.description));  // the runs are the same whatever the reference
    const double duration = kTicksAPath * scene.timeStep();
    const Vector2 size(scene.surface.sizeX(), scene.surface.sizeY());
    const auto record = [&](const DevicePath& path) {
        runs_.push_back(recordInputs(scene, path, duration, progress_));
    };
    record(slidePath(scene, {.duration = duration}));
    last_ = runModel(scene, runs_, progress_);
    slow_ = tickTime() > longestTick;
    if (slow_) {
        return;
    }
    for (const Vector2& share : {Vector2(0.31, 0.62), Vector2(0.71, 0.27)}) {
        const Vector2 place = share.cwiseProduct(size);
        record(slidePath(scene, {.duration = duration, .place = place}));
    }
    record(rasterPath(scene, {.duration = duration}));
    refer(reference);
}

double SampledRuns::error(const ForceModelOptions& model) {
    last_ = runWith(model);
    return forceShare(last_, reference_);
}

ModelDifference SampledRuns::between(const ForceModelOptions& with,
                                     const ForceModelOptions& without) {
    const ModelRun less = runWith(without);
    const bool isQuick = std::accumulate(less.times.begin(), less.times.end(), 0.0) < kQuickRuns;
    const bool isKnown = !isQuick && ofForce(with) == ofForce(referred_);
    ModelDifference difference{.with = isKnown ? reference_ : runWith(with)};
    difference.effect = forceShare(less, difference.with);
    difference.time = quantile(difference.with.times, 0.5) - quantile(less.times, 0.5);
    setModel(scene_, with);
    return difference;
}

void SampledRuns::refer(const ForceModelOptions& model) {
    referred_ = model;
    reference_ = runWith(model);
    last_ = reference_;
}

ModelRun SampledRuns::runWith(const ForceModelOptions& model) const {
    setModel(scene_, model);
    return runModel(scene_, runs_, progress_);
}

}  // namespace asperity
