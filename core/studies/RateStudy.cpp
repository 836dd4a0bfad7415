#include "core/studies/RateStudy.h"

#include "core/fidelity/ModelRun.h"
#include "core/scene/Scene.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kMinRate = 250.0;       // [Hz]
constexpr double kMaxRate = 8e3;         // [Hz]
constexpr double kReferenceRate = 16e3;  // [Hz]

/// How a run goes, whatever its rate.
struct Course {
    DevicePath path;
    double duration = 0.0;  ///< [s]
    const Progress* progress = nullptr;
};

ModelRun runAt(Scene& scene, const Course& course, double rate) {
    scene.description.tickRate = rate;
    const ModelInputs run = recordInputs(scene, course.path, course.duration, course.progress);
    return runModel(scene, {run}, course.progress);
}

/// Between ticks the last force stands.
double holdError(const ModelRun& held, double rate, const ModelRun& finest) {
    double sum = 0.0;
    for (std::size_t i = 0; i < finest.states.size(); ++i) {
        const auto tick = static_cast<std::size_t>(static_cast<double>(i) * rate / kReferenceRate);
        const TipState& state = held.states[std::min(tick, held.states.size() - 1)];
        sum += (state.force - finest.states[i].force).squaredNorm();
    }
    return std::sqrt(sum / static_cast<double>(finest.states.size()));
}

}  // namespace

std::vector<RateResult> studyRates(Scene& scene, double duration, const Progress* progress) {
    const Course course{slidePath(scene, {.duration = duration}), duration, progress};
    const ModelRun finest = runAt(scene, course, kReferenceRate);
    std::vector<RateResult> results;
    for (double rate = kMinRate; rate <= kMaxRate; rate *= 2.0) {
        const ModelRun run = runAt(scene, course, rate);
        results.push_back({.rate = rate,
                           .load = rate * quantile(run.times, 0.5),
                           .holdErrorRms = holdError(run, rate, finest)});
    }
    return results;
}

}  // namespace asperity
