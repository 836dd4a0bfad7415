#include "app/experiment/OpenStudy.h"
#include "core/io/experiment/StudyFile.h"
#include "tests/app/ProgramRun.h"
#include "tests/app/TracedProgram.h"
#include "tests/app/window/study/ShortStudy.h"
#include "tests/support/Places.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace asperity::test {
namespace {

namespace fs = std::filesystem;

TEST(KilledStudy, KeepsAllTrialsButTheOneInWorkAndGoesOnThere) {
    ScratchFolder scratch;
    Study study = shortStudy();
    study.repeats = 8;
    const fs::path out = scratch.file("out");
    const TracedEnd end = runTraced({programOfBuild("asperity_study_person").string(),
                                     writtenStudy(scratch, study).string(), out.string()},
                                    {}, {.made = "trials/005"});  // recorded, not yet in place
    ASSERT_TRUE(end.wasSignaled) << "it ended by itself";

    const std::vector<TrialRecord> kept = readTrials(out / "trials.csv", study);
    ASSERT_EQ(kept.size(), 4U);
    for (const TrialRecord& trial : kept) {
        EXPECT_TRUE(trial.counts());
        const std::string folder =
            (out / "trials" / ("00" + std::to_string(trial.plan.number))).string();
        const ProgramRun replay = runProgram("replay " + folder + " --out " + folder + "_again");
        EXPECT_EQ(replay.exitCode, 0) << replay.output;
    }
    const OpenStudy again(study, out, 1, nullptr);
    EXPECT_EQ(again.person.next()->number, 5);
    EXPECT_EQ(again.person.next()->attempt, 1);
}

}  // namespace
}  // namespace asperity::test
