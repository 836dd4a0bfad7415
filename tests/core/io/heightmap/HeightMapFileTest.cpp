#include "core/io/heightmap/HeightMapFile.h"

#include "core/Error.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/io/heightmap/ScanFile.h"
#include "tests/core/io/heightmap/BumpyMap.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity::test {

namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::string refusalOfPath(const std::filesystem::path& path) {
    return refusalOf([&] { (void)readHeightMapFile(path); });
}

ScanChannel channel(const std::string& name, const std::string& unit) {
    ScanChannel result;
    result.name = name;
    result.unit = unit;
    result.lateralUnit = "m";
    result.map = bumpyMap(2, 2);
    return result;
}

std::string defaultOf(const std::vector<ScanChannel>& channels) {
    return channels.at(suggestDefaultChannel(channels)).name;
}

}  // namespace

TEST(HeightMapFile, DefaultChannelFollowsTheUsualDirectionOfTheVendor) {
    std::vector<ScanChannel> channels = {channel("Height", "m"), channel("Height", "m"),
                                         channel("ZSensor", "m")};
    channels[0].direction = "forward";
    channels[1].direction = "backward";
    channels[2].direction = "forward";
    EXPECT_EQ(suggestDefaultChannel(channels, "backward"), 2U);
    channels.pop_back();
    EXPECT_EQ(suggestDefaultChannel(channels, "backward"), 1U);
    EXPECT_EQ(suggestDefaultChannel(channels), 0U);
}

TEST(HeightMapFile, CurrentIsNoTopographyButMayBeKeptConstantForOne) {
    EXPECT_EQ(defaultOf({channel("Current", "m"), channel("Image", "m")}), "Image");
    EXPECT_EQ(defaultOf({channel("Tunnel current", "m"), channel("z", "m")}), "z");
    EXPECT_EQ(defaultOf({channel("Constant current topography", "m"), channel("Other", "m")}),
              "Constant current topography");
}

TEST(HeightMapFile, SaysWhyAPathCannotBeRead) {
    const ScratchFolder folder;
    EXPECT_THAT(refusalOfPath(folder.file("none.gwy")),
                HasSubstr("none.gwy: there is no such file"));
    EXPECT_THAT(refusalOfPath(folder.path()), HasSubstr("this is a folder"));
    EXPECT_THAT(refusalOfPath(folder.write("empty.spm", "")),
                HasSubstr("empty.spm: the file is empty"));
    EXPECT_THAT(refusalOfPath("/dev/null"), HasSubstr("not a regular file"));
}

TEST(HeightMapFile, UnknownTypeNamesTheSupportedOnes) {
    const ScratchFolder folder;
    EXPECT_THAT(
        refusalOfPath(folder.write("scan.gwy", "not a scan")),
        AllOf(HasSubstr("scan.gwy"), HasSubstr("NanoScope"), HasSubstr(".gwy"), HasSubstr(".gsf")));
}

TEST(HeightMapFile, FormatsAreListedByTheirUsualExtensions) {
    EXPECT_THAT(readableExtensions(),
                ElementsAre(".gwy", ".spm", ".di", ".0*", ".1*", ".2*", ".3*", ".gsf", ".tiff",
                            ".tif", ".jpk", ".jpk-qi-image", ".sxm", ".nid", ".ezd", ".stp", ".top",
                            ".mi", ".sur", ".sdf", ".bcr", ".bcrf", ".ibw", ".jpk-qi-data",
                            ".jpk-force-map", ".x3p", ".exr", ".png", ".vti", ".nxs", ".txt",
                            ".xyz", ".asc", ".csv", ".dat"));
    EXPECT_THAT(heightMapExtensions(),
                ElementsAre(".gwy", ".gsf", ".exr", ".tiff", ".tif", ".png", ".vti", ".txt"));
}

TEST(HeightMapFile, EachReadableFormatHasANameAndItsExtensions) {
    const std::vector<ReadableFormat> formats = readableFormats();
    EXPECT_EQ(formats.front().name, "Gwyddion .gwy");
    EXPECT_THAT(formats.front().extensions, ElementsAre(".gwy"));
    for (const ReadableFormat& format : formats) {
        EXPECT_NE(format.name, "force curves") << "they are refused";
        EXPECT_FALSE(format.extensions.empty()) << format.name;
    }
}

TEST(HeightMapFile, TypeIsFoundByContentNotByExtension) {
    const ScratchFolder folder;
    const std::string gsf =
        std::string("Gwyddion Simple Field 1.0\nXRes=1\nYRes=1\n") + '\0' + std::string(4, '\0');
    std::string padded = gsf.substr(0, gsf.find('\0'));
    padded.append(4 - padded.size() % 4, '\0');
    padded.append(4, '\0');
    EXPECT_EQ(readHeightMapFile(folder.write("scan.spm", padded)).format,
              "Gwyddion Simple Field .gsf");
}

TEST(DefaultChannel, PrefersTheHeightSensorThenThePiezoHeight) {
    EXPECT_EQ(defaultOf({channel("Height", "m"), channel("ZSensor", "m")}), "ZSensor");
    EXPECT_EQ(defaultOf({channel("Slope", "N/m"), channel("Height (measured)", "m")}),
              "Height (measured)");
    EXPECT_EQ(defaultOf({channel("Other", "m"), channel("Topography", "m")}), "Topography");
    EXPECT_EQ(defaultOf({channel("Z (Forward)", "m"), channel("Z (Backward)", "m")}),
              "Z (Forward)");
}

TEST(DefaultChannel, IsNeverDeflectionAmplitudeOrPhase) {
    for (const char* name : {"DeflectionError", "AmplitudeTrace", "Phase", "Height Sensor Error"}) {
        EXPECT_EQ(defaultOf({channel(name, "m"), channel("Surface", "m")}), "Surface") << name;
        HeightMapFile file;
        file.channels = {channel(name, "m")};
        EXPECT_THROW((void)heightChannel(file, "scan", ""), InputError) << name;
        EXPECT_EQ(heightChannel(file, "scan", name).name, name);
    }
}

TEST(HeightChannel, RefusesWhatIsNoHeightAndNamesTheChannels) {
    HeightMapFile file;
    file.channels = {channel("Height", "m"), channel("Phase", "deg")};
    EXPECT_EQ(heightChannel(file, "scan", "").name, "Height");
    EXPECT_THROW((void)heightChannel(file, "scan", "Phase"), InputError);
    try {
        (void)heightChannel(file, "scan", "Lost");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(),
                    AllOf(HasSubstr("scan: "), HasSubstr("'Height' (m)"), HasSubstr("'Phase'")));
    }
}

TEST(HeightChannel, OfTwoEqualNamesTheHeightIsMeant) {
    HeightMapFile file;
    file.channels = {channel("Z", "V"), channel("Z", "m")};
    EXPECT_EQ(heightChannel(file, "scan", "Z").unit, "m");
}

TEST(HeightChannel, RefusesAScanOfUnknownSize) {
    HeightMapFile file;
    file.channels = {channel("Height", "m"), channel("Seconds", "m")};
    file.channels[0].map.pitchX = 0.0;
    file.channels[1].lateralUnit = "s";
    EXPECT_THROW((void)heightChannel(file, "scan", "Height"), InputError);
    EXPECT_THROW((void)heightChannel(file, "scan", "Seconds"), InputError);
}

}  // namespace asperity::test
