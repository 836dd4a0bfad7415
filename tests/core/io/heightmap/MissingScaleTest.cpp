#include "core/io/heightmap/ImageScale.h"
#include "core/io/heightmap/ScanFile.h"
#include "tests/core/io/heightmap/BumpyMap.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

namespace asperity::test {

namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

ScanChannel channelOf(const std::string& name, const std::string& unit, double pitch) {
    ScanChannel channel{.name = name, .unit = unit, .lateralUnit = "m", .map = bumpyMap(4, 3)};
    channel.map.pitchX = channel.map.pitchY = pitch;
    return channel;
}

std::optional<MissingScale> missingOf(const std::vector<ScanChannel>& channels,
                                      const std::string& name = "") {
    HeightMapFile file;
    file.channels = channels;
    try {
        (void)heightChannel(file, "scan.txt", name);
    } catch (const MissingScale& missing) {
        return missing;
    } catch (const InputError&) {  // refused for good
    }
    return std::nullopt;
}

}  // namespace

TEST(MissingScale, SaysWhichOptionGivesTheSize) {
    const auto missing = missingOf({channelOf("Height", "m", 0.0)});
    ASSERT_TRUE(missing);
    EXPECT_EQ(missing->gap(),
              (ScaleGap{.channel = "Height", .columns = 4, .rows = 3, .size = true}));
    EXPECT_THAT(missing->what(),
                AllOf(HasSubstr("scan.txt: channel 'Height': the file does not hold the size"),
                      HasSubstr("--size"), HasSubstr("size_x_m"), Not(HasSubstr("--z-"))));
}

TEST(MissingScale, SaysWhichOptionsGiveTheHeights) {
    const auto missing = missingOf({channelOf("Height", "", 1e-9)});
    ASSERT_TRUE(missing);
    EXPECT_EQ(missing->gap(),
              (ScaleGap{.channel = "Height", .columns = 4, .rows = 3, .height = true}));
    EXPECT_THAT(missing->what(), AllOf(HasSubstr("--z-unit"), HasSubstr("--z-scale"),
                                       HasSubstr("z_scale_m"), Not(HasSubstr("--size"))));
}

TEST(MissingScale, SaysBothWhereBothAreMissing) {
    const auto missing = missingOf({channelOf("matrix", "", 0.0)});
    ASSERT_TRUE(missing);
    EXPECT_TRUE(missing->gap().size && missing->gap().height);
    EXPECT_THAT(missing->what(), AllOf(HasSubstr("--size"), HasSubstr("--z-unit")));
}

TEST(MissingScale, OfAMaskSaysFirstThatItIsOne) {
    ScanChannel mask = channelOf("Grains", "", 1e-9);
    mask.isMask = true;
    const auto missing = missingOf({mask});
    ASSERT_TRUE(missing);
    EXPECT_TRUE(missing->gap().mask);
    EXPECT_THAT(missing->what(),
                HasSubstr("channel 'Grains': this is a mask, not heights (use it as material_mask "
                          "of a scene); the file does not hold the unit of its values (set it by"));
}

TEST(MissingScale, IsNoneWhereTheUnitIsKnownAndNoLength) {
    EXPECT_FALSE(missingOf({channelOf("Voltage", "V", 0.0)}, "Voltage"));
    EXPECT_FALSE(missingOf({channelOf("Phase", "", 0.0)})) << "no default";
    EXPECT_TRUE(missingOf({channelOf("Phase", "", 0.0)}, "Phase")) << "but by name";
}

TEST(MissingScale, NumbersAreTheDefaultAfterHeightsAndBeforeOtherUnits) {
    const auto defaultOf = [](const std::vector<ScanChannel>& channels) {
        return channels.at(suggestDefaultChannel(channels)).name;
    };
    EXPECT_EQ(defaultOf({channelOf("Topography", "", 1e-9), channelOf("Other", "m", 1e-9)}),
              "Other");
    EXPECT_EQ(defaultOf({channelOf("Voltage", "V", 1e-9), channelOf("Phase", "", 1e-9),
                         channelOf("gray", "", 1e-9), channelOf("Height", "", 1e-9)}),
              "Height");
    ScanChannel mask = channelOf("Height mask", "", 1e-9);
    mask.isMask = true;
    EXPECT_EQ(defaultOf({mask, channelOf("gray", "", 1e-9)}), "gray");
    EXPECT_EQ(defaultOf({channelOf("Voltage", "V", 1e-9), mask}), "Height mask");
}

}  // namespace asperity::test
