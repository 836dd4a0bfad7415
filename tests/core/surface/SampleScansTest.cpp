#include "tools/samples/SampleScans.h"

#include "core/io/heightmap/HeightMapWriter.h"
#include "core/surface/fit/BSplineFit.h"
#include "tests/support/ReferenceTable.h"

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
        writeHeightMap(folder / sample.fileName, sample.map, {.title = sample.title});
        const std::string stored =
            bytesOf(std::filesystem::path(ASPERITY_DATA_DIR) / "samples" / sample.fileName);
        EXPECT_GT(stored.size(), 4U * 256U * 256U) << sample.fileName;
        EXPECT_TRUE(stored == bytesOf(folder / sample.fileName)) << sample.fileName;
    }
    std::filesystem::remove_all(folder);
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
