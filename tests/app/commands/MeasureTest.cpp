#include "core/io/heightmap/HeightMapWriter.h"
#include "core/io/tables/CsvTable.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/app/ProgramRun.h"
#include "tests/support/Places.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

// `asperity measure`

namespace asperity {
namespace {

using testing::HasSubstr;

constexpr double kDepth = 50e-9;

/// A grating of 50 nm, ridges and grooves of 180 nm and flanks of 20 nm, on a slope of 0.01.
class Measure : public testing::Test {
protected:
    void SetUp() override {
        HeightMap map = sampledMap(
            {.columns = 300, .rows = 20, .sizeX = 3000e-9, .sizeY = 400e-9},
            TrapezoidGrating{
                .pitch = 400e-9, .depth = kDepth, .topWidth = 180e-9, .flankWidth = 20e-9});
        for (int row = 0; row < map.rows; ++row) {
            for (int column = 0; column < map.columns; ++column) {
                map.heights[map.index(row, column)] += 0.01 * (map.rows - row) * map.pitchY;
            }
        }
        writeHeightMap(scratch.file("grating.gwy"), map, {.title = "Height"});
    }
    [[nodiscard]] test::ProgramRun run(const std::string& options) const {
        return test::runProgram("measure " + scratch.file("grating.gwy").string() + " " + options);
    }
    [[nodiscard]] nlohmann::json measured(const std::string& options) const {
        const auto ran = run(options + " --json");
        EXPECT_EQ(ran.exitCode, 0) << ran.output;
        return nlohmann::json::parse(ran.output);
    }

    test::ScratchFolder scratch;
};

TEST_F(Measure, SaysWhichFileCannotBeWritten) {
    const std::string out = scratch.file("profile.csv").string();
    const auto full =
        test::runProgram("measure " + scratch.file("grating.gwy").string() +
                             " --profile 0,1e-7,3e-6,1e-7 --samples 5000 --out " + out,
                         "ulimit -f 8;");
    EXPECT_EQ(full.exitCode, 1);
    EXPECT_THAT(full.output, HasSubstr(out + ": writing stopped half-way"));
}

TEST_F(Measure, LevelsByAPlaneUnlessToldOtherwise) {
    const nlohmann::json level = measured("");
    EXPECT_EQ(level["level"], "plane");
    EXPECT_EQ(level["pixels"], 300 * 20);
    EXPECT_EQ(level["squares"], 299 * 19);
    EXPECT_NEAR(level["mean_m"].get<double>(), 0.0, 1e-20);
    EXPECT_THAT(level["notes"].back().get<std::string>(), HasSubstr("leveling: plane"));
    const nlohmann::json raw = measured("--level none");
    EXPECT_NEAR(raw["sz_m"].get<double>(), kDepth + 0.01 * 380e-9, 1e-20);
    const nlohmann::json flat = measured("--level rows,zero");
    EXPECT_EQ(flat["level"], "rows, zero");
    EXPECT_NEAR(flat["sz_m"].get<double>(), kDepth, 1e-20);
    EXPECT_EQ(flat["lowest_m"], 0.0);
}

TEST_F(Measure, RectangleLimitsTheRoughness) {
    // On the first ridge alone there is nothing but the slope.
    const nlohmann::json ridge = measured("--level none --rectangle 0,0,179e-9,400e-9");
    EXPECT_EQ(ridge["rectangle"],
              nlohmann::json({{"column", 0}, {"row", 0}, {"columns", 18}, {"rows", 20}}));
    EXPECT_NEAR(ridge["sz_m"].get<double>(), 0.01 * 380e-9, 1e-20);
    EXPECT_NEAR(ridge["sdr"].get<double>(), std::sqrt(1.0 + 0.01 * 0.01) - 1.0, 1e-15);
    const auto outside = run("--rectangle 5,5,6,6");
    EXPECT_EQ(outside.exitCode, 1);
    EXPECT_THAT(outside.output, HasSubstr("holds no pixel"));
}

TEST_F(Measure, ProfileAcrossAGratingGivesItsDepth) {
    const nlohmann::json all =
        measured("--level none --profile 0,110e-9,3000e-9,110e-9 --samples 1501 "
                 "--low 210e-9,370e-9 --high 0,170e-9");
    const nlohmann::json& profile = all["profile"];
    EXPECT_EQ(profile["samples"], 1501);
    EXPECT_NEAR(profile["length_m"].get<double>(), 3000e-9, 1e-20);
    EXPECT_NEAR(profile["grating"]["height_m"].get<double>(), kDepth, 1e-12 * kDepth);
    EXPECT_GE(profile["grating"]["plateaus"], 12);
    EXPECT_NEAR(profile["step"]["height_m"].get<double>(), kDepth, 1e-12 * kDepth);
    // The center of the last pixel lies on a flank, a quarter of the depth up.
    EXPECT_NEAR(profile["ends"]["rise_m"].get<double>(), -0.75 * kDepth, 1e-12 * kDepth);
}

TEST_F(Measure, ProfileAlongARidgeGivesTheAngle) {
    const nlohmann::json profile =
        measured("--level none --profile 95e-9,10e-9,95e-9,390e-9")["profile"];
    EXPECT_EQ(profile["samples"], 20);
    EXPECT_NEAR(profile["ends"]["angle_rad"].get<double>(), std::atan(0.01), 1e-12);
    EXPECT_NEAR(profile["fitted_angle_rad"].get<double>(), std::atan(0.01), 1e-12);
    EXPECT_TRUE(profile["grating"].is_null());  // no ridge or groove lies within the line
    EXPECT_TRUE(profile["step"].is_null());
}

TEST_F(Measure, ProfileGoesIntoATable) {
    const std::string out = scratch.file("profile.csv").string();
    const auto ran =
        run("--level none --profile 5e-9,110e-9,2995e-9,110e-9 --samples 300 --out " + out);
    EXPECT_EQ(ran.exitCode, 0) << ran.output;
    const CsvTable table(test::contentOf(out), out);
    ASSERT_EQ(table.rows(), 300U);
    EXPECT_NEAR(table.number(299, "distance_m"), 2990e-9, 1e-20);
    EXPECT_NEAR(table.number(30, "x_m"), 305e-9, 1e-20);
    EXPECT_EQ(table.number(30, "y_m"), 110e-9);
    EXPECT_NEAR(table.number(3, "z_m") - table.number(30, "z_m"), kDepth, 1e-12 * kDepth);
    EXPECT_EQ(test::runProgram("measure " + scratch.file("grating.gwy").string() +
                               " --profile 0,0,1e-9,0 --out " +
                               scratch.file("grating.gwy").string())
                  .exitCode,
              1);
}

TEST_F(Measure, TellsPeopleInWords) {
    const auto ran = run("--level rows,zero --profile 0,110e-9,3000e-9,110e-9");
    EXPECT_THAT(ran.output, HasSubstr("channel 'Height', 300 x 20 pixels, 3 µm x 400 nm\n"));
    EXPECT_THAT(ran.output, HasSubstr("Roughness (ISO 25178-2) of 6000 pixels with data"));
    EXPECT_THAT(ran.output, HasSubstr("Sz   50 nm"));
    EXPECT_THAT(ran.output, HasSubstr("height of a grating: 50 nm (scatter "));
}

TEST_F(Measure, TakesASceneAndRefusesAShape) {
    const auto scene = scratch.write(
        "scene.toml", "[sample]\nfile = \"grating.gwy\"\nlevel = [\"rows\", \"zero\"]\n");
    const auto ran = test::runProgram("measure --json " + scene.string());
    EXPECT_EQ(nlohmann::json::parse(ran.output)["level"], "rows, zero");
    const auto shape = scratch.write("shape.toml", "[sample]\nshape = \"sphere\"\n");
    const auto refused = test::runProgram("measure " + shape.string());
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_THAT(refused.output, HasSubstr("no height map to measure"));
}

TEST_F(Measure, NamesTheParametersOfIso) {
    const auto ran = run("--level none");
    EXPECT_EQ(ran.exitCode, 0);
    for (const char* const name :
         {"Sa", "Sq", "Sz", "Sp", "Sv", "Ssk", "Sku", "Sdq", "Sdr", "Sal", "Str"}) {
        EXPECT_THAT(ran.output, HasSubstr(std::string("\n  ") + name + " ")) << name;
    }
    const nlohmann::json all = measured("--level rows,zero");
    // Ridges and grooves alike, flanks of a pixel or two: nearly two heights.
    EXPECT_NEAR(all["sku"].get<double>(), 1.0, 0.2);
    EXPECT_NEAR(all["sp_m"].get<double>() + all["sv_m"].get<double>(), kDepth, 1e-20);
    EXPECT_NEAR(all["mean_m"].get<double>(), all["sv_m"].get<double>(), 1e-20);
    EXPECT_TRUE(all["str"].is_null());  // the ridges go on to the border
    EXPECT_EQ(all["texture_step"], 1);
}

TEST_F(Measure, ManyFilesMakeATable) {
    writeHeightMap(scratch.file("flat, 1.gsf"),
                   flatMap({.columns = 4, .rows = 3, .sizeX = 4e-6, .sizeY = 3e-6}),
                   {.title = "Flat"});
    const std::string folder = scratch.file("").string();
    const auto ran =
        test::runCommand("(cd " + folder + " && " + test::programOfBuild("asperity").string() +
                         " measure --csv --level none grating.gwy none.gsf "
                         "'flat, 1.gsf' 2>errors.txt >table.csv)");
    EXPECT_EQ(ran.exitCode, 3);
    const std::string text = test::contentOf(scratch.file("table.csv"));
    EXPECT_TRUE(text.starts_with("file,channel,width_m,height_m,pixels,Sa_m,Sq_m,Ssk,Sku,Sp_m,"
                                 "Sv_m,Sz_m,Sdq,Sdr,Sal_m,Str\ngrating.gwy,Height,"))
        << text;
    EXPECT_THAT(text, HasSubstr("\nnone.gsf,,,,,,,,,,,,,,,\n"));
    // Of one height: neither skewness nor kurtosis, neither length nor ratio.
    EXPECT_THAT(text, HasSubstr("\n\"flat, 1.gsf\",Flat,"));
    EXPECT_THAT(text, HasSubstr(",12,0,0,,,0,0,0,0,0,,\n"));
    const std::string errors = test::contentOf(scratch.file("errors.txt"));
    EXPECT_THAT(errors, HasSubstr("asperity: none.gsf: "));
    EXPECT_THAT(errors, HasSubstr("1 of 3 files: could not be measured"));
}

TEST_F(Measure, TheTableHasTheNumbersOfTheJson) {
    const nlohmann::json single = measured("--rectangle 0,0,900e-9,400e-9");
    const auto ran = run("--rectangle 0,0,900e-9,400e-9 --csv");
    EXPECT_EQ(ran.exitCode, 0);
    const CsvTable table(ran.output, "table");
    ASSERT_EQ(table.rows(), 1U);
    EXPECT_NEAR(table.number(0, "width_m"), 900e-9, 1e-20);
    EXPECT_NEAR(table.number(0, "height_m"), 400e-9, 1e-20);
    EXPECT_EQ(table.number(0, "pixels"), 90.0 * 20.0);
    const std::map<std::string, std::string> keys{
        {"Sa_m", "sa_m"}, {"Sq_m", "sq_m"}, {"Ssk", "ssk"}, {"Sku", "sku"}, {"Sp_m", "sp_m"},
        {"Sv_m", "sv_m"}, {"Sz_m", "sz_m"}, {"Sdq", "sdq"}, {"Sdr", "sdr"}, {"Sal_m", "sal_m"}};
    for (const auto& [column, key] : keys) {
        EXPECT_EQ(table.number(0, column), single[key].get<double>()) << column;
    }
    EXPECT_EQ(table.text(0, "Str"), "") << "the ridges go on to the border";
}

/// All waves together have Sq^2 of the part that was measured.
TEST_F(Measure, ThePowerSpectrumGoesIntoATable) {
    const std::string out = scratch.file("psd.csv").string();
    const nlohmann::json single = measured("--rectangle 0,0,900e-9,400e-9 --psd " + out);
    const CsvTable table(test::contentOf(out), out);
    double sum = 0.0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        sum += table.number(row, "psd_m4") * table.number(row, "waves");
        EXPECT_GT(table.number(row, "frequency_1_m"),
                  row > 0 ? table.number(row - 1, "frequency_1_m") : 0.0);
    }
    const double square = std::pow(single["sq_m"].get<double>(), 2);
    // 90 x 20 pixels, padded to 128 x 32; the file names this area of a wave, too.
    const double area = 1.0 / (128.0 * 10e-9) / (32.0 * 20e-9);
    EXPECT_NEAR(sum * area, square, 1e-9 * square);
    EXPECT_THAT(test::contentOf(out), HasSubstr("# Asperity"));
    EXPECT_THAT(test::contentOf(out), HasSubstr("channel Height\n"));
}

TEST_F(Measure, WrongCallsExitWith2) {
    for (const char* const options :
         {"--csv --json", "--csv --profile 0,0,1e-7,0", "--csv --psd p.csv", "other.gwy",
          "--rectangle 1,2,3", "--rectangle 0,0,nan,1", "--samples 5", "--out p.csv",
          "--profile 0,0,1,1 --samples 1", "--profile 0,0,1,1 --low 0,1", "--level flat"}) {
        EXPECT_EQ(run(options).exitCode, 2) << options;
    }
    EXPECT_EQ(run("--profile 0,0,0,0").exitCode, 1);
    EXPECT_EQ(run("--profile 0,0,1e-7,0 --low 5,6 --high 0,1e-8").exitCode, 1);
    EXPECT_EQ(test::runProgram("measure none.gsf").exitCode, 3);
}

}  // namespace
}  // namespace asperity
