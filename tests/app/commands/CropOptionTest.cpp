#include "app/commands/ScaleOption.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace asperity {
namespace {

std::string refusalOf(const std::string& text, std::optional<PixelRectangle>& crop) {
    CLI::App command;
    addCropOption(command, crop);
    try {
        command.parse(std::vector<std::string>{text, "--crop"});  // last one first
    } catch (const CLI::ParseError& error) {
        return error.what();
    }
    return "";
}

TEST(CropOption, IsColumnRowColumnsRows) {
    std::optional<PixelRectangle> crop;
    EXPECT_EQ(refusalOf("20,30,100,80", crop), "");
    EXPECT_EQ(crop, (PixelRectangle{.column = 20, .row = 30, .columns = 100, .rows = 80}));
    EXPECT_EQ(parseCrop("0,0,1,1"), (PixelRectangle{0, 0, 1, 1}));
}

TEST(CropOption, RefusesEverythingElseInWords) {
    std::optional<PixelRectangle> crop;
    for (const char* text : {"20,30,100", "20,30,100,80,5", "20,30,100,80,", "-1,0,5,5", "0,0,0,5",
                             "0,0,5,0", "0,0,5.5,5", "a,b,c,d", "0,0,5,99999999999", "20 30 5 5"}) {
        EXPECT_THAT(refusalOf(text, crop), testing::HasSubstr("COLUMN,ROW,COLUMNS,ROWS")) << text;
        EXPECT_FALSE(crop) << text;
    }
}

}  // namespace
}  // namespace asperity
