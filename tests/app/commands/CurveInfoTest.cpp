#include "core/io/curves/ForceCurveFile.h"
#include "tests/app/ProgramRun.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

// Force curves as `asperity info` lists them and `asperity convert` writes them.

namespace asperity {
namespace {

using testing::AllOf;

using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

std::string original(const std::string& name) {
    return test::sharedData("curves/original/" + name).string();
}

std::string spot() { return original("fmt-jpk-fd_spot3-0192.jpk-force"); }
std::string volume() { return original("20200903_Egel2.0_00023.spm"); }

TEST(CurveInfo, NamesSegmentsAndCalibration) {
    ASPERITY_NEEDS_SHARED_DATA();
    const auto run = test::runProgram("info " + spot());
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.output, AllOf(HasSubstr("JPK force curves: one curve"), HasSubstr("approach"),
                                  HasSubstr("2000"), HasSubstr("spring constant 43.5 mN/m"),
                                  HasSubstr("optical sensitivity 70 nm/V"),
                                  HasSubstr("height channel strainGaugeHeight (others: height)")));
    const auto json = nlohmann::json::parse(test::runProgram("info --json " + spot()).output);
    const nlohmann::json& curve = json["force_curves"]["curves"][0];
    EXPECT_EQ(curve["stiffness_n_m"], 0.043493666407368466);
    EXPECT_EQ(curve["segments"][1]["kind"], "retract");
    EXPECT_EQ(curve["segments"][1]["points"], 2000);
    EXPECT_NEAR(curve["segments"][0]["duration_s"].get<double>(), 1.0, 1e-12);
    EXPECT_NEAR(curve["segments"][0]["force_n"][1].get<double>(), 3.479918274951986e-09, 1e-17);
    EXPECT_TRUE(curve["missing"].empty());
}

TEST(CurveInfo, SaysWhatIsMissing) {
    ASPERITY_NEEDS_SHARED_DATA();
    const std::string volts =
        original("fmt-jpk-cl_calibration_force-save-2015.02.04-11.25.21.294.jpk-force");
    EXPECT_THAT(test::runProgram("info " + volts).output,
                HasSubstr("missing: spring constant, optical sensitivity"));
}

TEST(CurveInfo, OfAVolumeListsImageAndCurves) {
    ASPERITY_NEEDS_SHARED_DATA();
    EXPECT_THAT(test::runProgram("info " + volume()).output,
                AllOf(HasSubstr("16 x 16"), HasSubstr("256 curves of a grid of 16 x 16"),
                      HasSubstr("and 248 more")));
    const auto json =
        nlohmann::json::parse(test::runProgram("info --index 100 --json " + volume()).output);
    EXPECT_THAT(json["channels"], SizeIs(1));
    EXPECT_EQ(json["force_curves"]["count"], 256);
    ASSERT_THAT(json["force_curves"]["curves"], SizeIs(1));
    EXPECT_EQ(json["force_curves"]["curves"][0]["index"], 100);
    const auto run = test::runProgram("info --index 256 " + volume());
    EXPECT_EQ(run.exitCode, 3);
    EXPECT_THAT(run.output, HasSubstr("there is no curve 256"));
}

TEST(CurveInfo, OfASpectrumHasTheFitOfItsProgram) {
    ASPERITY_NEEDS_SHARED_DATA();
    EXPECT_THAT(test::runProgram("info " + original("thermal.nid")).output,
                AllOf(HasSubstr("thermal spectrum"), HasSubstr("180 kHz"), HasSubstr("442"),
                      HasSubstr("27.1 N/m")));
}

/// NanoScope Analysis writes images as text with titles that curves have, too.
TEST(CurveInfo, LeavesExportedImagesToTheReadersOfImages) {
    ASPERITY_NEEDS_SHARED_DATA();
    const std::string image =
        test::sharedData("afm/cases/nanoscope_analysis_ascii_header.txt").string();
    EXPECT_THAT(test::runProgram("info " + image).output,
                AllOf(HasSubstr("6 x 4"), Not(HasSubstr("curve"))));
}

TEST(CurveInfo, RefusesImagesOfCurvesWithAPointer) {
    ASPERITY_NEEDS_SHARED_DATA();
    const test::ScratchFolder folder;
    EXPECT_THAT(
        test::runProgram("convert " + spot() + " " + folder.file("a.gsf").string()).output,
        AllOf(HasSubstr("no image"), HasSubstr("asperity info"), HasSubstr("asperity fit")));
}

TEST(CurveConvert, WritesATableThatReadsBack) {
    ASPERITY_NEEDS_SHARED_DATA();
    const test::ScratchFolder folder;
    const std::string out = folder.file("curve.csv").string();
    const auto run = test::runProgram("convert --index 100 " + volume() + " " + out);
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("curve 100 of 256, 2048 points"));
    EXPECT_THAT(test::contentOf(out), HasSubstr("\nsegment,time_s,base_m,deflection_m,force_N\n"));
    const MeasuredForceCurve written = readForceCurve(out);
    const MeasuredForceCurve stored = readForceCurve(volume(), 100);
    ASSERT_EQ(written.segments.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(written.segments[i].kind, stored.segments[i].kind);
        EXPECT_EQ(written.segments[i].force, stored.segments[i].force);
        EXPECT_EQ(written.segments[i].base, stored.segments[i].base);
        EXPECT_EQ(written.segments[i].time, stored.segments[i].time);
    }
    EXPECT_THAT(test::runProgram("convert " + volume() + " " + out).output,
                HasSubstr("the file exists"));
}

TEST(CurveConvert, WritesManyAndASignalWhereThereIsNothingElse) {
    ASPERITY_NEEDS_SHARED_DATA();
    const test::ScratchFolder folder;
    const std::string volts = original("fmt-afm-workshop-fd_single_2021-01-15.csv");
    const auto run = test::runProgram("convert --out-dir " + folder.path().string() + " --to csv " +
                                      spot() + " " + volts);
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_TRUE(std::filesystem::exists(folder.file("fmt-jpk-fd_spot3-0192.csv")));
    const MeasuredForceCurve signal =
        readForceCurve(folder.file("fmt-afm-workshop-fd_single_2021-01-15.csv"));
    EXPECT_EQ(signal.segments[0].signal.size(), 3369U);
    EXPECT_THAT(
        test::runProgram("convert --all " + spot() + " " + folder.file("b.csv").string()).output,
        HasSubstr("options for height maps do not apply"));
}

TEST(CurveConvert, TakesColumnsThatAreNamed) {
    const test::ScratchFolder folder;
    const std::string text = folder.write("table.dat", "a b\n0.1 2,5\n0.2 7,5\n0.15 1\n0.1 0\n");
    const std::string out = folder.file("out.csv").string();
    const auto run = test::runProgram("convert --columns base=1:um,force=2:nN " + text + " " + out);
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_DOUBLE_EQ(readForceCurve(out).segments[0].force[1], 7.5e-9);
    const auto wrong = test::runProgram("info --columns base=1:nN,force=2 " + text);
    EXPECT_EQ(wrong.exitCode, 2);
    EXPECT_THAT(wrong.output, HasSubstr("expected a unit of m"));
}

}  // namespace
}  // namespace asperity
