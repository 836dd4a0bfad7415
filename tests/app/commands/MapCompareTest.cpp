#include "core/io/heightmap/HeightMapWriter.h"
#include "tests/app/ProgramRun.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

// `asperity map --compare`

namespace asperity {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr int kPixels = 16;  // a side

/// Values of 16 x 16 pixels over 64 nm.
template <class Value>
HeightMap mapOf(const Value& value, double pitch = 4e-9) {
    HeightMap map{.columns = kPixels, .rows = kPixels, .pitchX = pitch, .pitchY = pitch};
    for (int row = 0; row < kPixels; ++row) {
        for (int column = 0; column < kPixels; ++column) {
            map.heights.push_back(value(row, column));
        }
    }
    return map;
}

double hills(int row, int column) { return 2e-9 * std::sin(0.4 * row) * std::cos(0.4 * column); }
double nothing(int /*row*/, int /*column*/) { return std::nan(""); }
double flat(int /*row*/, int /*column*/) { return 1e-9; }

/// A scan of hills, and its force map.
class MapCompare : public testing::Test {
protected:
    void SetUp() override {
        write("hills.gwy", mapOf(hills), "Height", "m");
        ASSERT_EQ(run("before.gwy", "").exitCode, 0);
    }
    void write(const std::string& name, const HeightMap& map, const std::string& title,
               const std::string& unit) const {
        writeHeightMap(scratch.file(name), map, {.title = title, .unit = unit});
    }
    [[nodiscard]] std::string fileOf(const std::string& name) const {
        return scratch.file(name).string();
    }
    [[nodiscard]] test::ProgramRun run(const std::string& out, const std::string& options,
                                       const std::string& scan = "hills.gwy") const {
        return test::runProgram("map " + fileOf(scan) + " --grid 8x8 --no-pictures --out " +
                                fileOf(out) + " " + options);
    }
    [[nodiscard]] test::ProgramRun compare(const std::string& measured,
                                           const std::string& options) const {
        return run("map.gwy", "--compare " + fileOf(measured) + " " + options);
    }
    [[nodiscard]] nlohmann::json report() const {
        return nlohmann::json::parse(test::contentOf(scratch.file("map.compare.json")));
    }
    [[nodiscard]] bool isThere(const std::string& name) const {
        return std::filesystem::exists(scratch.file(name));
    }

    test::ScratchFolder scratch;
};

TEST_F(MapCompare, WithItselfLeavesNothing) {
    const auto ran =
        compare("before.gwy", "--channel 'adhesion force' --channel 'contact stiffness'");
    ASSERT_EQ(ran.exitCode, 0) << ran.output;
    EXPECT_THAT(ran.output, HasSubstr("'adhesion force' against adhesion force, 64 of 64 pixels: "
                                      "the prediction explains 100 % of the variance, correlation "
                                      "1.000; rms difference 0 N"));
    const nlohmann::json json = report();
    EXPECT_EQ(json["map"]["mode"], "approach");
    ASSERT_EQ(json["channels"].size(), 2U);
    EXPECT_EQ(json["channels"][0]["quantity"], "adhesion_force");
    EXPECT_EQ(json["channels"][1]["quantity"], "stiffness");
    for (const nlohmann::json& channel : json["channels"]) {
        EXPECT_EQ(channel["correlation"], 1.0);
        EXPECT_EQ(channel["share_explained_by_line"], 1.0);
        EXPECT_EQ(channel["share_explained_as_predicted"], 1.0);
        EXPECT_EQ(channel["removed_plane"], nullptr);
        EXPECT_EQ(channel["remark"], nullptr);
    }
    EXPECT_EQ(json["channels"][1]["rms_difference_n_m"], 0.0);
    const HeightMapFile vti = readHeightMapFile(scratch.file("map.vti"), {});
    EXPECT_EQ(vti.channels.size(), 14U + 4U);
    const ScanChannel& difference = channelNamed(vti, "map.vti", "adhesion_force_difference");
    EXPECT_EQ(difference.unit, "N");
    EXPECT_EQ(difference.map.heights, std::vector<double>(64, 0.0));
    EXPECT_EQ(channelNamed(vti, "map.vti", "stiffness_residual").unit, "N/m");
}

TEST_F(MapCompare, TakesSeveralChannelsForOneQuantity) {
    const auto ran = compare("before.gwy", "--channel 'pull-off force:adhesion_force' "
                                           "--channel 'adhesion force'");
    ASSERT_EQ(ran.exitCode, 0) << ran.output;
    const HeightMapFile vti = readHeightMapFile(scratch.file("map.vti"), {});
    (void)channelNamed(vti, "map.vti", "adhesion_force_difference");
    EXPECT_EQ(channelNamed(vti, "map.vti", "adhesion_force_difference_2").map.heights,
              std::vector<double>(64, 0.0));
}

TEST_F(MapCompare, SaysWhatIsNotDefined) {
    write("flat.gwy", mapOf(flat), "Adhesion", "N");
    const auto ran = compare("flat.gwy", "--channel Adhesion");
    ASSERT_EQ(ran.exitCode, 0) << ran.output;
    EXPECT_THAT(ran.output, HasSubstr("the measured map is constant"));
    const nlohmann::json channel = report()["channels"][0];
    EXPECT_EQ(channel["correlation"], nullptr);
    EXPECT_EQ(channel["share_explained_by_line"], nullptr);
    EXPECT_NEAR(channel["measured_mean_n"].get<double>(), 1e-9, 1e-23);
    EXPECT_THAT(channel["remark"], HasSubstr("the measured map is constant"));

    write("level.gwy", mapOf(flat), "Height", "m");
    const auto level =
        run("level_map.gwy", "--compare " + fileOf("before.gwy") + " --channel 'adhesion force'",
            "level.gwy");
    ASSERT_EQ(level.exitCode, 0) << level.output;
    EXPECT_THAT(level.output, HasSubstr("the predicted map is constant"));
}

TEST_F(MapCompare, DoubtsMeansThatAreFarApart) {
    write("weak.gwy", mapOf([](int row, int column) { return 1e-3 * hills(row, column) + 5e-12; }),
          "Adhesion", "N");
    EXPECT_THAT(compare("weak.gwy", "--channel Adhesion").output, HasSubstr("are far apart"));
    EXPECT_THAT(
        run("same.gwy", "--compare " + fileOf("before.gwy") + " --channel 'adhesion force'").output,
        Not(HasSubstr("far apart")));
}

TEST_F(MapCompare, RefusesInOneSentence) {
    const auto expectRefused = [&](const std::string& file, const std::string& options, int code,
                                   const char* words) {
        const auto ran = compare(file, options);
        EXPECT_EQ(ran.exitCode, code) << ran.output;
        EXPECT_THAT(ran.output, HasSubstr(words));
        EXPECT_FALSE(isThere("map.gwy")) << options;
        EXPECT_FALSE(isThere("map.gwy.part")) << options;
    };
    write("wide.gwy", mapOf(hills, 5e-9), "Adhesion", "N");
    write("volts.gwy", mapOf(hills), "Friction", "V");
    write("deformation.gwy", mapOf(hills), "Deformation", "m");
    write("empty.gsf", mapOf(nothing), "Adhesion", "N");
    expectRefused("none.gwy", "--channel Adhesion", 3, "none.gwy: ");
    expectRefused("empty.gsf", "--channel Adhesion", 3,
                  "it holds no data at the pixels of the map");
    expectRefused("before.gwy", "--channel color", 3, "there is no channel 'color'");
    expectRefused("before.gwy", "", 2, "--compare requires --channel");
    expectRefused("wide.gwy", "--channel Adhesion", 3,
                  "channel 'Adhesion': it shows 80 nm x 80 nm, the scan 64 nm x 64 nm");
    expectRefused("volts.gwy", "--channel Friction", 3, "it has the unit V");
    expectRefused("volts.gwy", "--channel Friction:adhesion_force", 3,
                  "it has the unit V; adhesion_force has N");
    expectRefused("deformation.gwy", "--channel Deformation", 3,
                  "as in --channel 'Deformation:snap_in_distance'");
    expectRefused("deformation.gwy", "--channel Deformation:depth", 3,
                  "the map has no quantity 'depth'");
    expectRefused("before.gwy", "--channel 'iterations:iterations'", 3,
                  "the map has no quantity 'iterations'");
    expectRefused("before.gwy", "--quantities height --channel 'adhesion force'", 3,
                  "which no quantity of the map has: there are height");
}

TEST_F(MapCompare, KeepsTheChannelOfTheScanWithoutAMeasuredFile) {
    EXPECT_EQ(run("map.gwy", "--channel Height").exitCode, 0);
    EXPECT_THAT(run("other.gwy", "--channel Depth").output, HasSubstr("no channel 'Depth'"));
    const auto two = run("other.gwy", "--channel Height --channel Depth");
    EXPECT_EQ(two.exitCode, 2);
    EXPECT_THAT(two.output, HasSubstr("several need --compare"));
}

TEST_F(MapCompare, ReplacesNoInput) {
    const auto measured = run("before.gwy", "--force --compare " + fileOf("before.gwy") +
                                                " --channel 'adhesion force'");
    EXPECT_EQ(measured.exitCode, 1);
    EXPECT_THAT(measured.output, HasSubstr("this is an input"));
    (void)scratch.write("map.compare.json", "precious");
    const auto refused = compare("before.gwy", "--channel 'adhesion force'");
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_THAT(refused.output, HasSubstr("map.compare.json: exists; --force replaces it"));
}

TEST_F(MapCompare, DrawsASheetForEachChannel) {
    const auto ran = test::runProgram("map " + fileOf("hills.gwy") + " --grid 8x8 --out " +
                                      fileOf("map.gwy") + " --compare " + fileOf("before.gwy") +
                                      " --channel 'adhesion force' --channel indentation");
    ASSERT_EQ(ran.exitCode, 0) << ran.output;
    EXPECT_TRUE(isThere("map_compare_1.png"));
    EXPECT_TRUE(isThere("map_compare_2.png"));
    EXPECT_FALSE(isThere("map_compare_3.png"));
}

}  // namespace
}  // namespace asperity
