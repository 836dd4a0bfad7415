#include "tests/app/ChildProgram.h"
#include "tests/app/ProgramRun.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/ShippedScene.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <thread>

namespace asperity {
namespace {

namespace fs = std::filesystem;

/// The commands' results in a folder in which something was before.
class OutputFolders : public ::testing::Test {
protected:
    [[nodiscard]] std::string explore(const std::string& more = {}) const {
        return "explore --no-pictures " + scene + " --duration 0.1 --out " + out.string() + more;
    }
    static void expectEnds(const std::string& call, int exitCode, const std::string& says = {}) {
        const auto run = test::runProgram(call);
        EXPECT_EQ(run.exitCode, exitCode) << call << "\n" << run.output;
        EXPECT_NE(run.output.find(says), std::string::npos) << call << "\n" << run.output;
    }
    void write(const std::string& name, const std::string& text) const {
        fs::create_directories(out);
        std::ofstream(out / name) << text;
    }
    [[nodiscard]] std::map<std::string, std::string> content() const {
        std::map<std::string, std::string> files;
        for (const auto& file : fs::recursive_directory_iterator(out)) {
            files[file.path().filename()] =
                file.is_regular_file() ? test::contentOf(file.path()) : "no file";
        }
        return files;
    }

    test::ScratchFolder scratch;
    fs::path out = scratch.file("out");
    std::string scene = test::shippedScene("polystyrene").string();
};

TEST_F(OutputFolders, AreFilledAgainAndAgainAndKeepWhatIsNotThePrograms) {
    const std::string call = "explore " + scene + " --duration 0.1 --out " + out.string();
    expectEnds(call, 0);
    const auto first = content();
    EXPECT_EQ(first.size(), 8U);
    write("notes.txt", "mine");
    write("energy_log.csv", "of an earlier run");
    fs::remove(out / "forces.png");
    expectEnds(call, 0);
    auto second = content();
    EXPECT_EQ(second["notes.txt"], "mine");
    second.erase("notes.txt");
    EXPECT_EQ(second, first);
}

TEST_F(OutputFolders, OfARunWithoutPicturesHaveNoneNorThoseOfARunBefore) {
    expectEnds("explore " + scene + " --duration 0.1 --out " + out.string(), 0);
    auto drawn = content();
    const auto withoutDisplay =
        test::runProgram(explore(), "DISPLAY= PATH=" + scratch.path().string());
    EXPECT_EQ(withoutDisplay.exitCode, 0) << withoutDisplay.output;
    for (const char* picture :
         {"deformation.png", "deformation.exr", "forces.png", "overview.png"}) {
        EXPECT_EQ(drawn.erase(picture), 1U) << picture;
    }
    EXPECT_EQ(content(), drawn);
}

TEST_F(OutputFolders, StayAsTheyAreWhereACommandFails) {
    expectEnds("explore --no-pictures " + scene + " --path /nonexistent.csv --out " + out.string(),
               3);
    EXPECT_FALSE(fs::exists(out));
    expectEnds(explore(), 0);
    const auto before = content();
    test::ChildProgram child({"explore", scene, "--duration", "3600", "--out", out.string()});
    const auto more = static_cast<std::ptrdiff_t>(before.size()) + 1;
    while (std::distance(fs::directory_iterator(out), {}) < more && !child.hasEnded()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    child.send(SIGKILL);
    child.wait();
    EXPECT_EQ(std::distance(fs::directory_iterator(out), {}), more)
        << "what was killed left a folder";
    for (const auto& [name, text] : before) {
        EXPECT_EQ(test::contentOf(out / name), text) << name;
    }
    expectEnds(explore(), 0);
    EXPECT_EQ(content(), before) << "the next command sweeps it";
}

TEST_F(OutputFolders, AreNamedAsGivenWhereTheDiskIsFull) {
    const std::string call =
        "explore --no-pictures " + scene + " --duration 2 --out " + out.string();
    const auto run = test::runProgram(call, "ulimit -f 200;");
    EXPECT_EQ(run.exitCode, 1) << run.output;
    const std::string sentence = (out / "force_log.csv").string() + ": cannot be written";
    EXPECT_NE(run.output.find(sentence), std::string::npos) << run.output;
    EXPECT_FALSE(fs::exists(out));
}

TEST_F(OutputFolders, WithARecordingAreRefusedWithoutForce) {
    expectEnds("loop " + scene + " --duration 2.5 --record " + out.string(), 0);
    const auto recording = content();
    EXPECT_TRUE(recording.contains("recording.json"));
    expectEnds(explore(), 1, "--force");
    expectEnds("loop " + scene + " --duration 2.5 --record " + out.string(), 1, "--force");
    expectEnds(scene + " --record " + out.string(), 1, "--force");
    expectEnds("replay " + out.string() + " --out " + scratch.file("again").string(), 0);
    EXPECT_EQ(content(), recording);
    expectEnds(explore(" --force"), 0);
    EXPECT_EQ(content().size(), 4U);
    EXPECT_FALSE(content().contains("tick_memory.csv"));
}

TEST_F(OutputFolders, WithFilesOfTheSameNamesAreRefusedWithoutForce) {
    for (const char* name : {"summary.json", "scene.toml", "overview.png", "recording.h5",
                             "tick_input.csv"}) {  // tables without what explore leaves beside them
        fs::remove_all(out);
        write(name, "mine");
        expectEnds(explore(), 1, name);
        EXPECT_EQ(content()[name], "mine");
    }
    fs::remove_all(out);
    write("needs.csv", "mine");
    expectEnds("tradeoff " + scene + " --out " + out.string(), 1, "needs.csv");
}

/// The earlier run was deleted before it was known whether there would be another one.
TEST_F(OutputFolders, KeepARecordingUntilTheNextHasBegun) {
    expectEnds("loop " + scene + " --duration 2.5 --record " + out.string(), 0);
    const auto recording = content();
    const std::string record = " --force --record " + out.string();
    expectEnds("loop /nosuch.gwy --duration 2.5" + record, 3, "/nosuch.gwy");
    EXPECT_EQ(content(), recording);
    expectEnds("/nosuch.gwy" + record, 3, "/nosuch.gwy");
    EXPECT_EQ(content(), recording);
    test::ChildProgram child(
        {"loop", scene, "--duration", "60", "--force", "--record", out.string()});
    child.send(SIGINT);
    child.wait();
    if (content() != recording) {  // it had begun
        expectEnds("replay " + out.string() + " --out " + scratch.file("replayed").string(), 0);
    }
    // A run may begin from what it replaces.
    const std::string own = (out / "scene.toml").string();
    expectEnds("loop " + own + " --duration 2.5" + record, 0);
    EXPECT_EQ(content().size(), recording.size());
    expectEnds("replay " + out.string() + " --out " + scratch.file("again").string(), 0);
}

TEST_F(OutputFolders, WithARunTakeNoRecordingAndNoReplayWithoutForce) {
    expectEnds(explore(), 0);
    const auto run = content();
    expectEnds("loop " + scene + " --duration 2.5 --record " + out.string(), 1, "--force");
    const fs::path other = scratch.file("other");
    expectEnds("explore --no-pictures " + scene + " --duration 0.1 --out " + other.string(), 0);
    expectEnds("replay " + other.string() + " --out " + out.string(), 1, "--force");
    EXPECT_EQ(content(), run);
    write("notes.txt", "mine");
    expectEnds("replay " + other.string() + " --out " + out.string() + " --force", 0);
    EXPECT_EQ(content().size(), 3U);
    expectEnds("replay " + other.string() + " --out " + out.string(), 0, "bit-identical");
    expectEnds("loop " + scene + " --duration 2.5 --force --record " + out.string(), 0);
    EXPECT_EQ(content()["notes.txt"], "mine");
}

TEST_F(OutputFolders, MayBeLinksAndThePresentOne) {
    fs::create_directory(scratch.file("far"));
    fs::create_directory_symlink("far", out);
    expectEnds(explore(), 0);
    EXPECT_TRUE(fs::is_symlink(out));
    EXPECT_TRUE(fs::exists(scratch.file("far") / "summary.json"));
    const fs::path before = fs::current_path();
    fs::current_path(scratch.file("far"));
    expectEnds("explore --no-pictures " + scene + " --duration 0.1 --out .", 0);
    fs::current_path(before);
}

}  // namespace
}  // namespace asperity
