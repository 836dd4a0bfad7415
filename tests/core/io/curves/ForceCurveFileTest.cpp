#include "core/io/curves/ForceCurveFile.h"

#include "core/Error.h"
#include "core/curves/AlignedForceCurve.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace asperity {
namespace {

using test::ReferenceTable;
using test::ScratchFolder;

std::string refusalOf(const std::filesystem::path& file) {
    try {
        static_cast<void>(readForceCurve(file));
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

bool holds(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

/// Compares one segment with a row of EXPECTED_READ.csv; the tables hold 7 to 9 digits.
void expectSegment(const CurveSegment& segment, const ReferenceTable& table, std::size_t row) {
    EXPECT_EQ(nameOf(segment.kind), table.text(row, "kind"));
    ASSERT_EQ(static_cast<double>(segment.force.size()), table.number(row, "points"));
    const auto near = [&](double value, const char* column) {
        const double expected = table.number(row, column);
        EXPECT_NEAR(value, expected, 1e-6 * std::abs(expected)) << column;
    };
    near(segment.base.front(), "first_base_m");
    near(segment.force.front(), "first_force_N");
    near(*std::max_element(segment.force.begin(), segment.force.end()), "max_force_N");
    near(*std::min_element(segment.force.begin(), segment.force.end()), "min_force_N");
    if (!table.text(row, "first_deflection_m").empty() &&
        table.text(row, "first_deflection_m") != "nan") {
        near(segment.deflection.front(), "first_deflection_m");
    }
}

TEST(ForceCurveFile, ReadsAllTablesOfTheMeasuredCurves) {
    ASPERITY_NEEDS_SHARED_DATA();
    const ReferenceTable table(test::sharedData("curves/EXPECTED_READ.csv"));
    int checked = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string name = table.text(row, "curve");
        SCOPED_TRACE(name + ", segment " + table.text(row, "segment"));
        const std::filesystem::path file = test::sharedData("curves/csv/" + name + ".csv");
        if (!std::filesystem::exists(file)) {
            continue;
        }
        const MeasuredForceCurve curve = readForceCurve(file);
        const auto segment = static_cast<std::size_t>(table.number(row, "segment"));
        ASSERT_LT(segment, curve.segments.size());
        expectSegment(curve.segments[segment], table, row);
        ++checked;
    }
    EXPECT_GE(checked, 26);
}

TEST(ForceCurveFile, ReadsAfmWorkshopsTableInPairsOfColumns) {
    ASPERITY_NEEDS_SHARED_DATA();
    const MeasuredForceCurve curve = readForceCurve(
        test::sharedData("curves/original/fmt-afm-workshop-fd_single_2021-10-22_14.16.csv"));
    const MeasuredForceCurve exported =
        readForceCurve(test::sharedData("curves/csv/workshop2021_csv.csv"));
    ASSERT_EQ(curve.segments.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(curve.segments[i].kind, exported.segments[i].kind);
        ASSERT_EQ(curve.segments[i].force.size(), exported.segments[i].force.size());
        EXPECT_NEAR(curve.segments[i].base.back(), exported.segments[i].base.back(), 1e-12);
        EXPECT_NEAR(curve.segments[i].force.back(), exported.segments[i].force.back(), 1e-15);
    }
}

TEST(ForceCurveFile, RefusesWhatItCannotReadInWords) {
    ScratchFolder folder;
    EXPECT_TRUE(holds(refusalOf(folder.write("a.dat", std::string("\x01\x00\x02", 3))),
                      "holds binary data of no known format of force curves"));
    EXPECT_TRUE(holds(refusalOf(folder.write("a.txt", "a letter\n")), "no line names"));
    EXPECT_TRUE(holds(refusalOf(folder.write(
                          "a.dat", "Experiment\tZ spectroscopy\t\nX (m)\t1\n\n[DATA]\n1\t2\n")),
                      "force curves (Nanonis spectroscopy, .dat), which are not read"));
}

TEST(ForceCurveFile, RefusesAThermalSpectrumByName) {
    ASPERITY_NEEDS_SHARED_DATA();
    EXPECT_TRUE(
        holds(refusalOf(test::sharedData("curves/original/thermal.nid")), "a thermal spectrum"));
}

TEST(ForceCurveFile, SaysWhichCurvesThereAre) {
    ScratchFolder folder;
    const auto file = folder.write("a.csv", "z [nm],force [nN]\n1,2\n2,3\n");
    try {
        static_cast<void>(readForceCurve(file, 3));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_TRUE(holds(error.what(), "there is no curve 3: the file holds one")) << error.what();
    }
}

TEST(ForceCurveFile, AlignsTheCurvesWhoseContactIsKnown) {
    ASPERITY_NEEDS_SHARED_DATA();
    // A sharp tip in air, with the calibration that its file has.
    const MeasuredForceCurve curve = readForceCurve(test::sharedData("curves/csv/sin_ibw.csv"));
    const AlignedForceCurve aligned = alignedCurve(curve, 1.0);
    const double pull =
        -*std::min_element(aligned.retract.force.begin(), aligned.retract.force.end());
    EXPECT_GT(pull, 2e-9);
    EXPECT_LT(pull, 2e-8);
    EXPECT_GT(aligned.lastPull, 0.0);
    EXPECT_NEAR(aligned.approach.force.front(), 0.0, 10.0 * aligned.noise);
}

TEST(ForceCurveFile, ReadsTabsAndDecimalCommas) {
    ScratchFolder folder;
    const MeasuredForceCurve curve = readForceCurve(folder.write(
        "a.txt",
        "Kurve 12\nZ (nm)\tForce (nN)\n100,5\t0,25\n50,25\t0,5\n10\t9,75\n60\t-1\n70\t0\n"));
    ASSERT_EQ(curve.segments.size(), 2U);
    EXPECT_EQ(curve.segments[0].kind, CurveSegmentKind::Approach);
    EXPECT_EQ(curve.segments[1].kind, CurveSegmentKind::Retract);
    ASSERT_EQ(curve.segments[0].force.size(), 3U) << "turns at the largest force";
    EXPECT_DOUBLE_EQ(curve.segments[0].force[2], 9.75e-9);
    EXPECT_DOUBLE_EQ(curve.segments[0].base[0], -100.5e-9) << "grows towards the sample";
    EXPECT_DOUBLE_EQ(curve.segments[1].base[0], -60e-9);
}

TEST(ForceCurveFile, TakesSeparationsAndIndentations) {
    ScratchFolder folder;
    const MeasuredForceCurve apart = readForceCurve(
        folder.write("a.csv", "tip-sample separation [nm],force [pN]\n5,0\n1,-20\n-1,80\n"));
    EXPECT_DOUBLE_EQ(apart.segments[0].separation[0], 5e-9);
    EXPECT_DOUBLE_EQ(apart.segments[0].force[1], -20e-12);
    const MeasuredForceCurve into =
        readForceCurve(folder.write("b.csv", "indentation_m;force_n\n-5e-9;0\n1e-9;8e-11\n"));
    EXPECT_DOUBLE_EQ(into.segments[0].separation[1], -1e-9);
}

TEST(ForceCurveFile, TakesLeverAndColumnsOfChiaro) {
    ScratchFolder folder;
    const MeasuredForceCurve curve = readForceCurve(
        folder.write("chiaro.txt", "Device:\tChiaro\nk (N/m)\t0.019\nMax load (\xB5N)\t0.050\n\n"
                                   "Time (s)\tLoad (uN)\tIndentation (nm)\tCantilever (nm)\tPiezo "
                                   "(nm)\tAuxiliary\n"
                                   "0\t-0.000308\t0\t-16.2\t64.97\t0\n"
                                   "1\t0.02\t100\t1052\t2000\t0\n"
                                   "2\t0.01\t10\t526\t1000\t0\n3\t0\t0\t0\t900\t0\n"));
    EXPECT_DOUBLE_EQ(curve.stiffness, 0.019);
    ASSERT_EQ(curve.segments.size(), 2U);
    EXPECT_DOUBLE_EQ(curve.segments[0].force[1], 0.02e-6);
    EXPECT_DOUBLE_EQ(curve.segments[0].base[1], 2000e-9);
    EXPECT_DOUBLE_EQ(curve.segments[0].deflection[1], 1052e-9);
}

TEST(ForceCurveFile, TakesOurOwnForceLog) {
    ScratchFolder folder;
    const MeasuredForceCurve curve = readForceCurve(folder.write(
        "force_log.csv",
        "time_s,base_x_m,base_y_m,base_z_m,est_fx_n,est_fy_n,est_fz_n,gap_m,indentation_m,branch\n"
        "0,1e-6,2e-6,9e-9,7,7,0,9e-9,-9e-9,approach\n"
        "1,1e-6,2e-6,-1e-9,7,7,5e-9,1e-10,1e-10,approach\n"
        "2,1e-6,2e-6,3e-9,7,7,-6e-9,3e-9,-3e-9,retract\n"
        "3,1e-6,2e-6,4e-9,7,7,0,4e-9,-4e-9,retract\n"));
    ASSERT_EQ(curve.segments.size(), 2U);
    EXPECT_DOUBLE_EQ(curve.segments[0].base[1], 1e-9);
    EXPECT_DOUBLE_EQ(curve.segments[1].force[0], -6e-9);
}

TEST(ForceCurveFile, SaysWhereACellIsNoNumber) {
    ScratchFolder folder;
    const std::string refusal =
        refusalOf(folder.write("a.csv", "z [nm],force [nN]\n1,2\n3,much\n"));
    EXPECT_TRUE(holds(refusal, "line 3")) << refusal;
    EXPECT_TRUE(holds(refusal, "'much' is no number")) << refusal;
    EXPECT_TRUE(holds(refusalOf(folder.write("b.csv", "z [nm],force [nN]\n")), "no point"));
}

}  // namespace
}  // namespace asperity
