#include "core/io/heightmap/HeightMapFile.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "tests/core/io/heightmap/BumpyMap.h"
#include "tests/core/io/heightmap/InstrumentFiles.h"
#include "tests/core/io/heightmap/MapStatistics.h"
#include "tests/core/io/heightmap/RealScans.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <sstream>

// Every pixel of every real file against the program gwyddion, where it is installed.

namespace asperity::test {

namespace {

bool haveGwyddion() { return !installedGwyddion().program.empty(); }

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

/// A file as Gwyddion reads it. Its settings are in the scratch folder.
HeightMapFile throughGwyddion(const ScratchFolder& folder, const std::filesystem::path& path) {
    const std::filesystem::path converted = folder.file("converted.gwy");
    const std::string command = "HOME=" + quoted(folder.path()) +
                                " timeout 60 gwyddion --convert-to-gwy=" + quoted(converted) + " " +
                                quoted(path) + " >" + quoted(folder.file("log")) + " 2>&1";
    // NOLINTNEXTLINE(concurrency-mt-unsafe,cert-env33-c): a test program with one thread
    EXPECT_EQ(std::system(command.c_str()), 0) << contentOf(folder.file("log"));
    return readHeightMapFile(converted);
}

/// Largest difference of two maps, in parts of the range; invalid pixels must agree.
double worstDeviation(const HeightMap& ours, const HeightMap& theirs) {
    EXPECT_EQ(ours.columns, theirs.columns);
    EXPECT_EQ(ours.rows, theirs.rows);
    EXPECT_EQ(ours.invalid, theirs.invalid);
    const HeightStatistics statistics = statisticsOf(theirs);
    const double range = statistics.highest - statistics.lowest;
    double worst = 0.0;
    for (std::size_t i = 0; i < std::min(ours.heights.size(), theirs.heights.size()); ++i) {
        const double difference = std::abs(ours.heights[i] - theirs.heights[i]);
        if (!std::isnan(difference)) {
            worst = std::max(worst, difference / range);
        }
    }
    return worst;
}

/// Files that Gwyddion 2.62 does not read as they are; docs/formats.md 5 and 9.
bool losesEverything(const std::string& file) {
    return file.ends_with(".exr") || file == "derived/cl0_height_u16_noscale.png";
}
bool losesScale(const std::string& file) { return file.ends_with(".tif"); }
bool showsPixelsWithoutData(const std::string& file) { return file.ends_with(".jpk-qi-image"); }

void leaveOut(HeightMap& map, const std::vector<bool>& invalid) {
    map.invalid = invalid;
    for (std::size_t i = 0; i < invalid.size(); ++i) {
        if (invalid[i]) {
            map.heights[i] = std::numeric_limits<double>::quiet_NaN();
        }
    }
}

/// The same shape between 0 and 1.
HeightMap normalized(HeightMap map) {
    const HeightStatistics statistics = statisticsOf(map);
    for (double& height : map.heights) {
        height = (height - statistics.lowest) / (statistics.highest - statistics.lowest);
    }
    return map;
}

/// But for those with a known error of Gwyddion 2.62 (docs/formats.md).
std::vector<std::string> scansOfGwyddion() {
    std::vector<std::string> scans = realScans();
    // It does not recognize a matrix or points as text: it asks for their layout.
    std::erase_if(scans, [](const std::string& scan) { return scan.starts_with("text/"); });
    std::erase(scans, "x3p/x3ptools_csafe-logo_subdir.x3p");  // main.xml in a sub-folder: unknown
    std::erase(scans, "jpk/qi_2020_extracted.jpk-qi-data");   // expects its curves in order
    return scans;
}

class Gwyddion : public testing::TestWithParam<std::string> {};

TEST_P(Gwyddion, ReadsTheSamePixels) {
    ASPERITY_NEEDS_SHARED_DATA();
    if (!haveGwyddion()) {
        GTEST_SKIP() << "the program gwyddion is not installed";
    }
    if (losesEverything(GetParam())) {
        GTEST_SKIP() << "Gwyddion 2.62 does not read this file";
    }
    const ScratchFolder folder;
    const HeightMapFile ours = readHeightMapFile(sharedData("afm/" + GetParam()));
    HeightMapFile theirs = throughGwyddion(folder, sharedData("afm/" + GetParam()));
    ASSERT_EQ(ours.channels.size(), theirs.channels.size());
    for (std::size_t i = 0; i < ours.channels.size(); ++i) {
        const ScanChannel& mine = ours.channels[i];
        SCOPED_TRACE(mine.name);
        if (losesScale(GetParam())) {
            EXPECT_LE(worstDeviation(normalized(mine.map), normalized(theirs.channels[i].map)),
                      1e-12);
            continue;
        }
        if (showsPixelsWithoutData(GetParam())) {
            leaveOut(theirs.channels[i].map, mine.map.invalid);
        }
        EXPECT_EQ(mine.name, channelName(GetParam(), theirs.channels[i].name));
        // Gwyddion calls the millivolts of this one channel volts; the numbers are the same.
        const bool misnamed = GetParam() == "nanoscope/di-3_v9.01.di" && mine.unit == "mV";
        EXPECT_EQ(misnamed ? "V" : mine.unit, theirs.channels[i].unit);
        EXPECT_NEAR(mine.map.pitchX / theirs.channels[i].map.pitchX, 1.0, 1e-12);
        EXPECT_NEAR(mine.map.pitchY / theirs.channels[i].map.pitchY, 1.0, 1e-12);
        const double worst = worstDeviation(mine.map, theirs.channels[i].map);
        EXPECT_LE(worst, 1e-12);
        std::cout << GetParam() << " '" << mine.name << "': " << worst << " of the range\n";
    }
}

INSTANTIATE_TEST_SUITE_P(RealScans, Gwyddion, testing::ValuesIn(scansOfGwyddion()),
                         [](const auto& scan) { return testName(scan.param); });

TEST(Gwyddion, ReadsTheSamePixelsOfSmallInstrumentFiles) {
    if (!haveGwyddion()) {
        GTEST_SKIP() << "the program gwyddion is not installed";
    }
    NanonisText upward;
    upward.direction = "up";
    upward.comment.assign(200, 'x');  // Gwyddion accepts no shorter file
    NanosurfChannel wide;
    wide.bits = "32";
    wide.stored = SampleType::Int32;
    PicoviewText narrow;
    narrow.data = "BINARY";
    DigitalSurfText offset;
    offset.bits = 32;
    offset.stored = SampleType::Int32;
    offset.offset = 2.0F;
    const struct {
        const char* name;
        std::string bytes;
    } files[] = {{"upward.sxm", nanonisFile(upward)},
                 {"wide.nid", nanosurfFile({wide})},
                 {"narrow.mi", picoviewFile(narrow, SampleType::Int16)},
                 {"double.stp", wsxmFile({})},
                 {"surface.sur", digitalSurfFile({})},
                 {"offset.sur", digitalSurfFile(offset)}};
    for (const auto& file : files) {
        SCOPED_TRACE(file.name);
        const ScratchFolder folder;
        const auto path = folder.write(file.name, file.bytes);
        const HeightMapFile ours = readHeightMapFile(path);
        const HeightMapFile theirs = throughGwyddion(folder, path);
        ASSERT_EQ(ours.channels.size(), theirs.channels.size());
        for (std::size_t i = 0; i < ours.channels.size(); ++i) {
            const ScanChannel& mine = ours.channels[i];
            EXPECT_EQ(mine.unit, theirs.channels[i].unit);
            EXPECT_NEAR(mine.map.pitchX / theirs.channels[i].map.pitchX, 1.0, 1e-12);
            EXPECT_NEAR(mine.map.pitchY / theirs.channels[i].map.pitchY, 1.0, 1e-12);
            EXPECT_LE(worstDeviation(mine.map, theirs.channels[i].map), 1e-12);
        }
    }
}

TEST(Gwyddion, ReadsWhatWeWrite) {
    if (!haveGwyddion()) {
        GTEST_SKIP() << "the program gwyddion is not installed";
    }
    const HeightMap map = bumpyMap(17, 9);
    const struct {
        const char* name;
        double tolerance;  ///< of the range
    } formats[] = {
        {"map.gwy", 0.0}, {"map.gsf", 1e-7}, {"map.png", 0.6 / 65535.0}, {"map.txt", 1e-15}};
    for (const auto& format : formats) {
        SCOPED_TRACE(format.name);
        const ScratchFolder folder;
        writeHeightMap(folder.file(format.name), map, {.title = "Height"});
        const HeightMapFile theirs = throughGwyddion(folder, folder.file(format.name));
        ASSERT_EQ(theirs.channels.size(), 1U);
        const ScanChannel& channel = theirs.channels[0];
        EXPECT_EQ(channel.unit, "m");
        EXPECT_NEAR(channel.map.sizeX() / map.sizeX(), 1.0, 1e-12);
        EXPECT_NEAR(channel.map.sizeY() / map.sizeY(), 1.0, 1e-12);
        EXPECT_LE(worstDeviation(map, channel.map), format.tolerance);
    }
}

/// docs/formats.md 9: there is no TIFF of which it reads both scales.
TEST(Gwyddion, TakesTheValuesOfOurTiffAlone) {
    if (!haveGwyddion()) {
        GTEST_SKIP() << "the program gwyddion is not installed";
    }
    const ScratchFolder folder;
    const HeightMap map = bumpyMap(17, 9);
    writeHeightMap(folder.file("map.tiff"), map, {});
    const ScanChannel theirs = throughGwyddion(folder, folder.file("map.tiff")).channels.at(0);
    EXPECT_LE(worstDeviation(map, theirs.map), 1e-7);
    EXPECT_EQ(theirs.unit, "");
    EXPECT_FALSE(theirs.hasSize());
}

TEST(Gwyddion, SeesThePixelsWithoutDataAsMasked) {
    if (!haveGwyddion()) {
        GTEST_SKIP() << "the program gwyddion is not installed";
    }
    const ScratchFolder folder;
    const HeightMap map = bumpyMapWithHoles(17, 9);
    for (const char* name : {"map.gwy", "map.txt"}) {
        writeHeightMap(folder.file(name), map, {});
        EXPECT_LE(worstDeviation(map, throughGwyddion(folder, folder.file(name)).channels[0].map),
                  1e-15)
            << name;
    }
}

TEST(Gwyddion, ReadsAllImagesThatWeWriteIntoOneFile) {
    if (!haveGwyddion()) {
        GTEST_SKIP() << "the program gwyddion is not installed";
    }
    const ScratchFolder folder;
    const HeightMap heights = bumpyMapWithHoles(17, 9);
    const HeightMap voltages = bumpyMap(5, 8);
    const std::map<std::string, std::string> metadata = {{"Scan rate", "1 Hz"}};
    const std::vector<WrittenImage> images = {
        {rowsOf(heights), {.title = "Höhe", .metadata = metadata}},
        {rowsOf(voltages), {.title = "Deflection", .unit = "V"}}};
    writeHeightMaps(folder.file("all.gwy"), images);
    const HeightMapFile theirs = throughGwyddion(folder, folder.file("all.gwy"));
    ASSERT_EQ(theirs.channels.size(), 2U);
    EXPECT_EQ(theirs.channels[0].name, "Höhe");
    EXPECT_EQ(theirs.channels[0].metadata, metadata);
    EXPECT_EQ(theirs.channels[1].unit, "V");
    EXPECT_EQ(worstDeviation(heights, theirs.channels[0].map), 0.0);
    EXPECT_EQ(worstDeviation(voltages, theirs.channels[1].map), 0.0);
}

}  // namespace
}  // namespace asperity::test
