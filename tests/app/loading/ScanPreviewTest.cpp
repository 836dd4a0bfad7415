#include "app/loading/ScanPreview.h"

#include "core/Error.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "tests/core/io/heightmap/BumpyMap.h"
#include "tests/core/io/heightmap/RealScans.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <string>

namespace asperity::test {
namespace {

using testing::HasSubstr;

class ScanPreviewTest : public testing::Test {
protected:
    ScanPreviewTest() { writeHeightMap(scan, map, {.title = "Topography"}); }

    ScratchFolder folder;
    HeightMap map = bumpyMapWithHoles(40, 30);
    std::filesystem::path scan = folder.file("scan.gwy");
    ScanPreviewer previewer;
};

TEST_F(ScanPreviewTest, TellsWhatTheFileHolds) {
    const ScanPreview preview = previewer.preview(scan, {});
    EXPECT_EQ(preview.format, "Gwyddion .gwy");
    ASSERT_EQ(preview.channels.size(), 1U);
    EXPECT_EQ(preview.channels.front().name, "Topography");
    EXPECT_EQ(preview.channels.front().unit, "m");
    EXPECT_TRUE(preview.channels.front().opens);
    EXPECT_EQ(preview.channel, "Topography");
    EXPECT_EQ(preview.columns, 40);
    EXPECT_EQ(preview.rows, 30);
    EXPECT_NEAR(preview.sizeX, 120e-9, 1e-15);
    EXPECT_NEAR(preview.sizeY, 150e-9, 1e-15);
    EXPECT_EQ(preview.whole.statistics.invalidPixels, 2U);
    EXPECT_FALSE(preview.provenance.empty());
    EXPECT_EQ(preview.refusal, "");
    EXPECT_FALSE(preview.gap);
}

TEST_F(ScanPreviewTest, LevelsAsTheSceneOrTheUserSays) {
    const ScanPreview usual = previewer.preview(scan, {});
    EXPECT_EQ(textOf(usual.leveling), "plane");
    EXPECT_NEAR(usual.leveled.statistics.mean, 0.0, 1e-15);
    EXPECT_LT(usual.leveled.statistics.rms, usual.part.statistics.rms);
    const ScanPreview none = previewer.preview(scan, {.leveling = LevelingSteps()});
    EXPECT_EQ(none.leveled.statistics.rms, none.part.statistics.rms);
    const ScanPreview zero =
        previewer.preview(scan, {.leveling = LevelingSteps{LevelingStep::Zero}});
    EXPECT_EQ(zero.leveled.statistics.lowest, 0.0);
    const auto scene =
        folder.write("scene.toml", "[sample]\nfile = \"scan.gwy\"\nlevel = [\"rows\", \"zero\"]\n");
    EXPECT_EQ(textOf(previewer.preview(scene, {}).leveling), "rows, zero");
}

TEST_F(ScanPreviewTest, CropsBeforeItLevels) {
    const ScanPreview preview = previewer.preview(scan, {.crop = PixelRectangle{10, 5, 20, 10}});
    EXPECT_EQ(preview.whole.map.columns, 40) << "to draw the part on";
    EXPECT_EQ(preview.part.map.columns, 20);
    EXPECT_EQ(preview.part.map.at(0, 0), preview.whole.map.at(5, 10));
    EXPECT_NEAR(preview.leveled.statistics.mean, 0.0, 1e-15);
    const auto scene =
        folder.write("scene.toml", "[sample]\nfile = \"scan.gwy\"\ncrop_px = [1, 2, 8, 9]\n");
    EXPECT_EQ(previewer.preview(scene, {}).crop, (PixelRectangle{1, 2, 8, 9}));
    const ScanPreview all = previewer.preview(scene, {.crop = PixelRectangle{0, 0, 40, 30}});
    EXPECT_FALSE(all.crop) << "all of it is no part";
    EXPECT_EQ(all.part.map.columns, 40);
}

TEST_F(ScanPreviewTest, SaysWhyAPartCannotBeOpened) {
    const ScanPreview preview = previewer.preview(scan, {.crop = PixelRectangle{30, 0, 20, 10}});
    EXPECT_THAT(preview.refusal, HasSubstr("is not within its 40 x 30 pixels"));
    EXPECT_FALSE(preview.whole.map.heights.empty());
    EXPECT_TRUE(preview.leveled.map.heights.empty());
    EXPECT_THAT(refusalOf([&] { (void)previewer.preview(scan, {.channel = "Phase"}); }),
                HasSubstr("there is no channel 'Phase'"));
}

TEST_F(ScanPreviewTest, AsksForTheScaleAlsoOnceItIsGiven) {
    const auto text = folder.write("scan.txt", "0 1 2 3\n1 2 3 4\n2 3 4 5\n");
    const ScanPreview asked = previewer.preview(text, {});
    ASSERT_TRUE(asked.gap);
    EXPECT_TRUE(asked.gap->size && asked.gap->height);
    EXPECT_EQ(asked.refusal, "");
    EXPECT_EQ(asked.whole.statistics.highest, 5.0);
    EXPECT_FALSE(asked.leveled.map.heights.empty()) << "the picture needs no size";
    const ScanPreview given = previewer.preview(text, {.scale = {4e-6, 3e-6, 1e-9}});
    EXPECT_EQ(given.gap, asked.gap);
    EXPECT_EQ(given.sizeX, 4e-6);
    EXPECT_EQ(given.unit, "m");
    EXPECT_NEAR(given.whole.statistics.highest, 5e-9, 1e-18);
    const auto scene = folder.write("scene.toml", "[sample]\nfile = \"scan.txt\"\nsize_x_m = 4e-6\n"
                                                  "size_y_m = 3e-6\nz_scale_m = 1e-9\n");
    EXPECT_FALSE(previewer.preview(scene, {}).gap) << "the scene says it";
}

TEST_F(ScanPreviewTest, SeesThatAFileHasBecomeAnother) {
    (void)previewer.preview(scan, {});
    writeHeightMap(scan, bumpyMap(16, 8), {});
    std::filesystem::last_write_time(scan, std::filesystem::last_write_time(scan) +
                                               std::chrono::seconds(1));
    EXPECT_EQ(previewer.preview(scan, {}).columns, 16);
}

TEST_F(ScanPreviewTest, ShowsAShape) {
    const auto scene = folder.write("sphere.toml", "[sample]\nshape = \"sphere\"\n");
    const ScanPreview preview = previewer.preview(scene, {});
    EXPECT_TRUE(preview.channels.empty());
    EXPECT_EQ(preview.columns, 256);
    EXPECT_EQ(preview.refusal, "");
}

/// Every real file is looked into without a crash; where it says that it opens, it does.
TEST_F(ScanPreviewTest, LooksIntoEveryRealScan) {
    ASPERITY_NEEDS_SHARED_DATA();
    int opened = 0;
    for (const std::string& file : realScans()) {
        SCOPED_TRACE(file);
        ScanPreview preview;
        ASSERT_NO_THROW(preview = previewer.preview(sharedData("afm/" + file), {}));
        EXPECT_FALSE(preview.channels.empty());
        EXPECT_FALSE(preview.whole.map.heights.empty());
        EXPECT_TRUE(preview.refusal.empty() != preview.leveled.map.heights.empty());
        for (const PreviewedChannel& channel : preview.channels) {
            EXPECT_NO_THROW(
                (void)previewer.preview(sharedData("afm/" + file), {.channel = channel.name}));
        }
        if (preview.refusal.empty() && !preview.gap) {
            ++opened;
        }
    }
    EXPECT_GT(opened, 20);
}

TEST_F(ScanPreviewTest, RefusesDamagedFilesInWords) {
    ASPERITY_NEEDS_SHARED_DATA();
    for (const MalformedScan& bad : malformedScans()) {
        EXPECT_THAT(refusalOf([&] { (void)previewer.preview(sharedData("afm/" + bad.file), {}); }),
                    testing::AllOf(HasSubstr(bad.location), HasSubstr(bad.reason)))
            << bad.file;
    }
    EXPECT_NE(refusalOf([&] { (void)previewer.preview(folder.file("none.gsf"), {}); }), "");
    const auto bad = folder.write("bad.toml", "[sample]\nfile = \"scan.gwy\"\nradius = 3\n");
    EXPECT_THAT(refusalOf([&] { (void)previewer.preview(bad, {}); }),
                HasSubstr("unknown key 'radius'"));
}

}  // namespace
}  // namespace asperity::test
