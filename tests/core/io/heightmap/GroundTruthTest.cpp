#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/io/heightmap/HeightMapFile.h"
#include "core/io/heightmap/ScanFile.h"
#include "tests/core/io/heightmap/MapStatistics.h"
#include "tests/core/io/heightmap/RealScans.h"
#include "tests/support/ReferenceTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <set>

// Every channel of every real file against statistics and pixels found by Gwyddion 2.62 and numpy.

namespace asperity::test {

namespace {

/// The tables have 10 significant digits: half a unit of the last one, besides 1e-9 of the range.
double tolerance(double expected, double range) {
    constexpr double kHalfLastDigit = 5e-10;
    return 1e-9 * range + kHalfLastDigit * std::abs(expected);
}

/// Gwyddion calls the amplitude error of di-3 volts, but shows the number of millivolts that its Z
/// scale of 2999.954 mV gives: the number is right, the unit is not.
std::string trueUnit(const std::string& file, const std::string& title, const std::string& unit) {
    return file == "nanoscope/di-3_v9.01.di" && title == "AmplitudeError" ? "mV" : unit;
}

/// The resolution of the TIFFs is a fraction, which differs from the size that they were made of.
double statedSize(const std::string& file, double size) {
    constexpr double kCentimeter = 0.01;
    constexpr double kPixels = 256.0;
    return file.ends_with(".tif") ? kPixels * kCentimeter * 142344.0 / 4294967295.0 : size;
}

/// The file whose rows in the tables hold: an archive is that of its image.
std::string rowsOfTables(const std::string& file) {
    return file == "jpk/qi_2020_extracted.jpk-qi-data" ? "jpk/qi_2020_data-image.jpk-qi-image"
                                                       : file;
}

class GroundTruth : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override {
        ASPERITY_NEEDS_SHARED_DATA();
        path = sharedData("afm/" + GetParam());
        file = readHeightMapFile(path);
    }

    void expectNear(double value, double expected, const std::string& what) {
        if (std::isnan(expected)) {
            EXPECT_TRUE(std::isnan(value)) << what;
            return;
        }
        EXPECT_NEAR(value, expected, tolerance(expected, range)) << what;
        if (range > 0.0) {
            worst = std::max(worst, std::abs(value - expected) / range);
        }
    }

    void expectChannel(const ReferenceTable& table, std::size_t row) {
        const ScanChannel& channel =
            file.channels.at(static_cast<std::size_t>(table.number(row, "index")));
        const HeightMap& map = channel.map;
        const HeightStatistics statistics = statisticsOf(map);
        range = table.number(row, "max") - table.number(row, "min");
        EXPECT_EQ(channel.name, channelName(GetParam(), table.text(row, "title")));
        EXPECT_EQ(channel.unit, trueUnit(GetParam(), channel.name, table.text(row, "unit")));
        EXPECT_EQ(map.columns, table.number(row, "width_px"));
        EXPECT_EQ(map.rows, table.number(row, "height_px"));
        expectSize(map.sizeX(), table, row, "xreal_m");
        expectSize(map.sizeY(), table, row, "yreal_m");
        EXPECT_EQ(static_cast<double>(statistics.invalidPixels), table.number(row, "invalid_px"));
        expectNear(statistics.lowest, table.number(row, "min"), "min");
        expectNear(statistics.highest, table.number(row, "max"), "max");
        expectNear(statistics.mean, table.number(row, "mean"), "mean");
        expectNear(statistics.rms, table.number(row, "rms_about_mean"), "rms");
        expectPixels(map, table, row);
    }

    /// @param column empty where the file does not give it
    static void expectSize(double size, const ReferenceTable& table, std::size_t row,
                           const std::string& column) {
        if (table.text(row, column).empty()) {
            EXPECT_EQ(size, 0.0) << column;
        } else {
            EXPECT_NEAR(size / statedSize(GetParam(), table.number(row, column)), 1.0, 1e-9)
                << column;
        }
    }

    void expectPixels(const HeightMap& map, const ReferenceTable& table, std::size_t row) {
        const int lastRow = map.rows - 1;
        const int lastColumn = map.columns - 1;
        expectNear(map.at(0, 0), table.number(row, "z_top_left"), "top left");
        expectNear(map.at(0, lastColumn), table.number(row, "z_top_right"), "top right");
        expectNear(map.at(lastRow, 0), table.number(row, "z_bottom_left"), "bottom left");
        expectNear(map.at(lastRow, lastColumn), table.number(row, "z_bottom_right"),
                   "bottom right");
        expectNear(map.at(map.rows / 3, map.columns / 4), table.number(row, "z_row_h/3_col_w/4"),
                   "inner pixel");
    }

    std::filesystem::path path;
    HeightMapFile file;
    double range = 0.0;
    double worst = 0.0;
};

TEST_P(GroundTruth, EveryChannelHasItsStatisticsAndPixels) {
    const ReferenceTable table(sharedData("afm/CHANNELS.csv"));
    std::size_t channels = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.text(row, "file") != rowsOfTables(GetParam())) {
            continue;
        }
        SCOPED_TRACE(table.text(row, "title"));
        expectChannel(table, row);
        ++channels;
    }
    EXPECT_EQ(file.channels.size(), channels);
    std::cout << GetParam() << ": worst deviation " << worst << " of the range\n";
}

TEST_P(GroundTruth, DefaultChannelIsTheLabsChoice) {
    const ReferenceTable table(sharedData("afm/MANIFEST.csv"));
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.text(row, "file") != rowsOfTables(GetParam())) {
            continue;
        }
        const ScanChannel& channel = file.channels.at(file.defaultChannel);
        range = table.number(row, "max") - table.number(row, "min");
        EXPECT_EQ(channel.name, channelName(GetParam(), table.text(row, "primary_channel")));
        EXPECT_EQ(channel.unit, table.text(row, "height_unit"));
        expectNear(statisticsOf(channel.map).rms, table.number(row, "rms_about_mean"), "rms");
        return;
    }
    FAIL() << "not in the manifest";
}

TEST_P(GroundTruth, DefaultChannelIsAHeightOrRefused) {
    const ScanChannel& channel = file.channels.at(file.defaultChannel);
    if (channel.unit == "m") {
        EXPECT_TRUE(isTopography(channel));
        EXPECT_EQ(&heightChannel(file, path, ""), &channel);
    } else {
        EXPECT_THROW((void)heightChannel(file, path, ""), InputError);
    }
}

/// Text and pictures of no instrument have no version.
bool hasVersion(const std::string& file) {
    return !file.starts_with("text/") && !file.starts_with("derived/") && !file.starts_with("mi/");
}

TEST_P(GroundTruth, SaysWhereItsNumbersComeFrom) {
    for (const ScanChannel& channel : file.channels) {
        SCOPED_TRACE(channel.name);
        std::multiset<std::string> subjects;
        for (const Provenance& entry : provenanceOf(file, channel)) {
            subjects.insert(entry.what);
            EXPECT_FALSE(entry.value.empty()) << entry.what;
            EXPECT_FALSE(entry.source.empty()) << entry.what;
            EXPECT_EQ(printable(entry.value), entry.value);
        }
        EXPECT_EQ(subjects.count("orientation"), 1U);
        EXPECT_EQ(subjects.count("lateral size"), channel.map.pitchX > 0.0 ? 1U : 0U);
        EXPECT_LE(subjects.count("scale"), 1U);
        EXPECT_TRUE(subjects.contains("scale") || channel.unit.empty());
        EXPECT_LE(subjects.count("format version"), 1U);
        EXPECT_TRUE(subjects.contains("format version") || !hasVersion(GetParam()));
    }
}

INSTANTIATE_TEST_SUITE_P(RealScans, GroundTruth, testing::ValuesIn(realScans()),
                         [](const auto& scan) { return testName(scan.param); });

TEST(RealScans, TraceAndRetraceOfCl0AreTheSameSurfaceAsItsGwyAndGsf) {
    ASPERITY_NEEDS_SHARED_DATA();
    const auto spm = readHeightMapFile(sharedData("afm/nanoscope/cl_0deg_xcal_v9.70.spm"));
    const auto gwy = readHeightMapFile(sharedData("afm/derived/cl0_from_spm.gwy"));
    const auto gsf = readHeightMapFile(sharedData("afm/derived/cl0_height.gsf"));
    const HeightMap& height = spm.channels[0].map;
    for (std::size_t i = 0; i < height.heights.size(); ++i) {
        ASSERT_NEAR(height.heights[i], gwy.channels[0].map.heights[i], 1e-12 * 4e-7);
        ASSERT_NEAR(height.heights[i], gsf.channels[0].map.heights[i],
                    6e-8 * std::abs(height.heights[i]));
    }
}

}  // namespace
}  // namespace asperity::test
