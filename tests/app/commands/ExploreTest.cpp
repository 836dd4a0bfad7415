#include "core/io/heightmap/HeightMapWriter.h"
#include "core/io/tables/CsvTable.h"
#include "core/scene/Validity.h"
#include "tests/app/ProgramRun.h"
#include "tests/support/Places.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/Sanitized.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/ShippedScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace asperity {
namespace {

const char* const kResults[] = {"deformation.exr", "deformation.png", "force_log.csv",
                                "forces.png",      "overview.png",    "scene.toml",
                                "summary.json",    "tick_input.csv"};

/// Every number of the log is finite and the ticks follow each other without a gap.
void expectWholeLog(const std::filesystem::path& folder, std::size_t ticks, double rate) {
    const CsvTable log = readCsv(folder / "force_log.csv");
    ASSERT_EQ(log.rows(), ticks);
    for (std::size_t row = 0; row < log.rows(); ++row) {
        ASSERT_NEAR(log.number(row, "time_s") * rate, static_cast<double>(row), 1e-6);
        for (const std::string& column : log.columns()) {
            if (column == "state" || column == "flags" || column == "branch") {
                continue;
            }
            ASSERT_TRUE(std::isfinite(log.number(row, column))) << column << " in row " << row;
        }
    }
}

nlohmann::json summaryOf(const std::filesystem::path& folder) {
    return nlohmann::json::parse(test::contentOf(folder / "summary.json"));
}

/// Each reading has what detector and model leave open, apart.
void expectBudgets(const nlohmann::json& cycle) {
    const nlohmann::json& budgets = cycle["uncertainty"];
    for (const char* key : {"pull_off_force_n", "adhesion_work_j", "max_force_n"}) {
        ASSERT_TRUE(budgets.contains(key)) << key;
        EXPECT_EQ(budgets[key]["value"], cycle[key]) << key;
        EXPECT_GT(budgets[key]["model_sigma"], 0.0) << key;
        const std::string dominant = budgets[key]["dominant"];
        const nlohmann::json& share = dominant == "terms_left_out"
                                          ? budgets[key]["terms_left_out"]
                                          : budgets[key]["shares"][dominant];
        EXPECT_GT(share, 0.3 * budgets[key]["model_sigma"].get<double>()) << key;
    }
    EXPECT_EQ(budgets["pull_off_force_n"]["noise_sigma"], cycle["pull_off_force_sigma_n"]);
    EXPECT_NE(budgets["pull_off_force_n"]["text"].get<std::string>().find("(noise)"),
              std::string::npos);
}

class Explore : public ::testing::TestWithParam<std::string> {
protected:
    static std::filesystem::path input() {
        return GetParam() == "real scan" ? test::sharedData("afm/nanoscope/di-3_v9.01.di")
                                         : test::shippedScene(GetParam());
    }
    test::ScratchFolder scratch;
};

TEST_P(Explore, LeavesPicturesFieldsLogAndSummary) {
    if (GetParam() == "real scan") {
        ASPERITY_NEEDS_SHARED_DATA();
    }
    const auto out = scratch.path() / "out";
    const auto run =
        test::runProgram("explore " + input().string() + " --duration 2 --out " + out.string());
    ASSERT_EQ(run.exitCode, 0) << run.output;
    for (const char* name : kResults) {
        EXPECT_GT(std::filesystem::file_size(out / name), 500U) << name;
    }
    expectWholeLog(out, 2001, 1000.0);
    const nlohmann::json summary = summaryOf(out);
    EXPECT_EQ(summary["statistics"]["ticks"], 2001);
    EXPECT_EQ(summary["statistics"]["ticks_faulted"], 0);
    EXPECT_EQ(summary["input"]["sha256"].get<std::string>().size(), 64U);
    EXPECT_EQ(summary["input"]["provenance"][0]["what"], "format version");
    ASSERT_TRUE(summary["snap_in"].is_object());
    ASSERT_TRUE(summary["pull_off"].is_object());
    EXPECT_GT(summary["largest_indentation"]["indentation_m"], 0.0);
    EXPECT_LT(summary["strongest_attraction"]["model_normal_force_n"], 0.0);
    EXPECT_TRUE(summary.contains("strongest_attraction_body"));
    expectBudgets(summary["cycles"].back());
}

INSTANTIATE_TEST_SUITE_P(Inputs, Explore,
                         ::testing::Values("granular_film", "polystyrene", "silicon_oxide",
                                           "silicone_rubber", "silicon", "real scan"),
                         [](const auto& test) {
                             return test.param == "real scan" ? std::string("RealScan")
                                                              : test.param;
                         });

TEST(ExploreTwice, GivesTheSameBytes) {
    const test::ScratchFolder scratch;
    const std::string start =
        "explore " + test::shippedScene("polystyrene").string() + " --duration 1 --out ";
    const auto first = scratch.path() / "first";
    const auto second = scratch.path() / "second";
    ASSERT_EQ(test::runProgram(start + first.string()).exitCode, 0);
    ASSERT_EQ(test::runProgram(start + second.string()).exitCode, 0);
    for (const char* name : kResults) {
        EXPECT_EQ(test::contentOf(first / name), test::contentOf(second / name)) << name;
    }
}

/// Ranges of the estimated force along z and of the base's lateral travel, over a run.
struct Extremes {
    double strongestPush = 0.0;  // [N]
    double farthestAside = 0.0;  // [m]

    explicit Extremes(const std::filesystem::path& folder) {
        const CsvTable log = readCsv(folder / "force_log.csv");
        for (std::size_t row = 0; row < log.rows(); ++row) {
            strongestPush = std::max(strongestPush, log.number(row, "est_fz_n"));
            farthestAside = std::max(
                farthestAside, std::hypot(log.number(row, "base_x_m") - log.number(0, "base_x_m"),
                                          log.number(row, "base_y_m") - log.number(0, "base_y_m")));
        }
    }
};

// It went 3 nm deep, whatever the force, and slid aside.
TEST(ExploreSetpoint, EndsTheApproachAndNothingGoesAside) {
    const test::ScratchFolder scratch;
    const std::string scene = test::shippedScene("silicon_oxide").string();
    for (const auto& [option, setpoint] :
         {std::pair("", 5e-9), std::pair(" --setpoint 12nN", 12e-9),
          std::pair(" --setpoint '0.8 nN'", 0.8e-9)}) {
        const auto out = scratch.path() / "out";
        const auto run = test::runProgram("explore --no-pictures " + scene + option +
                                          " --duration 3 --out " + out.string());
        ASSERT_EQ(run.exitCode, 0) << run.output;
        const Extremes extremes(out);
        EXPECT_NEAR(extremes.strongestPush, setpoint, 0.7e-9) << option;
        EXPECT_LT(extremes.farthestAside, 1e-15) << option;
        EXPECT_EQ(summaryOf(out)["scene"]["approach"]["setpoint_n"], setpoint);
    }
}

TEST(ExploreSetpoint, ThatIsNotReachedIsSaid) {
    const test::ScratchFolder scratch;
    const auto scene = scratch.write(
        "soft.toml", "[sample]\nshape = \"plane\"\n[truth]\nyoungs_modulus_pa = 5e6\n");
    const auto run =
        test::runProgram("explore --no-pictures " + scene.string() + " --duration 2 --out " +
                         scratch.file("out").string() + " --setpoint 50nN");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_NE(run.output.find("the force did not reach the setpoint of 50 nN"), std::string::npos)
        << run.output;
}

// A new user first sees a run on which every number holds.
TEST(ExploreDefaultScene, RaisesNoDoubt) {
    const test::ScratchFolder scratch;
    const auto out = scratch.path() / "out";
    const auto run =
        test::runProgram("explore --no-pictures " + test::shippedScene("granular_film").string() +
                         " --duration 4 --out " + out.string());
    ASSERT_EQ(run.exitCode, 0) << run.output;
    const nlohmann::json summary = summaryOf(out);
    const nlohmann::json& flagged = summary["statistics"]["ticks_flagged"];
    for (const ValidityTraits& traits : kValidityTraits) {
        // Point-blank at a jump the noise of a single tick may contradict the model.
        const long allowed = traits.flag == Validity::ModelContradicted ? 4 : 0;
        if (traits.severity == Severity::Doubt) {
            EXPECT_LE(flagged[traits.key].get<long>(), allowed) << traits.key;
        }
    }
    EXPECT_TRUE(summary["snap_in"].is_object());
    EXPECT_TRUE(summary["pull_off"].is_object());
    // Roughness that the noise may hide is in no deviation: it is said beside them.
    const auto note = summary["cycles"][0]["uncertainty"]["pull_off_force_n"]["note"];
    EXPECT_NE(note.get<std::string>().find("noise of the heights hides roughness"),
              std::string::npos)
        << note;
    EXPECT_NE(run.output.find("note: " + note.get<std::string>()), std::string::npos) << note;
}

TEST(ExplorePaths, SlideRasterScratchAndFileRunToTheirEnd) {
    const test::ScratchFolder scratch;
    const auto file = scratch.write("path.csv", "time_s,x_m,y_m,z_m\n"
                                                "0,2e-7,2e-7,1e-7\n0.4,2e-7,2.1e-7,9e-8\n");
    const std::string scene = test::shippedScene("silicon_oxide").string();
    const std::pair<std::string, std::size_t> paths[] = {{"slide --duration 1", 1001},
                                                         {"raster --duration 1", 1001},
                                                         {"scratch --duration 1", 1001},
                                                         {file.string(), 401}};
    for (const auto& [path, ticks] : paths) {
        const auto out = scratch.path() / "out";
        std::ostringstream call;
        call << "explore --no-pictures " << scene << " --path " << path << " --out "
             << out.string();
        const auto run = test::runProgram(call.str());
        ASSERT_EQ(run.exitCode, 0) << run.output;
        expectWholeLog(out, ticks, 1000.0);
    }
}

/// "zigzag: there is no such file" was all that it said.
TEST(ExplorePaths, ThatAreNeitherAWordNorAFileAreRefusedWithTheWords) {
    const test::ScratchFolder scratch;
    const auto out = scratch.file("out");
    const auto run =
        test::runProgram("explore --no-pictures " + test::shippedScene("silicon").string() +
                         " --path zigzag --out " + out.string());
    EXPECT_EQ(run.exitCode, 2) << run.output;
    EXPECT_NE(run.output.find("expected approach, slide, raster, scratch or a CSV "
                              "file, not 'zigzag'"),
              std::string::npos)
        << run.output;
    EXPECT_FALSE(std::filesystem::exists(out));
}

/// No path can begin on data where there are none but at the edge.
TEST(ExplorePaths, WithoutDataUnderThemSaySo) {
    const test::ScratchFolder scratch;
    HeightMap edge{.columns = 128,
                   .rows = 128,
                   .pitchX = 2e-9,
                   .pitchY = 2e-9,
                   .heights = std::vector<double>(128 * 128, std::nan("")),
                   .invalid = {}};
    for (int row = 0; row < edge.rows; ++row) {
        edge.heights[edge.index(row, 0)] = 0.0;
    }
    writeHeightMap(scratch.file("edge.gsf"), edge, {});
    const auto run =
        test::runProgram("explore --no-pictures " + scratch.file("edge.gsf").string() +
                         " --level none --duration 0.1 --out " + scratch.file("out").string());
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_NE(run.output.find("note: in 101 of 101 ticks: the scan holds no data here"),
              std::string::npos)
        << run.output;
}

/// The error holds what the scene overrules and its law misses: it said 0 %.
TEST(ExploreModel, TellsTheWholeErrorOfItsForces) {
    const test::ScratchFolder scratch;
    const std::filesystem::path scene = scratch.file("hertz.toml");
    std::ofstream(scene) << "[sample]\nfile = \"" << test::dataFolder().string()
                         << "/samples/steps.gsf\"\n[physics]\nlaw = \"hertz\"\n";
    const auto run = test::runProgram("explore --no-pictures " + scene.string() + " --out " +
                                      scratch.file("out").string() + " --duration 0.2");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    const nlohmann::json model = summaryOf(scratch.file("out"))["model"];
    const double error = model["error"];
    EXPECT_DOUBLE_EQ(error,
                     model["error_left_out"].get<double>() + model["error_law"].get<double>());
    EXPECT_GE(model["errors"]["pull_off_force"].get<double>(), 1.0) << "without adhesion none";
    EXPECT_EQ(model["error_quantity"], "rms force of a run");
    EXPECT_EQ(model["errors"]["rms_force"], error);
    for (const auto& term : model["terms"]) {
        if (term["term"] == "adhesion") {
            EXPECT_FALSE(term["on"]);
            EXPECT_GT(error, 0.5 * term["effect"].get<double>());
        }
    }
    EXPECT_NE(run.output.find("model: within "), std::string::npos);
    EXPECT_EQ(run.output.find("of the whole"), std::string::npos);
}

/// Between two walls the law of one contact says nothing of what is open.
TEST(ExploreUncertainty, IsNotStatedOfSeveralContacts) {
    const test::ScratchFolder scratch;
    HeightMap groove{.columns = 96,
                     .rows = 96,
                     .pitchX = 1e-9,
                     .pitchY = 1e-9,
                     .heights = std::vector<double>(96 * 96),
                     .invalid = {}};
    for (int row = 0; row < groove.rows; ++row) {
        for (int column = 0; column < groove.columns; ++column) {
            groove.heights[groove.index(row, column)] = 0.8 * std::abs(column - 47.5) * 1e-9;
        }
    }
    writeHeightMap(scratch.file("groove.gsf"), groove, {});
    const auto scene =
        scratch.write("scene.toml", "[sample]\nfile = \"groove.gsf\"\nlevel = \"none\"\n");
    const auto down = scratch.write("down.csv", "time_s,x_m,y_m,z_m\n0,48e-9,48e-9,14e-9\n"
                                                "1,48e-9,48e-9,2e-9\n2,48e-9,48e-9,14e-9\n");
    const auto run = test::runProgram("explore --no-pictures " + scene.string() + " --path " +
                                      down.string() + " --out " + scratch.file("out").string());
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_NE(run.output.find("up to 2 contacts at once"), std::string::npos) << run.output;
    const nlohmann::json cycle = summaryOf(scratch.file("out"))["cycles"].at(0);
    EXPECT_EQ(cycle["contacts"], 2);
    const nlohmann::json& pullOff = cycle["uncertainty"]["pull_off_force_n"];
    EXPECT_TRUE(pullOff["model_sigma"].is_null());
    EXPECT_NE(pullOff["note"].get<std::string>().find(
                  "uncertainty of the pull-off force from calibration, tip and "
                  "material is not known: several contacts at once"),
              std::string::npos)
        << pullOff["note"];
    const std::string text = pullOff["text"];
    EXPECT_NE(text.find("± ? ("), std::string::npos) << text;
    EXPECT_NE(run.output.find("pull-off force " + text), std::string::npos) << run.output;
    EXPECT_GT(cycle["uncertainty"]["max_force_n"]["model_sigma"], 0.0);
}

TEST(ExploreLeveling, IsSaidAndCanBeSwitchedOff) {
    const test::ScratchFolder scratch;
    const std::string start = "explore --no-pictures " +
                              test::shippedScene("polystyrene").string() +
                              " --duration 0.1 --out " + scratch.file("out").string();
    EXPECT_NE(test::runProgram(start).output.find("leveling: plane with slopes"),
              std::string::npos);
    EXPECT_NE(test::runProgram(start + " --level none").output.find("leveling: none"),
              std::string::npos);
}

// Mesa's driver ended the program with a segmentation fault where it got no memory.
TEST(ExploreMemory, TooLittleToDrawIsSaidAndTheRunIsKept) {
    if (test::kSanitized) {
        GTEST_SKIP() << "a sanitizer needs more address space than any limit leaves";
    }
    for (const char* limit : {"ulimit -v 400000;", "ulimit -v 700000;", "ulimit -v 900000;"}) {
        const test::ScratchFolder scratch;
        const std::filesystem::path out = scratch.file("out");
        const auto run = test::runProgram("explore " + test::shippedScene("polystyrene").string() +
                                              " --duration 0.1 --out " + out.string(),
                                          limit);
        EXPECT_EQ(run.exitCode, 1) << limit;
        EXPECT_NE(run.output.find("Not enough memory to draw"), std::string::npos) << run.output;
        expectWholeLog(out, 101, 1000.0);
    }
}

// The message was that Xvfb is not installed.
TEST(ExploreFiles, TooManyOpenForADisplayIsSaid) {
    const test::ScratchFolder scratch;
    const auto run = test::runProgram("explore " + test::shippedScene("polystyrene").string() +
                                          " --duration 0.1 --out " + scratch.file("out").string(),
                                      "DISPLAY= prlimit --nofile=4");
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_NE(run.output.find("Xvfb cannot be started: Too many open files"), std::string::npos)
        << run.output;
}

}  // namespace
}  // namespace asperity
