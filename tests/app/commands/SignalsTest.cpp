#include "tests/app/ChildProgram.h"
#include "tests/app/TracedProgram.h"
#include "tests/support/Places.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/ShippedScene.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace asperity {
namespace {

void pause() { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }

/// The program while it writes into a folder of its own.
class Signals : public ::testing::Test {
protected:
    void SetUp() override { std::filesystem::create_directory(folder); }

    [[nodiscard]] std::vector<std::string> explore(const std::string& duration) const {
        return {"explore",    test::shippedScene("polystyrene").string(),
                "--out",      folder.string(),
                "--duration", duration};
    }

    void waitFor(test::ChildProgram& child, const std::function<bool()>& event) const {
        while (!event() && !child.hasEnded()) {
            pause();
        }
    }
    void waitForAFile(test::ChildProgram& child) const {
        waitFor(child, [this] { return !std::filesystem::is_empty(folder); });
    }

    static std::vector<std::string> words(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), test::programOfBuild("asperity").string());
        return arguments;
    }
    /// Interrupts the program just before it makes a file of this name.
    static void expectEndedWhereItMakes(const char* name, std::vector<std::string> arguments) {
        const test::TracedEnd end =
            test::runTraced(words(std::move(arguments)), {}, {.made = name, .signal = SIGINT});
        EXPECT_TRUE(end.wasSignaled) << name;
        EXPECT_EQ(end.exitCode, 1);
    }

    test::ScratchFolder scratch;
    std::filesystem::path folder = scratch.file("results");
};

TEST_F(Signals, EndExploreWhileItRunsAndNothingHalfWrittenIsLeft) {
    test::ChildProgram child(explore("3600"));
    waitForAFile(child);
    child.send(SIGINT);
    EXPECT_EQ(child.wait().exitCode, 1);
    EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST_F(Signals, EndExploreWhileItDrawsAndAnEarlierRunIsLeftWhole) {
    ASSERT_EQ(test::ChildProgram(explore("0.2")).wait().exitCode, 0);
    const auto content = [this] {
        std::map<std::filesystem::path, std::string> files;
        for (const auto& file : std::filesystem::directory_iterator(folder)) {
            files[file.path()] = file.is_regular_file() ? test::contentOf(file.path()) : "folder";
        }
        return files;
    };
    const auto earlier = content();
    expectEndedWhereItMakes("deformation.png", explore("0.1"));
    EXPECT_EQ(content(), earlier);
}

TEST_F(Signals, EndReportAndAnEarlierPageIsLeftWhole) {
    const std::filesystem::path run = scratch.file("run");
    test::ChildProgram explorer({"explore", test::shippedScene("polystyrene").string(), "--out",
                                 run.string(), "--duration", "0.5"});
    ASSERT_EQ(explorer.wait().exitCode, 0);
    std::ofstream(folder / "asperity_report.json") << R"({"files": ["run.html"]})";
    std::ofstream(folder / "run.html") << "earlier";
    expectEndedWhereItMakes("run.html",
                            {"report", run.string(), run.string(), "--out", folder.string()});
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 2);
    EXPECT_EQ(test::contentOf(folder / "run.html"), "earlier");
}

/// A folder without a result was there while it worked, and stayed when it was killed.
TEST_F(Signals, ThatEndExtremesLeaveNoFolder) {
    const std::filesystem::path out = scratch.file("none");
    test::ChildProgram child({"extremes", "--out", out.string()});
    const std::filesystem::path threads = "/proc/" + std::to_string(child.id()) + "/task";
    const auto works = [&] {  // on all cores
        return std::distance(std::filesystem::directory_iterator(threads), {}) > 1;
    };
    for (int i = 0; i < 10000 && !child.hasEnded() && !works(); ++i) {
        pause();
    }
    EXPECT_FALSE(std::filesystem::exists(out));
    child.send(SIGTERM);
    EXPECT_EQ(child.wait().exitCode, 1);
    EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(Signals, OfAClosedTerminalEndInGoodOrderToo) {
    test::ChildProgram child(explore("3600"));
    waitForAFile(child);
    child.send(SIGHUP);
    EXPECT_EQ(child.wait().exitCode, 1);
    EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST_F(Signals, LeaveTheFilesOfAnEarlierRunWhenTheyEndExploreBeforeItsOwn) {
    std::ofstream(folder / "forces.png") << "earlier";
    test::ChildProgram child(explore("3600"));
    waitFor(child,
            [this] { return std::distance(std::filesystem::directory_iterator(folder), {}) > 1; });
    child.send(SIGTERM);
    EXPECT_EQ(child.wait().exitCode, 1);
    EXPECT_EQ(test::contentOf(folder / "forces.png"), "earlier");
}

TEST_F(Signals, ThatTheProgramWasStartedToIgnoreStayIgnored) {
    test::ChildProgram child(explore("0.2"), SIG_IGN);
    waitForAFile(child);
    child.send(SIGINT);
    EXPECT_EQ(child.wait().exitCode, 0);
}

TEST_F(Signals, EndProjectAndNothingIsLeft) {
    const std::filesystem::path points = scratch.file("points.csv");
    {
        std::ofstream stream(points);
        stream << "x_m,y_m,z_m\n";
        for (int i = 0; i < 100000; ++i) {
            stream << i * 1e-11 << ",5e-7,3e-8\n";
        }
    }
    const test::TracedEnd end =
        test::runTraced(words({"project", test::dataFolder().string() + "/samples/self_affine.gsf",
                               "--points", points.string(), "--out", (folder / "p.csv").string()}),
                        {}, {.bytes = 1000, .signal = SIGINT});
    EXPECT_TRUE(end.wasSignaled);
    EXPECT_EQ(end.exitCode, 1);
    EXPECT_TRUE(std::filesystem::is_empty(folder));
}

/// The first child of a process, when it has one and the system names it.
std::optional<pid_t> childOf(pid_t process) {
    const std::string id = std::to_string(process);
    std::ifstream file("/proc/" + id + "/task/" + id + "/children");
    pid_t child = 0;
    return file >> child ? std::optional(child) : std::nullopt;
}

/// Not gone, nor waiting for its parent to hear that it is.
bool isRunning(pid_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/stat");
    std::string id;
    std::string name;
    std::string state;
    return file >> id >> name >> state && state != "Z";
}

TEST_F(Signals, ThatKillTheProgramEndItsDisplayToo) {
    const char* display = std::getenv("DISPLAY");
    const std::string before = display == nullptr ? "" : display;
    unsetenv("DISPLAY");
    test::ChildProgram child(explore("3600"));
    if (!before.empty()) {
        setenv("DISPLAY", before.c_str(), 1);
    }
    waitForAFile(child);
    const std::optional<pid_t> server = childOf(child.id());
    child.send(SIGKILL);
    child.wait();
    if (!server) {
        GTEST_SKIP() << "the system does not tell a process's children";
    }
    constexpr int kPatience = 5000;
    for (int i = 0; i < kPatience && isRunning(*server); ++i) {
        pause();
    }
    EXPECT_FALSE(isRunning(*server));
}

}  // namespace
}  // namespace asperity
