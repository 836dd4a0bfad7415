#include "core/Error.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "tests/core/io/heightmap/SyntheticScans.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity::test {

namespace {

using testing::AllOf;
using testing::HasSubstr;

ScanChannel nanoscopeChannel(const NanoscopeText& text,
                             const std::vector<std::int32_t>& counts = {1, 2, 3, 4, 5, 6}) {
    return readHeightMapBytes(nanoscopeFile(text, counts), "scan.spm").channels.at(0);
}

std::string refusalOfNanoscope(const NanoscopeText& text) {
    return refusalOf([&] { (void)nanoscopeChannel(text); });
}

/// 2 V of full scale in 65536 counts, 100 nm/V.
constexpr double kMetersPerCount = 2.0 / 65536.0 * 100e-9;

}  // namespace

TEST(NanoscopeReader, FirstStoredRowIsTheBottomOfTheImage) {
    const HeightMap map = nanoscopeChannel({}).map;
    ASSERT_EQ(map.columns, 3);
    ASSERT_EQ(map.rows, 2);
    EXPECT_DOUBLE_EQ(map.at(0, 0), 4 * kMetersPerCount);
    EXPECT_DOUBLE_EQ(map.at(0, 2), 6 * kMetersPerCount);
    EXPECT_DOUBLE_EQ(map.at(1, 0), 1 * kMetersPerCount);
}

TEST(NanoscopeReader, HeightIsTheHardValueTimesTheSensitivityNotTheNumberInParentheses) {
    NanoscopeText text;
    text.zScale = "V [Sens. ZsensSens] (99999 V/LSB) 500.0 mV";
    EXPECT_DOUBLE_EQ(nanoscopeChannel(text).map.at(1, 0), 0.5 / 65536.0 * 100e-9);
}

TEST(NanoscopeReader, DivisorFollowsBytesPerPixelEvenWhereSamplesAreWider) {
    NanoscopeText text;
    text.version = "0x09700105";
    text.dataLength = "24";
    const auto counts = {100000, 2, 3, 4, 5, 6};
    EXPECT_DOUBLE_EQ(nanoscopeChannel(text, counts).map.at(1, 0), 100000 * kMetersPerCount);
    text.bytesPerPixel = "4";
    EXPECT_DOUBLE_EQ(nanoscopeChannel(text, counts).map.at(1, 0),
                     100000 * kMetersPerCount / 65536.0);
}

TEST(NanoscopeReader, ChannelSaysWhatTheHeaderSays) {
    const ScanChannel channel = nanoscopeChannel({});
    EXPECT_EQ(channel.name, "ZSensor");
    EXPECT_EQ(channel.unit, "m");
    EXPECT_EQ(channel.direction, "backward");
    EXPECT_DOUBLE_EQ(channel.originX, 7e-9 - 15e-9);  // the offset is that of the center
    EXPECT_DOUBLE_EQ(channel.originY, -10e-9);
    EXPECT_DOUBLE_EQ(channel.map.sizeX(), 30e-9);
    EXPECT_DOUBLE_EQ(channel.map.sizeY(), 20e-9);
    EXPECT_EQ(channel.metadata.at("@2:Image Data"), "S [ZSensor] \"Height Sensor\"");
}

TEST(NanoscopeReader, SensitivityWithoutUnitKeepsTheHardUnit) {
    NanoscopeText text;
    text.scanList = "\\@Sens. Phase: V 2.000000 \r\n";
    text.zScale = "V [Sens. Phase] (0.005 \xBA/LSB) 360.0 \xBA";
    const ScanChannel channel = nanoscopeChannel(text);
    EXPECT_EQ(channel.unit, "deg");
    EXPECT_DOUBLE_EQ(channel.map.at(1, 0), 720.0 / 65536.0);
}

TEST(NanoscopeReader, MillivoltsStayMillivolts) {
    NanoscopeText text;
    text.scanList = "\\@Sens. Amplitude: V 1.000000 \r\n";
    text.zScale = "V [Sens. Amplitude] (0.045 mV/LSB) 3000.0 mV";
    const ScanChannel channel = nanoscopeChannel(text);
    EXPECT_EQ(channel.unit, "mV");
    EXPECT_DOUBLE_EQ(channel.map.at(1, 0), 3000.0 / 65536.0);
}

TEST(NanoscopeReader, UnknownSoftScaleIsNeverAHeight) {
    NanoscopeText text;
    text.zScale = "V [Sens. Lost] (0.1 V/LSB) 2.0 V";
    EXPECT_EQ(nanoscopeChannel(text).unit, "V");
}

TEST(NanoscopeReader, MissingSoftScaleKeepsTheHardUnit) {
    NanoscopeText text;
    text.zScale = "V (0.1 nm/LSB) 65536.0 nm";
    EXPECT_EQ(nanoscopeChannel(text).unit, "m");
    EXPECT_DOUBLE_EQ(nanoscopeChannel(text).map.at(1, 0), 1e-9);
}

TEST(NanoscopeReader, SamplesCannotStartInsideTheHeader) {
    NanoscopeText text;
    text.dataOffset = "100";
    EXPECT_THROW((void)nanoscopeChannel(text), InputError);
}

TEST(NanoscopeReader, ParenthesesMayNest) {
    NanoscopeText text;
    text.scanList = "\\@Sens. Log: V 1.000000 log(Pa)/log(Arb)\r\n";
    text.zScale = "V [Sens. Log] (0.0004 log(Arb)/LSB) 2.0 log(Arb)";
    EXPECT_EQ(nanoscopeChannel(text).unit, "log(Pa)");
}

TEST(NanoscopeReader, KeysDifferInCaseBetweenVersions) {
    NanoscopeText text;
    std::string bytes = nanoscopeFile(text);
    const std::size_t offset = bytes.rfind("Scan Size");
    bytes.replace(offset, 9, "sCAN sIZE");
    EXPECT_DOUBLE_EQ(readHeightMapBytes(bytes, "scan").channels.at(0).map.sizeX(), 30e-9);
}

TEST(NanoscopeReader, MicrometersMayBeATildeOrALatinMicroSign) {
    NanoscopeText text;
    text.scanSize = "30 20 ~m";
    EXPECT_DOUBLE_EQ(nanoscopeChannel(text).map.sizeY(), 20e-6);
    text.scanSize = "30 20 \xB5m";
    EXPECT_DOUBLE_EQ(nanoscopeChannel(text).map.sizeY(), 20e-6);
}

/// All sizes below are those that Gwyddion 2.62 gives the same bytes.
TEST(NanoscopeReader, SizeOfASquareAspectStandsAsItIsWritten) {
    NanoscopeText text;
    text.aspectRatio = "1:1";
    text.scanSize = "30 30 nm";
    const ScanChannel channel = nanoscopeChannel(text);
    EXPECT_DOUBLE_EQ(channel.map.sizeX(), 30e-9);
    EXPECT_DOUBLE_EQ(channel.map.sizeY(), 30e-9);
    EXPECT_THAT(channel.notes, testing::Contains(HasSubstr("10 nm x 15 nm")));
    text.scanSize = "30 nm";
    EXPECT_DOUBLE_EQ(nanoscopeChannel(text).map.sizeY(), 30e-9);
    text.scanSize = "30 15 nm";
    EXPECT_DOUBLE_EQ(nanoscopeChannel(text).map.sizeY(), 15e-9);
    text.aspectRatio = "1:2";  // the number before the colon decides
    EXPECT_DOUBLE_EQ(nanoscopeChannel(text).map.sizeY(), 15e-9);
}

TEST(NanoscopeReader, AnotherAspectScalesTheHeightByLinesOverSamples) {
    NanoscopeText text;
    text.scanSize = "30 30 nm";
    for (const char* const aspect : {"3:2", "0.516184", "2:1"}) {
        text.aspectRatio = aspect;
        text.scanGrid =
            "\\Samps/line: 3\r\n\\Lines: 2\r\n\\Aspect Ratio: " + std::string(aspect) + "\r\n";
        EXPECT_DOUBLE_EQ(nanoscopeChannel(text).map.sizeY(), 20e-9) << aspect;
    }
}

TEST(NanoscopeReader, PartOfASquareScanIsAsHighAsItsLinesAreOfAllLines) {
    NanoscopeText text;
    text.scanSize = "30 30 nm";
    text.aspectRatio = "3:2";
    text.scanGrid = "\\Samps/line: 3\r\n\\Lines: 8\r\n\\Aspect Ratio: 1:1\r\n";
    EXPECT_DOUBLE_EQ(nanoscopeChannel(text).map.sizeY(), 7.5e-9);
}

TEST(NanoscopeReader, ScanListHasTheSizeWhereThatOfTheImageDoesNotFitItsData) {
    NanoscopeText text;
    text.scanSize = "30 30 nm";
    text.samples = "6";
    text.lines = "8";
    text.scanGrid = "\\Samps/line: 3\r\n\\Lines: 2\r\n";
    const ScanChannel channel = nanoscopeChannel(text);
    EXPECT_EQ(channel.map.columns, 3);
    EXPECT_EQ(channel.map.rows, 2);
    EXPECT_DOUBLE_EQ(channel.map.sizeX(), 15e-9);
    EXPECT_DOUBLE_EQ(channel.map.sizeY(), 7.5e-9);
    EXPECT_THAT(channel.notes, testing::Contains(HasSubstr("scan list")));
}

TEST(NanoscopeReader, DataMayBeLongerThanTheSamplesNeed) {
    NanoscopeText text;
    text.dataLength = "1000";
    const ScanChannel channel = nanoscopeChannel(text);
    EXPECT_EQ(channel.map.rows, 2);
    EXPECT_DOUBLE_EQ(channel.map.at(1, 0), kMetersPerCount);
}

TEST(NanoscopeReader, OffsetIsThatOfTheCenterAndARotationIsNoted) {
    NanoscopeText text;
    text.scanGrid = "\\Rotate Ang.: 30\r\n";
    const HeightMapFile file = readHeightMapBytes(nanoscopeFile(text), "scan.spm");
    EXPECT_DOUBLE_EQ(file.channels.at(0).originX, -8e-9);
    EXPECT_THAT(file.notes, testing::Contains(HasSubstr("rotated by 30 degrees")));
}

/// A crop of NanoScope Analysis: the scan list stays that of the scan.
TEST(NanoscopeReader, APartOfAScanWhosePositionIsNotGivenIsNoted) {
    NanoscopeText text;
    text.scanList = "\\Scan Size: 60 nm\r\n\\Lines: 2\r\n\\X Offset: 7 nm\r\n"
                    "\\@Sens. ZsensSens: V 100.0000 nm/V\r\n";
    const ScanChannel channel = nanoscopeChannel(text);
    EXPECT_DOUBLE_EQ(channel.originX, -8e-9);
    EXPECT_THAT(channel.notes,
                testing::Contains(HasSubstr("a part of a scan of 60 nm, and the file "
                                            "does not say which")));
    EXPECT_THAT(nanoscopeChannel({}).notes, Not(testing::Contains(HasSubstr("a part of a scan"))));
    text.scanList.erase(text.scanList.find("\\X Offset"), 18);
    EXPECT_THAT(nanoscopeChannel(text).notes,
                Not(testing::Contains(HasSubstr("a part of a scan"))));
}

TEST(NanoscopeReader, ASideOfZeroIsAnUnknownSize) {
    NanoscopeText text;
    text.scanSize = "10 0 nm";
    const ScanChannel channel = nanoscopeChannel(text);
    EXPECT_FALSE(channel.hasSize());
    EXPECT_THAT(channel.notes, testing::Contains(HasSubstr("no lateral size")));
    EXPECT_THAT(channel.notes, Not(testing::Contains(HasSubstr("not square"))));
}

TEST(NanoscopeReader, FirstLineMayNameElectrochemistry) {
    std::string bytes = nanoscopeFile({});
    bytes.insert(2, "EC ");
    bytes.erase(bytes.find('\x1A'), 3);
    const HeightMapFile file = readHeightMapBytes(bytes, "scan.spm");
    EXPECT_DOUBLE_EQ(file.channels.at(0).map.at(1, 0), kMetersPerCount);
    EXPECT_THAT(file.provenance, Not(testing::IsEmpty()));
}

TEST(NanoscopeReader, NameMayBelongToAnotherGroup) {
    for (const char* const key : {"@3:Image Data", "@4:Image Data", "Image data"}) {
        std::string bytes = nanoscopeFile({});
        const std::size_t offset = bytes.find("@2:Image Data");
        bytes.replace(offset, 13, key);
        if (std::string_view(key) == "Image data") {
            bytes.insert(bytes.find('\x1A'), 3, '\x1A');
        }
        const HeightMapFile file = readHeightMapBytes(bytes, "scan.spm");
        EXPECT_THAT(file.channels.at(0).name, HasSubstr("ZSensor")) << key;
    }
}

TEST(NanoscopeReader, ScaleMayBelongToAnotherGroup) {
    std::string bytes = nanoscopeFile({});
    bytes.replace(bytes.find("@2:Z scale"), 10, "@4:Z scale");
    EXPECT_DOUBLE_EQ(readHeightMapBytes(bytes, "scan").channels.at(0).map.at(1, 0),
                     kMetersPerCount);
}

TEST(NanoscopeReader, OldFilesStateTheFullScale) {
    std::string bytes = nanoscopeFile({});
    const std::string scale = "Z scale: 440 nm (0.00671387)";
    const std::size_t offset = bytes.find("@2:Z scale");
    bytes.replace(offset, bytes.find('\r', offset) - offset, scale);
    bytes.insert(bytes.find('\x1A'), 1200 - bytes.size() + 12, '\x1A');
    const ScanChannel channel = readHeightMapBytes(bytes, "old.001").channels.at(0);
    EXPECT_EQ(channel.unit, "m");
    EXPECT_DOUBLE_EQ(channel.map.at(1, 0), 440e-9 / 65536.0);
}

TEST(NanoscopeReader, OldestFilesScaleByTheKindOfTheImage) {
    const std::string header =
        "\\*File list\r\n\\Data length: 600\r\n\\*Microscope list\r\n\\Z sensitivity: 8.1\r\n"
        "\\*Controller list\r\n\\Z max: 220\r\n\\*Afm list\r\n\\*AFM image list\r\n"
        "\\Data offset: 600\r\n\\Data length: 12\r\n\\Samps/line: 3 2\r\n"
        "\\Scan size: 30 nm\r\n\\Image data: Height\r\n\\Z scale height: 1000\r\n"
        "\\*File list end\r\n";
    std::string bytes = header + std::string(600 - header.size(), '\x1A');
    for (int count = 1; count <= 6; ++count) {
        bytes += static_cast<char>(count);
        bytes += '\0';
    }
    const ScanChannel channel = readHeightMapBytes(bytes, "oldest.001").channels.at(0);
    EXPECT_EQ(channel.name, "Height");
    EXPECT_EQ(channel.unit, "m");
    EXPECT_EQ(channel.map.rows, 2);
    EXPECT_DOUBLE_EQ(channel.map.at(1, 0), 1e-9 * 2.0 / 65536.0 * 1000 * 220 * 8.1 / 65536.0);
}

/// Two images in one file, each of 12 bytes of samples.
std::string twoImages(const char* secondOffset = "1212") {
    std::string bytes = nanoscopeFile({});
    const std::size_t begin = bytes.find("\\*Ciao image list");
    const std::size_t end = bytes.find("\\*File list end");
    std::string list = bytes.substr(begin, end - begin);
    list.replace(list.find("1200"), 4, secondOffset);
    bytes.insert(end, list);
    bytes.erase(bytes.find('\x1A'), list.size());
    return bytes + std::string(12, '\0');
}

TEST(NanoscopeReader, WholeImagesOfATruncatedFileOpenWithANote) {
    std::string bytes = twoImages();
    bytes.pop_back();
    const HeightMapFile file = readHeightMapBytes(bytes, "cut.spm");
    EXPECT_EQ(file.channels.size(), 1U);
    EXPECT_THAT(file.notes, testing::Contains(AllOf(HasSubstr("truncated"), HasSubstr("ZSensor"))));
    bytes.resize(1211);
    EXPECT_THAT(refusalOf([&] { (void)readHeightMapBytes(bytes, "cut.spm"); }),
                HasSubstr("truncated"));
}

TEST(NanoscopeReader, TruncatedFileThatLostPartOfItsHeaderIsRefused) {
    std::string bytes = twoImages();
    bytes.erase(bytes.find('\x1A'), 1);
    EXPECT_THAT(refusalOf([&] { (void)readHeightMapBytes(bytes, "cut.spm"); }),
                HasSubstr("truncated"));
}

TEST(NanoscopeReader, ProfilesOfTrenchesAreRefusedInWords) {
    std::string bytes = nanoscopeFile({});
    bytes.replace(bytes.find("\\Data length: 1200"), 18,
                  "\\Start context: LVAR\r\n\\Data length: 1200");
    bytes.erase(bytes.find('\x1A'), 22);
    EXPECT_THAT(refusalOf([&] { (void)readHeightMapBytes(bytes, "trench.spm"); }),
                HasSubstr("profiles of different lengths"));
}

TEST(NanoscopeReader, StoppedScanShowsItsStoredLinesOnlyAndSaysSo) {
    NanoscopeText text;
    text.lines = "8";
    text.scanSize = "30 80 nm";
    text.aspectRatio = "1:1";
    text.scanGrid = "\\Lines: 8\r\n";
    const HeightMapFile file = readHeightMapBytes(nanoscopeFile(text), "scan");
    EXPECT_EQ(file.channels.at(0).map.rows, 2);
    EXPECT_DOUBLE_EQ(file.channels.at(0).map.sizeY(), 20e-9);
    EXPECT_DOUBLE_EQ(file.channels.at(0).originY, -40e-9);  // of the lines that were planned
    EXPECT_THAT(file.channels.at(0).notes.at(0), HasSubstr("stopped after 2 of 8 lines"));
}

TEST(NanoscopeReader, EarlierLevelingIsNoted) {
    NanoscopeText text;
    text.extra = "\\Offline Planefit: Full\r\n";
    EXPECT_THAT(readHeightMapBytes(nanoscopeFile(text), "scan").channels.at(0).notes.at(0),
                HasSubstr("leveled"));
}

TEST(NanoscopeReader, ZeroScanSizeIsUnknownNotOneMeter) {
    NanoscopeText text;
    text.scanSize = "0 0 nm";
    EXPECT_FALSE(nanoscopeChannel(text).hasSize());
}

TEST(NanoscopeReader, RefusesWhatDoesNotFitTogether) {
    const auto with = [](auto NanoscopeText::*field, const char* value) {
        NanoscopeText text;
        text.*field = value;
        return refusalOfNanoscope(text);
    };
    EXPECT_THAT(with(&NanoscopeText::dataLength, "0"), HasSubstr("Data length"));
    EXPECT_THAT(with(&NanoscopeText::dataLength, "11"), HasSubstr("do not fit 3 x 2"));
    EXPECT_THAT(with(&NanoscopeText::dataLength, "5"), HasSubstr("do not fit 3 x 2"));
    EXPECT_THAT(with(&NanoscopeText::samples, "0"), HasSubstr("0 x 2 pixels"));
    EXPECT_THAT(with(&NanoscopeText::samples, "-3"), HasSubstr("-3 x 2 pixels"));
    EXPECT_THAT(with(&NanoscopeText::samples, "4000000000"), HasSubstr("65536"));
    EXPECT_THAT(with(&NanoscopeText::samples, "512 512"), HasSubstr("whole number"));
    EXPECT_THAT(with(&NanoscopeText::bytesPerPixel, "3"), HasSubstr("Bytes/pixel"));
    EXPECT_THAT(with(&NanoscopeText::scanSize, "wide"), HasSubstr("Scan size"));
    EXPECT_THAT(with(&NanoscopeText::scanSize, "30 20 parsec"), HasSubstr("Scan size"));
    EXPECT_THAT(with(&NanoscopeText::zScale, "V [Sens. ZsensSens (0.1) 2 V"), HasSubstr("Z scale"));
    EXPECT_THAT(with(&NanoscopeText::zScale, "V [Sens. ZsensSens] (0.1) nan V"),
                HasSubstr("Z scale"));
    EXPECT_THAT(with(&NanoscopeText::zScale, "V [Sens. ZsensSens] (0.1) \xB2 V"),
                HasSubstr("Z scale"));
    EXPECT_THAT(with(&NanoscopeText::scanList, "\\@Sens. ZsensSens: V none\r\n"),
                HasSubstr("ZsensSens"));
}

TEST(NanoscopeReader, RefusalNamesFileLocationAndExpectation) {
    NanoscopeText text;
    text.dataLength = "11";
    EXPECT_THAT(refusalOfNanoscope(text),
                AllOf(HasSubstr("scan.spm: "), HasSubstr("image list 1: ")));
}

TEST(NanoscopeReader, RefusesImagesThatShareBytes) {
    EXPECT_EQ(readHeightMapBytes(twoImages(), "scan").channels.size(), 2U);
    EXPECT_THROW((void)readHeightMapBytes(twoImages("1200"), "scan"), InputError);
    EXPECT_THROW((void)readHeightMapBytes(twoImages("1204"), "scan"), InputError);
}

TEST(NanoscopeReader, RefusesForceCurvesAndTextExports) {
    for (const char* bytes : {"\\*Force file list\r\n", "?*File list\r\n"}) {
        EXPECT_THROW((void)readHeightMapBytes(bytes, "scan"), InputError) << bytes;
    }
}

TEST(NanoscopeReader, ImageOfAForceVolumeIsReadWithANote) {
    std::string bytes = nanoscopeFile({});
    const std::size_t listed = bytes.find("\\*Ciao image list");
    const std::string forceList = "\\*Ciao force image list\r\n\\Data offset: 1212\r\n"
                                  "\\Data length: 4000\r\n\\Samps/line: 16 16\r\n"
                                  "\\@4:Z scale: V [Sens. DeflSens] (0.1 V/LSB) 2.0 V\r\n";
    bytes.insert(listed, forceList);
    bytes.erase(bytes.find('\x1A'), forceList.size());
    std::string volume = bytes;
    const std::string first = "\\*File list";
    const std::string forceFirst = "\\*Force file list";
    volume.replace(0, first.size(), forceFirst);
    volume.erase(volume.find('\x1A'), forceFirst.size() - first.size());
    for (const std::string& file : {bytes, volume}) {
        const HeightMapFile read = readHeightMapBytes(file, "volume.000");
        ASSERT_EQ(read.channels.size(), 1U);
        EXPECT_DOUBLE_EQ(read.channels[0].map.at(0, 0), 4 * kMetersPerCount);
        EXPECT_THAT(read.notes, testing::Contains(HasSubstr("force curves")));
    }
}

TEST(NanoscopeReader, ForceCurvesWithoutAnImageAreRefusedInWords) {
    EXPECT_THAT(refusalOf([] {
                    (void)readHeightMapBytes("\\*Force file list\r\n\\Version: 0x09010201\r\n"
                                             "\\*Ciao force image list\r\n\x1A",
                                             "curve.000");
                }),
                AllOf(HasSubstr("curve.000: "), HasSubstr("force curves, no image")));
}

TEST(NanoscopeReader, RefusesAnImageWithoutAScale) {
    std::string bytes = nanoscopeFile({});
    bytes.replace(bytes.find("@2:Z scale"), 10, "@9:Z scale");
    try {
        (void)readHeightMapBytes(bytes, "old.001");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), AllOf(HasSubstr("old.001"), HasSubstr("before version 4.3")));
    }
}

TEST(NanoscopeReader, ExplainsDamagedLineEnds) {
    ASPERITY_NEEDS_SHARED_DATA();
    try {
        (void)readHeightMapFile(sharedData("afm/nanoscope/malformed_lf_line_endings.001"));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(),
                    AllOf(HasSubstr("malformed_lf_line_endings.001"), HasSubstr("text mode")));
    }
}

TEST(NanoscopeReader, RefusesATruncatedFile) {
    ASPERITY_NEEDS_SHARED_DATA();
    try {
        (void)readHeightMapFile(sharedData("afm/nanoscope/malformed_truncated.di"));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(),
                    AllOf(HasSubstr("malformed_truncated.di"), HasSubstr("truncated")));
    }
}

}  // namespace asperity::test
