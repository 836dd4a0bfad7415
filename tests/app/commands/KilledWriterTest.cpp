#include "core/io/heightmap/HeightMapWriter.h"
#include "tests/app/ProgramRun.h"
#include "tests/app/TracedProgram.h"
#include "tests/core/io/heightmap/BumpyMap.h"
#include "tests/support/Places.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/ShippedScene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace asperity::test {
namespace {

namespace fs = std::filesystem;

/// A command that writes a file, killed at some point, and run again.
class KilledWriter : public testing::Test {
protected:
    KilledWriter() { fs::create_directory(scratch_.file("tmp")); }

    [[nodiscard]] std::string in(const std::string& name) const {
        return scratch_.file(name).string();
    }
    [[nodiscard]] std::vector<std::string> environment() const {
        return {"TMPDIR=" + in("tmp"), "XDG_RUNTIME_DIR=" + in("tmp")};
    }

    [[nodiscard]] TracedEnd run(std::vector<std::string> words,
                                const SignalPoint& point = {}) const {
        words.insert(words.begin(), programOfBuild("asperity").string());
        return runTraced(words, environment(), point);
    }

    [[nodiscard]] std::set<std::string> allFiles() const {
        std::set<std::string> files;
        for (const auto& entry : fs::recursive_directory_iterator(scratch_.path())) {
            files.insert(entry.path().lexically_relative(scratch_.path()).string());
        }
        return files;
    }

    /// Kills the command at each of some points between start and end, and has another one of the
    /// same kind leave nothing but its own file.
    void killAndRepeat(const std::vector<std::string>& command, const std::string& target,
                       int kills) {
        const std::set<std::string> before = allFiles();
        const TracedEnd whole = run(command);
        ASSERT_EQ(whole.exitCode, 0) << testing::PrintToString(command);
        const std::set<std::string> after = allFiles();
        std::set<std::string> wanted = before;
        wanted.insert(target);
        ASSERT_EQ(after, wanted) << "without a kill";
        for (int i = 0; i < kills; ++i) {
            const auto part = [&](std::uint64_t total) {
                return total * static_cast<std::uint64_t>(i) / static_cast<std::uint64_t>(kills);
            };
            killOnce(command, {.bytes = part(whole.progress.bytes)}, wanted);
            killOnce(command, {.steps = part(whole.progress.steps)}, wanted);
        }
    }

    void convertToAll(int kills) {
        writeHeightMap(scratch_.file("in.gsf"), bumpyMap(48, 40), {});
        for (const std::string extension :
             {".gwy", ".gsf", ".exr", ".tiff", ".png", ".vti", ".txt", ".vtp", ".vts", ".stl"}) {
            const std::string target = "out" + extension;
            killAndRepeat({"convert", in("in.gsf"), in(target), "--force"}, target, kills);
        }
    }

    void bundleRun(int kills) {
        const auto made =
            runProgram("explore --no-pictures " + shippedScene("polystyrene").string() +
                       " --duration 0.1 --out " + in("run"));
        ASSERT_EQ(made.exitCode, 0) << made.output;
        killAndRepeat({"bundle", in("run"), in("run.zip"), "--force"}, "run.zip", kills);
    }

private:
    void killOnce(const std::vector<std::string>& command, const SignalPoint& point,
                  const std::set<std::string>& wanted) {
        const std::string where = testing::PrintToString(command) + " at byte " +
                                  std::to_string(point.bytes) + ", step " +
                                  std::to_string(point.steps);
        EXPECT_TRUE(run(command, point).wasSignaled) << where;
        EXPECT_EQ(run(command).exitCode, 0) << where;
        EXPECT_EQ(allFiles(), wanted) << where;
    }

    ScratchFolder scratch_;
};

class KilledWriterLong : public KilledWriter {};

constexpr int kSomeKills = 2;
constexpr int kManyKills = 50;

TEST_F(KilledWriter, OfAMapLeavesNothingToTheNextOne) { convertToAll(kSomeKills); }
TEST_F(KilledWriter, OfABundleLeavesNothingToTheNextOne) { bundleRun(kSomeKills); }

TEST_F(KilledWriterLong, OfAMapLeavesNothingToTheNextOne) { convertToAll(kManyKills); }
TEST_F(KilledWriterLong, OfABundleLeavesNothingToTheNextOne) { bundleRun(kManyKills); }

}  // namespace
}  // namespace asperity::test
