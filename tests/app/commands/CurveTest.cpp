#include "core/io/tables/CsvTable.h"
#include "tests/app/ProgramRun.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/ShippedScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace asperity {
namespace {

using test::ReferenceTable;

constexpr double kTolerance = 1e-9;
constexpr const char* kPaperMaterials =
    "--material silicon_oxide --material polystyrene --material silicone_rubber ";

std::string shippedName(const std::string& material) {
    return material == "SiO2" ? "silicon_oxide"
                              : (material == "PS" ? "polystyrene" : "silicone_rubber");
}

class CurveCommand : public ::testing::Test {
protected:
    /// The table of a run; its other output is in `said`.
    CsvTable tableOf(const std::string& arguments) {
        const auto out = scratch.file("curve.csv");
        const auto run = test::runProgram("curve " + arguments + " --out " + out.string());
        EXPECT_EQ(run.exitCode, 0) << run.output;
        said = run.output;
        return readCsv(out);
    }

    test::ScratchFolder scratch;
    std::string said;
};

/// The row before a jump of one branch of a material: the next one has the same base position.
std::optional<std::size_t> jumpOf(const CsvTable& table, const std::string& material,
                                  const std::string& way) {
    for (std::size_t row = 0; row + 1 < table.rows(); ++row) {
        if (table.text(row, "material") == material && table.text(row, "way") == way &&
            table.text(row + 1, "way") == way &&
            table.text(row, "base_position_m") == table.text(row + 1, "base_position_m")) {
            return row;
        }
    }
    return std::nullopt;
}

void expectNear(const CsvTable& ours, const std::pair<std::size_t, const char*>& cell,
                const ReferenceTable& theirs,
                const std::pair<std::size_t, const char*>& reference) {
    const double expected = theirs.number(reference.first, reference.second);
    EXPECT_NEAR(ours.number(cell.first, cell.second), expected, kTolerance * std::abs(expected))
        << reference.second;
}

void expectJumps(const CsvTable& ours, const ReferenceTable& table, std::size_t row) {
    const std::string material = shippedName(table.text(row, "material"));
    const auto in = jumpOf(ours, material, "approach");
    const auto off = jumpOf(ours, material, "retract");
    ASSERT_TRUE(in && off);
    expectNear(ours, {*in, "base_position_m"}, table, {row, "in_xb_m"});
    expectNear(ours, {*in, "force_n"}, table, {row, "in_P_N"});
    expectNear(ours, {*in + 1, "force_n"}, table, {row, "land_P_N"});
    expectNear(ours, {*in + 1, "indentation_m"}, table, {row, "land_delta_m"});
    expectNear(ours, {*in + 1, "contact_radius_m"}, table, {row, "land_a_m"});
    expectNear(ours, {*in + 1, "cohesive_radius_m"}, table, {row, "land_c_m"});
    expectNear(ours, {*off, "base_position_m"}, table, {row, "off_xb_m"});
    expectNear(ours, {*off, "force_n"}, table, {row, "off_P_N"});
    expectNear(ours, {*off, "indentation_m"}, table, {row, "off_delta_m"});
    expectNear(ours, {*off, "contact_radius_m"}, table, {row, "off_a_m"});
    expectNear(ours, {*off, "cohesive_radius_m"}, table, {row, "off_c_m"});
    expectNear(ours, {*off + 1, "force_n"}, table, {row, "after_P_N"});
}

/// docs/theory.md 3.5 with all digits, on levers of 0.5, 14 and 200 N/m.
TEST_F(CurveCommand, HasTheJumpsOfTheReference) {
    const ReferenceTable table = test::referenceTable("T21_split_spring_critical.csv");
    std::set<std::string> levers;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        levers.insert(table.text(row, "k"));
    }
    for (const std::string& lever : levers) {
        const CsvTable ours =
            tableOf(kPaperMaterials + ("--law split --points 20 --stiffness " + lever));
        for (std::size_t row = 0; row < table.rows(); ++row) {
            if (table.text(row, "k") == lever) {
                SCOPED_TRACE(table.text(row, "material") + " on " + lever + " N/m");
                expectJumps(ours, table, row);
            }
        }
    }
}

TEST_F(CurveCommand, TellsTheJumpsInAFewWords) {
    (void)tableOf(std::string(kPaperMaterials) + "--stiffness 14");
    for (const std::string part :
         {"silicon_oxide: R 15 nm",
          "law split (auto: ", "snap-in at base -0.493544 nm: force -1.82106 -> -7.92175 nN",
          "pull-off at base -1.33901 nm: force -17.887",
          "snap-in at base -0.449872 nm: force -0.600949 -> -4.90943 nN",
          "silicone_rubber: R 15 nm",
          "law split_sphere (auto: ", "law split (for comparison: formally",
          "snap-in at base -2.84108 nm: force -0.0106637 -> -1.4"}) {
        EXPECT_NE(said.find(part), std::string::npos) << part << "\nis not in\n" << said;
    }
}

TEST_F(CurveCommand, SaysWhereTheLeverIsBentTooFar) {
    (void)tableOf("--material silicon_oxide --radius 5000e-9 --stiffness 0.1 --points 20");
    EXPECT_NE(said.find("large_deflection at base "), std::string::npos) << said;
    (void)tableOf("--material silicon_oxide --stiffness 14 --points 20");
    EXPECT_EQ(said.find("large_deflection"), std::string::npos) << said;
}

/// The summary says of the whole curve what the table says of each point.
TEST_F(CurveCommand, SaysWhatTheLawDoesNotHoldFor) {
    (void)tableOf("--material silicon_oxide --law hertz --points 20");
    EXPECT_NE(said.find("law_out_of_range at base "), std::string::npos) << said;
    (void)tableOf("--material silicone_rubber --law split_sphere --points 20");
    EXPECT_EQ(said.find("law_out_of_range"), std::string::npos) << said;
    EXPECT_NE(said.find("large_contact at base "), std::string::npos) << said;
    EXPECT_NE(said.find("strain beyond linear elasticity"), std::string::npos) << said;
}

/// The smallest force of a branch [N].
double strongestIn(const CsvTable& table, const std::string& way) {
    double strongest = 0.0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.text(row, "way") == way) {
            strongest = std::min(strongest, table.number(row, "force_n"));
        }
    }
    return strongest;
}

/// On a stiff lever the tip pulls off with 1.91 nN, after it has pulled with 17.9.
TEST_F(CurveCommand, SaysTheStrongestPullBesideTheForceAtPullOff) {
    const CsvTable table =
        tableOf("--material silicon_oxide --law split --stiffness 200 --points 100");
    EXPECT_NE(said.find("pull-off at base -0.373998 nm: force -1.909"), std::string::npos) << said;
    EXPECT_NE(said.find("strongest pull of the law 17.9"), std::string::npos) << said;
    EXPECT_NEAR(strongestIn(table, "retract"), -17.9e-9, 0.05e-9);
    (void)tableOf("--law hertz --points 5");
    EXPECT_NE(said.find("the law never pulls"), std::string::npos) << said;
}

TEST_F(CurveCommand, SaysWhatModelAndCalibrationLeaveOpen) {
    (void)tableOf("--material silicon_oxide --law split --setpoint 5nN --points 20");
    EXPECT_NE(said.find("  adhesion force 17.9 nN ± 2 (tip radius, adhesion)"), std::string::npos)
        << said;
    EXPECT_NE(said.find("  normal force 5 nN ± 0.5 (k)"), std::string::npos) << said;
    for (const char* what : {"contact stiffness", "snap-in force", "snap-in distance", "hysteresis",
                             "work of separation"}) {
        const std::size_t line = said.find("  " + std::string(what) + " ");
        ASSERT_NE(line, std::string::npos) << what << '\n' << said;
        EXPECT_LT(said.find("±", line), said.find('\n', line)) << what;
    }
    const auto scene = scratch.file("certain.toml");
    std::ofstream(scene) << "[sample]\nshape = \"plane\"\n[uncertainty]\nenabled = false\n";
    (void)tableOf(scene.string() + " --points 20");
    EXPECT_EQ(said.find("±"), std::string::npos) << said;
}

/// On a lever so stiff the tip comes off with 0.45 pi w R: evenly placed points showed no more.
TEST_F(CurveCommand, FindsTheStrongestPullOfAColloid) {
    for (const std::string points : {"20", "500"}) {
        const CsvTable table = tableOf("--reduced-modulus 5e10 --radius 5e-6 --law split "
                                       "--material polystyrene --stiffness 1e5 --points " +
                                       points);
        const double unit = 3.14159265 * 0.066 * 5e-6;
        EXPECT_LT(strongestIn(table, "retract"), -1.5 * unit) << points;
        EXPECT_NE(said.find("E* 50 GPa"), std::string::npos) << said;
    }
}

TEST_F(CurveCommand, CoversTheBasePositionsAskedFor) {
    const CsvTable table = tableOf("--base -20nm:2e-9 --points 30");
    EXPECT_EQ(table.number(0, "base_position_m"), -20e-9);
    EXPECT_EQ(table.number(table.rows() - 1, "base_position_m"), -20e-9);
    double deepest = 0.0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        deepest = std::max(deepest, table.number(row, "base_position_m"));
    }
    EXPECT_EQ(deepest, 2e-9);
    // Never near enough to snap in: free both ways.
    const CsvTable far = tableOf("--base -20nm:-5nm --points 10");
    EXPECT_EQ(far.rows(), 20U);
    EXPECT_EQ(far.text(far.rows() - 1, "state"), "far");
    EXPECT_EQ(far.text(10, "state"), "far");
}

TEST_F(CurveCommand, EndsTheApproachAtTheSetpoint) {
    for (const std::string law : {"hertz", "split", "jkr", "md_sphere", "sneddon"}) {
        const CsvTable table = tableOf("--setpoint 25nN --points 30 --law " + law);
        double strongest = 0.0;
        for (std::size_t row = 0; row < table.rows(); ++row) {
            strongest = std::max(strongest, table.number(row, "force_n"));
        }
        EXPECT_NEAR(strongest, 25e-9, 1e-6 * 25e-9) << law;
    }
}

TEST_F(CurveCommand, KeepsTheTableApartFromWhatItSays) {
    const auto run = test::runProgram("curve --points 10 2>/dev/null | cat");
    const CsvTable table(run.output, "output");
    EXPECT_GE(table.rows(), 20U);
    EXPECT_EQ(table.text(0, "material"), "polystyrene");
    EXPECT_EQ(run.output.rfind("# Asperity ", 0), 0U);
}

/// The base moves by what the tip moves and the lever bends.
/// "0 m" alone read as exact.
TEST_F(CurveCommand, SaysWhyASnapInDistanceIsZero) {
    (void)tableOf("--material polystyrene --law jkr --points 20");
    EXPECT_NE(said.find("snap-in distance 0 m, by the form of the law\n"), std::string::npos)
        << said;
}

TEST_F(CurveCommand, FollowsEveryLawInBalanceWithTheLever) {
    for (const std::string law : {"hertz", "dmt", "jkr", "md", "sneddon", "jkr_sphere", "md_sphere",
                                  "split", "split_sphere", "auto"}) {
        SCOPED_TRACE(law);
        const CsvTable table = tableOf("--points 60 --stiffness 3 --law " + law);
        ASSERT_GE(table.rows(), 120U);
        for (std::size_t row = 0; row < table.rows(); ++row) {
            EXPECT_EQ(table.text(row, "law"), law == "auto" ? "split" : law);
            const double base = table.number(row, "base_position_m");
            const double balance =
                table.number(row, "indentation_m") + table.number(row, "force_n") / 3.0;
            EXPECT_NEAR(balance, base, 1e-12 * std::abs(base) + 1e-21);
        }
        const bool adhesive = law != "hertz" && law != "sneddon";
        EXPECT_EQ(jumpOf(table, "polystyrene", "approach").has_value(), adhesive);
        EXPECT_EQ(jumpOf(table, "polystyrene", "retract").has_value(), adhesive);
        EXPECT_EQ(said.find("none, the force is continuous") == std::string::npos, adhesive);
    }
}

TEST_F(CurveCommand, TakesTipAndLeverOfAScene) {
    const std::string content =
        "[sample]\nfile = \"" +
        (test::shippedScene("x").parent_path().parent_path() / "samples" / "steps.gsf").string() +
        "\"\n"
        "[tip]\nradius_m = 30e-9\n[physics]\nlaw = \"jkr\"\n";
    const std::string scene = scratch.write("scene.toml", content).string();
    const CsvTable asScene = tableOf(scene + " --points 5");
    EXPECT_EQ(asScene.text(0, "law"), "jkr");
    EXPECT_NE(said.find("R 30 nm"), std::string::npos) << said;
    (void)tableOf(scene + " --points 5 --radius 20e-9 --law dmt");
    EXPECT_NE(said.find("R 20 nm"), std::string::npos) << said;
    EXPECT_NE(said.find("law dmt"), std::string::npos) << said;
}

TEST_F(CurveCommand, SaysThatItLeavesOutAShape) {
    const auto saysSo = [this](const std::string& shape) {
        const auto scene = scratch.write("scene.toml", "[sample]\nshape = \"" + shape + "\"\n");
        (void)tableOf(scene.string() + " --points 5");
        return said.find("note: the curve is that of a flat sample") != std::string::npos;
    };
    EXPECT_TRUE(saysSo("sphere"));
    EXPECT_FALSE(saysSo("plane"));
}

TEST_F(CurveCommand, TakesAMaterialByNameOrFile) {
    const auto file =
        test::shippedScene("x").parent_path().parent_path() / "materials" / "polystyrene.toml";
    EXPECT_EQ(tableOf("--points 5 --material polystyrene").text(3, "force_n"),
              tableOf("--points 5 --material " + file.string()).text(3, "force_n"));
    const auto unknown = test::runProgram("curve --material unobtainium");
    EXPECT_EQ(unknown.exitCode, 3) << unknown.output;
    EXPECT_NE(unknown.output.find("silicone_rubber"), std::string::npos) << "names what it knows";
}

TEST_F(CurveCommand, NamesWrongOptions) {
    for (const auto& [arguments, part] :
         {std::pair<std::string, std::string>{"--law tabor", "--law"},
          {"--stiffness 0", "--stiffness"},
          {"--stiffness -1", "--stiffness"},
          {"--stiffness nan", "--stiffness"},
          {"--stiffness soft", "--stiffness"},
          {"--radius 0", "--radius"},
          {"--radius inf", "--radius"},
          {"--points 1", "--points"},
          {"--points 1e9", "--points"},
          {"--out ''", "--out"},
          {"--figure ''", "--figure"},
          {"--figure a.doc", "--figure"},
          {"--pace 3", "--pace"},
          {"--speed 3nm", "--speed"},
          {"--speed 0", "--speed"},
          {"--base 5nm", "--base"},
          {"--base 5nm:-5nm", "--base"},
          {"--base 5nN:9nN", "--base"},
          {"--setpoint 0", "--setpoint"},
          {"--setpoint 5nN --base 0:5nm", "--base"},
          {"--reduced-modulus 0", "--reduced-modulus"},
          {"--stiffness 1e-9", "--stiffness"},
          {"--radius 2", "--radius"}}) {
        const auto run = test::runProgram("curve " + arguments);
        EXPECT_EQ(run.exitCode, 2) << arguments << "\n" << run.output;
        EXPECT_NE(run.output.find(part), std::string::npos) << run.output;
    }
}

TEST_F(CurveCommand, SaysWhereItCannotReadOrWrite) {
    const auto noise = scratch.write("noise.toml", "= no scene");
    const auto run = test::runProgram("curve " + noise.string());
    EXPECT_EQ(run.exitCode, 3) << run.output;
    EXPECT_EQ(test::runProgram("curve /nonexistent.toml").exitCode, 3);
    EXPECT_EQ(test::runProgram("curve --material " + noise.string()).exitCode, 3);
    EXPECT_EQ(test::runProgram("curve --points 5 --out /proc/nothing.csv").exitCode, 3);
    EXPECT_EQ(test::runProgram("curve --points 5 --figure /proc/a.png", "DISPLAY=").exitCode, 3);
    EXPECT_EQ(test::runProgram("curve --law hertz_film").exitCode, 1);
}

TEST_F(CurveCommand, DrawsAFigureWithoutADisplay) {
    const auto figure = scratch.file("curves.png");
    const auto run = test::runProgram("curve --material polystyrene --figure " + figure.string() +
                                          " --out " + scratch.file("a.csv").string(),
                                      "DISPLAY=");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_GT(std::filesystem::file_size(figure), 5000U);
}

}  // namespace
}  // namespace asperity
