#include "core/ProgramRun.h"

#include "core/Error.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <span>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace asperity::test {

namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

/// A call of the shell, which is a program as any other here.
ProgramCall shell(const ScratchFolder& folder, const std::string& script,
                  std::chrono::milliseconds time = 20s) {
    return {.program = "/bin/sh",
            .arguments = {"-c", script},
            .environment = {"PATH=/usr/bin:/bin", "GREETING=hello"},
            .folder = folder.path(),
            .deadline = std::chrono::steady_clock::now() + time};
}

/// The number that a script has written into a file.
pid_t numberIn(const std::filesystem::path& path) { return std::atoi(contentOf(path).c_str()); }

/// A killed process may need a moment until it is gone.
bool isGone(pid_t process) {
    for (int i = 0; i < 2000; ++i) {
        if (kill(process, 0) != 0) {
            return true;
        }
        // An orphan that init has not collected yet is dead all the same.
        const std::string status = contentOf("/proc/" + std::to_string(process) + "/stat");
        if (status.find(") Z ") != std::string::npos) {
            return true;
        }
        std::this_thread::sleep_for(10ms);
    }
    return false;
}

/// Gives a program all of this, for as long as it reads any. @return whether it read all
bool feedAll(RunningProgram& program, const std::string& text) {
    std::vector<std::uint8_t> bytes(text.begin(), text.end());
    for (std::span<const std::uint8_t> left(bytes); !left.empty();) {
        const std::optional<std::size_t> taken = program.feed(left);
        if (!taken) {
            return false;
        }
        left = left.subspan(*taken);
    }
    return true;
}

ProgramOutcome outcomeOf(RunningProgram& program) {
    std::optional<ProgramOutcome> outcome;
    while (!outcome) {
        outcome = program.look();
    }
    return *outcome;
}

void waitFor(const std::filesystem::path& file) {
    while (!std::filesystem::exists(file)) {
        std::this_thread::sleep_for(10ms);
    }
}

/// Has another process start the program, which says its number in the file `number`, and kills
/// that process.
void killStarterOf(const ProgramCall& call, const ScratchFolder& folder) {
    const pid_t starter = fork();
    ASSERT_GE(starter, 0);
    if (starter == 0) {
        (void)runProgram(call);
        _exit(0);
    }
    while (!std::filesystem::exists(folder.file("number"))) {
        ASSERT_EQ(waitpid(starter, nullptr, WNOHANG), 0) << "it has ended by itself";
        std::this_thread::sleep_for(10ms);
    }
    ASSERT_EQ(kill(starter, SIGKILL), 0);
    ASSERT_EQ(waitpid(starter, nullptr, 0), starter);
}

void expectNoChild() {
    const pid_t child = waitpid(-1, nullptr, WNOHANG);
    const int reason = errno;
    EXPECT_EQ(child, -1) << "a child is left";
    EXPECT_EQ(reason, ECHILD);
}

}  // namespace

TEST(ProgramRun, GivesOutputAndExitCode) {
    const ScratchFolder folder;
    const ProgramOutcome outcome = runProgram(shell(folder, "echo out; echo err >&2; pwd; exit 7"));
    EXPECT_EQ(outcome.end, ProgramEnd::Exited);
    EXPECT_EQ(outcome.exitCode, 7);
    EXPECT_EQ(outcome.output, "out\nerr\n" + folder.path().string() + "\n");
    expectNoChild();
}

TEST(ProgramRun, ArgumentsPassNoShell) {
    const ScratchFolder folder;
    ProgramCall call = shell(folder, "");
    call.program = "/bin/echo";
    call.arguments = {"$(touch x)", "; touch x", "'\"*"};
    EXPECT_EQ(runProgram(call).output, "$(touch x) ; touch x '\"*\n");
    EXPECT_FALSE(std::filesystem::exists(folder.file("x")));
}

TEST(ProgramRun, HasItsOwnEnvironmentAndNoInputNorOpenFiles) {
    const ScratchFolder folder;
    const int open = ::open("/dev/null", O_RDONLY);  // without O_CLOEXEC
    ASSERT_GE(open, 3);
    const ProgramOutcome outcome = runProgram(shell(
        folder, "env | grep -v -e ^PWD= -e ^_= -e ^SHLVL= | sort; cat; ls /proc/$$/fd; true"));
    ::close(open);
    EXPECT_EQ(outcome.output, "GREETING=hello\nPATH=/usr/bin:/bin\n0\n1\n2\n");
}

TEST(ProgramRun, SignalsAreAsAtTheStartOfAProgram) {
    const ScratchFolder folder;
    sigset_t blocked;
    sigemptyset(&blocked);
    sigaddset(&blocked, SIGTERM);
    sigset_t before;
    pthread_sigmask(SIG_BLOCK, &blocked, &before);
    const auto ignoring = std::signal(SIGPIPE, SIG_IGN);
    // But for signals 32 and 33, which the C library keeps to itself.
    const ProgramOutcome outcome =
        runProgram(shell(folder, "for set in SigBlk SigIgn; do"
                                 " bits=$(grep $set /proc/self/status | cut -f 2);"
                                 " echo $set $((0x$bits & ~0x180000000)); done"));
    (void)std::signal(SIGPIPE, ignoring);
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    EXPECT_EQ(outcome.output, "SigBlk 0\nSigIgn 0\n");
}

TEST(ProgramRun, TheWholeGroupEndsInTime) {
    const ScratchFolder folder;
    const std::string script = "sleep 1000 & echo $! >child; echo $$ >self; echo begun; wait";
    ProgramOutcome outcome;
    // A busy machine may not have begun it by then.
    for (auto time = 500ms; outcome.output.empty() && time < 500s; time *= 2) {
        outcome = runProgram(shell(folder, script, time));
        EXPECT_EQ(outcome.end, ProgramEnd::TimedOut);
    }
    EXPECT_EQ(outcome.output, "begun\n");
    expectNoChild();
    EXPECT_TRUE(isGone(numberIn(folder.file("self"))));
    EXPECT_TRUE(isGone(numberIn(folder.file("child"))));
}

/// However slow the machine is, what a program may do until its end is the same.
TEST(ProgramRun, ProcessorTimeIsBounded) {
    const ScratchFolder folder;
    ProgramCall call = shell(folder, "echo begun; while :; do :; done", 1000s);
    call.maxProcessorTime = 1s;
    const ProgramOutcome outcome = runProgram(call);
    EXPECT_EQ(outcome.end, ProgramEnd::TimedOut);
    EXPECT_EQ(outcome.output, "begun\n");
    expectNoChild();
}

TEST(ProgramRun, ProcessorTimeDoesNotPassWhileAProgramWaits) {
    const ScratchFolder folder;
    ProgramCall call = shell(folder, "sleep 1.2; echo done", 1000s);
    call.maxProcessorTime = 1s;
    EXPECT_EQ(runProgram(call).output, "done\n");
}

TEST(ProgramRun, WhatAProgramLeavesBehindEndsWithIt) {
    const ScratchFolder folder;
    const auto begin = std::chrono::steady_clock::now();
    const ProgramOutcome outcome =
        runProgram(shell(folder, "sleep 100 & echo $! >child; echo done"));
    EXPECT_EQ(outcome.end, ProgramEnd::Exited);
    EXPECT_EQ(outcome.output, "done\n");
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 90s) << "it waited for the open pipe";
    EXPECT_TRUE(isGone(numberIn(folder.file("child"))));
}

TEST(ProgramRun, OneThatClosesItsOutputIsWaitedFor) {
    const ScratchFolder folder;
    const ProgramOutcome outcome =
        runProgram(shell(folder, "exec >/dev/null 2>&1; sleep 0.2; exit 3"));
    EXPECT_EQ(outcome.end, ProgramEnd::Exited);
    EXPECT_EQ(outcome.exitCode, 3);
}

TEST(ProgramRun, OutputIsBounded) {
    const ScratchFolder folder;
    ProgramCall call = shell(folder, "yes");
    call.maxOutput = 100000;
    const ProgramOutcome outcome = runProgram(call);
    EXPECT_EQ(outcome.end, ProgramEnd::WroteTooMuch);
    EXPECT_LT(outcome.output.size(), 200000U);
    expectNoChild();
}

TEST(ProgramRun, FilesAreBounded) {
    const ScratchFolder folder;
    ProgramCall call = shell(folder, "sleep 0.2; exec yes >large");
    call.maxFile = 1000000;
    EXPECT_EQ(runProgram(call).end, ProgramEnd::Killed);
    EXPECT_EQ(std::filesystem::file_size(folder.file("large")), 1000000U);
}

TEST(ProgramRun, ACrashIsNoExit) {
    const ScratchFolder folder;
    EXPECT_EQ(runProgram(shell(folder, "kill -SEGV $$")).end, ProgramEnd::Killed);
}

TEST(ProgramRun, RefusesWhatIsNoProgram) {
    const ScratchFolder folder;
    ProgramCall call = shell(folder, "");
    call.program = folder.write("text", "no program");
    EXPECT_THROW((void)runProgram(call), Error);
    call.program = folder.file("missing");
    EXPECT_THROW((void)runProgram(call), Error);
    expectNoChild();
}

/// Nobody is left to end it then.
TEST(ProgramRun, EndsWithAKilledStarter) {
    const ScratchFolder folder;
    killStarterOf(shell(folder, "echo $$ >begun; mv begun number; exec sleep 1000", 1000s), folder);
    const pid_t program = numberIn(folder.file("number"));
    EXPECT_TRUE(isGone(program));
    (void)kill(program, SIGKILL);
}

TEST(ProgramRun, OneThatTidiesUpDoesWhenItsStarterIsKilled) {
    const ScratchFolder folder;
    ProgramCall call = shell(folder,
                             "trap 'echo >tidy; exit' TERM; echo $$ >begun;"
                             " mv begun number; while :; do sleep 0.01; done",
                             1000s);
    call.endSignal = SIGTERM;
    killStarterOf(call, folder);
    EXPECT_TRUE(isGone(numberIn(folder.file("number"))));
    EXPECT_TRUE(std::filesystem::exists(folder.file("tidy")));
}

TEST(RunningProgram, TidiesUpWhenItIsNoLongerNeeded) {
    const ScratchFolder folder;
    ProgramCall call = shell(folder, "sleep 100 & echo $! >child; trap 'echo >tidy; exit' TERM;"
                                     " echo >begun; while :; do sleep 0.01; done");
    call.endSignal = SIGTERM;
    {
        const RunningProgram program(call);
        waitFor(folder.file("begun"));
    }
    EXPECT_TRUE(std::filesystem::exists(folder.file("tidy")));
    EXPECT_TRUE(isGone(numberIn(folder.file("child"))));
    expectNoChild();
}

/// More than any pipe holds is written while as much is read.
TEST(RunningProgram, IsFedWhileItWrites) {
    const ScratchFolder folder;
    std::string text;
    for (int i = 0; text.size() < (std::size_t{4} << 20U); ++i) {
        text += std::to_string(i) + "\n";
    }
    ProgramCall call = shell(folder, "cat; exit 5");
    call.isFed = true;
    call.maxOutput = text.size();
    RunningProgram program(call);
    EXPECT_TRUE(feedAll(program, text));
    program.endInput();
    const ProgramOutcome outcome = outcomeOf(program);
    EXPECT_EQ(outcome.end, ProgramEnd::Exited);
    EXPECT_EQ(outcome.exitCode, 5);
    EXPECT_TRUE(outcome.output == text) << outcome.output.size() << " bytes";
}

/// A signal would end this program otherwise.
TEST(RunningProgram, OneThatEndsBeforeItHasReadItsInputSaysSo) {
    const ScratchFolder folder;
    ProgramCall call = shell(folder, "head -c 2; echo enough >&2; exit 4");
    call.isFed = true;
    RunningProgram program(call);
    EXPECT_FALSE(feedAll(program, std::string(std::size_t{64} << 20U, 'a')));
    const ProgramOutcome outcome = outcomeOf(program);
    EXPECT_EQ(outcome.exitCode, 4);
    EXPECT_EQ(outcome.output, "aaenough\n");
}

TEST(RunningProgram, OneThatReadsNothingHasItsInputOffered) {
    const ScratchFolder folder;
    ProgramCall call = shell(folder, "sleep 100");
    call.isFed = true;
    RunningProgram program(call);
    const std::vector<std::uint8_t> bytes(std::size_t{1} << 20U);
    while (program.feed(bytes) != std::optional<std::size_t>(0)) {
    }
    EXPECT_FALSE(program.look());
}

TEST(RunningProgram, StreamsGoWhereTheCallHasThem) {
    const ScratchFolder folder;
    ProgramCall call = shell(folder, "echo out; echo err >&2; echo reply >&3");
    call.output = ProgramStream::Dropped;
    EXPECT_THAT(runProgram(call).output, HasSubstr("err\n"));
    call.errors = ProgramStream::Dropped;
    EXPECT_EQ(runProgram(call).output, "") << "there is no descriptor 3";
    call.hasReplies = true;
    EXPECT_EQ(runProgram(call).output, "reply\n");
    call.errors = ProgramStream::Shared;
    testing::internal::CaptureStderr();
    EXPECT_EQ(runProgram(call).output, "reply\n");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "err\n");
}

TEST(RunningProgram, ItsOutputIsReadWhileItRuns) {
    const ScratchFolder folder;
    RunningProgram program(shell(folder, "echo 7; exec sleep 1000", 1000s));
    while (program.output().empty()) {
        ASSERT_FALSE(program.look());
    }
    EXPECT_EQ(program.output(), "7\n");
}

TEST(ProgramRun, ATrustedOneIsAsThisProcess) {
    const ProgramOutcome outcome =
        runProgram(trustedCall("/bin/sh", {"-c", "pwd; ulimit -v; ulimit -f; echo \"$PATH\""}));
    EXPECT_EQ(outcome.output, std::filesystem::current_path().string() +
                                  "\nunlimited\nunlimited\n" + std::getenv("PATH") + "\n");
}

TEST(FindProgram, TakesTheFirstThatCanBeRun) {
    const ScratchFolder folder;
    const ScratchFolder other;
    (void)other.write("tool", "not executable");
    std::filesystem::permissions(folder.write("tool", "#!/bin/sh\n"),
                                 std::filesystem::perms::owner_all);
    const std::string list = "relative::" + other.path().string() + ":" + folder.path().string();
    EXPECT_EQ(findProgram("tool", list), folder.file("tool"));
    EXPECT_EQ(findProgram("tool", other.path().string()), "");
    EXPECT_EQ(findProgram("tool", ""), "");
    EXPECT_EQ(findProgram("sh", "/nowhere:/bin"), "/bin/sh");
}

/// A child of one thread is not waited for by another.
TEST(ProgramRun, ThreadsRunProgramsAtTheSameTime) {
    const ScratchFolder folder;
    std::array<ProgramOutcome, 8> outcomes;
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        threads.emplace_back([&folder, &outcomes, i] {
            const std::string number = std::to_string(i);
            outcomes[i] =
                runProgram(shell(folder, "sleep 0.05; echo " + number + "; exit " + number));
        });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        EXPECT_EQ(outcomes[i].exitCode, static_cast<int>(i));
        EXPECT_EQ(outcomes[i].output, std::to_string(i) + "\n");
    }
    expectNoChild();
}

}  // namespace asperity::test
