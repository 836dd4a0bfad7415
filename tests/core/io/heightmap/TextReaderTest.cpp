#include "core/Error.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "tests/core/io/heightmap/BumpyMap.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <Eigen/Dense>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace asperity::test {

namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

ScanChannel textChannel(std::string_view text) {
    const HeightMapFile file = readHeightMapBytes(text, "map.txt");
    EXPECT_EQ(file.channels.size(), 1U);
    return file.channels.at(0);
}

std::string refusalOfText(std::string_view text) {
    return refusalOf([&] { (void)readHeightMapBytes(text, "map.txt"); });
}

/// Removes the plane of least squares, and with it the mean.
void levelByPlane(HeightMap& map) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    const auto basis = [&](int row, int column) {
        return Eigen::Vector3d(1.0, column - 0.5 * map.columns, row - 0.5 * map.rows);
    };
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            normal += basis(row, column) * basis(row, column).transpose();
            right += basis(row, column) * map.at(row, column);
        }
    }
    const Eigen::Vector3d plane = normal.ldlt().solve(right);
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            map.heights[map.index(row, column)] -= plane.dot(basis(row, column));
        }
    }
}

double mean(const HeightMap& map) {
    return Eigen::Map<const Eigen::VectorXd>(map.heights.data(),
                                             static_cast<Eigen::Index>(map.heights.size()))
        .mean();
}

/// As SPIP writes it; values in nm.
std::string spipText(const std::string& unit = "# z-unit = nm\n", const std::string& more = "") {
    return "# File Format = ASCII\n# Created by SPIP 6.0\n# Original file: scan.spm\n"
           "# x-pixels = 3\n# y-pixels = 2\n# x-length = 300,5\n# y-length = 200\n"
           "# x-offset = 10\n# y-offset = -20\n" +
           unit + more + "# Start of Data:\n1.5\t2\t3\n4\t5\t6\n";
}

std::string wsxmMatrix(const std::string& amplitudes) {
    return "WSxM file copyright UAM\r\nWSxM ASCII Matrix file\r\n" + amplitudes +
           "\r\n1.5\t2\t3\r\n4\t5\t6\r\n";
}

}  // namespace

TEST(TextReader, SpipGivesSizeOriginAndUnit) {
    const ScanChannel channel = textChannel(spipText());
    EXPECT_EQ(channel.unit, "m");
    EXPECT_DOUBLE_EQ(channel.map.at(0, 0), 1.5e-9);
    EXPECT_DOUBLE_EQ(channel.map.at(1, 2), 6e-9);
    EXPECT_DOUBLE_EQ(channel.map.sizeX(), 300.5e-9);
    EXPECT_DOUBLE_EQ(channel.map.sizeY(), 200e-9);
    EXPECT_DOUBLE_EQ(channel.originX, 10e-9);
    EXPECT_DOUBLE_EQ(channel.originY, -20e-9);
    EXPECT_EQ(textChannel(spipText("# z-unit = V\n")).unit, "V");
    EXPECT_EQ(textChannel(spipText("")).unit, "");
    EXPECT_DOUBLE_EQ(textChannel(spipText("# Bit2nm = 2\n")).map.at(0, 0), 3e-9);
}

TEST(TextReader, SpipMayListWhichPixelsHoldData) {
    const ScanChannel channel =
        textChannel(spipText("# z-unit = nm\n", "# voidpixels = 1\n") + "1\t0\t1\n1\t1\t1\n");
    EXPECT_EQ(channel.map.rows, 2);
    EXPECT_TRUE(std::isnan(channel.map.at(0, 1)));
    EXPECT_DOUBLE_EQ(channel.map.at(1, 1), 5e-9);
}

TEST(TextReader, SpipThatEndsBeforeItsLinesOfValidPixelsSaysSo) {
    const ScanChannel channel = textChannel(spipText("# z-unit = nm\n", "# voidpixels = 1\n"));
    EXPECT_EQ(channel.map.rows, 2);
    EXPECT_THAT(channel.notes, testing::Contains(HasSubstr("truncated")));
}

TEST(TextReader, SpipMustHoldWhatItPromises) {
    std::string text = spipText();
    text.replace(text.find("x-pixels = 3"), 12, "x-pixels = 4");
    EXPECT_THAT(refusalOfText(text), HasSubstr("promises 4 x 2"));
    text.replace(text.find("x-pixels = 4"), 12, "x-pixels = q");
    EXPECT_THAT(refusalOfText(text), HasSubstr("x-pixels"));
    text = spipText();
    text.replace(text.find("300,5"), 5, "wide!");
    EXPECT_THAT(refusalOfText(text), HasSubstr("x-length"));
}

TEST(TextReader, WsxmMatrixIsInTheUnitOfItsAmplitude) {
    const ScanChannel channel = textChannel(
        wsxmMatrix("X Amplitude: 600 nm\r\nY Amplitude: 0,4 \xB5m\r\nZ Amplitude: 35 nm\r\n"));
    EXPECT_EQ(channel.unit, "m");
    EXPECT_DOUBLE_EQ(channel.map.at(0, 0), 1.5e-9);
    EXPECT_DOUBLE_EQ(channel.map.at(1, 2), 6e-9);
    EXPECT_DOUBLE_EQ(channel.map.sizeX(), 600e-9);
    EXPECT_DOUBLE_EQ(channel.map.sizeY(), 0.4e-6);
    EXPECT_EQ(textChannel(wsxmMatrix("Z Amplitude: 3 pA\r\n")).unit, "A");
    EXPECT_FALSE(textChannel(wsxmMatrix("Z Amplitude: 3 nm\r\n")).hasSize());
    EXPECT_EQ(textChannel(wsxmMatrix("Z Amplitude: 3 a.u.\r\n")).unit, "");
    const ScanChannel angstrom = textChannel(
        wsxmMatrix("X Amplitude: 600 A\r\nY Amplitude: 400 A\r\nZ Amplitude: 35 A\r\n"));
    EXPECT_EQ(angstrom.unit, "m");
    EXPECT_DOUBLE_EQ(angstrom.map.at(0, 0), 1.5e-10);
    EXPECT_DOUBLE_EQ(angstrom.map.sizeX(), 600e-10);
}

TEST(TextReader, Matrix3IsTheLeveledHeightSensorOfDi3) {
    ASPERITY_NEEDS_SHARED_DATA();
    HeightMap scan =
        readHeightMapFile(sharedData("afm/nanoscope/di-3_v9.01.di")).channels.at(0).map;
    const HeightMap text =
        readHeightMapFile(sharedData("afm/text/matrix-3_gwyddion_export.txt")).channels.at(0).map;
    levelByPlane(scan);
    const double offset = mean(text);
    double worst = 0.0;
    for (std::size_t i = 0; i < text.heights.size(); ++i) {
        worst = std::max(worst, std::abs(text.heights[i] - offset - scan.heights[i]));
    }
    std::cout << "largest difference " << worst << " m\n";
    EXPECT_LE(worst, 5e-12);
}

TEST(TextReader, HeaderMayBeInAnyLanguage) {
    for (const char* header :
         {"# Channel: Z\n# Width: 3 µm\n# Height: 2000 nm\n# Value units: nm\n",
          "# Kanal: Z\n# Breite: 3 \xB5m\n# H\xF6he: 2000 nm\n# Einheit: nm\n",
          "# A: Z\r\n# B: 3 um\r\n# C: 2000 nm\r\n# D: nm\r\n"}) {
        const ScanChannel channel = textChannel(std::string(header) + "1 2 3\n4 5 6\n");
        EXPECT_EQ(channel.name, "Z");
        EXPECT_EQ(channel.unit, "m");
        EXPECT_DOUBLE_EQ(channel.map.sizeX(), 3e-6);
        EXPECT_DOUBLE_EQ(channel.map.sizeY(), 2e-6);
        EXPECT_DOUBLE_EQ(channel.map.at(1, 0), 4e-9);
        EXPECT_FALSE(channel.provenance.empty());
    }
}

TEST(TextReader, HeaderMayHaveDecimalCommasButNoThousands) {
    const auto mapOf = [](const std::string& width) {
        return readHeightMapBytes(
                   "# Kanal: Topo\n# Breite: " + width +
                       "\n# Höhe: 5,00 µm\n# Value units: m\n1,5\t2\t3\t4\n5,5\t6\t7\t8\n",
                   "map.txt")
            .channels.at(0);
    };
    EXPECT_EQ(mapOf("10,00 µm").name, "Topo");
    EXPECT_DOUBLE_EQ(mapOf("10,00 µm").map.sizeX(), 10e-6);
    EXPECT_DOUBLE_EQ(mapOf("10,00 µm").map.sizeY(), 5e-6);
    EXPECT_EQ(mapOf("10,00 µm").unit, "m");
    EXPECT_FALSE(mapOf("10,000 µm").hasSize()) << "10 or 10000";
}

TEST(TextReader, SaysHowTheNumbersAreToldApart) {
    using testing::Contains;
    using testing::Field;
    const ScanChannel tabs = textChannel("1,5\t2\t3\t4\n4\t5\t6,25\t7\n");
    EXPECT_THAT(tabs.provenance, Contains(Field(&Provenance::what, "decimal sign")));
    const ScanChannel commas = textChannel("1.5,2,3,4\n4,5,6.25,7\n");
    EXPECT_THAT(commas.provenance, Contains(Field(&Provenance::what, "separator")));
    EXPECT_THAT(commas.provenance, Not(Contains(Field(&Provenance::what, "decimal sign"))));
}

/// As pandas.DataFrame.to_csv() writes a matrix.
TEST(TextReader, NumbersOfRowsAndColumnsAreNoHeights) {
    const ScanChannel channel = textChannel(",0,1,2\n0,1.5,2.5,3.5\n1,4.5,5.5,6.5\n");
    ASSERT_EQ(channel.map.columns, 3);
    ASSERT_EQ(channel.map.rows, 2);
    EXPECT_EQ(channel.map.heights, (std::vector<double>{1.5, 2.5, 3.5, 4.5, 5.5, 6.5}));
    EXPECT_THAT(channel.notes, testing::Contains(HasSubstr("number the others")));
}

TEST(TextReader, WhatMayBeANumberingOrAxesIsNamed) {
    using testing::Contains;
    const auto notesOf = [](std::string_view text) { return textChannel(text).notes; };
    EXPECT_THAT(notesOf(",10,20,30\n0,1.5,2.5,3.5\n5,4.5,5.5,6.5\n"),
                Contains(HasSubstr("if they are axes")));
    EXPECT_THAT(notesOf("0,1,2,3\n5.5,1.5,2.5,3.5\n4,4.5,5.5,6.5\n"),
                Contains(HasSubstr("first line counts")));
    EXPECT_THAT(notesOf("0,1,5,3\n1,1.5,2.5,3.5\n2,4.5,5.5,6.5\n"),
                Contains(HasSubstr("first column counts")));
    for (const char* plain : {"5,1,2,3\n5.5,1.5,2.5,3.5\n4,4.5,5.5,6.5\n",
                              "nan,nan,nan,nan\nnan,1.5,2.5,3.5\nnan,4.5,5.5,6.5\n"}) {
        EXPECT_EQ(textChannel(plain).map.columns, 4);
        EXPECT_THAT(notesOf(plain), Not(Contains(HasSubstr("first"))));
    }
}

TEST(TextReader, TwoLengthsAreASizeOnlyBeforeAUnit) {
    const auto sizeIsKnown = [](std::string_view header) {
        return textChannel(std::string(header) + "1 2 3 4\n4 5 6 7\n").hasSize();
    };
    EXPECT_FALSE(sizeIsKnown("# Setpoint: 1 nm\n# Amplitude: 5 nm\n"));
    EXPECT_FALSE(sizeIsKnown("# Setpoint: 1 nm\n# Amplitude: 5 nm\n# Rate: 2 Hz\n"));
    EXPECT_TRUE(sizeIsKnown("# Canal: Z\n# Largo: 3 um\n# Alto: 2 um\n# Unidad: nm\n"));
}

TEST(TextReader, OtherLengthsInCommentsAreNotTheSize) {
    const ScanChannel channel = textChannel("# Tip radius: 10 nm\n# Channel: Z\n# Width: 3 um\n"
                                            "# Height: 2 um\n# Value units: m\n1 2 3\n4 5 6\n");
    EXPECT_EQ(channel.name, "Z");
    EXPECT_DOUBLE_EQ(channel.map.sizeX(), 3e-6);
    EXPECT_EQ(channel.metadata.at("Tip radius"), "10 nm");
    const ScanChannel unclear =
        textChannel("# Tip: 10 nm\n# Largo: 3 um\n# Alto: 2 um\n1 2 3 4\n4 5 6 7\n");
    EXPECT_FALSE(unclear.hasSize());
}

TEST(TextReader, WhatTheTextWriterWritesComesBack) {
    const ScratchFolder folder;
    for (const bool holes : {false, true}) {
        const HeightMap map = holes ? bumpyMapWithHoles(7, 5) : bumpyMap(7, 5);
        writeHeightMap(folder.file("map.txt"), map, {.title = "高さ 10 nm"});
        const ScanChannel read = readHeightMapFile(folder.file("map.txt")).channels.at(0);
        EXPECT_EQ(read.name, "高さ 10 nm");
        EXPECT_EQ(read.unit, "m");
        EXPECT_DOUBLE_EQ(read.map.pitchX, map.pitchX);
        EXPECT_DOUBLE_EQ(read.map.pitchY, map.pitchY);
        EXPECT_EQ(read.map.invalid, map.invalid);
        for (std::size_t i = 0; i < map.heights.size(); ++i) {
            EXPECT_TRUE(read.map.heights[i] == map.heights[i] || std::isnan(map.heights[i])) << i;
        }
    }
}

TEST(TextReader, NarrowMapsOfKnownSizeAreMaps) {
    const std::string header = "# Width: 1 um\n# Height: 1 um\n# Value units: m\n";
    EXPECT_EQ(textChannel(header + "1e-9\n2e-9\n3e-9").map.rows, 3);
    EXPECT_EQ(textChannel(header + "1e-9 2e-9").map.columns, 2);
    EXPECT_EQ(textChannel(header + "1e-9").map.columns, 1);
}

TEST(TextReader, HeightsAreTheNumbersTimesTheFactor) {
    const ScanChannel channel = textChannel("h=2 w=4\npixel size=2e-007 m\ndata unit=rad\n"
                                            "height conversion factor (-> m)=3e-008\n"
                                            "1 2 3 4\n5 6 7 8\n");
    EXPECT_EQ(channel.unit, "m");
    EXPECT_DOUBLE_EQ(channel.map.at(1, 3), 8 * 3e-8);
    EXPECT_DOUBLE_EQ(channel.map.sizeX(), 8e-7);
    EXPECT_DOUBLE_EQ(channel.map.sizeY(), 4e-7);
    EXPECT_EQ(textChannel("h=1 w=4\ndata unit=rad\n1 2 3 4\n").unit, "rad");
}

TEST(TextReader, PromisedNumbersMustBeThere) {
    EXPECT_THAT(refusalOfText("h=3 w=4\n1 2 3 4\n5 6 7 8\n"),
                AllOf(HasSubstr("4 x 3"), HasSubstr("4 x 2"), HasSubstr("truncated")));
    EXPECT_THAT(refusalOfText("h=none w=4\n1 2 3 4\n"), HasSubstr("line 1: 'h'"));
    EXPECT_THAT(refusalOfText("ncols 3\nnrows 2\n1 2 3 4\n5 6 7 8\n"), HasSubstr("3 x 2"));
}

TEST(TextReader, EsriGridsNameTheirMissingNumber) {
    const char* grid = "ncols 4\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 50\n"
                       "NODATA_value -1\n1 2 -1 4\n5 6 7 8\n";
    const ScanChannel channel = textChannel(grid);
    EXPECT_TRUE(channel.map.invalid.at(2));
    EXPECT_FALSE(channel.hasSize());
    EXPECT_EQ(channel.metadata.at("cellsize"), "50");
    EXPECT_THAT(channel.notes, testing::Contains(HasSubstr("too large for meters")));
}

TEST(TextReader, EsriGridsGiveSizeAndCornerInMeters) {
    const auto grid = [](const std::string& corner) {
        return textChannel("ncols 4\nnrows 2\n" + corner + "NODATA_value -1\n1 2 -1 4\n5 6 7 8\n");
    };
    const ScanChannel corner = grid("xllcorner 3e-6\nyllcorner -1e-6\ncellsize 5e-9\n");
    EXPECT_TRUE(corner.hasSize());
    EXPECT_DOUBLE_EQ(corner.map.sizeX(), 20e-9);
    EXPECT_DOUBLE_EQ(corner.map.sizeY(), 10e-9);
    EXPECT_DOUBLE_EQ(corner.originX, 3e-6);
    EXPECT_DOUBLE_EQ(corner.originY, -1e-6);
    EXPECT_TRUE(corner.map.invalid.at(2));
    EXPECT_THAT(corner.notes, testing::Contains(HasSubstr("meters are assumed")));
    const ScanChannel center = grid("xllcenter 3e-6\nyllcenter -1e-6\ndx 4e-9\ndy 2e-9\n");
    EXPECT_DOUBLE_EQ(center.map.pitchY, 2e-9);
    EXPECT_DOUBLE_EQ(center.originX, 3e-6 - 2e-9);
    EXPECT_DOUBLE_EQ(center.originY, -1e-6 - 1e-9);
    EXPECT_THAT(center.notes, testing::Contains(HasSubstr("dx, dy and corner have no unit")));
}

TEST(TextReader, EsriGridsNameTheSideOfACellThatIsMissing) {
    const auto notesOf = [](const std::string& side) {
        const ScanChannel channel = textChannel("ncols 4\nnrows 2\n" + side + "1 2 3 4\n5 6 7 8\n");
        EXPECT_FALSE(channel.hasSize());
        return channel.notes;
    };
    EXPECT_THAT(notesOf("dx 4e-9\n"), testing::Contains(HasSubstr("dx without dy")));
    EXPECT_THAT(notesOf("dy 4e-9\n"), testing::Contains(HasSubstr("dy without dx")));
}

TEST(TextReader, MinusNineThousandMeansNoDataWhereNothingIsLower) {
    const ScanChannel channel = textChannel("1 2 -9999 4\n5 6 7 8\n");
    EXPECT_TRUE(channel.map.invalid.at(2));
    EXPECT_THAT(channel.notes, testing::Contains(HasSubstr("-9999")));
    EXPECT_TRUE(textChannel("1 2 -9999 4\n5 -10000 7 8\n").map.invalid.empty());
}

TEST(TextReader, BareMatricesHaveNoSizeAndNoUnit) {
    const ScanChannel channel = textChannel("1 2 3 4\n5 6 NaN 8\n");
    EXPECT_EQ(channel.name, "matrix");
    EXPECT_EQ(channel.unit, "");
    EXPECT_FALSE(channel.hasSize());
    EXPECT_TRUE(channel.map.invalid.at(6));
}

TEST(TextReader, GermanSpreadsheetsHaveDecimalCommas) {
    const ScanChannel channel = textChannel("1,5;2;3;4\r\n-5,25;6;;8\r\n");
    EXPECT_EQ(channel.map.at(0, 0), 1.5);
    EXPECT_EQ(channel.map.at(1, 0), -5.25);
    EXPECT_TRUE(channel.map.invalid.at(6));
    EXPECT_EQ(textChannel("1,5;2;3;4;\n5;6;7;8;\n").map.columns, 4);
}

TEST(TextReader, Utf16WithAByteOrderMarkIsText) {
    std::string bytes = "\xFF\xFE";
    for (const char c : std::string("1 2 3 4\r\n5 6 7 8\r\n")) {
        bytes += {c, '\0'};
    }
    EXPECT_EQ(textChannel(bytes).map.at(1, 3), 8.0);
}

TEST(TextReader, SeveralImagesInOneFileAreRefusedAtTheSecond) {
    EXPECT_THAT(refusalOfText("# Channel: a\n1 2 3 4\n3 4 5 6\n\n# Channel: b\n5 6 7 8\n"),
                HasSubstr("line 6: numbers go on after a comment"));
    EXPECT_EQ(readHeightMapBytes("1 2 3 4\n3 4 5 6\n# end\n", "map.txt").channels.size(), 1U);
}

TEST(TextReader, RaggedLinesAreRefusedByNumber) {
    EXPECT_THAT(refusalOfText("# Channel: Z\n1 2 3 4\n\n5 6 7\n"),
                AllOf(HasSubstr("map.txt: line 4: "), HasSubstr("3 numbers"), HasSubstr("have 4")));
    EXPECT_THAT(refusalOfText("1 2 3 4\n5 6 seven 8\n"),
                AllOf(HasSubstr("line 2: "), HasSubstr("'seven'")));
}

TEST(TextReader, ProfilesAreNamed) {
    EXPECT_THAT(refusalOfText("1\n2\n3\n"), HasSubstr("one column of numbers is a profile"));
    EXPECT_THAT(refusalOfText("1 2\n2 3\n3 4\n"),
                AllOf(HasSubstr("two columns"), HasSubstr("force curve")));
    EXPECT_THAT(refusalOfText("1 2 3 4\n"), HasSubstr("one line of numbers is a profile"));
}

TEST(TextReader, OtherTextsAndBinaryFilesAreNotRecognized) {
    using namespace std::string_literals;
    for (const std::string& text :
         {"This is nonsense."s, "[scene]\nsize = 3\n"s, "name,value\n1,2\n"s, "# only a comment\n"s,
          "<html>1 2 3 4</html>"s, "{\"a\": 1}"s, "1 2 3 4\0\0\0\n"s, "\0\1\2\3"s,
          "\x89PNG\r\n\x1A\n"s, "II*\0"s, "-----\ntitle\n"s, "\xFF\xFE\0\0"s}) {
        EXPECT_FALSE(kTextFormat.recognizes(MemoryBytes(text, "text"))) << text;
        EXPECT_FALSE(kXyzFormat.recognizes(MemoryBytes(text, "text"))) << text;
    }
}

TEST(TextReader, MalformedSamplesAreRefused) {
    ASPERITY_NEEDS_SHARED_DATA();
    const auto refusalOfFile = [](const char* name) {
        return refusalOf([&] { (void)readHeightMapFile(sharedData(name)); });
    };
    EXPECT_THAT(refusalOfFile("afm/text/malformed_nonsense.txt"), HasSubstr("no height map"));
    EXPECT_THAT(refusalOfFile("afm/text/malformed_single_column.txt"), HasSubstr("profile"));
}

TEST(TextReader, WidthOfADifferentUnitThanTheHeightIsNoSize) {
    const ScanChannel channel = textChannel("# Width: 3 um\n# Height: 2 s\n1 2 3\n4 5 6\n");
    EXPECT_FALSE(channel.hasSize());
    EXPECT_THAT(channel.notes, testing::Contains(HasSubstr("different units")));
}

}  // namespace asperity::test
