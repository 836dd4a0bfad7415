#include "core/io/tables/CsvTable.h"
#include "tests/app/ProgramRun.h"
#include "tests/app/exports/ReadPicture.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/ShippedScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace asperity {
namespace {

/// Width, height and pixels an inch, as in "640 480 96".
std::string sizeOf(const std::filesystem::path& path) {
    const test::ReadPicture picture = test::readPicture(path);
    return std::to_string(picture.width) + " " + std::to_string(picture.height) + " " +
           std::to_string(std::lround(picture.dpi));
}

/// One run for all tests, made when the first needs it.
const std::filesystem::path& exploredRun() {
    static const test::ScratchFolder scratch;
    static const std::filesystem::path folder = [] {
        const std::filesystem::path run = scratch.path() / "dent";
        (void)test::runProgram("explore " + test::shippedScene("polystyrene").string() +
                               " --duration 2 --out " + run.string());
        return run;
    }();
    return folder;
}

class Render : public ::testing::Test {
protected:
    /// Draws and expects a file. @return what was printed
    std::string rendered(const std::string& arguments, const std::string& name) {
        const auto run = test::runProgram("render " + arguments + " --out " + path(name).string());
        EXPECT_EQ(run.exitCode, 0) << run.output;
        EXPECT_TRUE(std::filesystem::exists(path(name))) << run.output;
        return run.output;
    }
    /// Expects a refusal in one line that leaves nothing. @return that line
    std::string refused(const std::string& arguments, int exitCode) {
        const auto before = entries();
        const auto run = test::runProgram("render " + arguments);
        EXPECT_EQ(run.exitCode, exitCode) << arguments << '\n' << run.output;
        EXPECT_EQ(entries(), before) << arguments;
        return run.output;
    }
    [[nodiscard]] std::filesystem::path path(const std::string& name) const {
        return scratch.path() / name;
    }
    [[nodiscard]] std::ptrdiff_t entries() const {
        return std::distance(std::filesystem::directory_iterator(scratch.path()),
                             std::filesystem::directory_iterator());
    }
    static std::string run() { return exploredRun().string(); }
    static std::string scene() { return test::shippedScene("polystyrene").string(); }

    test::ScratchFolder scratch;
};

TEST_F(Render, DrawsEachViewOfARun) {
    for (const char* view : {"3d", "front", "back", "right", "left", "top", "bottom", "section",
                             "overview", "deformation", "forces", "cycle"}) {
        const std::string name = std::string(view) + ".png";
        rendered(run() + " --size 480x360 --view " + view, name);
        EXPECT_GT(std::filesystem::file_size(path(name)), 5000U) << view;
        EXPECT_EQ(sizeOf(path(name)), "480 360 96") << view;
    }
}

TEST_F(Render, DrawsASceneAtRest) {
    rendered(scene() + " --size 400x300", "a.png");
    rendered(scene() + " --size 400x300 --view overview", "b.tif");
    const std::string said = refused(scene() + " --view cycle --out " + path("c.png").string(), 1);
    EXPECT_NE(said.find("the view cycle needs a run"), std::string::npos) << said;
}

TEST_F(Render, GivesTheSameBytesAgain) {
    rendered(run() + " --size 400x300 --at 1", "a.png");
    rendered(run() + " --size 400x300 --at 1", "b.png");
    EXPECT_EQ(test::contentOf(path("a.png")), test::contentOf(path("b.png")));
    rendered(run() + " --size 400x300 --at snap-in", "c.png");
    EXPECT_NE(test::contentOf(path("a.png")), test::contentOf(path("c.png")));
}

/// Over the colors of a height map a dent is hardly seen.
TEST_F(Render, ColorsAContactByDisplacementIfNothingElseIsChosen) {
    rendered(run() + " --size 400x300", "usual.png");
    rendered(run() + " --size 400x300 --color displacement", "dent.png");
    rendered(run() + " --size 400x300 --color height", "height.png");
    EXPECT_EQ(test::contentOf(path("usual.png")), test::contentOf(path("dent.png")));
    EXPECT_NE(test::contentOf(path("usual.png")), test::contentOf(path("height.png")));
    rendered(scene() + " --size 400x300", "rest.png");
    rendered(scene() + " --size 400x300 --color height", "rest_height.png");
    EXPECT_EQ(test::contentOf(path("rest.png")), test::contentOf(path("rest_height.png")));
    EXPECT_NE(refused(run() + " --color channel --out a.png", 2).find("expected one of height"),
              std::string::npos);
    EXPECT_NE(refused(run() + " --view overview --color slope --out " + path("a.png").string(), 1)
                  .find("--color"),
              std::string::npos);
}

TEST_F(Render, IsAsWideAsAColumn) {
    rendered(run() + " --column single", "a.png");
    EXPECT_EQ(sizeOf(path("a.png")), "1004 753 300");
    rendered(run() + " --view cycle --column double --dpi 600 --aspect 2", "b.tif");
    EXPECT_EQ(sizeOf(path("b.tif")), "4110 2055 600");
}

TEST_F(Render, HasNothingBehindWhereThatIsAskedFor) {
    for (const char* view : {"3d", "deformation", "overview", "cycle"}) {
        const std::string name = std::string(view) + ".png";
        rendered(run() + " --clean --transparent --size 400x300 --view " + view, name);
        const std::vector<std::uint8_t> pixels = test::readPicture(path(name)).pixels;
        std::uint8_t maxAlpha = 0;
        for (std::size_t at = 3; at < pixels.size(); at += 4) {
            maxAlpha = std::max(maxAlpha, pixels[at]);
        }
        EXPECT_EQ(pixels[3], 0) << view << ": alpha of the corner";
        EXPECT_GT(maxAlpha, 0.9 * 255) << view;
    }
    rendered(run() + " --size 400x300", "opaque.png");
    EXPECT_EQ(test::readPicture(path("opaque.png")).channels, 3);
}

TEST_F(Render, WritesPlotsAsVectorsAndTables) {
    rendered(run() + " --view forces", "a.svg");
    EXPECT_EQ(test::contentOf(path("a.svg")).find("<?xml"), 0U);
    rendered(run() + " --view cycle", "a.pdf");
    EXPECT_EQ(test::contentOf(path("a.pdf")).find("%PDF-"), 0U);
    rendered(run() + " --view forces", "a.csv");
    const CsvTable log = readCsv(exploredRun() / "force_log.csv");
    const CsvTable table = readCsv(path("a.csv"));
    ASSERT_EQ(table.rows(), log.rows());
    for (std::size_t row = 0; row < table.rows(); ++row) {
        ASSERT_EQ(table.text(row, "time_s"), log.text(row, "time_s"));
        ASSERT_EQ(table.text(row, "force_z_n"), log.text(row, "est_fz_n"));
    }
}

TEST_F(Render, WritesTheFieldOfADeformation) {
    for (const char* name : {"a.exr", "a.vtp", "a.vts", "a.csv"}) {
        rendered(run() + " --view deformation", name);
    }
    EXPECT_EQ(test::contentOf(path("a.exr")), test::contentOf(exploredRun() / "deformation.exr"));
    rendered(run() + " --view deformation --width 20e-9", "b.csv");
    const CsvTable table = readCsv(path("b.csv"));
    EXPECT_NEAR(table.number(table.rows() - 1, "rest_x_m") - table.number(0, "rest_x_m"), 20e-9,
                1e-15);
}

TEST_F(Render, ReplacesAFileOnlyIfAsked) {
    const auto there = scratch.write("a.png", "mine");
    const std::string said = refused(run() + " --size 400x300 --out " + there.string(), 1);
    EXPECT_NE(said.find("--force"), std::string::npos) << said;
    EXPECT_EQ(test::contentOf(there), "mine");
    rendered(run() + " --size 400x300 --force", "a.png");
    EXPECT_NE(test::contentOf(there), "mine");
}

TEST_F(Render, MakesNamesFromATemplate) {
    const std::string folder = scratch.path().string() + "/";
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(test::runProgram("render " + run() + " --size 400x300 --out " + folder).exitCode,
                  0);
    }
    EXPECT_TRUE(std::filesystem::exists(path("dent_3d_1.png")));
    EXPECT_TRUE(std::filesystem::exists(path("dent_3d_2.png")));
}

TEST_F(Render, RefusesNonsenseInOneSentence) {
    const std::string out = " --out " + path("a.png").string();
    EXPECT_NE(refused(run() + " --at 7" + out, 1).find("it goes from 0 s to 2 s"),
              std::string::npos);
    EXPECT_NE(refused(run() + " --view upside" + out, 2).find("3d, front, back"),
              std::string::npos);
    for (const char* size : {"0x0", "12", "axb", "10x-3", "1e3x2", "99999999999x2", "640x480x2"}) {
        refused(run() + " --size " + size + out, 2);
    }
    for (const char* size : {"20000x100", "10x10", "8193x8000"}) {
        EXPECT_NE(refused(run() + " --size " + size + out, 1).find("each side must be"),
                  std::string::npos);
    }
    refused(run() + " --at later" + out, 2);
    refused(run() + " --column triple" + out, 2);
    refused(run() + " --column single --size 640x480" + out, 2);
    refused(run() + " --width 0" + out, 2);
    refused(run() + " --width nan" + out, 2);
    refused(run() + " --dpi 5" + out, 2);
    refused(scene() + " --at 1" + out, 2);
    refused(run() + " --out " + path("a.jpg").string(), 1);
    refused(run() + " --out " + path("{time}.png").string(), 1);
    refused(run() + " --width 1" + out, 1);
    refused(run() + " --view forces --width 1e-8" + out, 1);
    refused(run() + " --out /proc/none/a.png", 3);
    refused(scratch.path().string() + out, 3);
    refused("/nowhere/scene.toml" + out, 3);
}

/// A server that went away ended the program without a word of its own.
TEST_F(Render, IsDrawnWhereTheDisplayIsDead) {
    const auto run = test::runProgram("render " + exploredRun().string() +
                                          " --size 320x240 --out " + path("dead.png").string(),
                                      "DISPLAY=:987");
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_TRUE(std::filesystem::exists(path("dead.png")));
}

}  // namespace
}  // namespace asperity
