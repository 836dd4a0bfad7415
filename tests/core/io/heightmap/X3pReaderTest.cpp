#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/ScanImage.h"
#include "tests/core/io/heightmap/ZipFiles.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asperity::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// Description in a small X3P file of 3 x 2 doubles; tests change single lines.
struct X3pText {
    std::string feature = "SUR";
    std::string axisX = "<AxisType>I</AxisType><Increment>2e-9</Increment><Offset>7e-9</Offset>";
    std::string axisY = "<AxisType>I</AxisType><Increment>3e-9</Increment><Offset>0</Offset>";
    std::string axisZ = "<AxisType>A</AxisType><DataType>D</DataType>";
    std::string record2 = "<Instrument><Manufacturer>Maker</Manufacturer></Instrument>"
                          "<Comment>two words</Comment>";
    std::string matrix = "<SizeX>3</SizeX><SizeY>2</SizeY><SizeZ>1</SizeZ>";
    std::string data = "<DataLink><PointDataLink>bindata/data.bin</PointDataLink></DataLink>";
    std::string root = "p:ISO5436_2";
};

std::string mainXml(const X3pText& text) {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<" + text.root +
           " xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\">\n<Record1><Revision>ISO5436 - "
           "2000</Revision><FeatureType>" +
           text.feature + "</FeatureType><Axes><CX>" + text.axisX + "</CX><CY>" + text.axisY +
           "</CY><CZ>" + text.axisZ + "</CZ></Axes></Record1>\n<Record2>" + text.record2 +
           "</Record2>\n<Record3><MatrixDimension>" + text.matrix + "</MatrixDimension>" +
           text.data + "</Record3>\n</" + text.root + ">\n";
}

template <typename Number>
std::string binary(const std::vector<Number>& numbers) {
    std::string bytes;
    for (const Number number : numbers) {
        appendLittleEndian(bytes, number);
    }
    return bytes;
}

const std::string kSixNanometers = binary<double>({1e-9, 2e-9, 3e-9, 4e-9, 5e-9, 6e-9});

std::string x3pFile(const X3pText& text, const std::string& points = kSixNanometers) {
    return zipFile({{"main.xml", mainXml(text)}, {"bindata/data.bin", points}});
}

HeightMapFile readAsX3p(const std::string& bytes) { return readHeightMapBytes(bytes, "scan.x3p"); }

std::string refusalOfX3p(const std::string& bytes) {
    return refusalOf([&] { (void)readAsX3p(bytes); });
}

std::string zAxis(const std::string& type, const std::string& scale = "") {
    return "<AxisType>A</AxisType><DataType>" + type + "</DataType>" + scale;
}

const std::string kValidLink = "<DataLink><PointDataLink>bindata/data.bin</PointDataLink>"
                               "<ValidPointsLink>bindata/valid.bin</ValidPointsLink></DataLink>";

}  // namespace

TEST(X3pReader, RowsComeFromTheTopAndColumnsFromTheLeft) {
    const HeightMapFile file = readAsX3p(x3pFile({}));
    EXPECT_EQ(file.format, "X3P (ISO 25178-72)");
    const ScanChannel& channel = file.channels.at(0);
    EXPECT_EQ(channel.name, "Topography");
    EXPECT_TRUE(channel.isHeight());
    EXPECT_EQ(channel.map.columns, 3);
    EXPECT_EQ(channel.map.rows, 2);
    EXPECT_DOUBLE_EQ(channel.map.pitchX, 2e-9);
    EXPECT_DOUBLE_EQ(channel.map.pitchY, 3e-9);
    EXPECT_DOUBLE_EQ(channel.originX, 7e-9);
    EXPECT_EQ(channel.map.at(0, 2), 3e-9);
    EXPECT_EQ(channel.map.at(1, 0), 4e-9);
    EXPECT_THAT(file.notes, IsEmpty());
    EXPECT_THAT(channel.notes, IsEmpty());
}

TEST(X3pReader, KeepsMetadataAndProvenance) {
    const HeightMapFile file =
        readAsX3p(x3pFile({.axisZ = zAxis("D", "<Increment>1e-3</Increment>")}));
    const ScanChannel& channel = file.channels.at(0);
    EXPECT_EQ(channel.metadata,
              (std::map<std::string, std::string>{{"Instrument Manufacturer", "Maker"},
                                                  {"Comment", "two words"}}));
    ASSERT_FALSE(file.provenance.empty());
    EXPECT_EQ(file.provenance[0].value, "ISO5436 - 2000");
    EXPECT_EQ(channel.provenance.at(0).value, "0.001 m per stored number");
    EXPECT_EQ(channel.provenance.at(0).source, "main.xml, Record1/Axes/CZ");
}

TEST(X3pReader, ReadsEveryTypeWithScaleAndOffset) {
    const std::string scale = "<Increment>1E-009</Increment><Offset>5e-9</Offset>";
    const struct {
        const char* type;
        std::string points;
    } cases[] = {{"I", binary<std::int16_t>({-1, 2, 3, 4, 5, -32768})},
                 {"L", binary<std::int32_t>({-1, 2, 3, 4, 5, -32768})},
                 {"F", binary<float>({-1, 2, 3, 4, 5, -32768})},
                 {"D", binary<double>({-1, 2, 3, 4, 5, -32768})}};
    for (const auto& each : cases) {
        SCOPED_TRACE(each.type);
        const HeightMap map =
            readAsX3p(x3pFile({.axisZ = zAxis(each.type, scale)}, each.points)).channels.at(0).map;
        EXPECT_DOUBLE_EQ(map.at(0, 0), 4e-9);
        EXPECT_DOUBLE_EQ(map.at(1, 2), -32763e-9);
        EXPECT_EQ(countInvalid(map), 0U);
    }
}

TEST(X3pReader, NanHoldsNoData) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const HeightMap map = readAsX3p(x3pFile({}, binary<double>({1e-9, nan, 1e-9, nan, 1e-9, 1e-9})))
                              .channels.at(0)
                              .map;
    EXPECT_EQ(map.invalid, (PixelMask{0, 1, 0, 1, 0, 0}));
}

TEST(X3pReader, ValidPointsAreBitsTheLowestFirst) {
    // 11 x 2 pixels: the second row begins within a byte.
    const X3pText text{.axisZ = zAxis("I"),
                       .matrix = "<SizeX>11</SizeX><SizeY>2</SizeY><SizeZ>1</SizeZ>",
                       .data = kValidLink};
    const std::string points = binary(std::vector<std::int16_t>(22, 1));
    // Invalid: 1, 10, 11, 21.
    const std::string valid("\xFD\xF3\xDF", 3);
    const HeightMap map = readAsX3p(zipFile({{"main.xml", mainXml(text)},
                                             {"bindata/data.bin", points},
                                             {"bindata/valid.bin", valid}}))
                              .channels.at(0)
                              .map;
    std::vector<std::size_t> invalid;
    for (std::size_t i = 0; i < map.invalid.size(); ++i) {
        if (map.invalid[i] != 0) {
            invalid.push_back(i);
        }
    }
    EXPECT_THAT(invalid, ElementsAre(1, 10, 11, 21));
    EXPECT_THAT(refusalOfX3p(zipFile({{"main.xml", mainXml(text)},
                                      {"bindata/data.bin", points},
                                      {"bindata/valid.bin", valid.substr(1)}})),
                HasSubstr("bindata/valid.bin: expected 3 bytes, found 2"));
}

TEST(X3pReader, ReadsAListOfText) {
    const std::string list = "<p:DataList><p:Datum>1e-9</p:Datum><p:Datum/><Datum> </Datum>"
                             "<Datum>0;1;4e-9</Datum><Datum>5E-009</Datum><Datum>NaN</Datum>"
                             "</p:DataList>";
    const HeightMap map =
        readAsX3p(zipFile({{"main.xml", mainXml({.data = list})}})).channels.at(0).map;
    EXPECT_EQ(map.invalid, (PixelMask{0, 1, 1, 0, 0, 1}));
    EXPECT_EQ(map.at(1, 0), 4e-9);
    EXPECT_EQ(map.at(1, 1), 5e-9);
    EXPECT_THAT(refusalOfX3p(zipFile({{"main.xml", mainXml({.data = "<DataList><Datum>1</Datum>"
                                                                    "</DataList>"})}})),
                HasSubstr("expected 6 elements Datum, found 1"));
    EXPECT_THAT(
        refusalOfX3p(zipFile(
            {{"main.xml", mainXml({.matrix = "<SizeX>1</SizeX><SizeY>1</SizeY><SizeZ>1</SizeZ>",
                                   .data = "<DataList><Datum>high</Datum></DataList>"})}})),
        HasSubstr("Datum 1: expected a number, found 'high'"));
}

// A main.xml of 62 KB, packed, took a gigabyte: the parser keeps many bytes for each element.
TEST(X3pReader, RefusesMoreElementsThanAListHas) {
    std::string elements;
    for (int i = 0; i < 1'200'000; ++i) {
        elements += i % 2 == 0 ? "<a/>" : "<a b=\"\"/>";
    }
    EXPECT_EQ(
        refusalOfX3p(x3pFile({.record2 = elements})),
        "scan.x3p: main.xml: expected at most 1200000 elements and attributes, found 1800028");
}

TEST(X3pReader, ReadsAListOfAMillionHeights) {
    std::string list = "<DataList>";
    for (int i = 0; i < 1024 * 1024; ++i) {
        list += "<Datum>1e-9</Datum>";
    }
    const std::string file = zipFile({{"main.xml", mainXml({.matrix = "<SizeX>1024</SizeX>"
                                                                      "<SizeY>1024</SizeY>",
                                                            .data = list + "</DataList>"})}});
    EXPECT_EQ(readAsX3p(file).channels.at(0).map.at(1023, 1023), 1e-9);
}

TEST(X3pReader, FindsMainXmlInASubFolderBesideThatOfAMac) {
    const HeightMapFile file = readAsX3p(zipFile({{"__MACOSX/scan/._main.xml", "x"},
                                                  {"__MACOSX/scan/main.xml", "x"},
                                                  {"scan/.DS_Store", "x"},
                                                  {"scan/main.xml", mainXml({})},
                                                  {"scan/bindata/data.bin", kSixNanometers}}));
    EXPECT_EQ(file.channels.at(0).map.at(0, 0), 1e-9);
}

TEST(X3pReader, ReadsAnyNamespacePrefixAndBackslashes) {
    for (const char* root : {"ISO5436_2", "x3p:ISO5436_2", "ISO5436", "p:ISO5436"}) {
        EXPECT_EQ(readAsX3p(x3pFile({.root = root})).channels.size(), 1U);
    }
    EXPECT_EQ(
        readAsX3p(x3pFile({.data = "<DataLink><PointDataLink>bindata\\data.bin</PointDataLink>"
                                   "</DataLink>"}))
            .channels.size(),
        1U);
}

TEST(X3pReader, LayersAreChannels) {
    const X3pText text{.axisZ = zAxis("I", "<Increment>1e-9</Increment>"),
                       .matrix = "<SizeX>2</SizeX><SizeY>1</SizeY><SizeZ>2</SizeZ>"};
    const HeightMapFile file = readAsX3p(x3pFile(text, binary<std::int16_t>({1, 2, 3, 4})));
    ASSERT_EQ(file.channels.size(), 2U);
    EXPECT_EQ(file.channels[1].name, "Topography 2");
    EXPECT_DOUBLE_EQ(file.channels[1].map.at(0, 0), 3e-9);
}

TEST(X3pReader, AnUnknownSizeIsNotInvented) {
    for (const char* axis :
         {"<AxisType>I</AxisType>", "<AxisType>I</AxisType><Increment>0</Increment>",
          "<AxisType>I</AxisType><Increment>nan</Increment>",
          "<AxisType>I</AxisType><Increment>-1e-9</Increment>"}) {
        const HeightMapFile file = readAsX3p(x3pFile({.axisX = axis}));
        EXPECT_FALSE(file.channels.at(0).hasSize()) << axis;
    }
}

TEST(X3pReader, NotesImplausibleUnits) {
    const HeightMapFile wide =
        readAsX3p(x3pFile({.axisX = "<AxisType>I</AxisType><Increment>0.25</Increment>"}));
    EXPECT_THAT(wide.notes, ElementsAre(HasSubstr("a side of 0.75 m is implausible")));
    const HeightMapFile high = readAsX3p(x3pFile({}, binary<double>({0, 1e-3, 0, 0, 0, 0})));
    EXPECT_THAT(high.channels.at(0).notes,
                ElementsAre(HasSubstr("heights from 0 m to 0.001 m are implausible")));
    const HeightMapFile flat = readAsX3p(x3pFile({}, binary<double>({0, 1e-14, 0, 0, 0, 0})));
    EXPECT_THAT(flat.channels.at(0).notes, ElementsAre(HasSubstr("implausible")));
    const HeightMapFile constant = readAsX3p(x3pFile({}, binary<double>({1, 1, 1, 1, 1, 1})));
    EXPECT_THAT(constant.channels.at(0).notes, IsEmpty());
}

TEST(X3pReader, AWrongChecksumIsNoted) {
    const auto withChecksum = [](const std::string& md5) {
        return "<DataLink><PointDataLink>bindata/data.bin</PointDataLink><MD5ChecksumPointData>" +
               md5 + "</MD5ChecksumPointData></DataLink>";
    };
    // md5sum of the six doubles.
    EXPECT_THAT(
        readAsX3p(x3pFile({.data = withChecksum("b0917c2cc91108660fc81f84a0f099e5")})).notes,
        IsEmpty());
    EXPECT_THAT(readAsX3p(x3pFile({.data = withChecksum(std::string(32, '0'))})).notes,
                ElementsAre(HasSubstr("MD5ChecksumPointData")));
    const std::vector<ZippedFile> files{{"main.xml", mainXml({})},
                                        {"bindata/data.bin", kSixNanometers},
                                        {"md5checksum.hex", std::string(32, '0') + " *main.xml"}};
    EXPECT_THAT(readAsX3p(zipFile(files)).notes, ElementsAre(HasSubstr("md5checksum.hex")));
}

TEST(X3pReader, RefusesWhatIsNoSurface) {
    EXPECT_THAT(refusalOfX3p(x3pFile({.feature = "PRF"})),
                AllOf(StartsWith("scan.x3p: main.xml, "), HasSubstr("a profile")));
    EXPECT_THAT(refusalOfX3p(x3pFile({.feature = "PCL"})), HasSubstr("a cloud of points"));
    EXPECT_THAT(refusalOfX3p(x3pFile({.feature = ""})), HasSubstr("expected SUR"));
    EXPECT_THAT(refusalOfX3p(x3pFile({.axisX = "<AxisType>A</AxisType>"})),
                HasSubstr("a list of points"));
}

TEST(X3pReader, RefusesWhatDoesNotFitTogether) {
    EXPECT_THAT(refusalOfX3p(x3pFile({}, kSixNanometers.substr(1))),
                HasSubstr("bindata/data.bin: expected 48 bytes for 3 x 2 pixels, found 47"));
    EXPECT_THAT(refusalOfX3p(x3pFile({}, kSixNanometers + "x")), HasSubstr("found 49"));
    EXPECT_THAT(refusalOfX3p(x3pFile({.axisZ = zAxis("Q")})), HasSubstr("expected I, L, F or D"));
    EXPECT_THAT(refusalOfX3p(x3pFile({.axisZ = "<AxisType>A</AxisType>"})), HasSubstr("DataType"));
    EXPECT_THAT(refusalOfX3p(x3pFile({.axisZ = zAxis("D", "<Increment>0</Increment>")})),
                HasSubstr("CZ"));
    EXPECT_THAT(refusalOfX3p(x3pFile({.axisZ = zAxis("D", "<Offset>inf</Offset>")})),
                HasSubstr("CZ"));
    EXPECT_THAT(refusalOfX3p(x3pFile({.axisZ = zAxis("D", "<Increment>1,5</Increment>")})),
                HasSubstr("expected a number, found '1,5'"));
    EXPECT_THAT(refusalOfX3p(x3pFile({.matrix = "<SizeX>0</SizeX><SizeY>2</SizeY>"})),
                HasSubstr("0 x 2 pixels"));
    EXPECT_THAT(refusalOfX3p(x3pFile({.matrix = "<SizeX>65536</SizeX><SizeY>65536</SizeY>"
                                                "<SizeZ>128</SizeZ>"})),
                HasSubstr("expected 4398046511104 bytes"));
    EXPECT_THAT(refusalOfX3p(x3pFile({.matrix = "<SizeX>1</SizeX><SizeY>1</SizeY>"
                                                "<SizeZ>129</SizeZ>"})),
                HasSubstr("expected 1 to 128, found 129"));
    EXPECT_THAT(
        refusalOfX3p(x3pFile({.matrix = "<SizeX>3</SizeX><SizeY>2</SizeY><SizeZ>0</SizeZ>"})),
        HasSubstr("SizeZ"));
    EXPECT_THAT(refusalOfX3p(x3pFile({.matrix = "<SizeX>three</SizeX><SizeY>2</SizeY>"})),
                HasSubstr("found 'three'"));
    EXPECT_THAT(refusalOfX3p(x3pFile({.data = ""})), HasSubstr("expected the heights"));
    EXPECT_THAT(refusalOfX3p(x3pFile({.data = kValidLink})),
                HasSubstr("does not hold 'bindata/valid.bin'"));
    EXPECT_THAT(refusalOfX3p(x3pFile({.root = "html"})),
                HasSubstr("expected the element ISO5436_2"));
}

TEST(X3pReader, RefusesDamagedXml) {
    EXPECT_THAT(refusalOfX3p(zipFile({{"main.xml", "<p:ISO5436_2><Record1>"}})),
                HasSubstr("this is no XML"));
    EXPECT_THAT(refusalOfX3p(zipFile({{"main.xml", ""}})), StartsWith("scan.x3p: main.xml"));
}

/// Faults that real files are known for.
TEST(X3pReader, NotesOnTheRealFiles) {
    ASPERITY_NEEDS_SHARED_DATA();
    EXPECT_THAT(readHeightMapFile(sharedData("afm/x3p/x3p-2_nonsquare_pixels.x3p")).notes,
                IsEmpty());
    EXPECT_THAT(readHeightMapFile(sharedData("afm/x3p/x3ptools_testing.x3p")).notes,
                ElementsAre(HasSubstr("implausible")));
    const HeightMapFile logo =
        readHeightMapFile(sharedData("afm/x3p/x3ptools_csafe-logo_subdir.x3p"));
    EXPECT_THAT(logo.notes, ElementsAre(HasSubstr("csafe-logo/md5checksum.hex")));
    EXPECT_THAT(logo.channels.at(0).notes, ElementsAre(HasSubstr("implausible")));
}

}  // namespace asperity::test
