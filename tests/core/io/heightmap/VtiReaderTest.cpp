#include "core/io/ByteReader.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "tests/core/io/heightmap/BumpyMap.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

// Images of VTK as other programs write them, and what is refused of them.

namespace asperity::test {

namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A file of 3 x 2 points with float32 values 1 to 6, the bottom row first.
struct VtiText {
    std::string type = "ImageData";
    std::string attributes = R"(version="0.1" byte_order="LittleEndian")";
    std::string extent = "0 2 0 1 0 0";
    std::string image = R"(Origin="0 0 0" Spacing="2 3 1")";
    std::string array = R"(type="Float32" Name="z" format="appended" offset="0")";
    std::string others;     ///< after the array
    std::string pointData;  ///< attributes of it
    std::string fields;     ///< before the piece
    std::string encoding = "raw";
    std::uint32_t bytes = 24;

    /// @param values after the mark
    [[nodiscard]] std::string textWith(const std::string& values) const {
        return "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + type + "\" " + attributes +
               "><ImageData WholeExtent=\"" + extent + "\" " + image + ">" + fields +
               "<Piece Extent=\"" + extent + "\"><PointData" + pointData + "><DataArray " + array +
               "/>" + others + "</PointData></Piece></ImageData><AppendedData " + "encoding=\"" +
               encoding + "\">_" + values + "</AppendedData></VTKFile>";
    }

    [[nodiscard]] std::string text() const {
        std::string values;
        appendLittleEndian(values, bytes);
        for (const float value : {1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F}) {
            appendLittleEndian(values, value);
        }
        return textWith(values);
    }
};

HeightMapFile readAsVti(const VtiText& file) {
    return readHeightMapBytes(file.text(), "image.vti");
}

std::string refusalOfVti(const VtiText& file) {
    return refusalOf([&] { (void)readAsVti(file); });
}

}  // namespace

TEST(VtiReader, ReadsNumbersOfOtherProgramsFromTheBottomUp) {
    const HeightMapFile file = readAsVti({});
    ASSERT_EQ(file.channels.size(), 1U);
    const ScanChannel& channel = file.channels[0];
    EXPECT_EQ(channel.name, "z");
    EXPECT_EQ(channel.unit, "");
    EXPECT_FALSE(channel.hasSize());
    EXPECT_EQ(channel.map.heights, (std::vector<double>{4, 5, 6, 1, 2, 3}));
    EXPECT_THAT(channel.notes, testing::Contains(HasSubstr("no units")));
}

TEST(VtiReader, TheMarkedArrayIsTheDefaultWhereItMayBeATopography) {
    const auto defaultOf = [](const std::string& marked) {
        VtiText file;
        file.pointData = " Scalars=\"" + marked + "\"";
        for (const char* name : {"Filtered", "Phase"}) {
            file.others += std::string(R"(<DataArray type="Float32" Name=")") + name +
                           R"(" format="appended" offset="0"/>)";
        }
        const HeightMapFile read = readAsVti(file);
        return read.channels.at(read.defaultChannel).name;
    };
    EXPECT_EQ(defaultOf("Filtered"), "Filtered");
    EXPECT_EQ(defaultOf("Phase"), "z");
    EXPECT_EQ(defaultOf("missing"), "z");
    EXPECT_EQ(defaultOf(""), "z");
}

TEST(VtiReader, ReadsEachArrayAndNotesThoseItLeavesOut) {
    VtiText file;
    file.others = R"(<DataArray type="UInt32" Name="n" format="appended" offset="0"/>)"
                  R"(<DataArray type="Bit" Name="id" format="appended" offset="0"/>)"
                  R"(<DataArray type="Float32" NumberOfComponents="3" Name="v" format="appended")"
                  R"( offset="0"/>)";
    const HeightMapFile result = readAsVti(file);
    ASSERT_EQ(result.channels.size(), 2U);
    EXPECT_EQ(result.channels[1].name, "n");
    EXPECT_THAT(result.notes, testing::ElementsAre(HasSubstr("Bit"), HasSubstr("3 numbers")));
}

/// Title and unit are those of one image: a slope is no height.
TEST(VtiReader, ManyArraysKeepTheirNamesAndHaveNoUnit) {
    VtiText file;
    file.fields = R"(<FieldData><Array type="String" Name="unit" NumberOfTuples="1" )"
                  R"(format="ascii">109 0</Array></FieldData>)";
    EXPECT_EQ(readAsVti(file).channels.at(0).unit, "m");
    file.others = R"(<DataArray type="UInt32" Name="n" format="appended" offset="0"/>)";
    const HeightMapFile both = readAsVti(file);
    EXPECT_EQ(both.channels.at(0).unit, "");
    EXPECT_EQ(both.channels.at(1).unit, "");
}

/// They are decoded at once, unlike the values of the image.
TEST(VtiReader, ReadsNumbersOfFieldDataThatAreAppended) {
    VtiText file;
    file.fields = R"(<FieldData><DataArray type="Float32" Name="TimeValue" format="appended" )"
                  R"(offset="0"/></FieldData>)";
    const HeightMapFile result = readAsVti(file);
    EXPECT_EQ(result.channels.at(0).map.heights, (std::vector<double>{4, 5, 6, 1, 2, 3}));
    EXPECT_THAT(result.notes, testing::IsEmpty());
}

/// A corner of our own kind, though this program writes it as text.
TEST(VtiReader, ReadsTheOriginFromAppendedFieldData) {
    VtiText file;
    file.fields = R"(<FieldData><Array type="String" Name="unit" NumberOfTuples="1" )"
                  R"(format="ascii">109 0</Array><DataArray type="Float32" Name="scan_origin" )"
                  R"(format="appended" offset="28"/></FieldData>)";
    std::string text = file.text();
    std::string origin;
    appendLittleEndian(origin, std::uint32_t{8});
    appendLittleEndian(origin, 0.25F);
    appendLittleEndian(origin, 0.5F);
    text.insert(text.find("</AppendedData>"), origin);
    const ScanChannel channel = readHeightMapBytes(text, "image.vti").channels.at(0);
    EXPECT_EQ(channel.originX, 0.25);
    EXPECT_EQ(channel.originY, 0.5);
}

TEST(VtiReader, ReadsBigEndianFiles) {
    VtiText file;
    file.attributes = R"(version="1.0" byte_order="BigEndian")";
    file.array = R"(type="UInt8" Name="z" format="appended" offset="0")";
    file.bytes = 0x06000000;
    EXPECT_EQ(readAsVti(file).channels[0].map.heights,
              (std::vector<double>{0x3f, 0, 0, 0, 0, 0x80}));
}

TEST(VtiReader, NamesWhatIsNotKnown) {
    VtiText file;
    file.encoding = "hexadecimal";
    EXPECT_THAT(refusalOfVti(file),
                testing::AllOf(HasSubstr("image.vti"), HasSubstr("'hexadecimal'")));
    file = {};
    file.attributes += R"( compressor="vtkOtherCompressor")";
    EXPECT_THAT(refusalOfVti(file), HasSubstr("'vtkOtherCompressor'"));
    file = {};
    file.array = R"(type="Float32" Name="z" format="other")";
    EXPECT_THAT(refusalOfVti(file), HasSubstr("'other'"));
    file = {};
    file.encoding = "base64";
    EXPECT_THAT(refusalOfVti(file), HasSubstr("base64"));
    file.attributes += R"( compressor="vtkZLibDataCompressor")";
    file.encoding = "raw";
    EXPECT_THAT(refusalOfVti(file), HasSubstr("compressed blocks"));
}

TEST(VtiReader, ReadsNumbersWithinTheXml) {
    VtiText file;
    file.array = R"(type="Int16" Name="z" format="ascii"> 1 2
        3 4 5 6 </DataArray><DataArray type="Float32" Name="y" format="appended" offset="0")";
    const HeightMapFile both = readAsVti(file);
    ASSERT_EQ(both.channels.size(), 2U);
    EXPECT_EQ(both.channels[0].map.heights, (std::vector<double>{4, 5, 6, 1, 2, 3}));
    EXPECT_EQ(both.channels[1].map.heights, both.channels[0].map.heights);
    file.array = R"(type="Int16" Name="z" format="ascii">1 2 3 4 five 6</DataArray><DataArray)";
    EXPECT_THAT(refusalOfVti(file), HasSubstr("found 'five'"));
    file.array = R"(type="Int16" Name="z" format="ascii">1 2 3 4 5</DataArray><DataArray)";
    EXPECT_THAT(refusalOfVti(file), HasSubstr("expected 48 bytes of values, found 40"));
}

/// Only offset and length of a text between tags are kept: no other text may pass for these.
TEST(VtiReader, TakesNoTextForTheOffsetOfOne) {
    const auto refused = [](const std::string& content, const char* format) {
        VtiText file;
        file.array = R"(type="Int8" Name="z" format=")" + std::string(format) + "\">" + content +
                     "</DataArray><DataArray";
        return refusalOfVti(file);
    };
    for (const char* const format : {"ascii", "binary"}) {
        for (const char* const text :
             {"0 5000000000", "99999999999 50", "-5 20", "0 9223372036854775807",
              "9223372036854775807 9223372036854775807", "0 10", "0 10 3"}) {
            EXPECT_THAT(refused("<![CDATA[" + std::string(text) + "]]>", format),
                        HasSubstr("CDATA"))
                << text;
        }
        for (const char* const text : {"0 5000000000", "99999999999 50", "-5 20", "3"}) {
            EXPECT_THAT(refused("<?x ' ?>" + std::string(text) + "<?x ' ?>", format),
                        HasSubstr("expected values within its tags"))
                << text;
        }
    }
}

TEST(VtiReader, LimitsFieldDataInAll) {
    VtiText file;
    file.fields = "<FieldData>";
    for (int i = 0; i < 100; ++i) {
        file.fields += "<Array type=\"String\" Name=\"" + std::to_string(i) +
                       R"(" format="appended" offset="28"/>)";
    }
    file.fields += "</FieldData>";
    const auto withFields = [&file](std::uint32_t size) {
        std::string text = file.text();
        std::string shared;
        appendLittleEndian(shared, size);
        shared += std::string(size, 'a');
        return text.insert(text.find("</AppendedData>"), shared);
    };
    EXPECT_EQ(readHeightMapBytes(withFields(40'000), "image.vti").channels.size(), 1U);
    EXPECT_THAT(refusalOf([&] { (void)readHeightMapBytes(withFields(1U << 20U), "image.vti"); }),
                HasSubstr("FieldData: expected texts and numbers of at most 4194304 bytes in all"));
}

TEST(VtiReader, ReadsNoMoreThan128Arrays) {
    VtiText file;
    for (int i = 0; i < 128; ++i) {
        file.others += "<DataArray type=\"Float32\" Name=\"" + std::to_string(i) +
                       R"(" format="appended" offset="0"/>)";
    }
    EXPECT_THAT(refusalOfVti(file), HasSubstr("PointData: at most 128 images are expected"));
}

/// Arrays may share their bytes: each further one costs a line of XML and is decoded again.
TEST(VtiReader, BoundsWhatAllArraysOfAnOffsetDecodeTo) {
    VtiText file;
    file.attributes += R"( compressor="vtkZLibDataCompressor")";
    file.extent = "0 16383 0 8191 0 0";
    EXPECT_THAT(refusalOfVti(file), Not(HasSubstr("decode to"))) << "half a gigabyte may be";
    for (const char* const name : {"a", "b"}) {
        file.others += std::string(R"(<DataArray type="Float32" Name=")") + name +
                       R"(" format="appended" offset="0"/>)";
    }
    EXPECT_THAT(refusalOfVti(file), HasSubstr("arrays: its images decode to"));
}

TEST(VtiReader, TakesTagsInCommentsAndQuotesForText) {
    VtiText file;
    file.others = R"(<!-- <DataArray> "more -->)";
    file.array = R"(type="Float32" Name="a > b" format="appended" offset="0")";
    EXPECT_EQ(readAsVti(file).channels.at(0).name, "a > b");
}

TEST(VtiReader, RefusesPiecesThatDoNotFillTheImage) {
    const auto withPieces = [](const std::string& pieces) {
        return refusalOf([&] {
            (void)readHeightMapBytes(R"(<VTKFile type="ImageData"><ImageData WholeExtent="0 4 0 2 )"
                                     R"(0 0" Spacing="1 1 1">)" +
                                         pieces + "</ImageData></VTKFile>",
                                     "image.vti");
        });
    };
    const std::string left = R"(<Piece Extent="0 2 0 2 0 0"/>)";
    EXPECT_THAT(withPieces(""), HasSubstr("fill"));
    EXPECT_THAT(withPieces(left), HasSubstr("fill"));
    EXPECT_THAT(withPieces(left + R"(<Piece Extent="1 4 0 2 0 0"/>)"), HasSubstr("fill"));
    EXPECT_THAT(withPieces(left + R"(<Piece Extent="2 5 0 2 0 0"/>)"), HasSubstr("fill"));
    EXPECT_THAT(withPieces(left + R"(<Piece Extent="2 4 0 2 0 0"/>)"),
                HasSubstr("an array of numbers"));
}

/// Tags without end are none of an image, values in text may be long.
TEST(VtiReader, ReadsNoXmlWithoutEnd) {
    const std::string start = R"(<VTKFile type="ImageData"><ImageData><DataArray format=")";
    EXPECT_THAT(refusalOf([&] {
                    (void)readHeightMapBytes(start + std::string(5'000'000, '1'), "long.vti");
                }),
                HasSubstr("too long"));
}

TEST(VtiReader, RefusesWhatIsNoFlatImage) {
    const auto refused = [](auto&& change) {
        VtiText file;
        change(file);
        return refusalOfVti(file);
    };
    EXPECT_THAT(refused([](VtiText& file) { file.type = "PolyData"; }), HasSubstr("'PolyData'"));
    EXPECT_THAT(refused([](VtiText& file) { file.extent = "0 2 0 1 0 4"; }), HasSubstr("volume"));
    EXPECT_THAT(refused([](VtiText& file) { file.extent = "0 2 1 1 0 4"; }), HasSubstr("upright"));
    EXPECT_THAT(refused([](VtiText& file) { file.extent = "0 0 0 0 0 5"; }),
                AllOf(HasSubstr("a line along z"), Not(HasSubstr("upright"))));
    EXPECT_THAT(refused([](VtiText& file) { file.extent = "0 2 0 1"; }), HasSubstr("6 numbers"));
    EXPECT_THAT(refused([](VtiText& file) { file.extent = "0 nan 0 1 0 0"; }),
                HasSubstr("6 numbers"));
    EXPECT_THAT(refused([](VtiText& file) { file.extent = "0 9e300 0 1 0 0"; }),
                HasSubstr("WholeExtent"));
    EXPECT_THAT(refused([](VtiText& file) { file.extent = "0 99999 0 1 0 0"; }),
                HasSubstr("65536"));
    EXPECT_THAT(refused([](VtiText& file) { file.image = R"(Spacing="2 x 1")"; }),
                HasSubstr("Spacing"));
    EXPECT_THAT(refused([](VtiText& file) { file.image += R"( Direction="0 1 0 1 0 0 0 0 1")"; }),
                HasSubstr("turned"));
}

TEST(VtiReader, RefusesValuesThatDoNotFit) {
    const auto refused = [](auto&& change) {
        VtiText file;
        change(file);
        return refusalOfVti(file);
    };
    EXPECT_THAT(refused([](VtiText& file) { file.bytes = 20; }),
                HasSubstr("expected 24 bytes of values, found 20"));
    EXPECT_THAT(refused([](VtiText& file) {
                    file.array = R"(type="Float32" Name="z" format="appended" offset="999")";
                }),
                HasSubstr("behind the end"));
    const std::string whole = VtiText().text();
    for (std::size_t size = 1; size < whole.find("</AppendedData>"); ++size) {
        EXPECT_NE(refusalOf([&] { (void)readHeightMapBytes(whole.substr(0, size), "cut.vti"); }),
                  "")
            << size;
    }
}

/// Values are read where they lie: any head before them is no matter.
TEST(VtiReader, TakesTheMaskOfOurFiles) {
    const ScratchFolder folder;
    writeHeightMap(folder.file("map.vti"), bumpyMapWithHoles(5, 3), {.title = "valid"});
    std::string bytes = contentOf(folder.file("map.vti"));
    const std::size_t valid = bytes.rfind("\n  </AppendedData>") - 15;
    ASSERT_EQ(bytes[valid], '\1') << "bottom row, left";
    bytes[valid] = '\0';
    const HeightMap map = readHeightMapBytes(bytes, "map.vti").channels.at(0).map;
    EXPECT_FALSE(map.isValid(2, 0));
    EXPECT_TRUE(map.isValid(2, 1));
    EXPECT_FALSE(map.isValid(0, 0));
}

}  // namespace asperity::test
