#include "core/io/tables/CsvTable.h"
#include "tests/app/ProgramRun.h"
#include "tests/support/Places.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

namespace asperity {
namespace {

constexpr const char* kHeader =
    "nx,ny,nz,vx,vy,vz,alpha_rad,theta_rad,friction_coefficient,shear_strength_pa,"
    "contact_area_m2,normal_force_model_n,normal_force_sigma_n,sigma_alpha_rad,sigma_theta_rad\n";

std::string shippedProbe(const std::string& name) {
    return test::dataFolder().string() + "/probes/" + name + ".toml";
}

std::string callFor(const std::string& probe, const std::filesystem::path& cases) {
    return "decouple --probe " + probe + " --cases " + cases.string();
}

/// T11 for the shipped lever of the paper, which is the table's first.
TEST(Decouple, GivesTheReferenceForces) {
    const test::ReferenceTable table = test::referenceTable("T11_decoupling.csv");
    const test::ScratchFolder scratch;
    std::string cases = kHeader;
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.text(row, "geom") != "G1_k14" || table.number(row, "tilt") != 0.0) {
            continue;
        }
        rows.push_back(row);
        for (const char* column : {"nx", "ny", "nz", "vx", "vy", "vz", "alpha", "theta",
                                   "mu_assumed", "tau", "A", "N_model", "sigma_N"}) {
            cases += table.text(row, column) + ",";
        }
        cases += "1e-7,1e-7\n";
    }
    const auto run = test::runProgram(
        callFor(shippedProbe("silicon_14_n_m"), scratch.write("cases.csv", cases)));
    ASSERT_EQ(run.exitCode, 0) << run.output;
    const CsvTable out(run.output, "output");
    ASSERT_EQ(out.rows(), rows.size());
    ASSERT_GT(rows.size(), 50U);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        SCOPED_TRACE(table.text(rows[i], "id"));
        const double size = std::hypot(table.number(rows[i], "eFx"), table.number(rows[i], "eFy"),
                                       table.number(rows[i], "eFz"));
        for (const auto& [ours, theirs] :
             {std::pair{"fx_n", "eFx"}, std::pair{"fy_n", "eFy"}, std::pair{"fz_n", "eFz"}}) {
            EXPECT_NEAR(out.number(i, ours), table.number(rows[i], theirs), 1e-10 * size);
        }
        const double variance = table.number(rows[i], "Cxx");
        EXPECT_NEAR(out.number(i, "cxx_n2"), variance, 1e-10 * variance);
    }
}

TEST(Decouple, SaysWhatItWantsAndWhatIsWrong) {
    EXPECT_EQ(test::runProgram("decouple --help").exitCode, 0);
    EXPECT_EQ(test::runProgram("decouple").exitCode, 2);
    EXPECT_EQ(test::runProgram("decouple --probe a.toml").exitCode, 2);
    const test::ScratchFolder scratch;
    const auto word = scratch.write(
        "word.csv", std::string(kHeader) + "0,0,up,0,0,0,1e-5,0,0.3,0,0,2e-8,4e-9,1e-7,1e-7\n");
    const auto run = test::runProgram(callFor(shippedProbe("silicon_14_n_m"), word));
    EXPECT_EQ(run.exitCode, 3);
    EXPECT_EQ(run.output, "asperity: " + word.string() +
                              ": line 2: column 'nz': expected a number, found 'up'\n");
    const auto noProbe = test::runProgram(callFor("/nonexistent.toml", word));
    EXPECT_EQ(noProbe.exitCode, 3) << noProbe.output;
    const auto noCases =
        test::runProgram(callFor(shippedProbe("silicon_14_n_m"), "/nonexistent.csv"));
    EXPECT_EQ(noCases.exitCode, 3) << noCases.output;
}

TEST(Decouple, NamesARowThatIsNoMeasurement) {
    const test::ScratchFolder scratch;
    const auto cases = scratch.write(
        "cases.csv", std::string(kHeader) + "0,0,nan,0,0,0,1e-5,0,0.3,0,0,2e-8,4e-9,1e-7,1e-7\n");
    const auto run = test::runProgram(callFor(shippedProbe("calibrated_2_8_n_m"), cases));
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_EQ(CsvTable(run.output, "output").text(0, "case"), "invalid_input");
}

constexpr const char* kGoodRow =
    "0,0,1,1e-6,2e-6,0,1.4e-5,-4e-7,0.3,5e7,2e-17,2e-8,4.1e-9,1e-7,1e-7\n";

TEST(Decouple, WritesAFileAndNothingWhenACellIsNoNumber) {
    const test::ScratchFolder scratch;
    const std::string out = scratch.file("out.csv").string();
    const std::string probe = shippedProbe("silicon_14_n_m");
    const auto bad = scratch.write("bad.csv", std::string(kHeader) + kGoodRow +
                                                  "0,0,1,,2e-6,0,0,0,"
                                                  "0.3,5e7,2e-17,2e-8,4.1e-9,1e-7,1e-7\n");
    const auto refused = test::runProgram(callFor(probe, bad) + " --out " + out);
    EXPECT_EQ(refused.exitCode, 3) << refused.output;
    EXPECT_FALSE(std::filesystem::exists(out));

    const auto good = scratch.write("good.csv", std::string(kHeader) + kGoodRow);
    const auto run = test::runProgram(callFor(probe, good) + " --out " + out);
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_EQ(run.output, "");
    EXPECT_EQ(test::contentOf(out), test::runProgram(callFor(probe, good)).output);
}

TEST(Decouple, SaysWhatDoesNotFit) {
    const test::ScratchFolder scratch;
    const std::string probe = shippedProbe("silicon_14_n_m");
    const auto twice = scratch.write("twice.csv", "case," + std::string(kHeader) + "1," + kGoodRow);
    const auto run = test::runProgram(callFor(probe, twice));
    EXPECT_EQ(run.exitCode, 3);
    EXPECT_EQ(run.output, "asperity: " + twice.string() +
                              ": header: the column 'case' is one that is added here\n");
    const auto good = scratch.write("good.csv", std::string(kHeader) + kGoodRow);
    EXPECT_EQ(test::runProgram(callFor(probe, good) + " --out /proc/a.csv").exitCode, 3);
    EXPECT_EQ(test::runProgram(callFor(probe, good) + " --out ''").exitCode, 2);
    EXPECT_EQ(test::runProgram("decouple --probe '' --cases " + good.string()).exitCode, 2);
    EXPECT_EQ(test::runProgram(callFor(good.string(), good)).exitCode, 3) << "no probe file";
    EXPECT_EQ(test::runProgram(callFor(probe, scratch.path())).exitCode, 3) << "a folder";
}

}  // namespace
}  // namespace asperity
