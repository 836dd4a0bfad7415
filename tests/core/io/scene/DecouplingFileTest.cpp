#include "core/Error.h"
#include "core/io/TextValue.h"
#include "core/io/scene/ProbeFile.h"
#include "core/io/tables/CsvTable.h"
#include "core/probe/ForceDecoupling.h"
#include "tests/core/probe/ReferenceLever.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <utility>

namespace asperity {
namespace {

using test::ReferenceTable;

constexpr const char* kHeader =
    "nx,ny,nz,vx,vy,vz,alpha_rad,theta_rad,friction_coefficient,shear_strength_pa,"
    "contact_area_m2,normal_force_model_n,normal_force_sigma_n,sigma_alpha_rad,sigma_theta_rad\n";
constexpr const char* kGoodRow =
    "0,0,1,1e-6,2e-6,0,1.4e-5,-4e-7,0.3,5e7,2e-17,2e-8,4.1e-9,1e-7,1e-7\n";

class DecouplingFile : public ::testing::Test {
protected:
    std::string textFor(const std::string& probe, const std::string& cases) {
        std::ostringstream out;
        writeForceEstimates(scratch.write("probe.toml", probe), scratch.write("cases.csv", cases),
                            out);
        return out.str();
    }

    CsvTable tableFor(const std::string& probe, const std::string& cases) {
        return {textFor(probe, cases), "output"};
    }

    std::string refusal(const std::string& probe, const std::string& cases) {
        return test::refusalOf([&] { (void)textFor(probe, cases); });
    }

    test::ScratchFolder scratch;
};

std::string probeOfRow(const ReferenceTable& table, std::size_t row) {
    const CantileverGeometry lever = test::referenceLever(table.text(row, "geom"));
    return "youngs_modulus_pa = " + exactText(lever.youngsModulus) +
           "\npoisson_ratio = " + exactText(lever.poissonRatio) +
           "\nlength_m = " + exactText(lever.length) + "\nwidth_m = " + exactText(lever.width) +
           "\nthickness_m = " + exactText(lever.thickness) +
           "\ntip_height_m = " + exactText(lever.tipHeight) +
           "\nmount_tilt_rad = " + exactText(table.number(row, "tilt")) + "\n";
}

std::string caseOfRow(const ReferenceTable& table, std::size_t row) {
    std::string line;
    for (const char* column : {"nx", "ny", "nz", "vx", "vy", "vz", "alpha", "theta", "mu_assumed",
                               "tau", "A", "N_model", "sigma_N"}) {
        line += table.text(row, column) + ",";
    }
    return line + "1e-7,1e-7\n";
}

/// T11's covariance is in the cantilever frame; the command's is in the lab's.
Matrix3 labCovarianceOfRow(const ReferenceTable& table, std::size_t row) {
    const auto cell = [&](const char* column) { return table.number(row, column); };
    Matrix3 local;
    local << cell("Cxx"), cell("Cxy"), cell("Cxz"),  //
        cell("Cxy"), cell("Cyy"), cell("Cyz"),       //
        cell("Cxz"), cell("Cyz"), cell("Czz");
    const double c = std::cos(cell("tilt"));
    const double s = std::sin(cell("tilt"));
    Matrix3 toLab;  // columns are the cantilever's axes
    toLab << c, 0.0, s, 0.0, 1.0, 0.0, -s, 0.0, c;
    return toLab * local * toLab.transpose();
}

void expectRow(const CsvTable& out, std::size_t line, const ReferenceTable& table,
               std::size_t row) {
    const auto given = [&](const char* column) { return out.number(line, column); };
    const Vector3 force(given("fx_n"), given("fy_n"), given("fz_n"));
    const Vector3 expected = test::vectorOfRow(table, row, "eF");
    EXPECT_LE((force - expected).norm(), 1e-10 * (expected.norm() + 1e-12));
    const Matrix3 covariance = labCovarianceOfRow(table, row);
    const std::map<std::string, std::pair<int, int>> entries{
        {"cxx_n2", {0, 0}}, {"cyy_n2", {1, 1}}, {"czz_n2", {2, 2}},
        {"cxy_n2", {0, 1}}, {"cxz_n2", {0, 2}}, {"cyz_n2", {1, 2}}};
    for (const auto& [name, indices] : entries) {
        const auto [i, j] = indices;
        EXPECT_NEAR(given(name.c_str()), covariance(i, j),
                    1e-10 * std::sqrt(covariance(i, i) * covariance(j, j)))
            << name;
    }
    const std::string kind = out.text(line, "case").substr(0, out.text(line, "case").find('|'));
    const double condition = table.number(row, "cond");
    const std::string& category = table.text(row, "cat");
    const bool rests = category == "static" || category == "normal_motion";
    EXPECT_EQ(kind, rests ? "no_sliding" : (condition > 100.0 ? "near_singular" : "regular"));
    if (condition < 1e6 && !rests) {
        EXPECT_NEAR(given("condition"), condition, 1e-9 * condition);
    }
}

TEST_F(DecouplingFile, HasTheReferenceForcesAndCovariancesInTheLabFrame) {
    const ReferenceTable table = test::referenceTable("T11_decoupling.csv");
    std::map<std::string, std::vector<std::size_t>> rowsOfProbe;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        rowsOfProbe[probeOfRow(table, row)].push_back(row);
    }
    EXPECT_GT(rowsOfProbe.size(), 3U) << "several levers, level and tilted";
    for (const auto& [probe, rows] : rowsOfProbe) {
        std::string cases = kHeader;
        for (const std::size_t row : rows) {
            cases += caseOfRow(table, row);
        }
        const CsvTable out = tableFor(probe, cases);
        ASSERT_EQ(out.rows(), rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            SCOPED_TRACE("row " + table.text(rows[i], "id") + " of T11");
            expectRow(out, i, table, rows[i]);
        }
    }
}

TEST_F(DecouplingFile, RepeatsTheInputAndAddsTheContractsColumns) {
    const std::string text = textFor("", "id," + std::string(kHeader) + "\"a, b\"," + kGoodRow);
    EXPECT_EQ(text.rfind("# Asperity ", 0), 0U);
    EXPECT_NE(text.find("lab frame"), std::string::npos);
    std::string header = kHeader;
    header.pop_back();
    EXPECT_NE(text.find("\nid," + header +
                        ",fx_n,fy_n,fz_n,cxx_n2,cyy_n2,czz_n2,cxy_n2,cxz_n2,cyz_n2,condition,"
                        "case\n"),
              std::string::npos)
        << text;
    const CsvTable out(text, "output");
    EXPECT_EQ(out.text(0, "id"), "a, b");
    EXPECT_EQ(out.text(0, "shear_strength_pa"), "5e7") << "as it was written";
}

/// The column is optional: 0 is the same as none, and a doubtful normal widens the covariance.
TEST_F(DecouplingFile, TakesADeviationOfTheNormal) {
    std::string header = kHeader;
    std::string row = kGoodRow;
    header.pop_back();
    row.pop_back();
    const CsvTable out = tableFor("", header + ",normal_deviation_rad\n" + row + ",0\n" + row +
                                          ",0.05\n" + row + ",-0.05\n");
    const CsvTable without = tableFor("", std::string(kHeader) + kGoodRow);
    for (const char* const column : {"fx_n", "fy_n", "fz_n", "cxx_n2", "cyy_n2", "czz_n2"}) {
        EXPECT_EQ(out.number(0, column), without.number(0, column)) << column;
    }
    EXPECT_GT(out.number(1, "cxx_n2"), 1.5 * out.number(0, "cxx_n2"));
    EXPECT_EQ(out.text(2, "case"), "invalid_input");
}

TEST_F(DecouplingFile, NamesRowsThatAreNoMeasurement) {
    const std::string good = kGoodRow;
    std::string cases = std::string(kHeader) + good;
    const std::string rest = "1e-6,2e-6,0,1.4e-5,-4e-7,0.3,5e7,2e-17,2e-8,4.1e-9,1e-7,1e-7\n";
    const std::string bad[] = {
        "0,0,0," + rest,
        "nan,0,1," + rest,
        "0,0,inf," + rest,
        "0,0,1e-310," + rest,
        "0,0,1,1e-6,2e-6,0,nan,-4e-7,0.3,5e7,2e-17,2e-8,4.1e-9,1e-7,1e-7\n",
        "0,0,1,1e-6,2e-6,0,1.4e-5,-4e-7,-0.3,5e7,2e-17,2e-8,4.1e-9,1e-7,1e-7\n",
        "0,0,1,1e-6,2e-6,0,1.4e-5,-4e-7,0.3,5e7,2e-17,-inf,4.1e-9,1e-7,1e-7\n",
        "0,0,1,1e-6,2e-6,0,1.4e-5,-4e-7,0.3,5e7,2e-17,2e-8,-4.1e-9,1e-7,1e-7\n",
        "0,0,1,1e-6,2e-6,0,1.4e-5,-4e-7,0.3,5e7,2e-17,2e-8,4.1e-9,0,1e-7\n",
        "0,0,1,1e-6,2e-6,0,1.4e-5,-4e-7,0.3,5e7,2e-17,2e-8,4.1e-9,1e-7,-1e-7\n",
    };
    for (const std::string& row : bad) {
        cases += row;
    }
    const CsvTable out = tableFor("", cases);
    ASSERT_EQ(out.rows(), 1U + std::size(bad));
    EXPECT_EQ(out.text(0, "case"), "regular");
    for (std::size_t row = 1; row < out.rows(); ++row) {
        EXPECT_EQ(out.text(row, "case"), "invalid_input") << out.line(row);
        EXPECT_TRUE(std::isnan(out.number(row, "fx_n")));
        EXPECT_TRUE(std::isnan(out.number(row, "condition")));
    }
}

TEST_F(DecouplingFile, TakesADenormalVelocityAsRest) {
    const CsvTable out =
        tableFor("", std::string(kHeader) +
                         "0,0,1,1e-310,0,0,1.4e-5,-4e-7,0.3,5e7,2e-17,2e-8,4.1e-9,1e-7,1e-7\n");
    EXPECT_EQ(out.text(0, "case"), "no_sliding");
    EXPECT_TRUE(std::isfinite(out.number(0, "fx_n")));
}

TEST_F(DecouplingFile, TakesVoltsOfACalibratedProbe) {
    const std::string probe = "inv_ols_m_v = 50e-9\nlateral_sensitivity_rad_v = 2e-4\n";
    // alpha = 3 / (2 l) inv_ols V = 5e-4 rad/V.
    const CsvTable radians = tableFor("", std::string(kHeader) + kGoodRow);
    std::string header = kHeader;
    for (const auto& [from, to] :
         {std::pair{"sigma_alpha_rad", "sigma_vertical_v"},
          std::pair{"sigma_theta_rad", "sigma_lateral_v"}, std::pair{"alpha_rad", "vertical_v"},
          std::pair{"theta_rad", "lateral_v"}}) {
        header.replace(header.find(from), std::string(from).size(), to);
    }
    const std::string row = "0,0,1,1e-6,2e-6,0,2.8e-2,-2e-3,0.3,5e7,2e-17,2e-8,4.1e-9,2e-4,5e-4\n";
    const CsvTable volts = tableFor(probe, header + row);
    for (const char* column : {"fx_n", "fy_n", "fz_n", "cxx_n2", "czz_n2", "cxz_n2"}) {
        EXPECT_NEAR(volts.number(0, column), radians.number(0, column),
                    1e-11 * std::abs(radians.number(0, column)))
            << column;
    }
    const std::string negative =
        "0,0,1,1e-6,2e-6,0,2.8e-2,-2e-3,0.3,5e7,2e-17,2e-8,4.1e-9,-2e-4,5e-4\n";
    EXPECT_EQ(tableFor(probe, header + negative).text(0, "case"), "invalid_input");
    EXPECT_NE(refusal("", header + row).find("inv_ols_m_v"), std::string::npos);
    header.replace(header.find("nx"), 2, "alpha_rad");
    EXPECT_NE(refusal(probe, header + row).find("either alpha_rad"), std::string::npos);
}

TEST_F(DecouplingFile, RefusesWhatItCannotReadWithFileAndLine) {
    const std::string header = kHeader;
    const std::string row = kGoodRow;
    const std::string word = "0,0,one,1e-6,2e-6,0,1e-5,0,0.3,5e7,2e-17,2e-8,4e-9,1e-7,1e-7\n";
    const std::string empty = "0,0,,1e-6,2e-6,0,1e-5,0,0.3,5e7,2e-17,2e-8,4e-9,1e-7,1e-7\n";
    std::string noNormal = header;
    noNormal.replace(0, 3, "");
    const std::pair<std::string, std::string> mistakes[] = {
        {header + row + word, "cases.csv: line 3: column 'nz': expected a number, found 'one'"},
        {header + empty, "found ''"},
        {noNormal, "there is no column 'nx'"},
        {header + "1,2\n", "line 2"},
        {"fx_n," + header + "1," + row, "'fx_n'"},
        {"# nothing\n", "names the columns"},
    };
    for (const auto& [cases, expected] : mistakes) {
        const std::string said = refusal("", cases);
        EXPECT_NE(said.find(expected), std::string::npos) << cases << "said: " << said;
        EXPECT_NE(said.find("cases.csv"), std::string::npos) << said;
    }
    EXPECT_NE(refusal("length_m = 0\n", header + row).find("probe.toml"), std::string::npos);
    std::ostringstream out;
    EXPECT_THROW(writeForceEstimates(scratch.file("none.toml"), scratch.file("none.csv"), out),
                 InputError);
    EXPECT_TRUE(out.str().empty());
}

TEST_F(DecouplingFile, WritesOnlyAHeaderForNoCases) { EXPECT_EQ(tableFor("", kHeader).rows(), 0U); }

}  // namespace
}  // namespace asperity
