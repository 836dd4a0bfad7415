#include "core/io/tables/CsvTable.h"
#include "tests/app/ProgramRun.h"
#include "tests/app/commands/CaseRuns.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace asperity {
namespace {

using test::contactTable;
using test::kContactHeader;

/// Polystyrene under the paper's tip, 1 nm deep.
constexpr std::array<const char*, 7> kGoodCells{"md",     "15e-9", "2.35e9", "0.066",
                                                "1.85e8", "1e-9",  "retract"};

/// The good line with another text in one of its cells.
std::string lineWith(std::size_t column, const std::string& cell) {
    std::string line;
    for (std::size_t i = 0; i < kGoodCells.size(); ++i) {
        line += (i == 0 ? "" : ",") + (i == column ? cell : std::string(kGoodCells[i]));
    }
    return line + "\n";
}

std::string goodLine() { return lineWith(kGoodCells.size(), ""); }

class Contact : public ::testing::Test {
protected:
    /// Runs the command on a file of this content.
    test::ProgramRun runOn(const std::string& content, const std::string& more = {}) {
        return test::runProgram("contact --cases " + scratch.write("cases.csv", content).string() +
                                " " + more);
    }

    /// Exit 3 and one sentence that names the file.
    void expectRefusal(const std::string& content, const std::string& part) {
        const auto run = runOn(content);
        EXPECT_EQ(run.exitCode, 3) << run.output;
        EXPECT_EQ(run.output.rfind("asperity: " + scratch.file("cases.csv").string(), 0), 0U)
            << run.output;
        EXPECT_NE(run.output.find(part), std::string::npos) << run.output;
        EXPECT_EQ(run.output.find('\n'), run.output.size() - 1) << run.output;
    }

    test::ScratchFolder scratch;
};

/// By Hertz the force is proportional to E* and the root of R.
TEST_F(Contact, SaysWhatStatedDeviationsLeaveOpen) {
    const std::string header = "model,radius_m,e_star_pa,work_of_adhesion_j_m2,sigma0_pa,"
                               "indentation_m,branch,radius_deviation,e_star_deviation\n";
    const auto out = scratch.file("out.csv");
    const auto run =
        runOn(header + "hertz,15e-9,2.35e9,0,0,1e-9,retract,0.1,0.2\n", "--out " + out.string());
    ASSERT_EQ(run.exitCode, 0) << run.output;
    const CsvTable table = readCsv(out);
    const double force = table.number(0, "force_n");
    const double byRadius = 0.5 * (std::sqrt(1.1) - 1.0 / std::sqrt(1.1));
    const double byModulus = 0.5 * (1.2 - 1.0 / 1.2);
    const double expected = force * std::hypot(byRadius, byModulus);
    EXPECT_NEAR(table.number(0, "force_sigma_n"), expected, 1e-9 * expected);
    EXPECT_EQ(table.text(0, "force_sigma_by"), "e_star");
    expectRefusal(header + "hertz,15e-9,2.35e9,0,0,1e-9,retract,0.1,-0.2\n",
                  "e_star_deviation must lie between 0 and 1");
}

TEST_F(Contact, NamesWhatIsWrongWithACase) {
    const std::vector<std::string> cells{"nan", "inf", "-inf", "1e-320", "0", "-1"};
    const std::string outside = "_out_of_range";
    const std::vector<std::vector<std::string>> statuses{
        std::vector<std::string>(6, "tip_radius" + outside),
        std::vector<std::string>(6, "modulus" + outside),
        {"adhesion" + outside, "adhesion" + outside, "adhesion" + outside, "ok", "ok",
         "adhesion" + outside},
        std::vector<std::string>(6, "cohesive_stress" + outside),
        {"approach" + outside, "approach" + outside, "approach" + outside, "ok", "ok",
         "law_out_of_range"}};  // the paraboloid's adhesion will reach too far
    std::string lines;
    for (std::size_t number = 0; number < statuses.size(); ++number) {
        for (const std::string& cell : cells) {
            lines += lineWith(number + 1, cell);  // after the model
        }
    }
    const CsvTable out = contactTable(lines);
    ASSERT_EQ(out.rows(), statuses.size() * cells.size());
    for (std::size_t row = 0; row < out.rows(); ++row) {
        SCOPED_TRACE("row " + std::to_string(row));
        const std::string& expected = statuses[row / cells.size()][row % cells.size()];
        EXPECT_EQ(out.text(row, "status"), expected);
        const bool solved = expected == "ok" || expected == "law_out_of_range";
        EXPECT_EQ(std::isfinite(out.number(row, "force_n")), solved);
        EXPECT_EQ(std::isfinite(out.number(row, "contact_radius_m")), solved);
        EXPECT_EQ(std::isfinite(out.number(row, "lambda")), solved);
        EXPECT_EQ(out.text(row, "state") == "none", !solved);
    }
}

TEST_F(Contact, HasNoFilmWithoutItsThicknessAndPoissonRatio) {
    const std::string thickness = "film_thickness_out_of_range";
    const std::string poisson = "poisson_ratio_out_of_range";
    EXPECT_EQ(contactTable(lineWith(0, "hertz_film")).text(0, "status"), thickness);
    const std::vector<std::pair<std::string, std::string>> films{
        {"0,0.5", thickness},     {"nan,0.5", thickness}, {"-1e-9,0.5", thickness},
        {"1e-13,0.5", thickness}, {"2,0.5", thickness},   {"1e-7,0.51", poisson},
        {"1e-7,-0.1", poisson},   {"1e-7,nan", poisson},  {"1e-7,0.5", "ok"},
        {"1e-7,0", "ok"}};
    std::string lines;
    for (const auto& [film, status] : films) {
        lines += "hertz_film,15e-9,2.35e9,0,0,1e-10,retract," + film + "\n";
    }
    const CsvTable out = contactTable(lines, test::kFilmHeader);
    for (std::size_t row = 0; row < films.size(); ++row) {
        EXPECT_EQ(out.text(row, "status"), films[row].second) << films[row].first;
        EXPECT_EQ(std::isfinite(out.number(row, "force_n")), films[row].second == "ok");
    }
    expectRefusal(test::kFilmHeader +
                      std::string("hertz,15e-9,2.35e9,0,0,1e-10,retract,thin,0.5\n"),
                  "line 2: column 'film_thickness_m'");
}

/// Rows of nan with exit code 0 were an answer to a slip in a law's name.
TEST_F(Contact, RefusesALawOrABranchThatItDoesNotKnow) {
    for (const std::string cell : {"", "nan", "1", "MD", "mdt"}) {
        expectRefusal(kContactHeader + goodLine() + lineWith(0, cell),
                      "line 3: column 'model': expected one of hertz, ");
        expectRefusal(kContactHeader + goodLine() + lineWith(6, cell),
                      "line 3: column 'branch': expected one of approach, retract, found '" + cell +
                          "'");
    }
}

/// Two rows of T25 (20 degrees, a = 2 R, w = 0 and 0.01 E* R), and what has no cone.
TEST_F(Contact, HasTheConeOfTheTip) {
    const std::string header =
        std::string(kContactHeader).substr(0, std::string(kContactHeader).size() - 1) +
        ",cone_half_angle_rad\n";
    const CsvTable out =
        contactTable("sneddon,1,1,0,0,6.649984875718411118,retract,0.34906585039886592\n"
                     "jkr_sphere,1,1,0.01,0,6.295494105537307913,retract,0.34906585039886592\n"
                     "md_sphere,1,1,0.01,1e6,6.295494105537307913,retract,0.34906585039886592\n"
                     "sneddon,1,1,0,0,1,retract,1.6\n"
                     "sneddon,1,1,0,0,1,retract,nan\n"
                     "hertz,1,1,0,0,1,retract,0.35\n"
                     "md,1,1,0.01,1,1,retract,0.35\n"
                     "md,1,1,0.01,1,1,retract,0\n",
                     header);
    EXPECT_NEAR(out.number(0, "force_n"), 16.81503808879238025, 1e-11);
    EXPECT_NEAR(out.number(1, "force_n"), 15.39707500806796743, 1e-11);
    EXPECT_NEAR(out.number(1, "contact_radius_m"), 2.0, 1e-12);
    EXPECT_NEAR(out.number(2, "force_n"), 15.39707500806796743, 1e-8) << "of hardly any range";
    EXPECT_EQ(out.text(0, "status"), "large_contact");
    EXPECT_EQ(out.text(2, "status"), "large_contact");
    EXPECT_EQ(out.text(3, "status"), "cone_half_angle_out_of_range");
    EXPECT_EQ(out.text(5, "status"), "law_without_cone");
    EXPECT_EQ(out.text(6, "status"), "law_without_cone");
    EXPECT_TRUE(out.text(7, "status").ends_with("large_contact")) << out.text(7, "status");
}

TEST_F(Contact, WarnsOfALargeContact) {
    EXPECT_EQ(contactTable(lineWith(5, "2e-9")).text(0, "status"), "law_out_of_range|large_contact")
        << "a paraboloid whose adhesion reaches too far";
    EXPECT_EQ(contactTable(lineWith(5, "1e-10")).text(0, "status"), "ok");
    EXPECT_EQ(contactTable("md_sphere,15e-9,2.35e9,0.066,1.85e8,2e-9,retract\n").text(0, "status"),
              "large_contact")
        << "the sphere is exact: its strain is too large all the same";
    EXPECT_EQ(contactTable("md_sphere,1e-10,1e10,0.05,1.4e8,-1e-10,retract\n").text(0, "status"),
              "cohesive_zone_at_equator");
    EXPECT_EQ(contactTable("sneddon,15e-9,2e9,0,0,1e-7,retract\n").text(0, "status"),
              "beyond_sphere|large_contact");
}

/// Silicon oxide under the paper's tip: four forces of which one is right.
TEST_F(Contact, SaysWhereALawLeavesOutWhatActs) {
    const std::string cell = ",15e-9,53e9,0.2,0,1e-10,retract\n";
    const std::string zone = "md,15e-9,53e9,0.2,5.6e8,1e-10,retract\n";
    const CsvTable out =
        contactTable("hertz" + cell + "dmt" + cell + "jkr" + cell + zone + "split" + cell);
    for (const auto& [row, force] : {std::pair<std::size_t, double>{0, 8.65e-9},
                                     {1, -10.2e-9},
                                     {2, -2.33e-9},
                                     {3, -4.64e-9}}) {
        EXPECT_NEAR(out.number(row, "force_n"), force, 0.005 * std::abs(force));
        EXPECT_EQ(out.text(row, "status"), row == 3 ? "ok" : "law_out_of_range") << row;
    }
    EXPECT_EQ(out.text(4, "status"), "ok");
}

/// lambda 5.2 under an attraction of 1 nm, 2.6 under one of 2 nm: JKR holds above 4.8.
TEST_F(Contact, JudgesALawWithoutAZoneByTheReachThatTheTableStates) {
    const std::string cell = "jkr,10e-6,1e8,0.01,";
    const CsvTable out = contactTable(cell + "1e7,1e-8,retract\n" + cell + "0.5e7,1e-8,retract\n" +
                                      cell + "0,1e-8,retract\n");
    EXPECT_EQ(out.text(0, "status"), "ok");
    EXPECT_EQ(out.text(1, "status"), "law_out_of_range");
    EXPECT_EQ(out.text(2, "status"), "ok");
    EXPECT_EQ(out.text(0, "force_n"), out.text(1, "force_n"));
}

/// At nu = 0.5 the film's force is 5 % above a half-space's from a/t = 0.042 on.
TEST_F(Contact, WarnsOfAThinFilm) {
    const CsvTable out = contactTable("hertz,1e-6,1e9,0,0,1.6e-11,retract,1e-7,0.5\n"
                                      "hertz,1e-6,1e9,0,0,2.0e-11,retract,1e-7,0.5\n"
                                      "hertz,1e-6,1e9,0,0,2.0e-11,retract,1e-7,0\n"
                                      "hertz,1e-6,1e9,0,0,2.0e-11,retract,0,0.5\n"
                                      "hertz_film,1e-6,1e9,0,0,1.8e-8,retract,1e-7,0.5\n"
                                      "hertz_film,1e-6,1e9,0,0,1.9e-8,retract,1e-7,0.5\n"
                                      "hertz,15e-9,1e9,0,0,5e-9,retract,2e-9,0.3\n",
                                      test::kFilmHeader);
    const std::vector<std::string> expected{
        "ok", "thin_film", "ok", "ok", "ok", "thin_film", "thin_film|large_contact"};
    for (std::size_t row = 0; row < expected.size(); ++row) {
        EXPECT_EQ(out.text(row, "status"), expected[row]) << row;
        EXPECT_GT(out.number(row, "force_n"), 0.0);
    }
}

TEST_F(Contact, BringsRubberIntoContactAcrossTheGap) {
    const CsvTable out = contactTable("split_sphere,15e-9,1.3333e6,0.022,6.1663e7,-3e-9,approach\n"
                                      "split_sphere,15e-9,1.3333e6,0.022,6.1663e7,-2e-9,approach\n"
                                      "split_sphere,1e-10,1e10,0.05,1.4e8,-1e-10,retract\n");
    EXPECT_EQ(out.text(0, "state"), "far");
    EXPECT_LT(out.number(0, "force_n"), -1e-12) << "the tail";
    EXPECT_EQ(out.text(1, "state"), "contact");
    EXPECT_LT(out.number(1, "force_n"), -3e-10);
    EXPECT_LT(out.number(1, "contact_radius_m"), 15e-9) << "no wider than the sphere";
    EXPECT_EQ(out.text(2, "status"), "cohesive_zone_at_equator");
}

TEST_F(Contact, RemembersTheBranch) {
    const CsvTable out = contactTable("md,15e-9,2.35e9,0.066,1.85e8,-3e-10,approach\n"
                                      "md,15e-9,2.35e9,0.066,1.85e8,-3.6e-10,approach\n"
                                      "md,15e-9,2.35e9,0.066,1.85e8,-3.6e-10,retract\n");
    EXPECT_NE(out.text(0, "state"), "far") << "snapped in";
    EXPECT_EQ(out.text(1, "state"), "far");
    EXPECT_EQ(out.number(1, "force_n"), 0.0);
    EXPECT_NE(out.text(2, "state"), "far") << "still bonded";
    EXPECT_LT(out.number(2, "force_n"), 0.0);
}

TEST_F(Contact, SaysWhereACellIsNoNumber) {
    for (std::size_t column = 1; column < 6; ++column) {
        for (const std::string cell : {"", "text", "1e-9 m", "1,5", "0x10", "1e999"}) {
            SCOPED_TRACE(cell);
            expectRefusal(kContactHeader + goodLine() + lineWith(column, cell), "line 3: ");
        }
    }
    expectRefusal(kContactHeader + lineWith(1, "text"),
                  "line 2: column 'radius_m': expected a number, found 'text'");
}

TEST_F(Contact, WritesNothingUnlessAllCanBeRead) {
    const auto out = scratch.file("out.csv");
    const auto run =
        runOn(kContactHeader + goodLine() + lineWith(2, "soft"), "--out " + out.string());
    EXPECT_EQ(run.exitCode, 3) << run.output;
    EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(Contact, RefusesColumnsThatDoNotFit) {
    std::string missing = kContactHeader;
    missing.replace(missing.find("sigma0_pa"), 9, "stress");
    expectRefusal(missing, "'sigma0_pa'");
    expectRefusal("model," + std::string(kContactHeader) + "md," + goodLine(),
                  "two columns 'model'");
    expectRefusal("lambda," + std::string(kContactHeader) + "1," + goodLine(), "'lambda'");
    expectRefusal(kContactHeader + goodLine() + "md,15e-9\n", "line 3: expected 7 cells");
    expectRefusal(kContactHeader + lineWith(0, "\"md"), "line 2: a quoted cell is not closed");
}

TEST_F(Contact, RefusesWhatIsNoTable) {
    expectRefusal("", "the file is empty");
    expectRefusal("# only a remark\n", "names the columns");
    expectRefusal({'\x89', 'P', 'N', 'G', '\r', '\n', '\0', '\xff', ',', '\0', '\n'}, "");
    const auto folder = test::runProgram("contact --cases " + scratch.path().string());
    EXPECT_EQ(folder.exitCode, 3) << folder.output;
    const auto none = test::runProgram("contact --cases /nonexistent.csv");
    EXPECT_EQ(none.exitCode, 3) << none.output;
}

TEST_F(Contact, SaysWhereItCannotWrite) {
    for (const std::string out : {"/proc/nothing.csv", "/nonexistent/out.csv", "/", "/dev"}) {
        const auto run = runOn(kContactHeader + goodLine(), "--out " + out);
        EXPECT_EQ(run.exitCode, 3) << out << run.output;
        EXPECT_EQ(run.output.rfind("asperity: " + out, 0), 0U) << run.output;
    }
    const auto full = runOn(kContactHeader + goodLine(), ">/dev/full");
    EXPECT_EQ(full.exitCode, 1) << full.output;
    EXPECT_EQ(runOn(kContactHeader, "--out ''").exitCode, 2);
    EXPECT_EQ(test::runProgram("contact").exitCode, 2);
}

TEST_F(Contact, AnswersNoCasesWithAHeader) {
    const auto run = runOn(kContactHeader);
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_EQ(CsvTable(run.output, "output").rows(), 0U);
    EXPECT_TRUE(CsvTable(run.output, "output").has("status"));
}

TEST_F(Contact, ReadsTablesAsSpreadsheetsWriteThem) {
    const std::string expected = contactTable(goodLine()).text(0, "force_n");
    const auto run = runOn("\xEF\xBB\xBF# from a spreadsheet\r\n\r\nid," +
                           std::string("model,radius_m,e_star_pa,work_of_adhesion_j_m2,sigma0_pa,"
                                       "indentation_m,branch\r\n") +
                           "\"one, \"\"first\"\"\",\"md\", 15e-9 ,\"2.35e9\",+0.066,1.85e8,1e-9,"
                           "retract\r\n# between\r\n");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    const CsvTable out(run.output, "output");
    ASSERT_EQ(out.rows(), 1U);
    EXPECT_EQ(out.text(0, "id"), "one, \"first\"");
    EXPECT_EQ(out.text(0, "force_n"), expected);
    EXPECT_EQ(out.columns().front(), "id");
    EXPECT_EQ(out.columns().back(), "status");
}

}  // namespace
}  // namespace asperity
