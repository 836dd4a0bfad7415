#include "core/io/FileBytes.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "tests/core/io/heightmap/ZipFiles.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity::test {

namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

/// The archive with another size of an entry in its directory: that alone says what it decodes to
/// before it is decoded.
std::string withListedSize(std::string archive, const std::string& entry, std::uint32_t size) {
    constexpr std::size_t kSize = 24;  // in an entry of the directory
    constexpr std::size_t kName = 46;
    const std::size_t listed = archive.rfind(entry) - kName;
    EXPECT_EQ(archive.substr(listed, 4), "PK\x01\x02");
    for (std::size_t i = 0; i < sizeof size; ++i) {
        archive.at(listed + kSize + i) = static_cast<char>(size >> (8 * i));
    }
    return archive;
}

std::string refusalOfJpkArchive(const std::string& bytes) {
    return refusalOf([&] { (void)readHeightMapBytes(bytes, "scan.zip"); });
}

}  // namespace

TEST(JpkArchiveReader, ReadsTheImageOfAMapOfCurves) {
    ASPERITY_NEEDS_SHARED_DATA();
    const HeightMapFile archive =
        readHeightMapFile(sharedData("afm/jpk/qi_2020_extracted.jpk-qi-data"));
    const HeightMapFile image =
        readHeightMapFile(sharedData("afm/jpk/qi_2020_data-image.jpk-qi-image"));
    EXPECT_EQ(archive.format, "JPK archive");
    EXPECT_THAT(archive.notes, Contains(HasSubstr("also holds force curves")));
    EXPECT_EQ(archive.defaultChannel, image.defaultChannel);
    ASSERT_EQ(archive.channels.size(), image.channels.size());
    for (std::size_t i = 0; i < image.channels.size(); ++i) {
        const HeightMap& ours = archive.channels[i].map;
        const HeightMap& own = image.channels[i].map;
        EXPECT_EQ(archive.channels[i].name, image.channels[i].name);
        EXPECT_EQ(ours.pitchX, own.pitchX);
        EXPECT_EQ(ours.invalid, own.invalid);
        for (std::size_t pixel = 0; pixel < own.heights.size(); ++pixel) {
            if (!own.invalid[pixel]) {
                ASSERT_EQ(ours.heights[pixel], own.heights[pixel]);
            }
        }
    }
}

TEST(JpkArchiveReader, TheImageMayBeStoredOrCompressed) {
    ASPERITY_NEEDS_SHARED_DATA();
    const std::string image = readFileBytes(sharedData("afm/jpk/map25x25_data-image.force.jpk"));
    const HeightMapFile alone = readHeightMapBytes(image, "image");
    for (const bool compressed : {false, true}) {
        const HeightMapFile file = readHeightMapBytes(
            zipFile({{"header.properties", "type=map"}, {"data-image.force", image, compressed}}),
            "map.jpk-force-map");
        ASSERT_EQ(file.channels.size(), alone.channels.size());
        EXPECT_EQ(file.channels.back().map.heights, alone.channels.back().map.heights);
        EXPECT_THAT(file.notes, Not(Contains(HasSubstr("force curves"))));
    }
}

/// The image's name is among the scan's numbers.
TEST(JpkArchiveReader, AVeryLongNameOfTheImageIsCut) {
    ASPERITY_NEEDS_SHARED_DATA();
    const std::string image = readFileBytes(sharedData("afm/jpk/map25x25_data-image.force.jpk"));
    const HeightMapFile file = readHeightMapBytes(
        zipFile({{"header.properties", ""}, {"data-image." + std::string(60'000, 'x'), image}}),
        "map.jpk-force-map");
    for (const Provenance& entry : file.provenance) {
        EXPECT_LE(entry.value.size(), 4096U) << entry.what;
    }
}

TEST(JpkArchiveReader, ForceCurvesAloneAreRefusedInWords) {
    EXPECT_THAT(refusalOfJpkArchive(zipFile({{"header.properties", "type=force"},
                                             {"segments/0/segment-header.properties", ""},
                                             {"segments/0/channels/height.dat", "12"},
                                             {"shared-data/header.properties", ""}})),
                AllOf(StartsWith("scan.zip: "), HasSubstr("force curves alone")));
}

TEST(JpkArchiveReader, ADamagedImageIsNamedWithItsArchive) {
    EXPECT_THAT(
        refusalOfJpkArchive(zipFile({{"header.properties", ""}, {"data-image.force", "MM"}})),
        StartsWith("scan.zip: data-image.force: "));
    EXPECT_THAT(refusalOfJpkArchive(zipFile({{"header.properties", ""}, {"data-image.force", ""}})),
                StartsWith("scan.zip: data-image.force: "));
}

/// Less than a megabyte of an archive took as much memory as its image pretends to have.
TEST(JpkArchiveReader, AnImageOfFarMoreBytesThanItIsPackedInIsNotUnpacked) {
    const std::string bytes = withListedSize(
        zipFile({{"header.properties", ""}, {"data-image.force", std::string(1000, '\0')}}),
        "data-image.force", 150U << 20U);
    EXPECT_THAT(refusalOfJpkArchive(bytes),
                AllOf(StartsWith("scan.zip: data-image.force: it holds 157286400 bytes"),
                      HasSubstr("at most 134217728 are expected")));
}

/// It took eight times the archive's size.
TEST(JpkArchiveReader, AnImageMayBeHalfAsLargeAgainAsALargeArchive) {
    constexpr std::size_t kArchive = std::size_t{100} << 20U;
    const std::string bytes =
        withListedSize(zipFile({{"header.properties", ""},
                                {"data-image.force", std::string(1000, '\0')},
                                {"segments/0", std::string(kArchive, 'x'), false}}),
                       "data-image.force", 160U << 20U);
    EXPECT_THAT(refusalOfJpkArchive(bytes),
                AllOf(HasSubstr("it holds 167772160 bytes; at most 157"), HasSubstr("expected")));
}

TEST(JpkArchiveReader, AnotherZipFileIsNone) {
    for (const char* entry : {"header.properties", "segments/a"}) {
        EXPECT_THAT(refusalOfJpkArchive(zipFile({{entry, ""}})),
                    HasSubstr("this is a zip archive of neither JPK nor X3P data"));
    }
}

}  // namespace asperity::test
