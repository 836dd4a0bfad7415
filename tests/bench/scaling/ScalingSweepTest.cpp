#include "bench/scaling/ScalingSweep.h"

#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>

namespace asperity {
namespace {

ScalingSweep pixels() {
    return {.what = "pixels",
            .unit = "million",
            .works = {1.0, 4.0, 16.0},
            .curves = {{.name = "fit", .maxSlope = 1.1, .times = {1e-3, 4e-3, 16e-3}},
                       {.name = "search", .maxSlope = 0.1, .times = {1e-6, 2e-6, 4e-6}}},
            .queries = 300,
            .certified = 300};
}

TEST(ScalingSweep, GivesTheSlopeOfEachCurveBesideItsGoal) {
    const std::array<ScalingSweep, 1> sweeps{pixels()};
    const std::vector<BenchRow> rows = scalingRows(sweeps);
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0].name, "slope against pixels: fit");
    EXPECT_NEAR(rows[0].value.value(), 1.0, 1e-12);
    EXPECT_EQ(rows[0].goal, 1.1);
    EXPECT_TRUE(rows[0].isMet());
    EXPECT_EQ(rows[1].name, "slope against pixels: search");
    EXPECT_NEAR(rows[1].value.value(), 0.5, 1e-12);
    EXPECT_FALSE(rows[1].isMet());
}

TEST(ScalingSweep, MissesTheGoalWhereOneAnswerOfAllSweepsIsNotProven) {
    std::array<ScalingSweep, 2> sweeps{pixels(), pixels()};
    EXPECT_TRUE(scalingRows(sweeps).back().isMet());
    sweeps[1].certified -= 3;
    const BenchRow row = scalingRows(sweeps).back();
    EXPECT_EQ(row.name, "scaling, 600 queries: certified");
    EXPECT_DOUBLE_EQ(row.value.value(), 99.5);
    EXPECT_FALSE(row.isMet());
}

TEST(ScalingSweep, WritesItsRowsAsAsperityBenchReadsThem) {
    const test::ScratchFolder folder;
    const std::array<ScalingSweep, 1> sweeps{pixels()};
    const std::string file = folder.file("rows.json").string();
    giveRows(scalingRows(sweeps), {.rows = file});
    const auto rows = nlohmann::json::parse(std::ifstream(file));
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[1].at("name"), "slope against pixels: search");
    EXPECT_NEAR(rows[1].at("value").get<double>(), 0.5, 1e-12);
    EXPECT_EQ(rows[1].at("unit"), "");
    EXPECT_EQ(rows[1].at("goal"), 0.1);
    EXPECT_EQ(rows[1].at("goal_is"), "at_most");
    EXPECT_EQ(rows[1].at("met"), false);
    EXPECT_EQ(rows[2].at("goal_is"), "at_least");
}

}  // namespace
}  // namespace asperity
