#include "app/experiment/OpenStudy.h"
#include "core/Error.h"
#include "core/io/experiment/StudyFile.h"
#include "tests/core/experiment/SmallStudy.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace asperity::test {
namespace {

class ParticipantStudies : public testing::Test {
protected:
    void keep(const PlannedTrial& plan, Fault fault = Fault::None) {
        DoneTrial trial;
        trial.record.plan = plan;
        trial.record.start = {0.0, 0.0, 60e-9};
        trial.record.fault = fault;
        trial.moments = {{.time = 1.0, .tip = {1e-9, 0.0, 0.0}}};
        evaluate(trial);
        (void)folder.begin(plan);
        folder.keep(trial);
    }

    ScratchFolder scratch;
    Study study = smallStudy();
    ExperimentFolder folder{scratch.file("out"), study, FolderUse::New};
};

TEST_F(ParticipantStudies, HaveTheirOwnTrialsInTheirOrder) {
    const ParticipantStudy second(folder, 2);
    EXPECT_TRUE(second.isNew());
    EXPECT_EQ(second.count(), static_cast<int>(planTrials(study, 1, 1).size()));
    EXPECT_EQ(second.next(), planTrials(study, 2, 1).at(static_cast<std::size_t>(second.count())));
}

TEST_F(ParticipantStudies, AreDoneWhenEachTrialCounts) {
    const ParticipantStudy person(folder, 1);
    std::set<int> numbers;
    while (const auto next = person.next()) {
        EXPECT_EQ(person.done(), static_cast<int>(numbers.size()));
        numbers.insert(next->number);
        keep(*next);
        EXPECT_FALSE(person.isNew());
    }
    EXPECT_EQ(static_cast<int>(numbers.size()), person.count());
    EXPECT_EQ(participantToGoOn(study, folder.trials()), 2);
    EXPECT_TRUE(ParticipantStudy(folder, 2).isNew());
}

TEST_F(ParticipantStudies, AFaultAndAStrikeOutBringTheTrialAgain) {
    const ParticipantStudy person(folder, 1);
    const PlannedTrial first = *person.next();
    keep(first, Fault::VelocityTrip);
    EXPECT_EQ(person.next(), again(first));
    keep(again(first));
    EXPECT_NE(person.next()->number, first.number);
    folder.strikeOut(again(first), "a \"door\", slammed");
    EXPECT_EQ(person.next(), again(again(first)));
    EXPECT_EQ(person.done(), 0);
}

TEST_F(ParticipantStudies, AStrikeOutIsInTheTableAtOnce) {
    const ParticipantStudy person(folder, 1);
    const PlannedTrial first = *person.next();
    EXPECT_THROW(folder.strikeOut(first, "not done"), Error);
    keep(first);
    folder.strikeOut(first, "a \"door\", slammed # twice");
    const std::vector<TrialRecord> read = readTrials(folder.path() / "trials.csv", study);
    ASSERT_EQ(read.size(), 1U);
    EXPECT_EQ(read[0].struckOut, "a \"door\", slammed # twice");
    EXPECT_FALSE(read[0].counts());
}

TEST_F(ParticipantStudies, TrialsThatWerePlannedOtherwiseAreRefused) {
    keep(planTrials(study, 1, 99).front());
    EXPECT_THROW(ParticipantStudy(folder, 1), Error);
}

TEST(OpenStudyTest, WithoutACouplingIsForTheOperatorModelOnly) {
    const ScratchFolder scratch;
    Study study = smallStudy();
    study.aids.coupling = false;
    try {
        const OpenStudy open(study, scratch.file("out"), 1, nullptr);
        FAIL();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("[aids] coupling"));
    }
}

TEST(OpenStudyTest, GoesOnWhereItWas) {
    const ScratchFolder scratch;
    const Study study = smallStudy();
    EXPECT_FALSE(holdsStudy(scratch.file("out")));
    { const OpenStudy open(study, scratch.file("out"), 1, nullptr); }
    EXPECT_TRUE(holdsStudy(scratch.file("out")));
    const OpenStudy again(study, scratch.file("out"), 3, nullptr);
    EXPECT_EQ(again.person.next()->participant, 3);
}

}  // namespace
}  // namespace asperity::test
