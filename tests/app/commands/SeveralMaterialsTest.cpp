#include "core/io/heightmap/HeightMapFile.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/io/tables/CsvTable.h"
#include "tests/app/ProgramRun.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/ShippedScene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>

// Runs and maps of the shipped scene of two materials.

namespace asperity {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class SeveralMaterials : public testing::Test {
protected:
    static void SetUpTestSuite() {
        scratch = std::make_unique<test::ScratchFolder>();
        fs::copy(test::shippedScene("particles").parent_path().parent_path(), scratch->file("data"),
                 fs::copy_options::recursive);
        const auto path = scratch->write("across.csv", "time_s,x_m,y_m,z_m\n0,20e-9,200e-9,50e-9\n"
                                                       "1,380e-9,200e-9,50e-9\n");
        const auto made = run("explore --no-pictures " + in("data/scenes/particles.toml") +
                              " --path " + path.string() + " --out " + in("run"));
        ASSERT_EQ(made.exitCode, 0) << made.output;
    }
    static void TearDownTestSuite() { scratch.reset(); }

    static test::ProgramRun run(const std::string& arguments) {
        return test::runProgram(arguments);
    }
    static std::string in(const std::string& name) { return scratch->file(name).string(); }
    /// Every value of the mask turned into its opposite.
    static void turnMask() {
        const fs::path file = scratch->file("data/samples/particle_mask.gsf");
        const ScanChannel channel = readHeightMapFile(file).channels.front();
        HeightMap mask = channel.map;
        for (double& value : mask.heights) {
            value = 1.0 - value;
        }
        writeHeightMap(file, mask, {.title = channel.name, .unit = ""});
    }

    static std::unique_ptr<test::ScratchFolder> scratch;
};

std::unique_ptr<test::ScratchFolder> SeveralMaterials::scratch;

TEST_F(SeveralMaterials, AreLoggedWhereTheTipIs) {
    const CsvTable log = readCsv(scratch->file("run") / "force_log.csv");
    double lowest = 1e15;
    double highest = 0.0;
    for (std::size_t row = 0; row < log.rows(); ++row) {
        const double modulus = log.number(row, "youngs_modulus_pa");
        lowest = std::min(lowest, modulus);
        highest = std::max(highest, modulus);
        ASSERT_GE(log.number(row, "work_of_adhesion_j_m2"), 0.066 - 1e-8);
        ASSERT_LE(log.number(row, "friction_coefficient"), 0.3 + 1e-6);
    }
    EXPECT_GE(lowest, 2e9);
    EXPECT_LE(highest, 70e9 * (1.0 + 1e-6));
    EXPECT_GT(highest, 10.0 * lowest) << "the path passes both";
}

TEST_F(SeveralMaterials, ReplayFromABundleOnAnyMachine) {
    const auto bundled = run("bundle " + in("run") + " " + in("run.zip"));
    ASSERT_EQ(bundled.exitCode, 0) << bundled.output;
    fs::rename(scratch->file("data"), scratch->file("gone"));
    const auto again = run("replay " + in("run.zip") + " --out " + in("again"));
    fs::rename(scratch->file("gone"), scratch->file("data"));
    EXPECT_EQ(again.exitCode, 0) << again.output;
    EXPECT_EQ(test::contentOf(scratch->file("again") / "force_log.csv"),
              test::contentOf(scratch->file("run") / "force_log.csv"));
}

TEST_F(SeveralMaterials, OfAChangedMapReplayNothingAndResumeNoMap) {
    const std::string map =
        "map " + in("data/scenes/particles.toml") + " --grid 6x5 --no-pictures --out ";
    ASSERT_EQ(run(map + in("before.gwy")).exitCode, 0);
    const std::string mask = in("data/samples/particle_mask.gsf");
    fs::copy_file(mask, in("kept.gsf"));
    turnMask();
    const auto replayed = run("replay " + in("run") + " --out " + in("changed"));
    const auto bundled = run("bundle " + in("run") + " " + in("changed.zip"));
    ASSERT_EQ(run(map + in("after.gwy")).exitCode, 0);
    fs::copy_file(in("kept.gsf"), mask, fs::copy_options::overwrite_existing);
    EXPECT_EQ(replayed.exitCode, 3);
    EXPECT_THAT(replayed.output, HasSubstr("particle_mask.gsf"));
    EXPECT_THAT(replayed.output, HasSubstr("has changed since"));
    EXPECT_NE(bundled.exitCode, 0);
    EXPECT_NE(test::contentOf(scratch->file("before.gwy")),
              test::contentOf(scratch->file("after.gwy")));
}

TEST_F(SeveralMaterials, AMapOverwritesNoneOfItsInputs) {
    const HeightMap mask =
        readHeightMapFile(scratch->file("data/samples/particle_mask.gsf")).channels.front().map;
    writeHeightMap(scratch->file("mask.gwy"), mask, {.title = "mask", .unit = ""});
    const fs::path scene = scratch->write(
        "masked.toml", "[sample]\nfile = \"data/samples/particles.gsf\"\nmaterial_mask = { file = "
                       "\"mask.gwy\", zero = \"data/materials/polystyrene.toml\", one = "
                       "\"data/materials/silicon.toml\" }\n");
    const auto ran =
        run("map " + scene.string() + " --grid 2x2 --no-pictures --force --out " + in("mask.gwy"));
    EXPECT_EQ(ran.exitCode, 1);
    EXPECT_THAT(ran.output, HasSubstr("this is an input"));
}

}  // namespace
}  // namespace asperity
