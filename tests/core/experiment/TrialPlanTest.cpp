#include "core/experiment/TrialPlan.h"

#include "tests/core/experiment/SmallStudy.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace asperity::test {
namespace {

TEST(TrialPlan, BalancedOrdersHaveEachConditionFollowEachOtherOneEquallyOften) {
    for (const std::size_t count : {2U, 3U, 4U, 5U, 6U}) {
        const std::size_t rows = count % 2 == 0 ? count : 2 * count;
        std::map<std::pair<std::size_t, std::size_t>, int> follows;
        for (std::size_t row = 0; row < rows; ++row) {
            const std::vector<std::size_t> order = balancedOrder(count, row);
            EXPECT_EQ(std::set(order.begin(), order.end()).size(), count);
            for (std::size_t i = 1; i < count; ++i) {
                ++follows[{order[i - 1], order[i]}];
            }
        }
        EXPECT_EQ(follows.size(), count * (count - 1));
        for (const auto& [pair, times] : follows) {
            EXPECT_EQ(times, static_cast<int>(rows / count)) << count;
        }
    }
}

TEST(TrialPlan, EachParticipantDoesEachTaskOnEachMaterialSoOften) {
    const Study study = smallStudy();
    const std::vector<PlannedTrial> trials = planTrials(study, 4, 1);
    ASSERT_EQ(trials.size(), 4U * 8U * static_cast<std::size_t>(study.repeats));
    std::map<std::tuple<int, std::size_t, std::size_t>, int> times;
    for (const PlannedTrial& trial : trials) {
        ++times[{trial.participant, trial.task, trial.material}];
    }
    EXPECT_EQ(times.size(), 4U * 8U);
    for (const auto& [condition, count] : times) {
        EXPECT_EQ(count, study.repeats);
    }
}

TEST(TrialPlan, TheMaterialChangesAfterEachTargetOfATask) {
    const std::vector<PlannedTrial> trials = planTrials(smallStudy(), 6, 3);
    int changes = 0;
    for (std::size_t i = 1; i < trials.size(); ++i) {
        if (trials[i].task == trials[i - 1].task && trials[i].repeat == trials[i - 1].repeat) {
            EXPECT_NE(trials[i].material, trials[i - 1].material);
            ++changes;
        }
    }
    EXPECT_GT(changes, 50);
}

TEST(TrialPlan, AParticipantsTrialsDoNotDependOnTheOthers) {
    const std::vector<PlannedTrial> few = planTrials(smallStudy(), 2, 5);
    const std::vector<PlannedTrial> many = planTrials(smallStudy(), 5, 5);
    EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
    EXPECT_NE(few, planTrials(smallStudy(), 2, 6));
}

TEST(TrialPlan, HeightsAreThoseOfTheTask) {
    const Study study = smallStudy();
    for (const PlannedTrial& trial : planTrials(study, 6, 1)) {
        const StudyTask& task = study.tasks[trial.task];
        const double sign = task.kind == TaskKind::Below ? -1.0 : 1.0;
        EXPECT_GE(sign * trial.height, task.nearest);
        EXPECT_LE(sign * trial.height, task.farthest);
        EXPECT_LT(trial.target, study.targets.size());
    }
}

TEST(TrialPlan, AnotherAttemptHasOtherRandomNumbersAndIsTheSameTrial) {
    const PlannedTrial trial = planTrials(smallStudy(), 1, 1).front();
    PlannedTrial next = again(trial);
    EXPECT_EQ(next.attempt, 2);
    EXPECT_NE(next.seed, trial.seed);
    next.attempt = trial.attempt;
    next.seed = trial.seed;
    EXPECT_EQ(next, trial);
}

}  // namespace
}  // namespace asperity::test
