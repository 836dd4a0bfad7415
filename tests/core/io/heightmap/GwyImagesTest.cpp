#include "core/Error.h"
#include "core/io/heightmap/HeightMapFile.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/io/heightmap/ScanFile.h"
#include "tests/core/io/heightmap/BumpyMap.h"
#include "tests/support/ProgressRecorder.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// Several images in one file.

namespace asperity::test {

namespace {

/// Heights without data at two pixels, voltages, and numbers of unknown size.
struct Images {
    HeightMap heights = bumpyMapWithHoles(7, 4);
    HeightMap voltages = bumpyMap(3, 5);
    std::vector<WrittenImage> all = {
        {rowsOf(heights),
         {.title = "高さ (forward)",
          .originX = 1e-6,
          .metadata = {{"Scan rate", "1 Hz"}, {"Оператор", "Анна"}}}},
        {rowsOf(voltages), {.title = "Deflection (backward)", .unit = "V"}},
        {rowsOf(voltages), {.title = "Counts", .unit = ""}, ""}};

    Images() { all[2].rows.pitchX = all[2].rows.pitchY = 0.0; }
};

}  // namespace

TEST(GwyImages, AllComeBackWithNamesUnitsMasksAndMetadata) {
    const ScratchFolder folder;
    const Images images;
    writeHeightMaps(folder.file("all.gwy"), images.all);
    const HeightMapFile file = readHeightMapFile(folder.file("all.gwy"), {});
    ASSERT_EQ(file.channels.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(file.channels[i].name, images.all[i].meta.title);
        EXPECT_EQ(file.channels[i].unit, images.all[i].meta.unit);
        EXPECT_EQ(file.channels[i].lateralUnit, images.all[i].lateralUnit);
        EXPECT_EQ(file.channels[i].metadata, images.all[i].meta.metadata);
    }
    EXPECT_EQ(file.channels[0].direction, "forward");
    EXPECT_EQ(file.channels[1].direction, "backward");
    EXPECT_EQ(file.channels[0].originX, 1e-6);
    EXPECT_EQ(file.channels[0].map.invalid, images.heights.invalid);
    EXPECT_TRUE(file.channels[0].hasSize());
    EXPECT_EQ(file.channels[1].map.heights, images.voltages.heights);
    EXPECT_FALSE(file.channels[2].hasSize());
}

TEST(GwyImages, OtherFormatsHoldOne) {
    const ScratchFolder folder;
    EXPECT_THROW(writeHeightMaps(folder.file("all.gsf"), Images().all), Error);
    EXPECT_NE(writeAllRefusal("all.gsf").find(".gwy"), std::string::npos);
    EXPECT_NE(writeAllRefusal("all.doc"), "");
    EXPECT_EQ(writeAllRefusal("all.GWY"), "");
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(GwyImages, TellHowFarTheyAre) {
    const ScratchFolder folder;
    ProgressRecorder recorder(2.0);
    writeHeightMaps(folder.file("all.gwy"), Images().all, &recorder);
    EXPECT_TRUE(std::ranges::is_sorted(recorder.fractions));
    EXPECT_EQ(recorder.fractions.back(), 1.0);
}

/// The rows that the file's channels give are those that are written.
TEST(GwyImages, AreReadRowByRow) {
    const ScratchFolder folder;
    writeHeightMaps(folder.file("all.gwy"), Images().all);
    const ScanFile file(folder.file("all.gwy"));
    const HeightRows rows = file.rowsOf(file.contents().channels[1]);
    ASSERT_EQ(rows.columns, 3);
    std::vector<double> values(3);
    for (int row = rows.rows - 1; row >= 0; --row) {
        rows.readRow(row, values.data());
        EXPECT_EQ(values[2], bumpyMap(3, 5).at(row, 2));
    }
    EXPECT_EQ(file.rowsOf(file.contents().channels[2]).pitchX, 0.0);
}

}  // namespace asperity::test
