#include "app/experiment/ExperimentFolder.h"

#include "core/Error.h"
#include "tests/core/experiment/SmallStudy.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace asperity::test {
namespace {

using testing::HasSubstr;

class ExperimentFolders : public testing::Test {
protected:
    ExperimentFolder open(FolderUse use) { return {scratch.file("out"), study, use}; }

    std::string refusal(FolderUse use) {
        try {
            (void)open(use);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }

    DoneTrial done(std::size_t index, Fault fault = Fault::None) {
        DoneTrial trial;
        trial.record.plan = planned.at(index);
        trial.record.start = {0.0, 0.0, 60e-9};
        trial.record.fault = fault;
        trial.moments = {{.time = 1.0, .tip = {1e-9, 0.0, 0.0}}};
        evaluate(trial);
        return trial;
    }

    void keep(ExperimentFolder& folder, const DoneTrial& trial) {
        (void)folder.begin(trial.record.plan);
        folder.keep(trial);
    }

    ScratchFolder scratch;
    Study study = smallStudy();
    std::vector<PlannedTrial> planned = planTrials(study, 2, 1);
};

TEST_F(ExperimentFolders, KeepTrialsInTheOrderOfTheirNumbers) {
    {
        ExperimentFolder folder = open(FolderUse::New);
        keep(folder, done(4));
        keep(folder, done(1));
        keep(folder, done(2));
    }
    const ExperimentFolder folder = open(FolderUse::Resume);
    ASSERT_EQ(folder.trials().size(), 3U);
    EXPECT_EQ(folder.trials()[0].plan, planned[1]);
    EXPECT_EQ(folder.trials()[2].plan, planned[4]);
    EXPECT_EQ(folder.momentsOf(folder.trials()[0]).size(), 1U);
    EXPECT_FALSE(folder.nextAttempt(planned[4]).has_value());
    EXPECT_EQ(folder.nextAttempt(planned[0]), planned[0]);
}

TEST_F(ExperimentFolders, ATrialThatAFaultEndedIsKeptAndComesAgain) {
    ExperimentFolder folder = open(FolderUse::New);
    keep(folder, done(0, Fault::VelocityTrip));
    const auto next = folder.nextAttempt(planned[0]);
    ASSERT_TRUE(next.has_value());
    EXPECT_EQ(*next, again(planned[0]));
    DoneTrial second = done(0);
    second.record.plan = *next;
    keep(folder, second);
    EXPECT_FALSE(folder.nextAttempt(planned[0]).has_value());
    EXPECT_EQ(folder.trials().size(), 2U);
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "trials" / "001_2" / "trajectory.csv"));
    EXPECT_NO_THROW(requirePlanned(folder, planned));
}

TEST_F(ExperimentFolders, AreNotWrittenOverUnasked) {
    {
        ExperimentFolder folder = open(FolderUse::New);
        keep(folder, done(0));
    }
    EXPECT_THAT(refusal(FolderUse::New), HasSubstr("--resume"));
    const ExperimentFolder replaced = open(FolderUse::Replace);
    EXPECT_TRUE(replaced.trials().empty());
    EXPECT_FALSE(std::filesystem::exists(replaced.path() / "trials.csv"));
}

TEST_F(ExperimentFolders, LeaveFilesOfOthersWhateverIsAsked) {
    std::filesystem::create_directories(scratch.file("out"));
    std::ofstream(scratch.file("out") / "summary.json") << "of a run";
    for (const FolderUse use : {FolderUse::New, FolderUse::Resume, FolderUse::Replace}) {
        EXPECT_THAT(refusal(use), HasSubstr("no study"));
        EXPECT_EQ(contentOf(scratch.file("out") / "summary.json"), "of a run");
    }
}

TEST_F(ExperimentFolders, GoOnWithTheSameStudyAlone) {
    { const ExperimentFolder folder = open(FolderUse::New); }
    study.repeats = 3;
    EXPECT_THAT(refusal(FolderUse::Resume), HasSubstr("another study"));
}

TEST_F(ExperimentFolders, GoOnWithTheSameTrialsAlone) {
    ExperimentFolder folder = open(FolderUse::New);
    keep(folder, done(0));
    EXPECT_THROW(requirePlanned(folder, planTrials(study, 2, 2)), Error);
    EXPECT_NO_THROW(requirePlanned(folder, planTrials(study, 5, 1)));
}

/// As of a full disk.
TEST_F(ExperimentFolders, LeaveNoTrialThatWasNotKept) {
    {
        const ExperimentFolder folder = open(FolderUse::New);
        EXPECT_TRUE(std::filesystem::exists(folder.begin(planned[0])));
    }
    EXPECT_TRUE(std::filesystem::is_empty(scratch.file("out") / "trials"));
}

TEST_F(ExperimentFolders, DropWhatAKilledProgramLeft) {
    { const ExperimentFolder folder = open(FolderUse::New); }
    const std::filesystem::path left = scratch.file("out") / "trials" / ".003";
    std::filesystem::create_directories(left);
    std::ofstream(left / "trajectory.csv") << "half";
    const ExperimentFolder folder = open(FolderUse::Resume);
    EXPECT_FALSE(std::filesystem::exists(left));
}

TEST_F(ExperimentFolders, ResumeWhereNothingIsBegins) {
    EXPECT_TRUE(open(FolderUse::Resume).trials().empty());
    EXPECT_TRUE(std::filesystem::exists(scratch.file("out") / "study.toml"));
}

}  // namespace
}  // namespace asperity::test
