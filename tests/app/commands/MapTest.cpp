#include "core/io/heightmap/HeightMapWriter.h"
#include "core/io/heightmap/ScanFile.h"
#include "tests/app/ProgramRun.h"
#include "tests/app/TracedProgram.h"
#include "tests/support/Places.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

// `asperity map`

namespace asperity {
namespace {

using testing::HasSubstr;

/// Hills of 8 nm on 64 x 64 pixels of 2 nm.
class Map : public testing::Test {
protected:
    void SetUp() override {
        HeightMap map{.columns = 64, .rows = 64, .pitchX = 2e-9, .pitchY = 2e-9};
        for (int row = 0; row < map.rows; ++row) {
            for (int column = 0; column < map.columns; ++column) {
                constexpr double kWave = 2.0 * std::numbers::pi / 25.0;
                map.heights.push_back(4e-9 * std::sin(kWave * row) * std::cos(kWave * column));
            }
        }
        writeHeightMap(scratch.file("hills.gwy"), map, {.title = "Height"});
    }
    [[nodiscard]] std::string arguments(const std::string& out, const std::string& options) const {
        return "map " + scratch.file("hills.gwy").string() + " --out " +
               scratch.file(out).string() + " " + options;
    }
    [[nodiscard]] test::ProgramRun run(const std::string& out, const std::string& options) const {
        return test::runProgram(arguments(out, options + " --no-pictures"));
    }
    [[nodiscard]] HeightMapFile read(const std::string& name) const {
        return readHeightMapFile(scratch.file(name), {});
    }
    [[nodiscard]] bool isThere(const std::string& name) const {
        return std::filesystem::exists(scratch.file(name));
    }
    void expectSameFiles(const std::string& one, const std::string& other) const {
        for (const char* end : {".gwy", ".vti", ".exr"}) {
            EXPECT_EQ(test::contentOf(scratch.file(one + end)),
                      test::contentOf(scratch.file(other + end)))
                << end;
        }
    }

    test::ScratchFolder scratch;
};

const ScanChannel& channelOf(const HeightMapFile& file, const std::string& name) {
    const auto found = std::ranges::find(file.channels, name, &ScanChannel::name);
    EXPECT_NE(found, file.channels.end()) << name;
    return *found;
}

TEST_F(Map, WritesEveryQuantityWithItsUnit) {
    const auto ran = run("map.gwy", "--grid 8x6 --setpoint 5nN");
    ASSERT_EQ(ran.exitCode, 0) << ran.output;
    EXPECT_THAT(ran.output, HasSubstr("8 x 6 pixels; 48 of them computed in"));
    const HeightMapFile gwy = read("map.gwy");
    EXPECT_EQ(gwy.channels.size(), 14U);
    const ScanChannel& pull = channelOf(gwy, "pull-off force");
    EXPECT_EQ(pull.unit, "N");
    EXPECT_EQ(pull.map.columns, 8);
    EXPECT_EQ(pull.map.rows, 6);
    EXPECT_NEAR(pull.map.sizeX(), 128e-9, 1e-15);
    EXPECT_GT(pull.map.heights[0], 1e-9);
    EXPECT_EQ(channelOf(gwy, "contact stiffness").unit, "N/m");
    const HeightMapFile vti = read("map.vti");
    EXPECT_EQ(channelOf(vti, "pull_off_force").map.heights, pull.map.heights);
    EXPECT_EQ(channelOf(vti, "apparent_modulus").unit, "Pa");
    EXPECT_EQ(read("map.exr").channels.size(), 14U);
    EXPECT_FALSE(isThere("map.gwy.part"));
}

/// It was that of the region in the scan alone.
TEST_F(Map, OriginIsTheCornerOfItsRegionInTheFrameOfTheInstrument) {
    const HeightMap flat{.columns = 16,
                         .rows = 16,
                         .pitchX = 2e-9,
                         .pitchY = 2e-9,
                         .heights = std::vector<double>(256, 0.0)};
    writeHeightMap(scratch.file("hills.gwy"), flat,
                   {.title = "Height", .originX = 1e-6, .originY = -2e-6});
    const auto ran = run("map.gwy", "--grid 2x2 --region 8e-9,4e-9,24e-9,20e-9");
    ASSERT_EQ(ran.exitCode, 0) << ran.output;
    const HeightMapFile gwy = read("map.gwy");
    const ScanChannel& pull = channelOf(gwy, "pull-off force");
    EXPECT_NEAR(pull.originX, 1.008e-6, 1e-15);
    EXPECT_NEAR(pull.originY, -1.996e-6, 1e-15);
}

/// A blank in a map of deviations was taken for 0.
TEST_F(Map, SaysHowManyStandardDeviationsAreUnknown) {
    HeightMap ridges{.columns = 64, .rows = 8, .pitchX = 2e-9, .pitchY = 2e-9};
    for (int row = 0; row < ridges.rows; ++row) {
        for (int column = 0; column < ridges.columns; ++column) {
            constexpr double kWave = 2.0 * std::numbers::pi / 30.0;
            ridges.heights.push_back(25e-9 * std::sin(kWave * (column + 0.5)));
        }
    }
    writeHeightMap(scratch.file("hills.gwy"), ridges, {.title = "Height"});
    const auto ran = run("map.gwy", "--grid 32x1 --uncertainty");
    ASSERT_EQ(ran.exitCode, 0) << ran.output;
    const HeightMapFile gwy = read("map.gwy");
    const ScanChannel& deviation = channelOf(gwy, "adhesion force, standard deviation");
    const auto unknown = std::ranges::count(deviation.map.invalid, true);
    ASSERT_GT(unknown, 0);
    ASSERT_LT(unknown, 32);
    const std::string sentence = "unknown in " + std::to_string(unknown) + " of 32 pixels, not 0";
    EXPECT_THAT(ran.output,
                HasSubstr("note: adhesion force, standard deviation: " + sentence + ": several"));
    EXPECT_THAT(deviation.metadata.at("remark"), HasSubstr(sentence));
    EXPECT_FALSE(channelOf(gwy, "adhesion force").metadata.contains("remark"));
}

TEST_F(Map, OfContactHasTraceAndRetrace) {
    const auto ran = run("map.gwy", "--grid 8x4 --mode contact");
    ASSERT_EQ(ran.exitCode, 0) << ran.output;
    const HeightMapFile file = read("map.gwy");
    EXPECT_EQ(file.channels.size(), 9U);
    EXPECT_GT(channelOf(file, "friction force").map.heights[3], 0.0);
    EXPECT_EQ(channelOf(file, "deflection error, trace").unit, "m");
}

TEST_F(Map, OfARegionHasThePixelsOfTheScan) {
    const auto ran = run("map.gwy", "--region 20e-9,30e-9,30e-9,36e-9 --quantities height");
    ASSERT_EQ(ran.exitCode, 0) << ran.output;
    const HeightMapFile file = read("map.gwy");
    ASSERT_EQ(file.channels.size(), 1U);
    EXPECT_EQ(file.channels[0].map.columns, 5);
    EXPECT_EQ(file.channels[0].map.rows, 3);
}

TEST_F(Map, DoesNotDependOnThreads) {
    for (const std::string mode : {"approach", "contact"}) {
        for (const std::string threads : {"1", "2", "3"}) {
            const auto ran = run(mode + threads + ".gwy",
                                 "--grid 10x9 --mode " + mode + " --threads " + threads);
            ASSERT_EQ(ran.exitCode, 0) << ran.output;
            expectSameFiles(mode + "1", mode + threads);
        }
    }
}

TEST_F(Map, RefusesInOneSentence) {
    const auto expectRefused = [&](const std::string& options, int code, const char* words) {
        const auto ran = run("map.gwy", options);
        EXPECT_EQ(ran.exitCode, code) << ran.output;
        EXPECT_THAT(ran.output, HasSubstr(words));
        EXPECT_FALSE(isThere("map.gwy")) << options;
        EXPECT_FALSE(isThere("map.gwy.part")) << options;
    };
    expectRefused("--quantities color", 1, "has no quantity 'color'");
    expectRefused("--mode contact --quantities pull_off_force", 1, "has no quantity");
    expectRefused("--region 0,0,1e-6,1e-8", 1, "the region of the map lies outside the scan");
    expectRefused("--region 0,0,10nm,10nm", 2,
                  "expected x0,y0,x1,y1 in meters, such as 0,0,1e-7,1e-7, not '10nm'");
    expectRefused("--region 0,0,nan,1", 2, "expected x0,y0,x1,y1 in meters");
    expectRefused("--grid 0x8", 1, "1 to 65536 pixels");
    expectRefused("--grid 8", 2, "expected WIDTHxHEIGHT");
    expectRefused("--grid 60000x60000", 1, "a .gwy file holds at most 4 GiB");
    EXPECT_EQ(run("map.tif", "").exitCode, 2);
}

TEST_F(Map, ReplacesNothingUnasked) {
    EXPECT_THAT(run("hills.gwy", "--force").output, HasSubstr("this is an input"));
    (void)scratch.write("map.vti", "precious");
    const auto refused = run("map.gwy", "--grid 4x4");
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_THAT(refused.output, HasSubstr("map.vti: exists; --force replaces it"));
    EXPECT_EQ(test::contentOf(scratch.file("map.vti")), "precious");
    EXPECT_EQ(run("map.gwy", "--grid 4x4 --force").exitCode, 0);
}

TEST_F(Map, LeavesAFolderOfThePartsNameAlone) {
    std::filesystem::create_directory(scratch.file("map.gwy.part"));
    const auto refused = run("map.gwy", "--grid 4x4 --force");
    EXPECT_EQ(refused.exitCode, 3);
    EXPECT_THAT(refused.output, HasSubstr("no regular file"));
    EXPECT_TRUE(std::filesystem::is_directory(scratch.file("map.gwy.part")));
}

TEST_F(Map, ThatIsWholeHasNothingLeftToDo) {
    ASSERT_EQ(run("map.gwy", "--grid 4x4").exitCode, 0);
    const auto again = run("map.gwy", "--grid 4x4 --resume");
    EXPECT_EQ(again.exitCode, 0) << again.output;
    EXPECT_THAT(again.output, HasSubstr("map.gwy: the map is whole; nothing is left to do"));
    const auto other = run("map.gwy", "--grid 4x4 --resume --setpoint 7nN");
    EXPECT_EQ(other.exitCode, 1) << other.output;
    EXPECT_THAT(other.output, HasSubstr("exists; --force replaces it"));
    std::filesystem::remove(scratch.file("map.vti"));
    const auto incomplete = run("map.gwy", "--grid 4x4 --resume");
    EXPECT_EQ(incomplete.exitCode, 1) << incomplete.output;
    EXPECT_THAT(incomplete.output, HasSubstr("the map is whole, but there is no map.vti"));
}

/// Ends a map by a signal when some rows are finished. @return its exit code
int interrupted(std::vector<std::string> arguments) {
    constexpr std::uint64_t kSomeRows = 30000;  // [bytes]
    arguments.insert(arguments.begin(), test::programOfBuild("asperity").string());
    const test::TracedEnd end =
        test::runTraced(arguments, {}, {.bytes = kSomeRows, .signal = SIGINT});
    EXPECT_TRUE(end.wasSignaled);
    return end.exitCode;
}

TEST_F(Map, ThatIsCanceledIsValidAndGoesOn) {
    const std::string scan = scratch.file("hills.gwy").string();
    const std::vector<std::string> arguments{"map", scan, "--out", scratch.file("map.gwy").string(),
                                             "--no-pictures"};
    ASSERT_EQ(interrupted(arguments), 1);
    const HeightMapFile partial = read("map.gwy");
    const ScanChannel& pull = channelOf(partial, "pull-off force");
    const auto missing = std::ranges::count(pull.map.invalid, true);
    EXPECT_GT(missing, 0);
    EXPECT_LT(missing, 64 * 64);
    EXPECT_EQ(missing % 64, 0) << "rows are whole";

    const auto other = run("map.gwy", "--resume --setpoint 7nN");
    EXPECT_EQ(other.exitCode, 1);
    EXPECT_THAT(other.output, HasSubstr("map.gwy.part: holds rows of another map"));
    const auto unasked = run("map.gwy", "");
    EXPECT_EQ(unasked.exitCode, 1);
    EXPECT_THAT(unasked.output, HasSubstr("rows of an unfinished map; --resume continues it"));

    const auto resumed = run("map.gwy", "--resume");
    EXPECT_EQ(resumed.exitCode, 0) << resumed.output;
    EXPECT_FALSE(isThere("map.gwy.part"));
    EXPECT_EQ(run("whole.gwy", "").exitCode, 0);
    expectSameFiles("whole", "map");
}

TEST_F(Map, DrawsSheetsOfItsQuantities) {
    const auto ran = test::runProgram(arguments("map.gwy", "--grid 12x12"));
    ASSERT_EQ(ran.exitCode, 0) << ran.output;
    for (const char* sheet : {"map_1.png", "map_2.png", "map_3.png"}) {
        EXPECT_TRUE(isThere(sheet)) << sheet;
    }
    EXPECT_FALSE(isThere("map_4.png"));
    (void)scratch.write("other_2.png", "precious");
    const auto refused = test::runProgram(arguments("other.gwy", "--grid 12x12"));
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_THAT(refused.output, HasSubstr("other_2.png: exists; --force replaces it"));
}

}  // namespace
}  // namespace asperity
