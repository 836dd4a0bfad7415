#include "app/experiment/OpenStudy.h"
#include "core/io/experiment/TrialTable.h"
#include "tests/app/ProgramRun.h"
#include "tests/app/window/ShortStudy.h"
#include "tests/support/Places.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace asperity::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

pid_t startPerson(const fs::path& study, const fs::path& folder) {
    const fs::path person = test::programOfBuild("asperity_study_person");
    const pid_t child = fork();
    if (child == 0) {
        execl(person.c_str(), person.c_str(), study.c_str(), folder.c_str(), nullptr);
        _exit(127);
    }
    return child;
}

/// Waits until something lies there.
bool comes(const fs::path& path) {
    for (int i = 0; i < 6000 && !fs::exists(path); ++i) {
        std::this_thread::sleep_for(10ms);
    }
    return fs::exists(path);
}

TEST(KilledStudy, KeepsAllTrialsButTheOneInWorkAndGoesOnThere) {
    ScratchFolder scratch;
    Study study = shortStudy();
    study.repeats = 8;
    const fs::path out = scratch.file("out");
    const pid_t person = startPerson(writtenStudy(scratch, study), out);
    const bool isInFifth = comes(out / "trials" / ".005");  // it is being recorded
    std::this_thread::sleep_for(100ms);  // somewhere in the trial: no place is waited for
    ::kill(person, SIGKILL);
    int status = 0;
    waitpid(person, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << "it ended by itself";
    ASSERT_TRUE(isInFifth);

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
