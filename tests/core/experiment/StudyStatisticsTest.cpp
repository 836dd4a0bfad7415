#include "core/experiment/StudyStatistics.h"

#include "tests/core/experiment/SmallStudy.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::test {
namespace {

TrialRecord record(int participant, std::size_t task, std::size_t material, int repeat,
                   double error, double time) {
    TrialRecord trial;
    trial.plan = {.participant = participant, .task = task, .material = material, .repeat = repeat};
    trial.errorPercent = error;
    trial.time = time;
    return trial;
}

Estimate valueOf(const std::vector<TrialRecord>& trials, StudyQuantity quantity, TaskKind task,
                 const std::string& material = {}) {
    const std::vector<StudyEstimate> all = studyStatistics(smallStudy(), trials);
    const StudyEstimate* found = find(all, quantity, task, material);
    EXPECT_NE(found, nullptr);
    return found == nullptr ? Estimate{} : found->value;
}

TEST(StudyStatistics, AParticipantIsOneValue) {
    const std::vector<TrialRecord> trials{
        record(1, 1, 0, 1, 1.0, 4.0), record(1, 1, 0, 2, 3.0, 4.0), record(2, 1, 0, 1, 5.0, 4.0)};
    const Estimate error = valueOf(trials, StudyQuantity::ErrorPercent, TaskKind::On);
    EXPECT_EQ(error.count, 2U);
    EXPECT_DOUBLE_EQ(error.mean, 3.5);  // of 2 and 5
    EXPECT_DOUBLE_EQ(
        valueOf(trials, StudyQuantity::ErrorPercent, TaskKind::On, "silicon_oxide").mean, 3.5);
}

TEST(StudyStatistics, FaultsAndStruckOutTrialsDoNotCount) {
    std::vector<TrialRecord> trials{record(1, 1, 0, 1, 1.0, 4.0), record(1, 1, 0, 2, 100.0, 4.0),
                                    record(1, 1, 0, 3, 100.0, 4.0)};
    trials[1].fault = Fault::VelocityTrip;
    trials[2].struckOut = "the phone rang";
    EXPECT_DOUBLE_EQ(valueOf(trials, StudyQuantity::ErrorPercent, TaskKind::On).mean, 1.0);
    EXPECT_DOUBLE_EQ(valueOf(trials, StudyQuantity::FaultShare, TaskKind::On).mean, 1.0 / 3.0);
}

TEST(StudyStatistics, LearningIsTheSlopeOverRepeats) {
    std::vector<TrialRecord> trials;
    for (const int participant : {1, 2, 3}) {
        for (const int repeat : {1, 2, 3}) {
            trials.push_back(record(participant, 1, 0, repeat, 10.0 * participant - 0.5 * repeat,
                                    20.0 - repeat));
        }
    }
    const Estimate error = valueOf(trials, StudyQuantity::ErrorLearning, TaskKind::On);
    EXPECT_NEAR(error.mean, -0.5, 1e-12);
    EXPECT_TRUE(error.isBelow(0.0));
    EXPECT_NEAR(valueOf(trials, StudyQuantity::TimeLearning, TaskKind::On).mean, -1.0, 1e-12);
}

TEST(StudyStatistics, PersonsAndMaterialsMakeNoRelationOfTimeAndError) {
    std::vector<TrialRecord> trials;
    for (const int participant : {1, 2}) {
        for (const std::size_t material : {0U, 1U}) {
            const double slow = 10.0 * participant + 5.0 * static_cast<double>(material);
            trials.push_back(record(participant, 1, material, 1, slow + 1.0, slow - 1.0));
            trials.push_back(record(participant, 1, material, 2, slow - 1.0, slow + 1.0));
        }
    }
    EXPECT_NEAR(valueOf(trials, StudyQuantity::TimeAndError, TaskKind::On).mean, -1.0, 1e-12);
}

FindingVerdict verdictOf(const std::vector<TrialRecord>& trials, const std::string& paper) {
    for (const StudyFinding& finding : findingsOf(smallStudy(), trials)) {
        if (finding.paper.find(paper) != std::string::npos) {
            return finding.verdict;
        }
    }
    ADD_FAILURE() << paper;
    return FindingVerdict::NotTested;
}

TEST(StudyFindings, AgreeOrDifferWhereTheIntervalLeavesOutZero) {
    const auto trials = [](double oxide, double rubber, double spread) {
        std::vector<TrialRecord> all;
        for (const int participant : {1, 2, 3, 4}) {
            const double own = spread * (participant % 2 == 0 ? 1.0 : -1.0);
            all.push_back(record(participant, 1, 0, 1, oxide + own, 4.0));
            all.push_back(record(participant, 1, 2, 1, rubber - own, 4.0));
        }
        return all;
    };
    const std::string finding = "larger on silicon oxide than on rubber";
    EXPECT_EQ(verdictOf(trials(3.0, 1.0, 0.1), finding), FindingVerdict::Agrees);
    EXPECT_EQ(verdictOf(trials(1.0, 3.0, 0.1), finding), FindingVerdict::Differs);
    EXPECT_EQ(verdictOf(trials(2.0, 1.9, 3.0), finding), FindingVerdict::Open);
    EXPECT_EQ(verdictOf({}, finding), FindingVerdict::NotTested);
}

/// A single repeat has no slope.
TEST(StudyFindings, AreNotTestedByWhatHasNoNumber) {
    std::vector<TrialRecord> trials;
    for (const int participant : {1, 2, 3, 4}) {
        for (const std::size_t task : {0U, 1U, 2U}) {
            trials.push_back(record(participant, task, 0, 1, 3.0 + participant, 4.0));
        }
    }
    EXPECT_EQ(verdictOf(trials, "time and error are related in C alone"),
              FindingVerdict::NotTested);
    EXPECT_EQ(verdictOf(trials, "error does not change from repeat to repeat"),
              FindingVerdict::NotTested);
    for (const StudyFinding& finding : findingsOf(smallStudy(), trials)) {
        EXPECT_EQ(finding.ours.find("nan"), std::string::npos) << finding.ours;
    }
}

}  // namespace
}  // namespace asperity::test
