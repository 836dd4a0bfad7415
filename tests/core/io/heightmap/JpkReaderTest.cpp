#include "core/Error.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/jpk/JpkSlot.h"
#include "tests/core/io/heightmap/TiffFiles.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

// Images of JPK instruments: slots, pixels without data, Reflect; docs/formats.md 5.

namespace asperity::test {

namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr double kMarker = 2147483647.0;

struct JpkTestSlot {
    std::string name;
    std::string unit;
    double multiplier = 1.0;
    double offset = 0.0;
    std::string encoder = "SignedInteger";
    std::string scaling = "LinearScaling";
};

struct JpkTestChannel {
    std::string id = "measuredHeight";
    std::string name = "Height (measured)";
    int retrace = 0;
    std::string defaultSlot = "nominal";
    std::vector<JpkTestSlot> slots = {{"raw", "", 1.0, 0.0, "SignedInteger", "NullScaling"},
                                      {"volts", "V", 0.5, 1.0},
                                      {"nominal", "m", 2e-9, 100e-9}};
    std::vector<double> counts = {1, 2, 3, 4, 5, kMarker};
};

void add(std::vector<TiffTestField>& fields, const JpkTestSlot& slot, std::size_t number) {
    const auto tag = [number](unsigned first) {
        return static_cast<std::uint16_t>(first + 0x30 * number);
    };
    fields.push_back(tiffText(tag(0x8090), slot.name));
    fields.push_back(tiffText(tag(0x80A1), slot.encoder));
    fields.push_back(tiffText(tag(0x80A2), slot.unit));
    fields.push_back(tiffText(tag(0x80A3), slot.scaling));
    if (slot.scaling != "NullScaling") {
        fields.push_back(tiffDouble(tag(0x80A4), slot.multiplier));
        fields.push_back(tiffDouble(tag(0x80A5), slot.offset));
    }
    fields.push_back({.tag = tag(0x80AA), .type = 9, .numbers = {kMarker}});
}

TiffTestImage imageOf(const JpkTestChannel& channel) {
    TiffTestImage image{.type = SampleType::Int32, .columns = 2, .rows = 3, .rowsPerStrip = 2};
    image.values = channel.counts;
    image.extra = {tiffText(0x8050, channel.id),
                   {.tag = 0x8051, .type = 8, .numbers = {static_cast<double>(channel.retrace)}},
                   tiffText(0x8052, channel.name),
                   {.tag = 0x8080, .type = 9, .numbers = {double(channel.slots.size())}},
                   tiffText(0x8081, channel.defaultSlot)};
    for (std::size_t i = 0; i < channel.slots.size(); ++i) {
        add(image.extra, channel.slots[i], i);
    }
    return image;
}

std::string jpkFile(const std::vector<JpkTestChannel>& channels, int reflect = 0,
                    double sizeX = 4e-6) {
    std::vector<TiffTestImage> images = {
        {.type = SampleType::UInt8,
         .photometric = 3,
         .extra = {tiffText(0x8000, "6.1.157"),
                   tiffDouble(0x8040, -1e-6),
                   tiffDouble(0x8041, 2e-6),
                   tiffDouble(0x8042, sizeX),
                   tiffDouble(0x8043, 3e-6),
                   tiffDouble(0x8044, 0.5),
                   {.tag = 0x8045, .type = 8, .numbers = {double(reflect)}}}}};
    for (const JpkTestChannel& channel : channels) {
        images.push_back(imageOf(channel));
    }
    return tiffFile(images, ByteOrder::Big);
}

HeightMapFile readAsJpk(const std::string& bytes) { return readHeightMapBytes(bytes, "small.jpk"); }
std::string refusalOfJpk(const std::string& bytes) {
    return refusalOf([&] { (void)readAsJpk(bytes); });
}

}  // namespace

TEST(JpkReader, TheDefaultSlotsOwnFactorsTurnCountsIntoHeights) {
    const HeightMapFile file = readAsJpk(jpkFile({{}}));
    EXPECT_EQ(file.format, "JPK image");
    const ScanChannel& channel = file.channels.at(0);
    EXPECT_EQ(channel.name, "Height (measured)");
    EXPECT_EQ(channel.unit, "m");
    EXPECT_EQ(channel.direction, "forward");
    EXPECT_EQ(channel.metadata.at("slot"), "nominal");
    EXPECT_EQ(channel.metadata.at("version"), "6.1.157");
    EXPECT_DOUBLE_EQ(channel.map.pitchX, 2e-6);
    EXPECT_DOUBLE_EQ(channel.map.pitchY, 1e-6);
    EXPECT_DOUBLE_EQ(channel.originX, -1e-6);
    EXPECT_DOUBLE_EQ(channel.originY, 2e-6);
    EXPECT_NEAR(channel.map.at(2, 0), 102e-9, 1e-20);
    EXPECT_THAT(file.notes, Contains(HasSubstr("rotated")));
    JpkTestChannel volts;
    volts.defaultSlot = "volts";
    EXPECT_EQ(readAsJpk(jpkFile({volts})).channels[0].unit, "V");
    EXPECT_DOUBLE_EQ(readAsJpk(jpkFile({volts})).channels[0].map.at(2, 1), 2.0);
}

TEST(JpkReader, RowsAreStoredFromTheBottomUnlessReflected) {
    EXPECT_NEAR(readAsJpk(jpkFile({{}}, 0)).channels[0].map.at(2, 0), 102e-9, 1e-20);
    EXPECT_NEAR(readAsJpk(jpkFile({{}}, 1)).channels[0].map.at(0, 0), 102e-9, 1e-20);
}

TEST(JpkReader, TheMarkerIsNoDataOnlyWithItsEncoder) {
    const ScanChannel plain = readAsJpk(jpkFile({{}})).channels.at(0);
    EXPECT_TRUE(plain.map.invalid.empty());
    EXPECT_NEAR(plain.map.at(0, 1), kMarker * 2e-9 + 100e-9, 1e-12);
    JpkTestChannel channel;
    channel.slots[2].encoder = "SignedIntegerWithValidity";
    const HeightMap map = readAsJpk(jpkFile({channel})).channels.at(0).map;
    EXPECT_TRUE(std::isnan(map.at(0, 1)));
    EXPECT_TRUE(map.invalid.at(1));
    EXPECT_NEAR(map.at(0, 0), 110e-9, 1e-20);
}

TEST(JpkReader, RepeatedNamesAreToldApart) {
    JpkTestChannel retrace;
    retrace.retrace = 1;
    const HeightMapFile file = readAsJpk(jpkFile({{}, retrace, {}, retrace}));
    ASSERT_EQ(file.channels.size(), 4U);
    EXPECT_EQ(file.channels[0].name, "Height (measured)");
    EXPECT_EQ(file.channels[1].name, "Height (measured) (backward)");
    EXPECT_EQ(file.channels[1].direction, "backward");
    EXPECT_EQ(file.channels[2].name, "Height (measured) 2");
    EXPECT_EQ(file.channels[3].name, "Height (measured) 3");
}

TEST(JpkReader, WithoutSlotsValuesAreCounts) {
    JpkTestChannel channel;
    channel.slots.clear();
    channel.name.clear();
    const ScanChannel read = readAsJpk(jpkFile({channel})).channels.at(0);
    EXPECT_EQ(read.name, "measuredHeight");
    EXPECT_EQ(read.unit, "");
    EXPECT_THAT(read.notes, Contains(HasSubstr("they are counts")));
    EXPECT_EQ(read.map.at(2, 0), 1.0);
}

TEST(JpkReader, AnUnknownSizeIsSaid) {
    EXPECT_FALSE(readAsJpk(jpkFile({{}}, 0, -1.0)).channels[0].hasSize());
    EXPECT_FALSE(readAsJpk(jpkFile({{}}, 0, std::nan(""))).channels[0].hasSize());
}

TEST(JpkReader, RefusesWhatItCannotScale) {
    JpkTestChannel channel;
    channel.defaultSlot = "lost";
    EXPECT_THAT(refusalOfJpk(jpkFile({channel})), HasSubstr("default slot 'lost'"));
    channel = {};
    channel.slots[2].scaling = "CubicScaling";
    EXPECT_THAT(refusalOfJpk(jpkFile({channel})), HasSubstr("CubicScaling"));
    channel = {};
    channel.slots[2].multiplier = std::nan("");
    EXPECT_THAT(refusalOfJpk(jpkFile({channel})), HasSubstr("scale"));
    EXPECT_THAT(refusalOfJpk(jpkFile({})), HasSubstr("no channel"));
}

TEST(JpkReader, ReadsFromAnySourceOfBytes) {
    const std::string bytes = jpkFile({{}});
    const MemoryBytes source(bytes, "archive.zip, data-image.jpk-qi-image");
    ASSERT_TRUE(isJpkImage(source));
    EXPECT_EQ(readJpkImage(source).channels.size(), 1U);
    EXPECT_FALSE(isJpkImage(MemoryBytes("II*", "short")));
}

}  // namespace asperity::test
