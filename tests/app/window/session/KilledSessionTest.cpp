#include "core/io/scene/SceneFile.h"
#include "tests/support/Places.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/ShippedScene.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace asperity::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// Of the editor's changes, one each 20 ms: a second, by its own event loop. On a machine with
/// other work both come later, the changes and the timer that keeps them.
constexpr int kMayBeLost = 50;

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

pid_t startEditor(const fs::path& folder, const fs::path& scene, const fs::path& log) {
    const fs::path editor = test::programOfBuild("asperity_session_editor");
    const pid_t child = fork();
    if (child == 0) {
        execl(editor.c_str(), editor.c_str(), folder.c_str(), scene.c_str(), log.c_str(), nullptr);
        _exit(127);
    }
    return child;
}

/// The last change that was made until then; 0: none.
int lastEdit(const fs::path& log, double until) {
    std::ifstream file(log);
    int last = 0;
    int count = 0;
    double time = 0.0;
    while (file >> count >> time) {
        last = time <= until ? count : last;
    }
    return last;
}

/// Waits until the editor makes changes.
bool edits(const fs::path& log) {
    const double begin = now();
    while (lastEdit(log, now()) == 0 && now() - begin < 60.0) {
        std::this_thread::sleep_for(10ms);
    }
    return lastEdit(log, now()) > 0;
}

void expectLosesASecondAtMost(int kills) {
    const ScratchFolder scratch;
    const fs::path kept = scratch.file("kept");
    std::mt19937 random(1);  // NOLINT: the same moments each time
    std::uniform_real_distribution<double> moment(1.0, 3.0);
    double worst = 0.0;
    for (int kill = 0; kill < kills; ++kill) {
        const fs::path log = scratch.file("edits" + std::to_string(kill));
        const pid_t editor = startEditor(kept, shippedScene("polystyrene"), log);
        ASSERT_TRUE(edits(log));
        std::this_thread::sleep_for(std::chrono::duration<double>(moment(random)));
        const double killed = now();
        ::kill(editor, SIGKILL);
        int status = 0;
        waitpid(editor, &status, 0);
        ASSERT_TRUE(WIFSIGNALED(status)) << "it ended by itself";
        const SceneDescription offered = readScene(kept / "session.toml");
        const int count = static_cast<int>(std::lround(offered.setpoint / 1e-12));
        EXPECT_GE(count, lastEdit(log, killed) - kMayBeLost) << "kill " << kill;
        EXPECT_GT(count, 0) << "nothing was kept";
        std::ifstream file(log);
        int edit = 0;
        for (double time = 0.0; file >> edit >> time;) {
            if (edit == count + 1) {
                worst = std::max(worst, killed - time);
            }
        }
    }
    std::cout << "at worst the last " << worst << " s were lost\n";
}

TEST(KilledSession, LosesASecondAtMost) { expectLosesASecondAtMost(5); }

TEST(KilledSessionLong, LosesASecondAtMost) { expectLosesASecondAtMost(20); }

}  // namespace
}  // namespace asperity::test
