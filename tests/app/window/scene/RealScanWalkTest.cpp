#include "core/io/tables/CsvTable.h"
#include "tests/app/window/ScanWalk.h"
#include "tests/core/io/heightmap/RealScans.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace asperity::test {
namespace {

/// How states follow one another, tick by tick, without repetition.
std::vector<std::string> statesOf(const CsvTable& log) {
    std::vector<std::string> states;
    for (std::size_t row = 0; row < log.rows(); ++row) {
        states.push_back(log.text(row, "state"));
    }
    states.erase(std::unique(states.begin(), states.end()), states.end());
    return states;
}

}  // namespace

class RealScanWalk : public ScanWalk, public ::testing::WithParamInterface<std::string> {};

TEST_P(RealScanWalk, OpensLevelsTouchesAndComesOffWithoutAnError) {
    ASSERT_NO_FATAL_FAILURE(openScan(GetParam()));
    ASSERT_NO_FATAL_FAILURE(levelAndOpen());
    startRecording();
    ASSERT_NO_FATAL_FAILURE(engage());
    ASSERT_TRUE(runsFor(0.3));
    ASSERT_NO_FATAL_FAILURE(withdraw());
    const std::filesystem::path run = stopRecording();
    expectNothingToRead();
    // Bonded across a gap, the tip stays for ticks, not for frames.
    std::vector<std::string> said = saidOfTip();
    std::erase(said, "cohesive (bonded across a gap)");
    EXPECT_THAT(said, ::testing::ElementsAre("far", "in contact", "far"));
    std::vector<std::string> states = statesOf(readCsv(run / "force_log.csv"));
    std::erase(states, "cohesive");
    EXPECT_THAT(states, ::testing::ElementsAre("far", "contact", "far"));
    const auto summary = nlohmann::json::parse(contentOf(run / "summary.json"));
    const auto& snapIn = summary.at("snap_in");
    const auto& off = summary.at("pull_off");
    EXPECT_EQ(snapIn.at("before").at("state"), "far");
    EXPECT_NE(snapIn.at("after").at("state"), "far");
    EXPECT_NE(off.at("before").at("state"), "far");
    EXPECT_EQ(off.at("after").at("state"), "far");
    const double deepest = summary.at("largest_indentation").at("time_s");
    EXPECT_LE(snapIn.at("after").at("time_s").get<double>(), deepest);
    EXPECT_LT(deepest, off.at("after").at("time_s").get<double>());
}

INSTANTIATE_TEST_SUITE_P(Formats, RealScanWalk,
                         ::testing::Values("derived/cl0_from_spm.gwy",
                                           "nanoscope/cl_0deg_xcal_v9.70.spm",
                                           "jpk/qi_2020_data-image.jpk-qi-image",
                                           "igor/spot_1-1000nm.ibw"),
                         [](const auto& scan) { return testName(scan.param); });

}  // namespace asperity::test
