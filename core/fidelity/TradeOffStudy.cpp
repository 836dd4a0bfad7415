#include "core/fidelity/TradeOffStudy.h"

#include "core/haptics/HapticTick.h"
#include "core/haptics/VirtualRun.h"
#include "core/probe/SimulatedAfm.h"
#include "core/scene/ContactPatch.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace asperity {

namespace {

using SteadyClock = std::chrono::steady_clock;

double secondsSince(SteadyClock::time_point start) {
    return std::chrono::duration<double>(SteadyClock::now() - start).count();
}

/// The value below which a share of the values lies.
double quantile(std::vector<double> values, double share) {
    if (values.empty()) {
        return 0.0;
    }
    const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    return values[static_cast<std::size_t>(rank)];
}

/// One tier with its scene and what was measured of it so far.
struct TierRun {
    FidelityTier tier;
    Scene scene;
    std::vector<TipState> states;    ///< the believed state of every tick
    std::vector<double> tickTimes;   ///< [s]
    std::vector<double> patchTimes;  ///< [s]
    std::vector<SurfacePatch> patches;
};

/// All inputs of the run, recorded once, so that every tier works on the same ones.
std::vector<TickInput> recordInputs(const Scene& scene, const TradeOffPlan& plan) {
    SimulatedAfm afm(scene.touched(), scene.truth);
    std::vector<TickInput> inputs;
    const long ticks = std::lround(plan.path.duration / scene.timeStep()) + 1;
    runVirtually(scene, approachPath(scene, plan.path), afm, ticks,
                 [&inputs](const TickSample& sample) { inputs.push_back(sample.input); });
    return inputs;
}

/// One timed pass over the inputs; keeps the states of the last pass.
void runTicks(TierRun& run, const std::vector<TickInput>& inputs) {
    TickMemory memory;
    run.states.clear();
    for (const TickInput& input : inputs) {
        const auto start = SteadyClock::now();
        const TickOutput output = tick(run.scene, input, memory);
        run.tickTimes.push_back(secondsSince(start));
        run.states.push_back(output.model);
    }
}

/// Moments at which the reference is bonded, spread evenly.
std::vector<std::size_t> bondedMoments(const std::vector<TipState>& states, int count) {
    std::vector<std::size_t> bonded;
    for (std::size_t i = 0; i < states.size(); ++i) {
        if (states[i].contact.contactRadius > 0.0) {
            bonded.push_back(i);
        }
    }
    std::vector<std::size_t> moments;
    for (int i = 0; i < count && !bonded.empty(); ++i) {
        const double share = count > 1 ? static_cast<double>(i) / (count - 1) : 0.0;
        moments.push_back(
            bonded[static_cast<std::size_t>(share * static_cast<double>(bonded.size() - 1))]);
    }
    return moments;
}

void makePatches(TierRun& run, const std::vector<std::size_t>& moments, const PatchGrid& grid) {
    run.patches.clear();
    for (const std::size_t moment : moments) {
        const auto start = SteadyClock::now();
        run.patches.push_back(
            contactPatch(run.scene, run.states[moment], run.tier.deformation, grid));
        run.patchTimes.push_back(secondsSince(start));
    }
}

void compareForces(const TierRun& run, const TierRun& reference, TierResult& result) {
    double sum = 0.0;
    for (std::size_t i = 0; i < run.states.size(); ++i) {
        const double error = (run.states[i].force - reference.states[i].force).norm();
        sum += error * error;
        result.forceErrorMax = std::max(result.forceErrorMax, error);
        result.contactRadiusError = std::max(result.contactRadiusError,
                                             std::abs(run.states[i].contact.contactRadius -
                                                      reference.states[i].contact.contactRadius));
    }
    result.forceErrorRms = std::sqrt(sum / static_cast<double>(run.states.size()));
}

void compareSurfaces(const TierRun& run, const TierRun& reference, TierResult& result) {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t p = 0; p < run.patches.size(); ++p) {
        const SurfacePatch& patch = run.patches[p];
        const SurfacePatch& exact = reference.patches[p];
        for (std::size_t i = 0; i < patch.points.size(); ++i, ++count) {
            // Feet of two tiers differ by their lever's deflection: compare displacements.
            const double error = (patch.points[i].z() - patch.rest[i].z()) -
                                 (exact.points[i].z() - exact.rest[i].z());
            sum += error * error;
            result.surfaceErrorMax = std::max(result.surfaceErrorMax, std::abs(error));
        }
    }
    if (count > 0) {
        result.surfaceErrorRms = std::sqrt(sum / static_cast<double>(count));
    }
}

TierResult resultOf(const TierRun& run, const TierRun& reference) {
    constexpr double kP99 = 0.99;
    TierResult result{.tier = run.tier,
                      .isReference = &run == &reference,
                      .tickMedian = quantile(run.tickTimes, 0.5),
                      .tickP99 = quantile(run.tickTimes, kP99),
                      .patchMedian = quantile(run.patchTimes, 0.5)};
    compareForces(run, reference, result);
    compareSurfaces(run, reference, result);
    return result;
}

}  // namespace

std::vector<TierResult> studyTradeOff(const Scene& scene, const TradeOffPlan& plan) {
    std::vector<TierRun> runs;
    for (const FidelityTier& tier : fidelityTiers()) {
        runs.push_back({.tier = tier, .scene = sceneWithTier(scene, tier)});
    }
    const TierRun& reference = runs.back();
    const std::vector<TickInput> inputs = recordInputs(reference.scene, plan);
    for (int round = 0; round < plan.rounds; ++round) {
        for (TierRun& run : runs) {
            runTicks(run, inputs);
        }
    }
    const std::vector<std::size_t> moments = bondedMoments(reference.states, plan.patches);
    const PatchGrid grid{.halfWidth = 2.0 * scene.belief.tipRadius(), .samples = plan.patchSamples};
    for (int round = 0; round < plan.rounds; ++round) {
        for (TierRun& run : runs) {
            makePatches(run, moments, grid);
        }
    }
    std::vector<TierResult> results;
    results.reserve(runs.size());
    for (const TierRun& run : runs) {
        results.push_back(resultOf(run, reference));
    }
    return results;
}

}  // namespace asperity
