#include "core/identify/cycle/ModelComparison.h"

#include "tests/core/identify/cycle/CycleFiles.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

ModelComparison comparedCycle(const std::string& name, double noise, std::uint64_t seed) {
    return compareModels(test::syntheticCycle(name, noise, seed), {.tipRadius = 7.5e-6});
}

/// Each cycle's model is named with low noise; with high noise no other one is.
/// @param seeds of each cycle and noise
void expectNamed(int seeds) {
    for (const auto& [name, model] :
         {std::pair{"jkr_two", CycleModel::JkrTwo}, std::pair{"jkr_one", CycleModel::JkrOne},
          std::pair{"relaxing_slow", CycleModel::Relaxation},
          std::pair{"relaxing_fast", CycleModel::Relaxation},
          std::pair{"relaxing_drag", CycleModel::RelaxationDrag}}) {
        for (int seed = 1; seed <= seeds; ++seed) {
            EXPECT_EQ(comparedCycle(name, 1e-4, static_cast<std::uint64_t>(seed)).best, model)
                << name << ", seed " << seed;
            const auto noisy = comparedCycle(name, 1e-2, static_cast<std::uint64_t>(seed)).best;
            EXPECT_EQ(noisy.value_or(model), model) << name << ", seed " << seed;
        }
    }
}

TEST(ModelComparison, NamesTheModelOfTheCycle) { expectNamed(1); }

TEST(ModelComparisonLong, NamesTheModelOfTheCycle) { expectNamed(100); }

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

/// A cycle with much relaxation and much adhesion, which no model has.
TEST(ModelComparison, IsUndecidedWhereErrorsAreTooAlike) {
    MeasuredCycle cycle = test::syntheticCycle("jkr_one", 1e-2);
    for (CycleBranch* branch : {&cycle.approach, &cycle.retract}) {
        for (std::size_t i = 0; i < branch->size(); ++i) {
            branch->force[i] += 0.05 * cycle.forceRange() * std::sin(branch->base[i] / 0.4e-6);
        }
    }
    const ModelComparison comparison = compareModels(cycle, {.tipRadius = 7.5e-6});
    EXPECT_LT(comparison.independentSamples, 60.0);
}

}  // namespace
}  // namespace asperity
