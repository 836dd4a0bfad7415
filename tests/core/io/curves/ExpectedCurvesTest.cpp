#include "core/io/curves/CurveSegments.h"
#include "core/io/curves/ForceCurveFile.h"
#include "core/io/curves/ThermalSpectrumFile.h"
#include "tests/support/ReferenceTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

// Real files against what an independent reader took from them.

namespace asperity {
namespace {

using test::ReferenceTable;
using test::sharedData;

/// One curve of a file for all tests: its rows of EXPECTED_READ.csv follow each other.
class ExpectedRows {
public:
    const MeasuredForceCurve& curve(const std::string& original, std::size_t index) {
        const std::string key = original + "#" + std::to_string(index);
        const auto known = curves_.find(key);
        if (known != curves_.end()) {
            return known->second;
        }
        return curves_.emplace(key, readForceCurve(sharedData("curves/" + original), index))
            .first->second;
    }

private:
    std::map<std::string, MeasuredForceCurve> curves_;
};

/// Compares a number with a cell, which is empty where the file does not give it.
void expectCell(double value, const ReferenceTable& table, std::size_t row, const char* column,
                double tolerance = 1e-9) {
    if (table.text(row, column).empty()) {
        EXPECT_TRUE(value == 0.0 || std::isnan(value)) << column << " " << value;
        return;
    }
    const double expected = table.number(row, column);
    EXPECT_NEAR(value, expected, tolerance * std::abs(expected)) << column;
}

double firstOf(const std::vector<double>& values) { return values.empty() ? 0.0 : values.front(); }

TEST(ExpectedCurves, AreReadFromTheFilesOfTheInstruments) {
    ASPERITY_NEEDS_SHARED_DATA();
    const ReferenceTable table(sharedData("curves/EXPECTED_READ.csv"));
    ExpectedRows rows;
    std::map<std::string, std::size_t> segments;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(table.text(row, "curve") + ", segment " + table.text(row, "segment"));
        const auto index = static_cast<std::size_t>(table.number(row, "index"));
        const MeasuredForceCurve& curve = rows.curve(table.text(row, "original"), index);
        const auto number = static_cast<std::size_t>(table.number(row, "segment"));
        ASSERT_LT(number, curve.segments.size());
        const CurveSegment& segment = curve.segments[number];
        EXPECT_EQ(nameOf(segment.kind), table.text(row, "kind"));
        ASSERT_EQ(static_cast<double>(segment.force.size()), table.number(row, "points"));
        EXPECT_EQ(segment.base.size(), segment.force.size());
        expectCell(firstOf(segment.base), table, row, "first_base_m");
        expectCell(firstOf(segment.deflection), table, row, "first_deflection_m");
        expectCell(segment.force.front(), table, row, "first_force_N");
        expectCell(std::ranges::max(segment.force), table, row, "max_force_N");
        expectCell(std::ranges::min(segment.force), table, row, "min_force_N");
        expectCell(durationOf(segment), table, row, "duration_s");
        expectCell(curve.stiffness, table, row, "k");
        expectCell(curve.invols, table, row, "invols");
        segments[table.text(row, "curve")] = number + 1;
        EXPECT_LE(segments[table.text(row, "curve")], curve.segments.size());
    }
    EXPECT_EQ(table.rows(), 46U) << "all rows";
}

constexpr double kSixDigits = 5.1e-6;
constexpr double kSevenDigits = 5.1e-7;
constexpr double kNineDigits = 5.1e-9;

/// Compares an array of a segment with one of the table. @param digit half of the last one that is
/// printed, of the number
void expectSameSamples(const std::vector<double>& values, const std::vector<double>& printed,
                       double digit, const char* what) {
    if (printed.empty() || values.empty()) {
        return;
    }
    ASSERT_EQ(values.size(), printed.size()) << what;
    const double largest = std::abs(
        *std::ranges::max_element(printed, {}, [](double value) { return std::abs(value); }));
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double digits = std::max(digit * std::abs(printed[i]), 1e-13 * largest);
        ASSERT_NEAR(values[i], printed[i], digits) << what << " " << i;
    }
}

TEST(ExpectedCurves, AreThoseOfTheExportedTablesSampleBySample) {
    ASPERITY_NEEDS_SHARED_DATA();
    const ReferenceTable table(sharedData("curves/EXPECTED_READ.csv"));
    ExpectedRows rows;
    std::size_t compared = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string name = table.text(row, "curve");
        const std::filesystem::path exported = sharedData("curves/csv/" + name + ".csv");
        if (table.number(row, "segment") > 0.0 || !std::filesystem::exists(exported)) {
            continue;
        }
        SCOPED_TRACE(name);
        const MeasuredForceCurve& curve = rows.curve(
            table.text(row, "original"), static_cast<std::size_t>(table.number(row, "index")));
        const MeasuredForceCurve printed = readForceCurve(exported);
        ASSERT_EQ(curve.segments.size(), printed.segments.size());
        for (std::size_t i = 0; i < curve.segments.size(); ++i) {
            expectSameSamples(curve.segments[i].time, printed.segments[i].time, kSixDigits, "time");
            expectSameSamples(curve.segments[i].base, printed.segments[i].base, kNineDigits,
                              "base");
            expectSameSamples(curve.segments[i].deflection, printed.segments[i].deflection,
                              kSevenDigits, "deflection");
            expectSameSamples(curve.segments[i].force, printed.segments[i].force, kSevenDigits,
                              "force");
        }
        ++compared;
    }
    EXPECT_EQ(compared, 13U);
}

TEST(ExpectedCurves, WithoutTheirCalibrationHaveASignalOrADeflectionOnly) {
    ASPERITY_NEEDS_SHARED_DATA();
    const MeasuredForceCurve volts = readForceCurve(sharedData(
        "curves/original/fmt-jpk-cl_calibration_force-save-2015.02.04-11.25.21.294.jpk-force"));
    EXPECT_EQ(volts.invols, 0.0);
    EXPECT_EQ(volts.stiffness, 0.0);
    EXPECT_EQ(volts.segments[0].signal.size(), 2048U);
    EXPECT_TRUE(volts.segments[0].deflection.empty());
    EXPECT_TRUE(volts.segments[0].force.empty());
    const MeasuredForceCurve metres =
        readForceCurve(sharedData("curves/original/fmt-jpk-fd_single-modified_2023.jpk-force"));
    EXPECT_DOUBLE_EQ(metres.invols, 8.932268680909602e-08);
    EXPECT_EQ(metres.stiffness, 0.0);
    EXPECT_EQ(metres.segments[0].deflection.size(), 10'000U);
    EXPECT_TRUE(metres.segments[0].force.empty());
}

TEST(ExpectedCurves, OfMapsAreFoundByTheirIndexAndCell) {
    ASPERITY_NEEDS_SHARED_DATA();
    const ForceCurveFile jpk(
        sharedData("curves/original/fmt-jpk-fd_map-data-reference-points.jpk-force-map"));
    EXPECT_EQ(jpk.count(), 3U);
    EXPECT_EQ(jpk.grid().columns, 25);
    EXPECT_TRUE(jpk.hasImage());
    EXPECT_EQ(jpk.contents(0).heightChannel, "capacitiveSensorHeight");
    // The second curve of the file is the 129th of a map whose odd rows run back.
    ASSERT_TRUE(jpk.cell(1));
    EXPECT_EQ(jpk.cell(1)->column, 20);
    EXPECT_EQ(jpk.cell(1)->row, 5);
    EXPECT_NEAR(jpk.position(1)->x, -0.000999765625, 1e-15);

    const ForceCurveFile volume(sharedData("curves/original/20200903_Egel2.0_00023.spm"));
    EXPECT_EQ(volume.count(), 256U);
    EXPECT_EQ(volume.grid().rows, 16);
    EXPECT_TRUE(volume.hasImage());
    EXPECT_EQ(volume.cell(17)->column, 1);
    EXPECT_EQ(volume.cell(17)->row, 1);
}

TEST(ExpectedCurves, HaveTheHeightThatIsAskedFor) {
    ASPERITY_NEEDS_SHARED_DATA();
    const std::filesystem::path file =
        sharedData("curves/original/fmt-jpk-fd_spot3-0192.jpk-force");
    const CurveContents usual = ForceCurveFile(file).contents(0);
    EXPECT_EQ(usual.heightChannel, "strainGaugeHeight");
    ASSERT_EQ(usual.heights.size(), 2U);
    CurveReadOptions options;
    options.height = "height";
    const CurveContents piezo = ForceCurveFile(file, options).contents(0);
    // Its shown slot is the calibrated one: 0.580608 of the nominal height.
    EXPECT_NEAR(piezo.curve.segments[0].base[0], -0.580608 * 4.9574279773415606e-05, 1e-15);
}

TEST(ExpectedCurves, HaveTheHeightsThatAllTheirSegmentsHave) {
    ASPERITY_NEEDS_SHARED_DATA();
    const CurveContents contents =
        ForceCurveFile(
            sharedData("curves/original/fmt-jpk-cc_pr14-polymergel-2021.06.30.jpk-force"))
            .contents(0);
    EXPECT_EQ(contents.heights, (std::vector<std::string>{"measuredHeight", "height"}))
        << "the pause has no capacitiveSensorHeight";
}

TEST(ThermalSpectrum, OfNanosurfHasTheFitOfItsProgram) {
    ASPERITY_NEEDS_SHARED_DATA();
    const ThermalSpectrum spectrum = readThermalSpectrum(sharedData("curves/original/thermal.nid"));
    ASSERT_EQ(spectrum.power.size(), 8369U);
    ASSERT_EQ(spectrum.fittedPower.size(), 8369U);
    EXPECT_DOUBLE_EQ(spectrum.frequency.back(), 319214.0);
    EXPECT_NEAR(spectrum.frequency[1], 38.147, 1e-3) << "the resolution that the file names";
    EXPECT_DOUBLE_EQ(spectrum.resonance, 179.8e3);
    EXPECT_DOUBLE_EQ(spectrum.quality, 442.0);
    EXPECT_DOUBLE_EQ(spectrum.stiffness, 27.13);
    EXPECT_DOUBLE_EQ(spectrum.averages, 1000.0);
    EXPECT_DOUBLE_EQ(spectrum.lowest, 114e3);
    const auto peak = std::ranges::max_element(spectrum.fittedPower);
    EXPECT_NEAR(spectrum.frequency[static_cast<std::size_t>(peak - spectrum.fittedPower.begin())],
                spectrum.resonance, 100.0);
    EXPECT_NEAR(std::sqrt(*peak), spectrum.peakDensity, 0.01 * spectrum.peakDensity);
}

}  // namespace
}  // namespace asperity
