#include "tools/samples/SampleScans.h"

#include "core/Error.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/surface/fit/BSplineFit.h"
#include "tests/support/Places.h"
#include "tests/support/ReferenceTable.h"
#include "tools/samples/ParkScan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace asperity {
namespace {

std::string bytesOf(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST(SampleScans, AreThoseInTheRepositoryByteForByte) {
    const std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) / "asperity_sample_scans";
    std::filesystem::create_directories(folder);
    for (const SampleScan& sample : makeSampleScans()) {
        writeHeightMap(folder / sample.fileName, sample.map,
                       {.title = sample.title, .unit = sample.unit});
        const std::string stored = bytesOf(test::dataFolder() / "samples" / sample.fileName);
        EXPECT_GT(stored.size(), 4U * 256U * 256U) << sample.fileName;
        EXPECT_TRUE(stored == bytesOf(folder / sample.fileName)) << sample.fileName;
    }
    std::filesystem::remove_all(folder);
}

/// The benchmark of closest points measured the mask, too.
TEST(SampleScans, AreHeightsButForTheMask) {
    for (const SampleScan& sample : makeSampleScans()) {
        EXPECT_EQ(sample.isHeight(), sample.fileName != "particle_mask.gsf") << sample.fileName;
    }
}

std::filesystem::path parkFile() { return test::sharedData("afm/park/example_ps.tiff"); }

TEST(ParkScan, HasTheHeightsThatGwyddionReads) {
    ASPERITY_NEEDS_SHARED_DATA();
    const HeightMap film = readParkScan(parkFile());
    ASSERT_EQ(film.columns, 512);
    ASSERT_EQ(film.rows, 512);
    EXPECT_DOUBLE_EQ(film.sizeX(), 1e-6);
    // From CHANNELS.csv: the corners and the pixel at a third and a fourth.
    EXPECT_NEAR(film.at(0, 0), -2.019951079e-09, 1e-17);
    EXPECT_NEAR(film.at(0, 511), 8.95068831e-10, 1e-17);
    EXPECT_NEAR(film.at(511, 0), 3.838167321e-09, 1e-17);
    EXPECT_NEAR(film.at(511, 511), 2.083638621e-09, 1e-17);
    EXPECT_NEAR(film.at(170, 128), 6.032147946e-09, 1e-17);
}

TEST(ParkScan, IsWhatTheGranularFilmIsCutOutOf) {
    ASPERITY_NEEDS_SHARED_DATA();
    const HeightMap film = readParkScan(parkFile());
    const HeightMap part = granularFilm(film);
    EXPECT_EQ(part.at(0, 0), film.at(119, 122));
    EXPECT_EQ(part.at(255, 255), film.at(374, 377));
    const auto written = std::filesystem::path(testing::TempDir()) / "granular_film.gsf";
    writeHeightMap(written, part, {.title = kGranularFilmTitle});
    EXPECT_TRUE(bytesOf(written) == bytesOf(test::dataFolder() / "samples" / "granular_film.gsf"));
    std::filesystem::remove(written);
}

TEST(ParkScan, RefusesAnotherTiff) {
    const auto other = std::filesystem::path(testing::TempDir()) / "other.tiff";
    writeHeightMap(other, makeSampleScans().front().map, {.title = "no Park file"});
    EXPECT_THROW((void)readParkScan(other), InputError);
    std::filesystem::remove(other);
}

TEST(SampleScans, AreSmoothEnoughForASplineNotToRing) {
    for (const SampleScan& sample : makeSampleScans()) {
        const auto [low, high] = std::ranges::minmax(sample.map.heights);
        const BSplineSurface surface = fitSurface(sample.map);
        const double allowance = 0.02 * (high - low);
        for (int i = 0; i < 2 * sample.map.columns; ++i) {
            for (int j = 0; j < 2 * sample.map.rows; ++j) {
                const double x = 0.5 * i + 0.25;
                const double y = 0.5 * j + 0.25;
                const double height =
                    surface.at(x * sample.map.pitchX, y * sample.map.pitchY).height;
                ASSERT_GT(height, low - allowance) << sample.fileName;
                ASSERT_LT(height, high + allowance) << sample.fileName;
            }
        }
    }
}

}  // namespace
}  // namespace asperity
