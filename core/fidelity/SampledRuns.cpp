#include "core/fidelity/SampledRuns.h"

#include "core/fidelity/SampledPlaces.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace asperity {

namespace {

constexpr int kTicksAPath = 120;

/// Whether the same contact points bear a force.
bool isHeldAlike(const TipState& a, const TipState& b) {
    return (a.contact.contactRadius > 0.0) == (b.contact.contactRadius > 0.0) &&
           a.points == b.points;
}

QuantityErrors cycleErrors(const std::optional<SampledCycle>& cycle,
                           const SampledCycle& reference) {
    if (cycle) {
        return errorsOf(*cycle, reference);
    }
    QuantityErrors nothing;  // to be read, where there is something
    for (const JudgedQuantity quantity : kValues<JudgedQuantity>) {
        nothing[quantity] = 1.0;
    }
    return nothing;
}

}  // namespace

double forceShare(std::span<const TipState> run, std::span<const TipState> reference) {
    const auto differs = [&](std::size_t tick) {
        return tick < run.size() && !isHeldAlike(run[tick], reference[tick]);
    };
    ForceSquares squares;
    for (std::size_t i = 0; i < run.size(); ++i) {
        const double error = (run[i].force - reference[i].force).squaredNorm();
        squares.reference += reference[i].force.squaredNorm();
        if (!differs(i)) {
            squares.heldAlike += error;
        } else if (differs(i - 1) || differs(i + 1)) {
            squares.heldByOne += error;
        }
    }
    return squares.share();
}

SampledRuns::SampledRuns(Scene& scene, double longestTick, const Progress* progress)
    : scene_(scene), progress_(progress) {
    setModel(scene, usualModel(scene.description));  // the runs are the same whatever the reference
    const double duration = kTicksAPath * scene.timeStep();
    addRun(slidePath(scene, {.duration = duration}));
    usualTickTime_ = quantile(runModel(scene, runs_, progress_).times, 0.5);
    slow_ = usualTickTime_ > longestTick;
    if (slow_) {
        return;
    }
    const Vector2 size(scene.surface.sizeX(), scene.surface.sizeY());
    double depth = PathPlan{}.indentation;
    for (const Vector2& share : {Vector2(0.31, 0.62), Vector2(0.71, 0.27)}) {
        depth *= 0.5;  // the less a slide presses, the more adhesion weighs in its force
        addRun(slidePath(
            scene,
            {.duration = duration, .indentation = depth, .place = share.cwiseProduct(size)}));
    }
    addRun(rasterPath(scene, {.duration = duration}));
    places_ = sampledPlaces(scene);
}

void SampledRuns::addRun(const DevicePath& path) {
    runs_.push_back(recordInputs(scene_, path, kTicksAPath * scene_.timeStep(), progress_));
}

const ModelSample& SampledRuns::of(const ForceModelOptions& model) {
    setModel(scene_, model);
    const ForceModelOptions same = ofForce(model);
    const auto known = std::ranges::find(samples_, same, &ModelSample::model);
    if (known != samples_.end()) {
        return *known;
    }
    ModelSample sample{
        .model = same, .run = runModel(scene_, runs_, progress_), .tickTime = 0.0, .cycles = {}};
    sample.tickTime = quantile(sample.run.times, 0.5);
    for (const Vector2& place : places_) {
        throwIfCanceled(progress_);
        sample.cycles.push_back(sampleCycle(scene_, place, scene_.description.setpoint));
    }
    return samples_.emplace_back(std::move(sample));
}

double SampledRuns::timeDifference(const ForceModelOptions& one, const ForceModelOptions& other) {
    const std::vector<ModelInputs> first(runs_.begin(), runs_.begin() + 1);
    const auto timeOf = [&](const ForceModelOptions& model) {
        setModel(scene_, model);
        return quantile(runModel(scene_, first, progress_).times, 0.5);
    };
    const double ofOther = timeOf(other);
    return timeOf(one) - ofOther;
}

QuantityErrors SampledRuns::errors(const ForceModelOptions& model,
                                   const ForceModelOptions& reference) {
    const ModelSample& exact = of(reference);
    const ModelSample& sample = of(model);
    QuantityErrors errors;
    for (std::size_t i = 0; i < exact.cycles.size(); ++i) {
        if (exact.cycles[i]) {
            errors.raiseTo(cycleErrors(sample.cycles[i], *exact.cycles[i]));
        }
    }
    std::size_t first = 0;
    for (const ModelInputs& run : runs_) {
        const std::size_t ticks = run.inputs.size();
        const double share = forceShare(std::span(sample.run.states).subspan(first, ticks),
                                        std::span(exact.run.states).subspan(first, ticks));
        errors[JudgedQuantity::RunForce] = std::max(errors[JudgedQuantity::RunForce], share);
        first += ticks;
    }
    return errors;
}

}  // namespace asperity
