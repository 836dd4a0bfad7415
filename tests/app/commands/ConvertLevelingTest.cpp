#include "core/io/heightmap/HeightMapFile.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/app/ProgramRun.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

// `asperity convert --level`: every row of the ground truth, through the program and a file;
// `asperity measure` gives the same root mean square.

namespace asperity {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Half a unit of the tenth digit, which the table rounds to.
double roundingOf(double value) {
    return value == 0.0 ? 0.0 : 0.5 * std::pow(10.0, std::floor(std::log10(std::abs(value))) - 9.0);
}

/// Root mean square about the mean [m], with the computation of the table: all pixels, two passes.
double rmsOf(const HeightMap& map) {
    long double mean = 0.0L;
    for (const double height : map.heights) {
        mean += height;
    }
    mean /= static_cast<long double>(map.heights.size());
    long double square = 0.0L;
    for (const double height : map.heights) {
        square += (height - mean) * (height - mean);
    }
    return static_cast<double>(std::sqrt(square / static_cast<long double>(map.heights.size())));
}

/// Slope of the least-squares plane along the columns, or the rows (down), of a full map.
double slopeOf(const HeightMap& map, bool alongX) {
    const int count = alongX ? map.columns : map.rows;
    long double product = 0.0L;
    long double square = 0.0L;
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            const long double position = (alongX ? column : row) - 0.5L * (count - 1);
            product += position * (map.at(row, column) - map.at(0, 0));
            square += position * position;
        }
    }
    return static_cast<double>(product / square / (alongX ? map.pitchX : map.pitchY));
}

/// Root mean square of (z[j + 1] - z[j - 1]) / (2 pitch) along the rows.
double rmsSlopeOf(const HeightMap& map) {
    long double square = 0.0L;
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 1; column + 1 < map.columns; ++column) {
            const long double slope =
                (map.at(row, column + 1) - map.at(row, column - 1)) / (2.0L * map.pitchX);
            square += slope * slope;
        }
    }
    return static_cast<double>(
        std::sqrt(square / (static_cast<long double>(map.rows) * (map.columns - 2))));
}

class GroundTruth : public testing::Test {
protected:
    /// One row of the table.
    struct Row {
        std::size_t index = 0;
        std::string input;  ///< in quotes
        std::string channel;
    };

    [[nodiscard]] HeightMap leveled(const Row& row, const std::string& steps) {
        const std::string output = scratch.file("leveled.gwy").string();
        const auto run = test::runProgram("convert " + row.input + " " + output +
                                          " --force --level " + steps + row.channel);
        EXPECT_EQ(run.exitCode, 0) << run.output;
        return readHeightChannel(output, "").channel.map;
    }
    [[nodiscard]] static double measuredSq(const Row& row, const std::string& steps) {
        const auto run =
            test::runProgram("measure " + row.input + " --json --level " + steps + row.channel);
        EXPECT_EQ(run.exitCode, 0) << run.output;
        return nlohmann::json::parse(run.output).at("sq_m").get<double>();
    }
    /// To 1e-9 of `unit`, but for the rounding of the table.
    void expect(const Row& row, const std::string& column, double value, double unit) {
        const double expected = table.number(row.index, column);
        const double error = std::max(std::abs(value - expected) - roundingOf(expected), 0.0);
        EXPECT_LE(error, 1e-9 * unit) << column;
        double& worst = worst_[column];
        worst = std::max(worst, std::abs(value - expected) / unit);
    }
    /// The root mean square that a column is compared by.
    [[nodiscard]] double unitOf(const Row& row, const std::string& column) const {
        return table.number(row.index, column);
    }
    void expectLeveled(const Row& row, const std::string& steps, const std::string& column) {
        expect(row, column, rmsOf(leveled(row, steps)), unitOf(row, column));
        expect(row, column, measuredSq(row, steps), unitOf(row, column));
    }
    void TearDown() override {
        for (const auto& [column, worst] : worst_) {
            RecordProperty(column, std::to_string(worst));
            std::printf("  %-50s worst %.2g of its unit\n", column.c_str(), worst);
        }
    }

    test::ReferenceTable table{test::sharedData("afm/LEVELLING.csv")};
    test::ScratchFolder scratch;

private:
    std::map<std::string, double> worst_;
};

class ConvertLeveling : public GroundTruth {
protected:
    void checkRow(const Row& row) {
        const HeightMap raw = leveled(row, "none");
        const double roughness = unitOf(row, "rms_slope_x_central_difference");
        expect(row, "plane_slope_x", slopeOf(raw, true), roughness);
        expect(row, "plane_slope_y_down", slopeOf(raw, false), roughness);
        expect(row, "rms_slope_x_central_difference", rmsSlopeOf(raw), roughness);
        expectLeveled(row, "none", "rms_raw");
        const HeightMap flat = leveled(row, "plane");
        const double rms = unitOf(row, "rms_after_plane");
        expectLeveled(row, "plane", "rms_after_plane");
        const auto [low, high] = std::ranges::minmax(flat.heights);
        expect(row, "min_after_plane", low, rms);
        expect(row, "max_after_plane", high, rms);
        expectLeveled(row, "rows", "rms_after_row_median");
        expectLeveled(row, "median_of_differences", "rms_after_median_of_differences_keep_y_trend");
    }
};

TEST_F(ConvertLeveling, AgreesWithEveryRowOfTheGroundTruth) {
    ASPERITY_NEEDS_SHARED_DATA();
    EXPECT_EQ(table.rows(), 20U);
    for (std::size_t index = 0; index < table.rows(); ++index) {
        SCOPED_TRACE(table.text(index, "file"));
        checkRow(
            {.index = index,
             .input = "'" + test::sharedData("afm/" + table.text(index, "file")).string() + "'",
             .channel = " --channel '" + table.text(index, "channel") + "'"});
    }
}

class ConvertSteps : public testing::Test {
protected:
    void SetUp() override {
        HeightMap map = sampledMap({.columns = 60, .rows = 40, .sizeX = 600e-9, .sizeY = 400e-9},
                                   EggBox{.amplitude = 4e-9, .periodX = 300e-9, .periodY = 400e-9});
        for (int column = 10; column < 40; ++column) {
            map.heights[map.index(17, column)] += 20e-9;
        }
        writeHeightMap(scratch.file("in.gwy"), map, {.title = "Height"});
    }
    [[nodiscard]] test::ProgramRun convert(const std::string& options,
                                           const std::string& output = "out.gwy") const {
        return test::runProgram("convert " + scratch.file("in.gwy").string() + " " +
                                scratch.file(output).string() + " --force " + options);
    }
    [[nodiscard]] HeightMap output(const std::string& name = "out.gwy") const {
        return readHeightChannel(scratch.file(name), "").channel.map;
    }

    test::ScratchFolder scratch;
};

TEST_F(ConvertSteps, AreDoneInOrderAndNoted) {
    const auto run = convert("--level scars,plane,zero");
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("note: leveling, step 1 of 3: 30 pixels of scars "
                                      "interpolated and marked as filled\n"));
    EXPECT_THAT(run.output, HasSubstr("note: leveling, step 2 of 3: plane with slopes "));
    EXPECT_THAT(run.output, HasSubstr("note: leveling, step 3 of 3: lowest height, "));
    EXPECT_THAT(run.output, HasSubstr("30 of them without data"));
    EXPECT_THAT(convert("").output, Not(HasSubstr("leveling")));
    EXPECT_THAT(convert("--residual --level rows").output, HasSubstr("note: leveling: the median"));
}

/// A mask marks the interpolated heights, which other programs show.
TEST_F(ConvertSteps, ScarsAreMaskedInGwyAndNoDataElsewhere) {
    ASSERT_EQ(convert("--level scars,zero").exitCode, 0);
    const std::string bytes = test::contentOf(scratch.file("out.gwy"));
    EXPECT_THAT(bytes, HasSubstr("mask"));
    const HeightMap map = output();
    EXPECT_EQ(std::ranges::count(map.invalid, true), 30);
    EXPECT_FALSE(map.isValid(17, 20));
    ASSERT_EQ(convert("--level scars,zero", "out.gsf").exitCode, 0);
    const HeightMap plain = output("out.gsf");
    EXPECT_EQ(std::ranges::count(plain.invalid, true), 30);
    // The height of the masked pixel in the file: between its neighbors.
    const double filled = 0.5 * (map.at(16, 20) + map.at(18, 20));
    std::string expected(sizeof filled, '\0');
    std::memcpy(expected.data(), &filled, sizeof filled);
    EXPECT_THAT(bytes, HasSubstr(expected));
}

TEST_F(ConvertSteps, ThreePointTakesItsPoints) {
    const auto run =
        convert("--level three_point --level-points 100e-9,100e-9,500e-9,100e-9,300e-9,350e-9");
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("note: leveling: plane through three points"));
    const auto without = convert("--level three_point");
    EXPECT_EQ(without.exitCode, 1);
    EXPECT_THAT(without.output, HasSubstr("three_point needs three points"));
    const auto line =
        convert("--level three_point --level-points 100e-9,100e-9,200e-9,200e-9,300e-9,300e-9");
    EXPECT_EQ(line.exitCode, 2);
    EXPECT_THAT(line.output, HasSubstr("do not lie on one line"));
    EXPECT_EQ(convert("--level-points 1,2,3").exitCode, 2);
}

/// The same options level what other commands, and the window, open.
TEST_F(ConvertSteps, AreThoseOfEveryCommandThatOpensAScan) {
    const std::string input = scratch.file("in.gwy").string();
    const std::string points = " --level-points 100e-9,100e-9,500e-9,100e-9,300e-9,350e-9";
    const auto explored = test::runProgram(
        "explore --no-pictures " + input + " --out " + scratch.file("run").string() +
        " --path slide --duration 0.1 --level three_point,zero" + points);
    EXPECT_EQ(explored.exitCode, 0) << explored.output;
    EXPECT_THAT(explored.output, HasSubstr("leveling, step 1 of 2: plane through three points"));
    EXPECT_THAT(test::contentOf(scratch.file("run") / "scene.toml"),
                HasSubstr("level = [ 'three_point', 'zero' ]"));
    const auto window = test::runProgram(input + " --level three_point", "DISPLAY=");
    EXPECT_EQ(window.exitCode, 3);
    EXPECT_THAT(window.output, HasSubstr("three_point needs level_points_m (or --level-points)"));
}

TEST_F(ConvertSteps, RefuseWhatIsNoStep) {
    const auto run = convert("--level plane,flat");
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.output, HasSubstr("expected steps of plane, rows, three_point"));
    EXPECT_EQ(convert("--all --level plane").exitCode, 2);
    EXPECT_EQ(convert("--level ''").exitCode, 2);
}

}  // namespace
}  // namespace asperity
