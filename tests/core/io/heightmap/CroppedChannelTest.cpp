
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/io/heightmap/ScanFile.h"
#include "tests/core/io/heightmap/BumpyMap.h"
#include "tests/core/io/heightmap/SyntheticScans.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace asperity::test {
namespace {

using testing::HasSubstr;

constexpr PixelRectangle kPart{.column = 7, .row = 5, .columns = 11, .rows = 9};

class CroppedChannelTest : public testing::TestWithParam<std::string> {
protected:
    ScratchFolder folder;
};

/// Formats of whole rows, of strips, of compressed rows and of texts.
TEST_P(CroppedChannelTest, IsThatPartOfTheWholePixelByPixel) {
    const std::filesystem::path path = folder.file(GetParam());
    writeHeightMap(path, bumpyMap(40, 30), {});
    const ScanFile file(path);
    const auto whole = std::get<HeightMap>(file.readSceneScan("").map);
    const auto part = std::get<HeightMap>(file.readSceneScan("", kPart).map);
    ASSERT_EQ(part.columns, kPart.columns);
    ASSERT_EQ(part.rows, kPart.rows);
    ASSERT_EQ(part.heights.size(), 99U);
    EXPECT_EQ(part.pitchX, whole.pitchX);
    EXPECT_EQ(part.pitchY, whole.pitchY);
    for (int row = 0; row < part.rows; ++row) {
        for (int column = 0; column < part.columns; ++column) {
            EXPECT_EQ(part.at(row, column), whole.at(row + kPart.row, column + kPart.column));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, CroppedChannelTest,
                         testing::Values("a.gsf", "a.gwy", "a.tif", "a.png", "a.exr", "a.txt"),
                         [](const auto& name) { return name.param.substr(2); });

TEST_F(CroppedChannelTest, OriginIsTheCornerOfThePart) {
    writeHeightMap(folder.file("map.gwy"), bumpyMap(10, 8), {"Height", 1e-6, 2e-6});
    const ScanFile file(folder.file("map.gwy"));
    const SceneScan part = file.readSceneScan("", PixelRectangle{3, 1, 4, 2});
    const HeightMap map = std::get<HeightMap>(part.map);
    EXPECT_DOUBLE_EQ(part.originX, 1e-6 + 3 * map.pitchX);
    EXPECT_DOUBLE_EQ(part.originY, 2e-6 + 5 * map.pitchY);
}

TEST_F(CroppedChannelTest, KeepsTheMarksOfPixelsWithoutData) {
    const std::filesystem::path path = folder.file("a.gwy");
    writeHeightMap(path, bumpyMapWithHoles(8, 6), {});  // the first and the fifth
    const ScanFile file(path);
    const auto part = std::get<HeightMap>(file.readSceneScan("", PixelRectangle{3, 0, 4, 2}).map);
    EXPECT_FALSE(part.isValid(0, 1));
    EXPECT_TRUE(part.isValid(0, 0));
    const auto clean = std::get<HeightMap>(file.readSceneScan("", PixelRectangle{1, 1, 4, 2}).map);
    EXPECT_TRUE(clean.invalid.empty());
}

TEST_F(CroppedChannelTest, RefusesPixelsThatAreNotThere) {
    const std::filesystem::path path = folder.file("a.gsf");
    writeHeightMap(path, bumpyMap(40, 30), {});
    const ScanFile file(path);
    constexpr int kMax = std::numeric_limits<int>::max();
    for (const PixelRectangle part :
         {PixelRectangle{30, 0, 11, 5}, PixelRectangle{0, 25, 5, 6}, PixelRectangle{40, 0, 1, 1},
          PixelRectangle{0, 0, 0, 5}, PixelRectangle{-1, 0, 5, 5},
          PixelRectangle{kMax, 1, kMax, 1}}) {
        EXPECT_NE(refusalOf([&] { (void)file.readSceneScan("", part); }), "") << part.column;
    }
    EXPECT_THAT(refusalOf([&] {
                    (void)file.readSceneScan("", PixelRectangle{30, 2, 11, 5});
                }),
                HasSubstr("a crop of 11 x 5 pixels from column 30, row 2 is not within its 40 x "
                          "30 pixels"));
    EXPECT_NO_THROW((void)file.readSceneScan("", PixelRectangle{39, 29, 1, 1}));
}

/// Damage elsewhere does not matter; in the part it is named by its location in the file.
TEST_F(CroppedChannelTest, NamesADamagedPixelByItsLocationInTheFile) {
    std::vector<double> values(3 * 2, 0.0);
    values[4] = 7e300;
    const std::string field = gwyObjectBytes(
        "GwyDataField", gwyInteger("xres", 3) + gwyInteger("yres", 2) + gwyNumber("xreal", 3e-6) +
                            gwyNumber("yreal", 2e-6) + gwyUnit("si_unit_xy", "m") +
                            gwyUnit("si_unit_z", "m") + gwyNumbers("data", values));
    const ScanFile file(folder.write("a.gwy", gwyFile(gwyComponent("/0/data", field))));
    EXPECT_THAT(refusalOf([&] {
                    (void)file.readSceneScan("", PixelRectangle{1, 1, 2, 1});
                }),
                HasSubstr("the pixel in column 1, row 1 "));
    EXPECT_NO_THROW((void)file.readSceneScan("", PixelRectangle{0, 0, 3, 1}));
}

}  // namespace
}  // namespace asperity::test
