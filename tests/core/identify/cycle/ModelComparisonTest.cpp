#include "core/identify/cycle/ModelComparison.h"

#include "tests/core/identify/cycle/CycleFiles.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

ModelComparison comparedCycle(const std::string& name, double noise, std::uint64_t seed) {
    return compareModels(test::syntheticCycle(name, noise, seed), {.tipRadius = 7.5e-6});
}

/// The model is named with low noise; with high noise no other one is.
void expectNamed(const std::string& name, CycleModel model, int seeds) {
    for (int seed = 1; seed <= seeds; ++seed) {
        const auto number = static_cast<std::uint64_t>(seed);
        EXPECT_EQ(comparedCycle(name, 1e-4, number).best, model) << name << ", seed " << seed;
        const auto noisy = comparedCycle(name, 1e-2, number).best;
        EXPECT_EQ(noisy.value_or(model), model) << name << ", seed " << seed;
    }
}

TEST(ModelComparison, NamesTheModelOfTheCycle) {
    expectNamed("jkr_two", CycleModel::JkrTwo, 1);
    expectNamed("relaxing_fast", CycleModel::Relaxation, 1);
    expectNamed("relaxing_drag", CycleModel::RelaxationDrag, 1);
}

TEST(ModelComparisonLong, NamesTheModelOfTheCycle) {
    constexpr int kSeeds = 100;
    expectNamed("jkr_one", CycleModel::JkrOne, kSeeds);
    expectNamed("jkr_two", CycleModel::JkrTwo, kSeeds);
    expectNamed("relaxing_slow", CycleModel::Relaxation, kSeeds);
    expectNamed("relaxing_fast", CycleModel::Relaxation, kSeeds);
    expectNamed("relaxing_drag", CycleModel::RelaxationDrag, kSeeds);
}

TEST(ModelComparison, TwoWorksPredictTheUnseenApproach) {
    const ModelComparison comparison = comparedCycle("jkr_two", 1e-4, 1);
    const ComparedModel& best = comparison.ranked.front();
    EXPECT_LT(best.unseenApproach.value(), 2e-4);
    EXPECT_FALSE(best.unseenRetract.has_value());  // an approach shows one work
    EXPECT_GT(comparison.ranked.at(1).unseenApproach.value(), 50.0 * *best.unseenApproach);
}

TEST(ModelComparison, WithoutTimesOnlyQuasiStaticModelsAreCompared) {
    MeasuredCycle cycle = test::syntheticCycle("jkr_two", 1e-4);
    cycle.approach.time.clear();
    cycle.retract.time.clear();
    const ModelComparison comparison = compareModels(cycle, {.tipRadius = 7.5e-6});
    EXPECT_EQ(comparison.ranked.size(), 4U);
    EXPECT_EQ(comparison.reasons.size(), 3U);
    EXPECT_EQ(comparison.best, CycleModel::JkrTwo);
}

/// A long wave that no model has: neighboring samples repeat each other's errors.
TEST(ModelComparison, CountsAlikeErrorsOnce) {
    MeasuredCycle cycle = test::syntheticCycle("jkr_one", 1e-3);
    const double range = cycle.forceRange();
    for (CycleBranch* branch : {&cycle.approach, &cycle.retract}) {
        for (std::size_t i = 0; i < branch->size(); ++i) {
            branch->force[i] += 0.02 * range * std::sin(branch->base[i] / 0.1e-6);
        }
    }
    const ModelComparison comparison = compareModels(cycle, {.tipRadius = 7.5e-6});
    EXPECT_LT(comparison.independentSamples, 100.0);
}

}  // namespace
}  // namespace asperity
