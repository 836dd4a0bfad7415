#include "core/FormattedText.h"
#include "core/io/ByteReader.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "tests/core/io/heightmap/BoundedRead.h"
#include "tests/core/io/heightmap/InstrumentFiles.h"
#include "tests/core/io/heightmap/SyntheticScans.h"
#include "tests/core/io/heightmap/TiffFiles.h"
#include "tests/core/io/heightmap/ZipFiles.h"
#include "tests/support/Refusal.h"
#include "tests/support/Sanitized.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>
#include <zlib.h>

// Small files with more texts, images or attributes than any instrument writes: the memory follows
// the size of the file, the heights are read, and a note says what is left out.

namespace asperity::test {

namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr const char* kNote = "more metadata than an instrument writes";

/// Returns `count` pieces, each made of its number.
std::string repeated(int count, const std::function<std::string(int)>& piece) {
    std::string text;
    for (int i = 0; i < count; ++i) {
        text += piece(i);
    }
    return text;
}

/// Returns `count` lines with this between a number of five digits and the line's end.
std::string numberedLines(int count, const std::string& prefix, const std::string& suffix) {
    return repeated(count, [&](int i) { return prefix + formatted("%05d", i) + suffix; });
}

std::string replacedOnce(std::string text, const std::string& part, const std::string& by) {
    const std::size_t found = text.find(part);
    EXPECT_NE(found, std::string::npos) << part;
    return found == std::string::npos ? text : text.replace(found, part.size(), by);
}

std::string nanoscopeWithTexts() {
    constexpr int kOffset = 1 << 20;
    const std::string lists = repeated(128, [](int i) {
        return "\\*Ciao image list\r\n\\Data offset: " + std::to_string(kOffset + 12 * i) +
               "\r\n\\Data length: 12\r\n\\Bytes/pixel: 2\r\n\\Samps/line: 3\r\n\\Number of lines: "
               "2\r\n\\Scan size: 30 20 nm\r\n\\@2:Image Data: S [Height] \"Height\"\r\n"
               "\\@2:Z scale: V (0.1 V/LSB) 1 V\r\n";
    });
    std::string bytes = "\\*File list\r\n\\Version: 0x05120000\r\n" +
                        numberedLines(60000, "\\", ": 1\r\n") + lists + "\\*File list end\r\n\x1A";
    bytes.resize(kOffset, '\0');
    return bytes + std::string(std::size_t{12} * 128, '\0');
}

std::string nanonisWithTexts() {
    NanonisText text;
    text.table =
        "\tChannel\tName\tUnit\tDirection\tCalibration\tOffset\n" +
        repeated(64, [](int i) { return "\t" + std::to_string(i) + "\tZ\tm\tboth\t1\t0\n"; });
    text.comment += numberedLines(30000, "\n:", ":");
    return nanonisFile(text, std::vector<double>(std::size_t{6} * 128, 1.0));
}

/// The same Nanosurf file with its channel 128 times, all described by one section.
std::string with128Channels(const std::string& bytes) {
    const std::size_t name = bytes.find("Gr0-Ch1=") + 8;
    const std::string section = bytes.substr(name, bytes.find('\r', name) - name);
    const std::string more = repeated(
        127, [&](int i) { return "Gr0-Ch" + std::to_string(i + 2) + "=" + section + "\r\n"; });
    return replacedOnce(bytes, "[DataSet]\r\n", "[DataSet]\r\n" + more) +
           std::string(std::size_t{12} * 127, '\0');
}

std::string nanosurfWithTexts() {
    return with128Channels(replacedOnce(nanosurfFile({{}}), "SaveBits=16\r\n",
                                        "SaveBits=16\r\n" + numberedLines(30000, "", "=\r\n")));
}

std::string picoviewWithTexts() {
    PicoviewText text;
    text.size += numberedLines(30000, "x", "\n");
    text.image = repeated(128, [](int) { return "bufferLabel   Topography\n"; });
    return picoviewFile(text, SampleType::Int32, std::vector<double>(std::size_t{6} * 128, 1.0));
}

std::string igorWithTexts() {
    IgorWaveText wave;
    wave.counts = {3, 2, 128, 0};
    wave.numbers.assign(std::size_t{6} * 128, 1e-9);
    wave.note = numberedLines(30000, "", ":\r");
    return igorFile(wave);
}

std::string x3pWithTexts() {
    const std::string texts = repeated(30000, [](int i) {
        const std::string name = "c" + std::to_string(i);
        return "<" + name + ">1</" + name + ">";
    });
    const std::string axis = "<AxisType>I</AxisType><Increment>1e-9</Increment><Offset>0</Offset>";
    const std::string main =
        "<p:ISO5436_2 xmlns:p=\"x\"><Record1><Revision>ISO5436 - 2000</Revision><FeatureType>SUR"
        "</FeatureType><Axes><CX>" +
        axis + "</CX><CY>" + axis +
        "</CY><CZ><AxisType>A</AxisType><DataType>I</DataType><Increment>1e-9</Increment></CZ>"
        "</Axes></Record1><Record2>" +
        texts +
        "</Record2><Record3><MatrixDimension><SizeX>2</SizeX><SizeY>2</SizeY><SizeZ>128</SizeZ>"
        "</MatrixDimension><DataLink><PointDataLink>data.bin</PointDataLink></DataLink></Record3>"
        "</p:ISO5436_2>";
    return zipFile({{"main.xml", main}, {"data.bin", std::string(std::size_t{8} * 128, '\1')}});
}

std::string sdfWithTexts() {
    return "aISO-1.0\nNumPoints = 2\nNumProfiles = 2\nXscale = 1e-9\nYscale = 1e-9\nZscale = "
           "1e-9\n" +
           numberedLines(1'000'000, "", "=\n") + "*\n1 2\n3 4\n*\n";
}

/// @param images that have as many texts each
std::string gwyWithTexts(int images, int texts) {
    const std::string meta = gwyObjectBytes(
        "GwyContainer", repeated(texts, [](int i) { return gwyText(std::to_string(i), "1"); }));
    return gwyFile(repeated(images, [&](int i) {
        const std::string key = "/" + std::to_string(i);
        return gwyComponent(key + "/data", smallGwyField()) + gwyComponent(key + "/meta", meta);
    }));
}

std::string tiffWithTexts() {
    TiffTestImage image;
    image.extra = {
        tiffText(270, "Gwy::XReal=1e-9\nGwy::YReal=1e-9\n" + numberedLines(8000, "", "=\n"))};
    return tiffFile(std::vector<TiffTestImage>(200, image));
}

std::string vtiWithTexts() {
    const std::string texts = repeated(30000, [](int i) {
        return "<Array type=\"String\" Name=\"" + std::to_string(i) +
               "\" NumberOfTuples=\"1\" format=\"ascii\">49 0</Array>";
    });
    const std::string arrays = repeated(100, [](int i) {
        return "<DataArray Name=\"z" + std::to_string(i) +
               "\" type=\"Float64\" format=\"ascii\">1 2 3 4</DataArray>";
    });
    return R"(<VTKFile type="ImageData" byte_order="LittleEndian"><ImageData )"
           R"(WholeExtent="0 1 0 1 0 0" Spacing="1 1 1"><FieldData>)" +
           texts + R"(</FieldData><Piece Extent="0 1 0 1 0 0"><PointData>)" + arrays +
           "</PointData></Piece></ImageData></VTKFile>";
}

std::string bigEndian(std::uint32_t number) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) {
        bytes += static_cast<char>(number >> static_cast<unsigned>(shift) & 0xFFU);
    }
    return bytes;
}

std::string pngChunk(const std::string& type, const std::string& data) {
    const std::string checked = type + data;
    const auto sum = crc32(0, reinterpret_cast<const unsigned char*>(checked.data()),
                           static_cast<unsigned>(checked.size()));
    return bigEndian(static_cast<std::uint32_t>(data.size())) + checked +
           bigEndian(static_cast<std::uint32_t>(sum));
}

/// An image of one pixel.
std::string pngWithTexts() {
    const std::string header =
        bigEndian(1) + bigEndian(1) + std::string("\x10\0\0\0\0", 5);  // 16-bit gray
    const std::string pixel("\x78\x01\x01\x03\0\xFC\xFF\0\0\x01\0\x04\0\x02", 14);
    return "\x89PNG\r\n\x1A\n" + pngChunk("IHDR", header) +
           repeated(500'000, [](int i) { return pngChunk("tEXt", std::to_string(i) + '\0'); }) +
           pngChunk("IDAT", pixel) + pngChunk("IEND", "");
}

std::string exrAttribute(const std::string& name, const std::string& type,
                         const std::string& value) {
    std::string bytes = name + '\0' + type + '\0';
    appendLittleEndian(bytes, static_cast<std::uint32_t>(value.size()));
    return bytes + value;
}

/// An image of one pixel, not compressed.
std::string exrFile(int channels, int texts) {
    const std::string list = repeated(channels, [](int i) {
        std::string channel = formatted("c%04d", i) + '\0';
        for (const std::uint32_t number : {2U, 0U, 1U, 1U}) {
            appendLittleEndian(channel, number);
        }
        return channel;
    });
    const std::string one("\0\0\x80\x3F", 4);
    std::string bytes("v/1\x01\2\0\0\0", 8);
    bytes += exrAttribute("channels", "chlist", list + '\0') +
             exrAttribute("compression", "compression", std::string(1, '\0')) +
             exrAttribute("dataWindow", "box2i", std::string(16, '\0')) +
             exrAttribute("displayWindow", "box2i", std::string(16, '\0')) +
             exrAttribute("lineOrder", "lineOrder", std::string(1, '\0')) +
             exrAttribute("pixelAspectRatio", "float", one) +
             exrAttribute("screenWindowCenter", "v2f", std::string(8, '\0')) +
             exrAttribute("screenWindowWidth", "float", one) +
             repeated(texts,
                      [](int i) { return exrAttribute("a" + std::to_string(i), "string", "1"); }) +
             '\0';
    appendLittleEndian(bytes, std::uint64_t{bytes.size() + 8});
    appendLittleEndian(bytes, std::uint32_t{0});
    appendLittleEndian(bytes, static_cast<std::uint32_t>(4 * channels));
    return bytes + repeated(channels, [&](int) { return one; });
}

std::string refusalOf(const std::string& bytes) {
    return test::refusalOf([&] { (void)readHeightMapBytes(bytes, "scan"); });
}

}  // namespace

TEST(TextBounds, HoldForFilesOfEachKind) {
    struct Kind {
        const char* name;
        std::string bytes;
    };
    constexpr std::uint64_t kMax = 100'000'000;
    for (const Kind& kind : std::vector<Kind>{{"NanoScope", nanoscopeWithTexts()},
                                              {"Nanonis", nanonisWithTexts()},
                                              {"Nanosurf", nanosurfWithTexts()},
                                              {"PicoView", picoviewWithTexts()},
                                              {"Igor", igorWithTexts()},
                                              {"X3P", x3pWithTexts()},
                                              {"SDF", sdfWithTexts()},
                                              {"one image of .gwy", gwyWithTexts(1, 1'000'000)},
                                              {"images of .gwy", gwyWithTexts(128, 20000)},
                                              {"TIFF", tiffWithTexts()},
                                              {".vti", vtiWithTexts()},
                                              {"PNG", pngWithTexts()},
                                              {"EXR", exrFile(128, 20000)}}) {
        EXPECT_THAT(readHeightMapBytes(kind.bytes, "scan").notes, Contains(HasSubstr(kNote)))
            << kind.name;
        if (!kSanitized) {
            const BoundedRead read = readBounded(kind.bytes, kMax);
            EXPECT_TRUE(read.isRead) << kind.name << ": " << read.failure;
            EXPECT_LT(read.memory, kMax) << kind.name;
        }
    }
}

/// The rest of a file beyond its first texts is found all the same.
TEST(TextBounds, LeaveValuesBehindManyTextsReadable) {
    const std::string bytes = replacedOnce(nanonisWithTexts(), ":SCAN_RANGE:", ":SCAN_RANGES:");
    const HeightMapFile file = readHeightMapBytes(
        replacedOnce(bytes, ":SCANIT_END:", ":SCAN_RANGE:\n3e-8 2e-8\n:SCANIT_END:"), "scan");
    EXPECT_TRUE(file.channels.at(0).hasSize());
}

TEST(TextBounds, KeepTheTextsOfAnInstrument) {
    const HeightMapFile file = readHeightMapBytes(gwyWithTexts(512, 1000), "scan");
    EXPECT_THAT(file.notes, testing::Not(Contains(HasSubstr(kNote))));
    for (const ScanChannel& channel : file.channels) {
        EXPECT_EQ(channel.metadata.size(), 1000U);
    }
}

TEST(TextBounds, HoldForTheNumberOfGwyddionsImages) {
    const HeightMapFile file = readHeightMapBytes(gwyWithTexts(1500, 0), "scan");
    EXPECT_EQ(file.channels.size(), 1024U);
    EXPECT_THAT(file.notes, Contains(HasSubstr("more than 1024 images")));
}

TEST(TextBounds, CutALongTitle) {
    const std::string title = "x" + repeated(500'000, [](int) { return "µ"; });
    const HeightMapFile file = readHeightMapBytes(
        gwyFile(gwyComponent("/0/data", smallGwyField()) + gwyText("/0/data/title", title)),
        "scan");
    EXPECT_EQ(file.channels.at(0).name, title.substr(0, 4095));
}

TEST(TextBounds, CutANameOfManyChannels) {
    const std::string bytes = with128Channels(nanosurfFile({{.name = std::string(200'000, 'x')}}));
    for (const ScanChannel& channel : readHeightMapBytes(bytes, "scan").channels) {
        EXPECT_EQ(channel.name, std::string(4096, 'x'));
    }
}

/// The OpenEXR library needs 400 bytes for each, before anything can be left out.
TEST(TextBounds, RefuseMoreAttributesAndChannelsThanTheLibraryTakes) {
    EXPECT_THAT(refusalOf(exrFile(1, 70000)), HasSubstr("at most 65536 attributes"));
    EXPECT_THAT(refusalOf(exrFile(129, 0)), HasSubstr("at most 128 images"));
}

}  // namespace asperity::test
