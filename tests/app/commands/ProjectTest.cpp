#include "core/io/tables/CsvTable.h"
#include "tests/app/ProgramRun.h"
#include "tests/support/Places.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

namespace asperity {
namespace {

constexpr const char* kPoints = "x_m,y_m,z_m\n"
                                "500e-9,500e-9,30e-9\n"
                                "212e-9,740e-9,-5e-9\n"
                                "-40e-9,300e-9,20e-9\n";

std::string sample(const std::string& name) {
    return test::dataFolder().string() + "/samples/" + name;
}

CsvTable projected(const std::string& arguments) {
    const auto run = test::runProgram("project " + arguments);
    EXPECT_EQ(run.exitCode, 0) << run.output;
    return {run.exitCode == 0 ? run.output : std::string("none\n"), "output"};
}

TEST(Project, DoesNotWriteOverItsInput) {
    const test::ScratchFolder scratch;
    const auto points = scratch.write("points.csv", kPoints);
    const auto scan = scratch.file("scan.gsf");
    std::filesystem::copy_file(sample("self_affine.gsf"), scan);
    for (const auto& input : {points, scan}) {
        const std::string before = test::contentOf(input);
        const auto run = test::runProgram("project " + scan.string() + " --points " +
                                          points.string() + " --out " + input.string());
        EXPECT_EQ(run.exitCode, 1) << run.output;
        EXPECT_NE(run.output.find("this is an input"), std::string::npos) << run.output;
        EXPECT_EQ(test::contentOf(input), before);
    }
}

TEST(Project, GivesClosestPointsOnTheSurfaceAlongItsNormal) {
    const test::ScratchFolder scratch;
    const auto points = scratch.write("points.csv", kPoints);
    const CsvTable out = projected(sample("self_affine.gsf") + " --points " + points.string());
    ASSERT_EQ(out.rows(), 3U);
    for (std::size_t row = 0; row < 2; ++row) {
        SCOPED_TRACE(row);
        EXPECT_EQ(out.text(row, "certified"), "true");
        EXPECT_EQ(out.text(row, "proof"), "nearest");
        EXPECT_EQ(out.text(row, "inside"), "true");
        const double distance = out.number(row, "distance_m");
        for (const auto& [point, closest, normal] : {std::tuple{"x_m", "closest_x_m", "nx"},
                                                     {"y_m", "closest_y_m", "ny"},
                                                     {"z_m", "closest_z_m", "nz"}}) {
            EXPECT_NEAR(out.number(row, point),
                        out.number(row, closest) + distance * out.number(row, normal), 1e-18);
        }
    }
    EXPECT_LT(out.number(1, "distance_m"), out.number(0, "distance_m"));
    EXPECT_EQ(out.text(2, "inside"), "false");
    EXPECT_EQ(out.number(2, "closest_x_m"), 0.0);
    EXPECT_EQ(out.number(2, "u"), 0.0);
}

/// No force has a part in it: notes on contact law and model were in the table.
TEST(Project, NotesWhatWasDoneToTheHeightsAlone) {
    const test::ScratchFolder scratch;
    const auto points = scratch.write("points.csv", kPoints);
    const auto run =
        test::runProgram("project " + sample("self_affine.gsf") + " --points " + points.string());
    EXPECT_NE(run.output.find("# leveling: "), std::string::npos) << run.output;
    for (const char* const ofForce : {"contact law", "model:", "Maugis"}) {
        EXPECT_EQ(run.output.find(ofForce), std::string::npos) << run.output;
    }
}

TEST(Project, FindsTheExactDistanceOfASphere) {
    const test::ScratchFolder scratch;
    const auto scene =
        scratch.write("sphere.toml", "[sample]\nshape = \"sphere\"\nshape_radius_m = 50e-9\n");
    const auto points =
        scratch.write("points.csv", "x_m,y_m,z_m\n25e-9,25e-9,75e-9\n5e-9,-30e-9,40e-9\n");
    const CsvTable out = projected(scene.string() + " --points " + points.string());
    ASSERT_EQ(out.rows(), 2U);
    for (std::size_t row = 0; row < 2; ++row) {
        EXPECT_EQ(out.text(row, "certified"), "true");
        EXPECT_NEAR(out.number(row, "curvature_1_per_m"), 1.0 / 50e-9, 1e-3);
        // The point and its closest point lie on one ray from the center, which is the closest
        // point less R along the normal.
        const double distance = out.number(row, "distance_m");
        EXPECT_NEAR(out.number(row, "x_m") - out.number(row, "closest_x_m"),
                    distance * out.number(row, "nx"), 1e-20);
    }
}

TEST(Project, SaysOfWhatIsNoPositionThatItHasNoClosestPoint) {
    const test::ScratchFolder scratch;
    const auto points = scratch.write(
        "points.csv", "x_m,y_m,z_m\nnan,1e-9,1e-9\n1e-9,inf,1e-9\n1e-9,1e-9,-1e300\n");
    const auto sphere =
        scratch.write("sphere.toml", "[sample]\nshape = \"sphere\"\nshape_radius_m = 50e-9\n");
    for (const std::string& surface : {sample("self_affine.gsf"), sphere.string()}) {
        const CsvTable out = projected(surface + " --points " + points.string());
        ASSERT_EQ(out.rows(), 3U);
        for (std::size_t row = 0; row < out.rows(); ++row) {
            for (const char* column :
                 {"closest_x_m", "closest_y_m", "closest_z_m", "nx", "ny", "nz", "distance_m", "u",
                  "v", "curvature_1_per_m", "curvature_2_per_m"}) {
                EXPECT_TRUE(std::isnan(out.number(row, column))) << column << ' ' << row;
            }
            EXPECT_EQ(out.text(row, "proof"), "not_converged");
            EXPECT_EQ(out.text(row, "certified"), "false");
        }
    }
}

TEST(Project, SmoothsOnlyWhenAskedTo) {
    const test::ScratchFolder scratch;
    const auto points = scratch.write("points.csv", kPoints);
    const std::string call = sample("self_affine.gsf") + " --points " + points.string();
    EXPECT_EQ(projected(call).number(0, "distance_m"),
              projected(call + " --sigma 0").number(0, "distance_m"));
    EXPECT_NE(projected(call).number(0, "distance_m"),
              projected(call + " --sigma 3").number(0, "distance_m"));
}

TEST(Project, RefusesWhatIsNoPointWithItsLine) {
    const test::ScratchFolder scratch;
    const auto points = scratch.write("points.csv", "x_m,y_m,z_m\n1e-9,here,0\n");
    const auto run =
        test::runProgram("project " + sample("self_affine.gsf") + " --points " + points.string());
    EXPECT_EQ(run.exitCode, 3);
    EXPECT_NE(run.output.find("points.csv"), std::string::npos) << run.output;
    EXPECT_NE(run.output.find("line 2"), std::string::npos) << run.output;
    const auto missing = scratch.write("missing.csv", "x_m,y_m\n1,2\n");
    EXPECT_EQ(
        test::runProgram("project " + sample("self_affine.gsf") + " --points " + missing.string())
            .exitCode,
        3);
}

}  // namespace
}  // namespace asperity
