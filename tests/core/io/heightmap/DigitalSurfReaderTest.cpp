#include "core/Error.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "tests/core/io/heightmap/InstrumentFiles.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

// The files are made from the layout alone (docs/formats.md 15): no real one has proven it.

namespace asperity::test {

namespace {

using testing::HasSubstr;

HeightMapFile readAsDigitalSurf(const DigitalSurfText& text,
                                const std::vector<double>& numbers = {1, 2, 3, 4, 5, 6}) {
    return readHeightMapBytes(digitalSurfFile(text, numbers), "surface.sur");
}

std::string refusalOfDigitalSurf(const DigitalSurfText& text) {
    return refusalOf([&] { (void)readAsDigitalSurf(text); });
}

}  // namespace

TEST(DigitalSurfReader, FirstStoredRowIsTheTopOfTheImage) {
    const HeightMapFile file = readAsDigitalSurf({});
    const ScanChannel& channel = file.channels.at(0);
    EXPECT_EQ(channel.name, "Height");
    EXPECT_EQ(channel.unit, "m");
    EXPECT_DOUBLE_EQ(channel.map.at(0, 0), 0.5e-9);
    EXPECT_DOUBLE_EQ(channel.map.at(1, 2), 3e-9);
    EXPECT_DOUBLE_EQ(channel.map.sizeX(), 30e-9);
    EXPECT_DOUBLE_EQ(channel.map.sizeY(), 20e-9);
    EXPECT_EQ(channel.metadata.at("object name"), "steps");
    EXPECT_THAT(file.notes, testing::Contains(HasSubstr("no real .sur file")));
}

TEST(DigitalSurfReader, OffsetIsInTheUnitOfTheStep) {
    DigitalSurfText text;
    text.unit = "\xB5m";
    text.offset = 2.0F;
    EXPECT_DOUBLE_EQ(readAsDigitalSurf(text).channels.at(0).map.at(0, 0), 2.5e-6);
}

TEST(DigitalSurfReader, SamplesMayHave32Bits) {
    DigitalSurfText text;
    text.bits = 32;
    text.stored = SampleType::Int32;
    EXPECT_DOUBLE_EQ(readAsDigitalSurf(text, {100000, 2, 3, 4, 5, 6}).channels.at(0).map.at(0, 0),
                     50e-6);
    text.bits = 24;
    EXPECT_THAT(refusalOfDigitalSurf(text),
                HasSubstr("surface.sur: byte 98: expected samples of 16 or 32"));
}

TEST(DigitalSurfReader, SpecialPointsAreNoData) {
    DigitalSurfText text;
    text.lowest = 3;
    EXPECT_FALSE(std::isnan(readAsDigitalSurf(text).channels.at(0).map.at(0, 0)));
    text.specialPoints = 1;
    EXPECT_TRUE(std::isnan(readAsDigitalSurf(text).channels.at(0).map.at(0, 0)));
    EXPECT_FALSE(std::isnan(readAsDigitalSurf(text).channels.at(0).map.at(0, 1)));
}

TEST(DigitalSurfReader, InvertedSurfaceIsShownAsItIsStored) {
    DigitalSurfText text;
    text.inversion = 1;
    const ScanChannel channel = readAsDigitalSurf(text).channels.at(0);
    EXPECT_DOUBLE_EQ(channel.map.at(0, 0), 0.5e-9);
    EXPECT_THAT(channel.notes, testing::Contains(HasSubstr("inverted")));
}

TEST(DigitalSurfReader, HeaderAndFileSizeMustAgree) {
    DigitalSurfText text;
    text.commentSize = 4;
    EXPECT_THAT(refusalOfDigitalSurf(text), HasSubstr("bytes 334 to 337"));
    text.commentSize = 6;
    EXPECT_THAT(refusalOfDigitalSurf(text), HasSubstr("truncated"));
}

TEST(DigitalSurfReader, AnOffsetThatIsNoNumberIsRefused) {
    DigitalSurfText text;
    text.offset = std::numeric_limits<float>::infinity();
    EXPECT_THAT(refusalOfDigitalSurf(text),
                HasSubstr("expected a step and an offset of the heights"));
}

TEST(DigitalSurfReader, CompressedSamplesAreNamedAsSuch) {
    DigitalSurfText text;
    text.magic = "DSCOMPRESSED";
    EXPECT_THAT(refusalOfDigitalSurf(text), HasSubstr("compressed"));
}

TEST(DigitalSurfReader, OtherObjectsAreRefused) {
    DigitalSurfText text;
    text.object = 1;
    EXPECT_THAT(refusalOfDigitalSurf(text), HasSubstr("object of type 1"));
}

}  // namespace asperity::test
