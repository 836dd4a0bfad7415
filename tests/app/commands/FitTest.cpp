#include "core/io/heightmap/ScanFile.h"
#include "core/io/tables/CsvTable.h"
#include "tests/app/ProgramRun.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace asperity {
namespace {

class FitCommand : public ::testing::Test {
protected:
    /// Writes an elastic cycle of a paraboloid of 5 um on a lever of 0.05 N/m, E* 5 kPa.
    std::string curveFile(const std::string& name) {
        const std::filesystem::path path = scratch.file(name);
        std::ofstream file(path);
        file << "segment,base_m,deflection_m,force_N\n" << std::setprecision(12);
        for (const bool retracts : {false, true}) {
            for (int i = 0; i <= 500; ++i) {
                const double way = -3e-6 + (4.2e-6 * (retracts ? 500 - i : i) / 500.0);
                const double force = forceAt(way) + (1e-12 * ((i * 7919) % 13 - 6));
                file << (retracts ? "retract," : "approach,") << 1e-6 + way << ','
                     << force / kStiffness << ',' << force << '\n';
            }
        }
        return path.string();
    }

    static double forceAt(double way) {
        double low = 0.0;
        double high = std::max(way, 0.0);
        for (int i = 0; i < 100; ++i) {
            const double depth = 0.5 * (low + high);
            const double law = 4.0 / 3.0 * 5e3 * std::sqrt(5e-6) * std::pow(depth, 1.5);
            (depth + (law / kStiffness) < way ? low : high) = depth;
        }
        return kStiffness * (std::max(way, 0.0) - low);
    }

    [[nodiscard]] nlohmann::json json(const std::string& name) const {
        std::ifstream file(scratch.file("out") / name);
        return nlohmann::json::parse(file);
    }
    [[nodiscard]] test::ProgramRun fit(const std::string& arguments) const {
        return test::runProgram("fit " + arguments + " --out " + scratch.file("out").string());
    }

    static constexpr double kStiffness = 0.05;  // [N/m]
    test::ScratchFolder scratch;
};

TEST_F(FitCommand, WritesNumbersTablesAndFigure) {
    const auto run = fit(curveFile("a.csv") + " --tip paraboloid:5um --nu 0.5");
    EXPECT_EQ(run.exitCode, 0) << run.output;
    const auto result = json("fit.json");
    EXPECT_EQ(result["verdict"], "matched");
    const auto& modulus = result["parameters"]["youngs_modulus_pa"];
    EXPECT_NEAR(modulus["value"].get<double>(), 3750.0, 40.0);
    EXPECT_GT(modulus["std"].get<double>(), 0.0);
    EXPECT_GT(modulus["std_calibration"].get<double>(), 375.0);
    EXPECT_EQ(modulus["unit"], "Pa");
    EXPECT_EQ(modulus["source"], "fitted");
    EXPECT_EQ(result["parameters"]["stiffness_n_m"]["source"], "file");
    EXPECT_EQ(result["parameters"]["tip_radius_m"]["source"], "assumed");
    EXPECT_EQ(result["sha256"].get<std::string>().size(), 64U);
    EXPECT_LT(result["residuals"]["rms_forward_cycle"].get<double>(), 0.02);
    EXPECT_EQ(readCsv(scratch.file("out") / "curve.csv").rows(), 1002U);
    EXPECT_EQ(readCsv(scratch.file("out") / "simulated.csv").rows(), 1002U);
    EXPECT_GT(std::filesystem::file_size(scratch.file("out") / "fit.png"), 1000U);
    EXPECT_EQ(fit(curveFile("a.csv") + " --tip paraboloid:5um").exitCode, 1);  // no --force
}

/// Number behind these words, with a factor of the unit that follows.
double numberAfter(const std::string& text, const std::string& words, double unit) {
    const std::size_t at = text.find(words);
    return at == std::string::npos ? std::nan("")
                                   : unit * std::stod(text.substr(at + words.size()));
}

TEST_F(FitCommand, ItsSceneSnapsInAndPullsOffAsTheFit) {
    const std::filesystem::path curve =
        test::sharedData("curves/original/fmt-igor-fd_SiN_FD_plot.ibw");
    if (curve.empty()) {
        GTEST_SKIP() << "../shared/data is not beside this checkout";
    }
    const auto run =
        fit(curve.string() + " --tip paraboloid:10nm --nu 0.27 --law md --lever thermal");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    const auto result = json("fit.json");
    const auto found = [&](const char* key) {
        return result["parameters"][key]["value"].get<double>();
    };
    const auto figure = [&](const char* key) { return result["tests"][key].get<double>(); };
    const std::string scene = (scratch.file("out") / "scene.toml").string();
    const auto simulated =
        test::runProgram("curve " + scene + " --out " + scratch.file("curve.csv").string());
    ASSERT_EQ(simulated.exitCode, 0) << simulated.output;
    EXPECT_NEAR(numberAfter(simulated.output, "strongest pull of the law ", 1e-9) /
                    -figure("lowest_force_n_simulated"),
                1.0, 1e-4);
    for (const auto& [words, key] : {std::pair{"snap-in at base ", "snap_in_base_m_simulated"},
                                     std::pair{"pull-off at base ", "pull_off_base_m_simulated"}}) {
        EXPECT_NEAR(numberAfter(simulated.output, words, 1e-9),
                    figure(key) - found("contact_point_m"), 1e-13)
            << words;
    }
    const std::string material = test::contentOf(scratch.file("out") / "material.toml");
    EXPECT_NE(material.find("source = 'asperity fit, curve 0 of fmt-igor-fd_SiN_FD_plot.ibw: "
                            "matched, Maugis-Dugdale, elastic'"),
              std::string::npos)
        << material;
}

/// Two works of adhesion are felt, recorded and replayed.
TEST_F(FitCommand, ASceneOfTwoWorksReplaysToTheBit) {
    const std::string scene =
        scratch
            .write("scene.toml",
                   "[sample]\nshape = \"plane\"\nyoungs_modulus_pa = 2e6\n"
                   "work_of_adhesion_j_m2 = 0.04\nretract_work_of_adhesion_j_m2 = 0.06\n"
                   "[tip]\nradius_m = 1e-6\n[physics]\nlaw = \"jkr_sphere\"\n"
                   "[approach]\nsetpoint_n = 50e-9\n")
            .string();
    const std::string out = scratch.file("run").string();
    const auto run = test::runProgram("explore " + scene + " --no-pictures --out " + out);
    ASSERT_EQ(run.exitCode, 0) << run.output;
    const std::vector<double> force =
        readCsv(scratch.file("run") / "force_log.csv").numbers("model_fz_n");
    EXPECT_LT(*std::min_element(force.begin(), force.end()), -0.2e-6)
        << "the pull of the work on retract, 1.5 pi w R = 0.28 uN";
    const auto again = test::runProgram("replay " + out + " --out " + scratch.file("2").string());
    EXPECT_EQ(again.exitCode, 0) << again.output;
    EXPECT_NE(again.output.find("bit-identical"), std::string::npos) << again.output;
}

/// A sample that relaxes in a liquid: its scene is run and replayed, and its curve needs a speed.
TEST_F(FitCommand, ASceneOfRelaxationAndDragReplaysToTheBit) {
    const std::filesystem::path measured =
        test::sharedData("curves/original/fmt-jpk-fd_map-data-reference-points.jpk-force-map");
    if (measured.empty()) {
        GTEST_SKIP() << "../shared/data is not beside this checkout";
    }
    const auto fitted = fit(measured.string() + " --tip sphere:18.64um --relaxation on --drag on");
    ASSERT_EQ(fitted.exitCode, 0) << fitted.output;
    const std::string scene = (scratch.file("out") / "scene.toml").string();
    const auto slow = test::runProgram("curve " + scene);
    EXPECT_EQ(slow.exitCode, 1) << slow.output;
    EXPECT_NE(slow.output.find("give --speed"), std::string::npos) << slow.output;
    const std::string table = scratch.file("curve.csv").string();
    const auto curve = test::runProgram("curve " + scene + " --speed 25um/s --out " + table);
    ASSERT_EQ(curve.exitCode, 0) << curve.output;
    const std::vector<double> pull = readCsv(table).numbers("force_n");
    EXPECT_LT(*std::min_element(pull.begin(), pull.end()), -0.4e-9) << "of the drag alone";
    const auto map = test::runProgram("map " + scene + " --out " + scratch.file("m.gwy").string());
    EXPECT_EQ(map.exitCode, 1) << map.output;
    const std::string out = scratch.file("run").string();
    const auto run = test::runProgram("explore " + scene + " --no-pictures --out " + out);
    ASSERT_EQ(run.exitCode, 0) << run.output;
    const auto again = test::runProgram("replay " + out + " --out " + scratch.file("2").string());
    EXPECT_EQ(again.exitCode, 0) << again.output;
    EXPECT_NE(again.output.find("bit-identical"), std::string::npos) << again.output;
}

TEST_F(FitCommand, SaysWhyThereIsNoScene) {
    for (const auto& [options, reason] :
         {std::pair{"--tip cone:20deg", "that of the fit is a cone"},
          std::pair{"--tip pyramid4:20deg", "that of the fit is a pyramid4"},
          std::pair{"", "no tip is named"}}) {
        const auto run = fit(curveFile("a.csv") + " --force " + options);
        EXPECT_EQ(run.exitCode, 0) << run.output;
        EXPECT_NE(run.output.find(reason), std::string::npos) << run.output;
        EXPECT_FALSE(std::filesystem::exists(scratch.file("out") / "scene.toml")) << options;
    }
    EXPECT_EQ(fit(curveFile("a.csv") + " --force --tip paraboloid:5um").exitCode, 0);
    EXPECT_TRUE(std::filesystem::exists(scratch.file("out") / "scene.toml"));
}

TEST_F(FitCommand, RefusesWithItsFile) {
    const std::string bare = scratch.file("bare.csv").string();
    {
        std::ofstream file(bare);
        file << "segment,base_m,force_N\n";
        for (int i = 0; i < 100; ++i) {
            file << "approach," << 1e-8 * i << ',' << 1e-12 * ((i * 7919) % 13) << '\n';
        }
    }
    const auto run = fit(bare + " --tip sphere:5um");
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_NE(run.output.find("--stiffness"), std::string::npos) << run.output;
    EXPECT_EQ(json("fit.json")["verdict"], "refused");
    EXPECT_FALSE(std::filesystem::exists(scratch.file("out") / "curve.csv"));
}

TEST_F(FitCommand, OfManyCurvesABadOneEndsNothing) {
    const auto run =
        fit(curveFile("a.csv") + " " + curveFile("b.csv") + " missing.csv --tip sphere:5um");
    EXPECT_EQ(run.exitCode, 0) << run.output;
    const CsvTable table = readCsv(scratch.file("out") / "fits.csv");
    ASSERT_EQ(table.rows(), 3U);
    EXPECT_EQ(table.text(0, "verdict"), "matched");
    EXPECT_EQ(table.text(2, "verdict"), "unreadable");
    EXPECT_NE(table.text(2, "flags").find("missing.csv"), std::string::npos);
    const auto statistics = json("fits.json")["statistics"]["youngs_modulus_pa"];
    EXPECT_EQ(statistics["count"], 2);
    EXPECT_EQ(fit("missing.csv other.csv --force").exitCode, 1);
}

TEST_F(FitCommand, FitsAllCurvesOfAMapIntoImages) {
    const std::filesystem::path volume =
        test::sharedData("curves/original/20200903_Egel2.0_00023.spm");
    if (volume.empty()) {
        GTEST_SKIP() << "../shared/data is not beside this checkout";
    }
    const auto run = fit(volume.string() + " --tip pyramid4:20deg --all");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    const CsvTable table = readCsv(scratch.file("out") / "fits.csv");
    ASSERT_EQ(table.rows(), 256U);
    const std::filesystem::path path = scratch.file("out") / "maps.gwy";
    const ScanFile maps(path);
    const ScanChannel& modulus = channelNamed(maps.contents(), path, "Young's modulus");
    ASSERT_EQ(modulus.map.columns, 16);
    ASSERT_EQ(modulus.map.rows, 16);
    maps.forEachRow(modulus, [&](int row, std::span<const double> values) {
        for (std::size_t column = 0; column < values.size(); ++column) {
            const std::size_t curve = (static_cast<std::size_t>(15 - row) * 16) + column;
            EXPECT_EQ(std::isfinite(values[column]), table.text(curve, "verdict") != "refused");
            if (std::isfinite(values[column])) {
                EXPECT_EQ(values[column], table.number(curve, "youngs_modulus_pa")) << curve;
            }
        }
    });
    EXPECT_NE(test::runProgram("info " + (scratch.file("out") / "maps.gwy").string())
                  .output.find("Adhesion force, deviation by noise"),
              std::string::npos);
    EXPECT_EQ(fit(volume.string() + " --all --index 3 --force").exitCode, 2);
}

TEST_F(FitCommand, TellsUsageFromFiles) {
    EXPECT_EQ(fit("missing.csv").exitCode, 3);
    const std::string curve = curveFile("a.csv");
    for (const char* wrong : {"--tip sphere", "--tip cone:5um", "--tip sphere:5V",
                              "--tip conesphere:5um", "--tip ball:1", "--nu 0.6", "--stiffness 0",
                              "--range 5nN:1nN", "--law hertz", "--lever soft", "--columns base"}) {
        EXPECT_EQ(fit(curve + " " + wrong).exitCode, 2) << wrong;
    }
}

}  // namespace
}  // namespace asperity
