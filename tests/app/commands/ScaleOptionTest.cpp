#include "app/commands/ScaleOption.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace asperity {
namespace {

using testing::HasSubstr;

/// The scale after a command line; throws as the command does.
GivenScale scaleOf(const std::vector<std::string>& arguments) {
    GivenScale scale;
    CLI::App command;
    addScaleOptions(command, scale);
    command.parse(
        std::vector<std::string>(arguments.rbegin(), arguments.rend()));  // last one first
    return scale;
}

std::string refusalOf(const std::vector<std::string>& arguments) {
    try {
        (void)scaleOf(arguments);
    } catch (const CLI::ParseError& error) {
        return error.what();
    }
    return "";
}

TEST(ScaleOption, TakesALengthWithItsUnitOrInMeters) {
    const std::vector<std::pair<std::string, double>> lengths = {
        {"5um", 5e-6},       {"5 um", 5e-6}, {"5µm", 5e-6},    {"5\u03BCm", 5e-6},
        {" 5 µm ", 5e-6},    {"5e-6", 5e-6}, {"5e-6 m", 5e-6}, {"0.5nm", 5e-10},
        {"12.5Å", 12.5e-10}, {"2mm", 2e-3},  {"+3pm", 3e-12}};
    for (const auto& [text, length] : lengths) {
        ASSERT_TRUE(parseLength(text)) << text;
        EXPECT_EQ(*parseLength(text), length) << text;
    }
}

TEST(ScaleOption, RefusesWhatIsNoLength) {
    for (const char* text : {"", "um", "5V", "5 m/s", "5u", "5,5um", "-5um", "0", "0nm", "nan",
                             "inf", "infm", "1e400m", "5um2"}) {
        EXPECT_FALSE(parseLength(text)) << text;
    }
}

TEST(ScaleOption, TakesTheSidesOfAScan) {
    const GivenScale square{.sizeX = 5e-6, .sizeY = 5e-6};
    const GivenScale wide{.sizeX = 5e-6, .sizeY = 2e-6};
    for (const char* text : {"5um", "5 um", "5e-6", "5µm", "5umx5um"}) {
        ASSERT_TRUE(parseScanSize(text)) << text;
        EXPECT_DOUBLE_EQ(parseScanSize(text)->sizeX, square.sizeX) << text;
        EXPECT_DOUBLE_EQ(parseScanSize(text)->sizeY, square.sizeY) << text;
    }
    for (const char* text :
         {"5umx2um", "5x2um", "5 µm x 2 µm", "5 x 2 µm", "5umx2000nm", "5e-6x2e-6", "5 um x2um"}) {
        ASSERT_TRUE(parseScanSize(text)) << text;
        EXPECT_DOUBLE_EQ(parseScanSize(text)->sizeX, wide.sizeX) << text;
        EXPECT_DOUBLE_EQ(parseScanSize(text)->sizeY, wide.sizeY) << text;
        EXPECT_FALSE(parseScanSize(text)->hasHeight());
    }
}

TEST(ScaleOption, RefusesSidesThatAreNone) {
    for (const char* text : {"", "x", "5umx", "x5um", "5umx2", "5umx2umx1um", "5um*2um", "5umx-2um",
                             "0x0", "0x10", "5umx0", "infxinf", "5Vx2V"}) {
        EXPECT_FALSE(parseScanSize(text)) << text;
    }
}

TEST(ScaleOption, AHeightIsTheNumberTimesTheUnit) {
    EXPECT_FALSE(scaleOf({}).hasHeight());
    EXPECT_EQ(scaleOf({"--z-unit", "nm"}).heightPerValue, 1e-9);
    EXPECT_EQ(scaleOf({"--z-scale", "2.5e-10"}).heightPerValue, 2.5e-10);
    EXPECT_EQ(scaleOf({"--z-scale", "0.25", "--z-unit", "nm"}).heightPerValue, 0.25 * 1e-9);
    EXPECT_EQ(scaleOf({"--z-unit", "Å", "--z-scale", "3"}).heightPerValue, 3 * 1e-10);
    EXPECT_EQ(scaleOf({"--z-unit", "m"}).heightPerValue, 1.0);
    EXPECT_EQ(scaleOf({"--size", "1um", "--z-unit", "µm"}),
              (GivenScale{.sizeX = 1e-6, .sizeY = 1e-6, .heightPerValue = 1e-6}));
}

TEST(ScaleOption, RefusesInWords) {
    EXPECT_THAT(refusalOf({"--size", "large"}),
                HasSubstr("expected a size such as 5um or 5umx2um, not 'large'"));
    EXPECT_THAT(refusalOf({"--z-unit", "V"}),
                HasSubstr("expected a unit of length such as nm, not 'V'"));
    EXPECT_THAT(refusalOf({"--z-unit", ""}), HasSubstr("expected a unit of length"));
    for (const char* number : {"0", "-1", "nan", "inf", "1nm", "0,5"}) {
        EXPECT_THAT(refusalOf({"--z-scale", number}),
                    HasSubstr(std::string("expected a number above 0, not '") + number))
            << number;
    }
    EXPECT_THAT(refusalOf({"--z-scale", "1e300", "--z-unit", "Ym"}), HasSubstr("no length"));
    EXPECT_THAT(refusalOf({"--z-scale", "1e-305", "--z-unit", "ym"}), HasSubstr("no length"));
}

}  // namespace
}  // namespace asperity
