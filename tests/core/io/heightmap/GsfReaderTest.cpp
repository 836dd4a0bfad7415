#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asperity::test {

namespace {

using testing::HasSubstr;

constexpr const char* kMagic = "Gwyddion Simple Field 1.0\n";
constexpr const char* kSizeFields = "XRes = 3\nYRes = 2\nXReal = 30e-9\nYReal = 40e-9\n";
constexpr const char* kMeters = "XYUnits = m\nZUnits = m\n";

std::string gsfFile(const std::string& fields, const std::vector<float>& values,
                    const std::string& magic = kMagic) {
    std::string bytes = magic + fields;
    bytes.append(4 - bytes.size() % 4, '\0');
    for (const float value : values) {
        appendLittleEndian(bytes, value);
    }
    return bytes;
}

const std::vector<float> kValues = {1, 2, 3, 4, 5, 6};

HeightMapFile readAsGsf(const std::string& bytes) { return readHeightMapBytes(bytes, "scan.gsf"); }

std::string refusalOfGsf(const std::string& bytes) {
    return refusalOf([&] { (void)readAsGsf(bytes); });
}

}  // namespace

TEST(GsfReader, RowsComeFromTheTop) {
    const ScanChannel channel =
        readAsGsf(gsfFile(std::string(kSizeFields) + kMeters, kValues)).channels.at(0);
    EXPECT_EQ(channel.map.at(0, 2), 3.0);
    EXPECT_EQ(channel.map.at(1, 0), 4.0);
    EXPECT_DOUBLE_EQ(channel.map.pitchX, 10e-9);
    EXPECT_DOUBLE_EQ(channel.map.pitchY, 20e-9);
    EXPECT_TRUE(channel.isHeight());
}

TEST(GsfReader, HeaderOfAnyLengthIsPaddedByOneToFourNulBytes) {
    for (const char* title : {"a", "ab", "abc", "abcd"}) {
        const auto fields = std::string(kSizeFields) + kMeters + "Title = " + title + "\n";
        const ScanChannel channel = readAsGsf(gsfFile(fields, kValues)).channels.at(0);
        EXPECT_EQ(channel.name, title);
        EXPECT_EQ(channel.map.at(1, 2), 6.0);
    }
}

TEST(GsfReader, OtherFieldsAreMetadata) {
    const auto fields = std::string(kSizeFields) + kMeters + "XOffset=-1e-6\n  Author  =  A = B \n";
    const ScanChannel channel = readAsGsf(gsfFile(fields, kValues)).channels.at(0);
    EXPECT_EQ(channel.metadata, (std::map<std::string, std::string>{{"Author", "A = B"}}));
    EXPECT_DOUBLE_EQ(channel.originX, -1e-6);
}

TEST(GsfReader, NanIsInvalid) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const HeightMap map =
        readAsGsf(gsfFile(std::string(kSizeFields) + kMeters, {1, nan, 3, 4, 5, 6}))
            .channels.at(0)
            .map;
    EXPECT_FALSE(map.isValid(0, 1));
    EXPECT_TRUE(map.isValid(0, 0));
}

TEST(GsfReader, MissingLateralUnitIsTakenAsMetersAndSaid) {
    const HeightMapFile file =
        readAsGsf(gsfFile(std::string(kSizeFields) + "ZUnits = m\n", kValues));
    EXPECT_TRUE(file.channels.at(0).hasSize());
    EXPECT_THAT(file.channels.at(0).notes.at(0), HasSubstr("meters are assumed"));
}

TEST(GsfReader, MissingSizeOrHeightUnitIsNotGuessed) {
    const HeightMapFile noSize = readAsGsf(gsfFile("XRes=3\nYRes=2\nZUnits=m\n", kValues));
    EXPECT_THROW((void)heightChannel(noSize, "scan.gsf", ""), InputError);
    const HeightMapFile noUnit = readAsGsf(gsfFile(kSizeFields, kValues));
    EXPECT_THROW((void)heightChannel(noUnit, "scan.gsf", ""), InputError);
}

TEST(GsfReader, RefusesDamage) {
    const std::string good = gsfFile(std::string(kSizeFields) + kMeters, kValues);
    EXPECT_THAT(refusalOfGsf(good + "x"), HasSubstr("found 25"));
    EXPECT_THAT(refusalOfGsf(good.substr(0, good.size() - 1)), HasSubstr("found 23"));
    EXPECT_THAT(refusalOfGsf(gsfFile("XRes = 3\n", kValues)), HasSubstr("YRes"));
    EXPECT_THAT(refusalOfGsf(gsfFile("XRes = 3.5\nYRes = 2\n", kValues)), HasSubstr("XRes"));
    EXPECT_THAT(refusalOfGsf(gsfFile("XRes = 0\nYRes = 2\n", {})), HasSubstr("0 x 2"));
    EXPECT_THAT(refusalOfGsf(gsfFile("XRes = 4294967296\nYRes = 4294967296\n", {})),
                HasSubstr("65536"));
    EXPECT_THAT(refusalOfGsf(gsfFile(std::string(kSizeFields) + "XOffset = left\n", kValues)),
                HasSubstr("XOffset"));
    EXPECT_THAT(refusalOfGsf(gsfFile(std::string(kSizeFields) + "no equals sign\n", kValues)),
                HasSubstr("line 6"));
    EXPECT_THAT(refusalOfGsf(kMagic), HasSubstr("truncated"));
    EXPECT_THAT(refusalOfGsf(gsfFile(kSizeFields, kValues, "Gwyddion Simple Field 1.0\r\n")),
                HasSubstr("text mode"));
    EXPECT_THAT(refusalOfGsf(gsfFile(kSizeFields, kValues, "Gwyddion Simple Field 2.0\n")),
                HasSubstr("1.0"));
}

TEST(GsfReader, RefusesPaddingThatIsNotNul) {
    std::string bytes = gsfFile(std::string(kSizeFields) + kMeters + "Title = ab\n", kValues);
    const std::size_t end = bytes.find('\0');
    ASSERT_NE((end + 1) % 4, 0U) << "the header must leave more than one byte of padding";
    bytes[end + 1] = 'x';
    EXPECT_THAT(refusalOfGsf(bytes), HasSubstr("NUL"));
}

}  // namespace asperity::test
