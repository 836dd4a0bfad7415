#include "vtkplugins/pictures/MapSheet.h"

#include "core/Error.h"
#include "tests/vtkplugins/NeedsDisplay.h"
#include "tests/vtkplugins/PictureFixture.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <vector>

namespace asperity {

namespace {

constexpr double kNoData = std::numeric_limits<double>::quiet_NaN();

class MapSheets : public test::Pictures {};

/// Low values on the left, high ones on the right, none in the lower right pixel.
SheetMap halves() {
    return {.quantity = "pull-off force",
            .unit = "N",
            .columns = 2,
            .rows = 2,
            .width = 1e-6,
            .height = 1e-6,
            .values = {1e-9, 3e-9, 1e-9, kNoData}};
}

int countOf(const test::Image& image, int red, int green, int blue) {
    return image.count([&](const auto& rgb) {
        return std::abs(rgb[0] - red) < 3 && std::abs(rgb[1] - green) < 3 &&
               std::abs(rgb[2] - blue) < 3;
    });
}

/// Of the color bar of a sheet with one map.
int ticksOf(const test::Image& image) {
    constexpr int kBelowBar = 31;  // where ticks are drawn, and no labels [pixel]
    int ticks = 0;
    bool wasTick = false;
    for (int x = 0; x < image.width(); ++x) {
        const auto rgb = image.at(x, kBelowBar);
        const bool isTick = rgb[0] + rgb[1] + rgb[2] < 700;
        ticks += isTick && !wasTick ? 1 : 0;
        wasTick = isTick;
    }
    return ticks;
}

TEST_F(MapSheets, ShowPixelsInTheirColorsAndPositions) {
    ASPERITY_NEEDS_DISPLAY();
    const std::filesystem::path path = folder / "sheet.png";
    writeMapSheet(path, "A map", std::vector{halves()});
    const test::Image image(path);
    const auto low = image.at(160, 200);
    const auto high = image.at(400, 420);
    EXPECT_LT(low[0] + low[1] + low[2], high[0] + high[1] + high[2]);
    EXPECT_NEAR(image.at(400, 200)[0], 190, 2) << "no data is gray";
    const int gray = countOf(image, 190, 190, 190);
    EXPECT_NEAR(gray, countOf(image, high[0], high[1], high[2]), 0.05 * gray);
}

TEST_F(MapSheets, HaveTwoTicksOrMoreOnEachColorBar) {
    ASPERITY_NEEDS_DISPLAY();
    SheetMap map = halves();
    for (const CentralRange& range :
         {CentralRange{1.28e-9, 1.41e-9}, {0.0, 9e-9}, {1.05e-9, 1.66e-9}, {7.7e-10, 1.9e-9}}) {
        map.range = range;
        writeMapSheet(folder / "sheet.png", "A map", std::vector{map});
        EXPECT_GE(ticksOf(test::Image(folder / "sheet.png")), 2) << range.low << " " << range.high;
    }
}

/// Else its bar would go from a value to the same value.
TEST_F(MapSheets, ShowAMapOfOneValueInTheMiddleOfARange) {
    ASPERITY_NEEDS_DISPLAY();
    const auto drawn = [&](const SheetMap& map) {
        writeMapSheet(folder / "sheet.png", "A map", std::vector{map});
        return test::Image(folder / "sheet.png");
    };
    SheetMap map = halves();
    map.values = std::vector(4, 2e-9);
    const test::Image one = drawn(map);
    map.range = CentralRange{1.5e-9, 2.5e-9};
    EXPECT_EQ(one.at(280, 300), drawn(map).at(280, 300)) << "the middle of the colors";
    EXPECT_GE(ticksOf(one), 2);
    map.range.reset();
    map.values = std::vector(4, 0.0);
    EXPECT_GE(ticksOf(drawn(map)), 2) << "zero everywhere";
}

/// 0.2 µm of a map of 1 µm, in its lower left corner.
TEST_F(MapSheets, HaveAScaleBar) {
    ASPERITY_NEEDS_DISPLAY();
    SheetMap map = halves();
    map.values = {1e-9, 1e-9, 3e-9, 1e-9};  // bright below the bar
    writeMapSheet(folder / "sheet.png", "A map", std::vector{map});
    const test::Image image(folder / "sheet.png");
    int dark = 0;
    for (int x = 50; x < 250; ++x) {
        const auto rgb = image.at(x, 86);
        dark += rgb[0] + rgb[1] + rgb[2] < 200 ? 1 : 0;
    }
    constexpr double kMapWidth = 468.0;
    EXPECT_NEAR(dark, 0.2 * kMapWidth, 3.0);
}

TEST_F(MapSheets, ShowSignsByColor) {
    ASPERITY_NEEDS_DISPLAY();
    SheetMap map = halves();
    map.values = {-1e-9, 3e-9, 0.0, kNoData};
    map.isSigned = true;
    writeMapSheet(folder / "sheet.png", "A map", std::vector{map});
    const test::Image image(folder / "sheet.png");
    const auto negative = image.at(160, 420);
    const auto positive = image.at(400, 420);
    EXPECT_GT(negative[0], negative[2]) << "orange";
    EXPECT_GT(positive[2], positive[0] + 50) << "blue";
    const auto zero = image.at(160, 200);
    EXPECT_LT(std::abs(zero[0] - zero[2]), 12) << "neutral";
}

TEST_F(MapSheets, ShowTheSameValueAlikeOverTheSameRange) {
    ASPERITY_NEEDS_DISPLAY();
    SheetMap wide = halves();
    wide.values = {1e-9, 9e-9, 9e-9, 9e-9};
    wide.range = CentralRange{.low = 0.0, .high = 9e-9};
    SheetMap narrow = halves();
    narrow.range = wide.range;
    writeMapSheet(folder / "sheet.png", "Maps", std::vector{wide, narrow});
    const test::Image image(folder / "sheet.png");
    EXPECT_EQ(image.at(160, 420), image.at(560 + 160, 420)) << "1 nN in both";
    EXPECT_NE(image.at(400, 420), image.at(560 + 400, 420)) << "9 nN and 3 nN";
}

TEST_F(MapSheets, HaveRoomForAChart) {
    ASPERITY_NEEDS_DISPLAY();
    const std::array<std::uint8_t, 4> red{255, 0, 0, 255};
    const auto sizeWith = [&](std::size_t maps) {
        PictureSize room;
        writeMapSheet(folder / "sheet.png", "Maps", std::vector(maps, halves()),
                      [&](const PictureSize& size) {
                          room = size;
                          RasterImage chart{.width = kChartPixels * size.width,
                                            .height = kChartPixels * size.height,
                                            .pixels = {}};
                          while (chart.pixels.size() <
                                 chart.rowBytes() * static_cast<std::size_t>(chart.height)) {
                              chart.pixels.insert(chart.pixels.end(), red.begin(), red.end());
                          }
                          return chart;
                      });
        const test::Image image(folder / "sheet.png");
        EXPECT_EQ(image.count([](const auto& rgb) {
            return rgb == std::array<int, 3>{255, 0, 0};
        }),
                  room.width * room.height);
        return std::pair(image.width(), image.height());
    };
    EXPECT_EQ(sizeWith(4), std::pair(3 * 560, 56 + 2 * 560)) << "beside the fourth map";
    EXPECT_EQ(sizeWith(3), std::pair(3 * 560, 56 + 2 * 560)) << "in a row of its own";
    EXPECT_EQ(sizeWith(1), std::pair(3 * 560, 56 + 560));
}

TEST_F(MapSheets, RefuseWhatIsNoMap) {
    SheetMap uneven = halves();
    uneven.values.pop_back();
    EXPECT_THROW(writeMapSheet(folder / "sheet.png", "", std::vector{uneven}), Error);
    EXPECT_THROW(writeMapSheet(folder / "sheet.png", "", {}), Error);
    EXPECT_THROW(writeMapSheet(folder / "sheet.png", "", std::vector(7, halves())), Error);
}

}  // namespace
}  // namespace asperity
