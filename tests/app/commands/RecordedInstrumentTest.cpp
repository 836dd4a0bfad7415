#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/curves/AlignedForceCurve.h"
#include "core/io/curves/ForceCurveFile.h"
#include "core/io/tables/CsvTable.h"
#include "core/probe/DetectorCalibration.h"
#include "core/scene/SceneDescription.h"
#include "tests/app/ProgramRun.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace asperity {
namespace {

using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

constexpr double kCurveRate = 2000.0;  // [Hz], of both curves and of the run

/// A scene whose instrument plays a real curve, and the base as it was recorded.
class PlayedCurveRun : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override {
        ASPERITY_NEEDS_SHARED_DATA();
        fs::copy_file(test::sharedData("curves/csv/" + GetParam()), curve);
        write("");
        aligned = alignedCurve(readForceCurve(curve), 1.0);
        std::ofstream path(scratch.file("path.csv"));
        path << "time_s,x_m,y_m,z_m\n";
        for (const AlignedBranch* branch : {&aligned.approach, &aligned.retract}) {
            for (const double distance : branch->baseDistance) {
                path << formatted("%.17g,50e-9,50e-9,%.17g\n", ticks++ / kCurveRate, distance);
            }
        }
    }

    /// A level plane under the default tip and lever.
    void write(const std::string& more) {
        (void)scratch.write("scene.toml",
                            "[sample]\nshape = \"plane\"\n[truth]\ncurve = \"curve.csv\"\n"
                            "curve_stiffness_n_m = 1.0\n[haptics]\nrate_hz = 2000\n" +
                                more);
    }
    [[nodiscard]] std::string in(const std::string& name) const {
        return scratch.file(name).string();
    }
    [[nodiscard]] test::ProgramRun explore(const std::string& path, const std::string& out) const {
        return test::runProgram("explore " + in("scene.toml") + " --no-pictures --path " + path +
                                " --out " + in(out));
    }

    test::ScratchFolder scratch;
    fs::path curve = scratch.file("curve.csv");
    AlignedForceCurve aligned;
    int ticks = 0;
};

INSTANTIATE_TEST_SUITE_P(OfInstruments, PlayedCurveRun,
                         testing::Values("sin_ibw.csv", "spot3_jpk.csv"), [](const auto& test) {
                             return test.param.substr(0, test.param.find('_'));
                         });

TEST_P(PlayedCurveRun, FollowsTheCurveToTheBit) {
    const auto run = explore(in("path.csv"), "run");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("the instrument plays the curve curve.csv"));
    EXPECT_THAT(run.output, Not(HasSubstr("no such motion")));
    const CsvTable log = readCsv(scratch.file("run") / "force_log.csv");
    ASSERT_EQ(log.rows(), static_cast<std::size_t>(ticks));
    const Cantilever lever(defaultScene().probe);
    std::size_t row = 0;
    const auto compare = [&](const AlignedBranch& branch, double offset) {
        for (const double force : branch.force) {
            const Vector3 along(0.0, 0.0, force + offset);
            ASSERT_EQ(log.number(row, "alpha_rad"), leverSignals(lever, along).bending) << row;
            ASSERT_EQ(log.number(row, "theta_rad"), 0.0);
            ++row;
        }
    };
    compare(aligned.approach, 0.0);
    compare(aligned.retract, aligned.retractOffset);
}

TEST_P(PlayedCurveRun, ReplaysAndIsBundledWithItsCurve) {
    ASSERT_EQ(explore(in("path.csv"), "run").exitCode, 0);
    const auto bundled = test::runProgram("bundle " + in("run") + " " + in("run.zip"));
    ASSERT_EQ(bundled.exitCode, 0) << bundled.output;
    EXPECT_THAT(test::runProgram("replay " + in("run") + " --out " + in("again")).output,
                HasSubstr("bit-identical"));
    fs::remove(curve);
    const auto again = test::runProgram("replay " + in("run.zip") + " --out " + in("bundled"));
    EXPECT_EQ(again.exitCode, 0) << again.output;
    EXPECT_THAT(again.output, HasSubstr("bit-identical"));
}

TEST_P(PlayedCurveRun, WithATurnAndAnEndReplaysWithTheirFlags) {
    std::ofstream(scratch.file("turns.csv"))
        << "time_s,x_m,y_m,z_m\n0,50e-9,50e-9,30e-9\n0.1,50e-9,50e-9,-5e-9\n"
           "0.2,50e-9,50e-9,0\n0.3,55e-9,50e-9,-4e-9\n0.4,50e-9,50e-9,-1e-6\n";
    const auto run = explore(in("turns.csv"), "run");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("the recorded curve has no such motion"));
    EXPECT_THAT(run.output, HasSubstr("the recorded curve is of another place"));
    EXPECT_THAT(run.output, HasSubstr("ticks with the force off after a fault"));
    const std::string log = test::contentOf(scratch.file("run") / "force_log.csv");
    EXPECT_THAT(log, HasSubstr("record_ended"));
    EXPECT_THAT(log, HasSubstr("extrapolated"));
    const auto again = test::runProgram("replay " + in("run") + " --out " + in("again"));
    EXPECT_EQ(again.exitCode, 0) << again.output;
    EXPECT_THAT(again.output, HasSubstr("bit-identical"));
    EXPECT_EQ(test::contentOf(scratch.file("again") / "force_log.csv"), log);
}

TEST_P(PlayedCurveRun, AnApproachPastItsEndSaysSo) {
    const auto run = test::runProgram("explore " + in("scene.toml") +
                                      " --no-pictures --setpoint 5uN --out " + in("run"));
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("the approach ended below the recorded curve"));
}

TEST_P(PlayedCurveRun, HasNoMapAndNoCurveOfALaw) {
    const auto map = test::runProgram("map " + in("scene.toml") + " --out " + in("map.gwy"));
    EXPECT_EQ(map.exitCode, 1);
    EXPECT_THAT(map.output, HasSubstr("plays a recorded curve"));
    const auto drawn = test::runProgram("curve " + in("scene.toml") + " --out " + in("out.csv"));
    EXPECT_EQ(drawn.exitCode, 3);
    EXPECT_THAT(drawn.output, HasSubstr("plays a recorded curve"));
}

TEST_P(PlayedCurveRun, SaysWhichCurveItCannotPlay) {
    std::ofstream(curve) << "base_m,force_N\n0,0\n1e-9,0\n";
    const auto few = explore(in("path.csv"), "run");
    EXPECT_EQ(few.exitCode, 3);
    EXPECT_THAT(few.output, HasSubstr("curve.csv: the curve has no segment of two points or more"));
    fs::remove(curve);
    const auto none = explore(in("path.csv"), "run");
    EXPECT_EQ(none.exitCode, 3);
    EXPECT_THAT(none.output, HasSubstr("curve.csv"));
}

}  // namespace
}  // namespace asperity
