#include "core/io/heightmap/HeightMapWriter.h"
#include "tests/app/ProgramRun.h"
#include "tests/core/io/heightmap/BumpyMap.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace asperity::test {
namespace {

using testing::HasSubstr;

class CropRuns : public testing::Test {
protected:
    CropRuns() { writeHeightMap(scan, bumpyMap(64, 48), {}); }

    [[nodiscard]] ProgramRun explore(const std::string& input, const std::string& rest) const {
        return runProgram("explore --no-pictures '" + input + "' --duration 0.2 --force --out '" +
                          out.string() + "' " + rest);
    }

    ScratchFolder folder;
    std::filesystem::path scan = folder.file("scan.gsf");
    std::filesystem::path out = folder.file("out");
};

TEST_F(CropRuns, ARunIsOnThatPartAndReplaysToTheSameBits) {
    const ProgramRun run = explore(scan.string(), "--crop 10,8,32,24");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("crop: 32 x 24 pixels from column 10, row 8 of the file"));
    EXPECT_THAT(contentOf(out / "scene.toml"), HasSubstr("crop_px = [ 10, 8, 32, 24 ]"));
    const std::string summary = contentOf(out / "summary.json");
    EXPECT_THAT(summary, HasSubstr("\"columns\": 32"));
    const ProgramRun replay =
        runProgram("replay '" + out.string() + "' --out '" + folder.file("again").string() + "'");
    EXPECT_EQ(replay.exitCode, 0) << replay.output;
    EXPECT_THAT(replay.output, HasSubstr("bit-identical"));
}

TEST_F(CropRuns, TheCommandLineGoesBeforeTheScene) {
    const auto scene =
        folder.write("scene.toml", "[sample]\nfile = \"scan.gsf\"\ncrop_px = [0, 0, 40, 40]\n");
    const ProgramRun asSaid = explore(scene.string(), "");
    ASSERT_EQ(asSaid.exitCode, 0) << asSaid.output;
    EXPECT_THAT(contentOf(out / "scene.toml"), HasSubstr("crop_px = [ 0, 0, 40, 40 ]"));
    const ProgramRun other = explore(scene.string(), "--crop 4,4,20,20");
    ASSERT_EQ(other.exitCode, 0) << other.output;
    EXPECT_THAT(contentOf(out / "scene.toml"), HasSubstr("crop_px = [ 4, 4, 20, 20 ]"));
}

TEST_F(CropRuns, PixelsThatAreNotThereAreRefused) {
    const ProgramRun run = explore(scan.string(), "--crop 60,0,10,10");
    EXPECT_EQ(run.exitCode, 3);
    EXPECT_THAT(run.output, HasSubstr("is not within its 64 x 48 pixels"));
    const auto sphere = folder.write("sphere.toml", "[sample]\nshape = \"sphere\"\n");
    const ProgramRun shape = explore(sphere.string(), "--crop 0,0,10,10");
    EXPECT_EQ(shape.exitCode, 3);
    EXPECT_THAT(shape.output, HasSubstr("has no height map whose channel, scale, crop"));
}

}  // namespace
}  // namespace asperity::test
