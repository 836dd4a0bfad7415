// Recordings whose process ends at a random time, from the command line and from the window: by
// SIGKILL, by SIGHUP, and on a disk that gets full. ASPERITY_ENDS says how many of each (2).

#include "app/commands/VirtualDisplay.h"
#include "app/recording/RecordedRun.h"
#include "app/runs/RunFolder.h"
#include "core/GrowingFile.h"
#include "tests/app/ChildProgram.h"
#include "tests/app/ProgramRun.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/ShippedScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <random>
#include <string>
#include <sys/mount.h>
#include <sys/resource.h>
#include <thread>
#include <vector>

namespace asperity {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

enum class End { Kill, HangUp, FullDisk };

struct Case {
    bool window = false;
    End end = End::Kill;
};

/// State of the recordings of one case.
struct Tally {
    long ended = 0;
    long replayed = 0;
    long ticks = 0;
    double oldestLost = 0.0;  ///< from the last flush to the end of the process, at most [s]
    double slowestEnd = 0.0;  ///< from the full disk to the end of the recording, at most [s]
};

double since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

void pause(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

/// A file system of its own, in memory; a plain folder where mounting is not allowed.
class SmallDisk {
public:
    explicit SmallDisk(fs::path folder) : folder_(std::move(folder)) {
        fs::create_directories(folder_);
        mounted_ = mount("tmpfs", folder_.c_str(), "tmpfs", 0, "size=16m") == 0;
    }
    ~SmallDisk() {
        if (mounted_) {
            umount2(folder_.c_str(), MNT_DETACH);
        }
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

    /// From now on nothing more can be written, by this child at least.
    void fill(const test::ChildProgram& child) const {
        if (!mounted_) {
            const rlimit none{1, RLIM_INFINITY};
            prlimit(child.id(), RLIMIT_FSIZE, &none, nullptr);
            return;
        }
        std::ofstream filler(folder_ / "filler", std::ios::binary);
        const std::string block(1U << 12U, 'x');
        while (filler.write(block.data(), static_cast<std::streamsize>(block.size())).flush()) {
        }
    }

private:
    fs::path folder_;
    bool mounted_ = false;
};

/// The content of every file below a folder.
std::map<fs::path, std::string> contentBelow(const fs::path& folder) {
    std::map<fs::path, std::string> content;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            content[entry.path()] = test::contentOf(entry.path());
        }
    }
    return content;
}

class EndAtAnyTime : public ::testing::TestWithParam<Case> {
protected:
    void SetUp() override {
        setenv("HOME", scratch.path().c_str(), 1);  // where the window looks for recordings
        setenv("XDG_DOCUMENTS_DIR", scratch.path().c_str(), 1);
        setenv("XDG_CONFIG_HOME", scratch.path().c_str(), 1);  // and leaves its folder
        const auto made =
            test::runProgram("explore --no-pictures " + scene + " --duration 0.2 --out " +
                             scratch.file("older").string());
        ASSERT_EQ(made.exitCode, 0) << made.output;
    }

    [[nodiscard]] std::vector<std::string> recording(const fs::path& folder) const {
        return GetParam().window ? std::vector<std::string>{scene, "--record", folder.string()}
                                 : std::vector<std::string>{"loop", scene,      "--duration",
                                                            "60",   "--record", folder.string()};
    }

    /// Starts one, ends it at a random time.
    void endOne(const fs::path& folder, const SmallDisk& disk) {
        test::ChildProgram child(recording(folder));
        const Clock::time_point begin = Clock::now();
        while (!fs::exists(folder / run_files::kManifest) && since(begin) < 60.0) {
            pause(0.001);
        }
        pause(std::uniform_real_distribution(0.0, 3.0)(random));
        ASSERT_FALSE(child.hasEnded());
        if (GetParam().end == End::FullDisk) {
            endByFullDisk(child, folder, disk);
        } else {
            takeLost(folder);
            child.send(GetParam().end == End::Kill ? SIGKILL : SIGHUP);
        }
        child.wait();
        ++tally.ended;
    }

    void endByFullDisk(test::ChildProgram& child, const fs::path& folder, const SmallDisk& disk) {
        disk.fill(child);
        const Clock::time_point full = Clock::now();
        while (isGrowing(folder / run_files::kInput) && since(full) < 30.0) {
            pause(0.005);
        }
        EXPECT_FALSE(isGrowing(folder / run_files::kInput)) << "it has noticed nothing";
        tally.slowestEnd = std::max(tally.slowestEnd, since(full));
        if (GetParam().window) {  // which continues, with a message
            EXPECT_FALSE(child.hasEnded());
            child.send(SIGTERM);
        } else {
            EXPECT_EQ(child.wait().exitCode, 1);
        }
    }

    void takeLost(const fs::path& folder) {
        const auto flushed = fs::last_write_time(folder / run_files::kInput);
        const std::chrono::duration<double> age = fs::file_time_type::clock::now() - flushed;
        tally.oldestLost = std::max(tally.oldestLost, age.count());
    }

    /// Replays to the same bits, as far as both tables hold whole lines.
    void check(const fs::path& folder) {
        const RecordedRun run = readRun(folder);
        const std::string ticks = std::to_string(run.samples.size());
        const fs::path out = scratch.file("again");
        const auto again = test::runProgram("replay " + folder.string() + " --out " + out.string());
        ASSERT_EQ(again.exitCode, 0) << again.output;
        ASSERT_NE(again.output.find("bit-identical: " + ticks + " ticks"), std::string::npos)
            << again.output;
        const bool whole = GetParam().end == End::HangUp;
        ASSERT_EQ(run.state, whole ? RunState::Complete : RunState::Unfinished);
        ASSERT_TRUE(test::contentOf(folder / run_files::kLog)
                        .starts_with(test::contentOf(out / run_files::kLog)));
        tally.ticks += static_cast<long>(run.samples.size());
        ++tally.replayed;
    }

    void tell() const {
        const char* const ends[] = {"SIGKILL", "SIGHUP", "full disk"};
        std::printf("%-6s  %-9s  ended %3ld  replayed %3ld  ticks %7ld  last flush %.2f s before "
                    "the end  full disk noticed within %.2f s\n",
                    GetParam().window ? "window" : "loop", ends[static_cast<int>(GetParam().end)],
                    tally.ended, tally.replayed, tally.ticks, tally.oldestLost, tally.slowestEnd);
    }

    test::ScratchFolder scratch;
    std::string scene = test::shippedScene("polystyrene").string();
    std::mt19937 random{std::random_device{}()};
    Tally tally;
};

TEST_P(EndAtAnyTime, ReplaysUpToItsLastWholeTickAndHarmsNothingOlder) {
    unsetenv("DISPLAY");  // its windows take no focus from another test's
    const VirtualDisplay display;
    const char* wanted = std::getenv("ASPERITY_ENDS");
    const int ends = wanted != nullptr ? std::atoi(wanted) : 1;
    const auto before = contentBelow(scratch.file("older"));
    for (int i = 0; i < ends && !HasFatalFailure(); ++i) {
        const fs::path mount = scratch.file("disk" + std::to_string(i));
        const SmallDisk disk(mount);
        const fs::path folder = mount / "run";
        endOne(folder, disk);
        if (!HasFatalFailure()) {
            check(folder);
        }
    }
    EXPECT_EQ(contentBelow(scratch.file("older")), before);
    tell();
}

std::string nameOf(const ::testing::TestParamInfo<Case>& test) {
    const std::string where = test.param.window ? "Window" : "Loop";
    switch (test.param.end) {
    case End::Kill:
        return where + "SigKill";
    case End::HangUp:
        return where + "SigHup";
    case End::FullDisk:
        break;
    }
    return where + "FullDisk";
}

INSTANTIATE_TEST_SUITE_P(Recordings, EndAtAnyTime,
                         ::testing::Values(Case{false, End::Kill}, Case{false, End::HangUp},
                                           Case{false, End::FullDisk}, Case{true, End::Kill},
                                           Case{true, End::HangUp}, Case{true, End::FullDisk}),
                         nameOf);

}  // namespace
}  // namespace asperity
