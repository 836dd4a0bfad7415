#include "core/fidelity/ModelRun.h"

#include "core/haptics/VirtualRun.h"
#include "core/scene/BelievedModel.h"

#include <chrono>
#include <cmath>

namespace asperity {

void throwIfCanceled(const Progress* progress) {
    if (progress != nullptr && progress->isCanceled()) {
        throw Canceled();
    }
}

ModelInputs recordInputs(const Scene& scene, const DevicePath& path, double duration,
                         const Progress* progress) {
    SimulatedAfm afm(scene.trueSurface(), truthOf(scene));
    ModelInputs run;
    const long ticks = std::lround(duration / scene.timeStep()) + 1;
    runVirtually(scene, path, afm, ticks, [&](const TickSample& sample) {
        throwIfCanceled(progress);
        run.inputs.push_back(sample.input);
        run.trueForces.push_back(afm.trueState().force);
    });
    return run;
}

ModelRun runModel(const Scene& scene, const std::vector<ModelInputs>& runs,
                  const Progress* progress) {
    using Clock = std::chrono::steady_clock;
    ModelRun result;
    for (const ModelInputs& run : runs) {
        TickMemory memory;
        ClosestPointTracker tracker;
        for (const TickInput& input : run.inputs) {
            throwIfCanceled(progress);
            const auto start = Clock::now();
            const TickOutput output = tick(scene, input, memory, tracker);
            result.times.push_back(std::chrono::duration<double>(Clock::now() - start).count());
            result.states.push_back(output.model);
            result.estimates.push_back(output.estimate.force);
        }
    }
    return result;
}

ForceDifference differenceOf(const ModelRun& run, const ModelRun& reference) {
    ForceDifference difference;
    double sum = 0.0;
    for (std::size_t i = 0; i < run.states.size(); ++i) {
        const TipState& state = run.states[i];
        const TipState& exact = reference.states[i];
        const double error = (state.force - exact.force).norm();
        sum += error * error;
        difference.largest = std::max(difference.largest, error);
        difference.contactRadius =
            std::max(difference.contactRadius,
                     std::abs(state.contact.contactRadius - exact.contact.contactRadius));
        if (exact.contact.contactRadius > 0.0 && state.contact.contactRadius > 0.0) {
            difference.closest =
                std::max(difference.closest, (state.closest.point - exact.closest.point).norm());
        }
    }
    difference.rms = std::sqrt(sum / static_cast<double>(run.states.size()));
    return difference;
}

double forceScale(const ModelRun& run) {
    double sum = 0.0;
    for (const TipState& state : run.states) {
        sum += state.force.squaredNorm();
    }
    return std::sqrt(sum / static_cast<double>(run.states.size()));
}

double quantile(std::vector<double> values, double share) {
    if (values.empty()) {
        return 0.0;
    }
    const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    return values[static_cast<std::size_t>(rank)];
}

ForceModelOptions wholeModel(const Scene& scene) {
    SceneDescription description = scene.description;
    description.choices = {.solver = SolverSetting::Exact,
                           .closestPointSearch = SearchEffort::Certified,
                           .decoupling = description.choices.decoupling,
                           .deformation = description.choices.deformation};
    ForceModelOptions model = usualModel(description);
    model.bodyAttraction = isInScene(ModelTerm::BodyAttraction, scene);
    return model;
}

bool isInScene(ModelTerm term, const Scene& scene) noexcept {
    return isPossible(term, scene.description) &&
           (term != ModelTerm::BodyAttraction || scene.moments != nullptr);
}

std::vector<ModelTerm> missingTerms(const ForceModelOptions& model, const Scene& scene) {
    std::vector<ModelTerm> missing;
    for (const ModelTerm term : kModelTerms) {
        if (!isOfSurface(term) && !has(model, term) && isInScene(term, scene)) {
            missing.push_back(term);
        }
    }
    return missing;
}

TermPair pairOf(ModelTerm term, ForceModelOptions model) {
    for (const ModelTerm other : kModelTerms) {
        model = exclude(term, other) ? without(model, other) : model;
    }
    const ForceModelOptions in = with(model, term);
    return {in, without(in, term)};
}

}  // namespace asperity
