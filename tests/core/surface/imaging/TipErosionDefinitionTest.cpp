#include "core/Random.h"
#include "core/Units.h"
#include "core/surface/imaging/TipErosion.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/core/surface/imaging/ErosionDefinition.h"
#include "tests/support/ScanMaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace asperity {
namespace {

using test::erosionAt;
using test::forEachPixel;
using test::kNan;
using test::riseOf;
using test::tipIsWithin;

HeightMap randomMap(const ScanSize& size, double height, double missing, Random& random) {
    HeightMap map = flatMap(size);
    for (double& pixel : map.heights) {
        pixel = random.uniform(0.0, 1.0) < missing ? kNan : random.uniform(0.0, height);
    }
    return map;
}

/// A random map of a random size and a tip for it, from smaller than a pixel to wider than all.
struct RandomCase {
    HeightMap map;
    double tip = 0.0;  ///< [m]
};

RandomCase randomCase(Random& random) {
    const auto count = [&] { return 1 + static_cast<int>(random.uniform(0.0, 40.0)); };
    ScanSize size{.columns = count(), .rows = count()};
    size.sizeX = size.columns * random.uniform(0.3, 2.0) * 1.0_nm;
    size.sizeY = size.rows * random.uniform(0.3, 2.0) * 1.0_nm;
    const double height = std::pow(10.0, random.uniform(-11.0, -7.0));
    return {randomMap(size, height, random.uniform(0.0, 0.3), random),
            std::pow(10.0, random.uniform(-9.5, -6.5))};
}

TEST(TipErosionDefinition, IsItsDefinitionToTheLastBit) {
    Random random(7);
    for (int run = 0; run < 60; ++run) {
        const RandomCase given = randomCase(random);
        const HeightMap surface = eroded(given.map, given.tip);
        forEachPixel(given.map, [&](int row, int column) {
            const double before = given.map.at(row, column);
            if (isFiniteHeight(before)) {
                EXPECT_EQ(surface.at(row, column), erosionAt(given.map, row, column, given.tip));
            } else {
                EXPECT_FALSE(isFiniteHeight(surface.at(row, column)));
            }
        });
    }
}

/// The pixels that the tip over (row, column) can touch; `surface` is the erosion, infinite where
/// unknown.
std::vector<std::size_t> touchable(const HeightMap& image, const std::vector<double>& surface,
                                   int row, int column, double tip) {
    std::vector<std::size_t> touched;
    const double level = image.at(row, column) - 1e-12 * tip;
    forEachPixel(image, [&](int r, int c) {
        const double height = surface[image.index(r, c)];
        if (isFiniteHeight(height) && height - riseOf(image, r - row, c - column, tip) >= level) {
            touched.push_back(image.index(r, c));
        }
    });
    return touched;
}

TEST(TipErosionDefinition, CertaintyIsItsDefinition) {
    Random random(11);
    std::size_t certain = 0;
    for (int run = 0; run < 60; ++run) {
        const RandomCase given = randomCase(random);
        const HeightMap& map = given.map;
        std::vector<double> surface;
        forEachPixel(map, [&](int row, int column) {
            surface.push_back(erosionAt(map, row, column, given.tip));
        });
        std::vector<std::uint8_t> expected(map.heights.size(), 0);
        forEachPixel(map, [&](int row, int column) {
            if (isFiniteHeight(map.at(row, column)) && tipIsWithin(map, row, column, given.tip)) {
                const auto touched = touchable(map, surface, row, column, given.tip);
                if (touched.size() == 1 && isFiniteHeight(map.heights[touched.front()])) {
                    expected[touched.front()] = 1;
                }
            }
        });
        EXPECT_EQ(reconstructed(map, given.tip).certain, expected);
        certain += static_cast<std::size_t>(std::ranges::count(expected, 1));
    }
    EXPECT_GT(certain, 1000U);
}

/// The map whose heights are those of the other, in double precision.
HeightMap sameHeights(const ScanMap& scan) {
    HeightMap map;
    map.columns = scan.columns;
    map.rows = scan.rows;
    map.pitchX = scan.pitchX;
    map.pitchY = scan.pitchY;
    map.heights.assign(scan.heights.begin(), scan.heights.end());
    map.invalid = scan.invalid;
    return map;
}

TEST(TipErosionDefinition, InSinglePrecisionIsTheDefinitionRounded) {
    Random random(13);
    for (int run = 0; run < 60; ++run) {
        const RandomCase given = randomCase(random);
        ScanMap image = test::singlePrecision(given.map);
        image.invalid.assign(image.heights.size(), false);
        image.invalid[image.heights.size() / 2] = true;
        const TipReconstruction exact = reconstructed(sameHeights(image), given.tip);
        const ScanReconstruction rounded = reconstructed(image, given.tip);
        EXPECT_EQ(rounded.surface.datum, image.datum);
        EXPECT_EQ(rounded.certain, exact.certain);
        EXPECT_EQ(certainPixels(image, given.tip), exact.certain);
        for (std::size_t i = 0; i < exact.certain.size(); ++i) {
            if (isFiniteHeight(exact.surface.heights[i])) {
                ASSERT_EQ(rounded.surface.heights[i], static_cast<float>(exact.surface.heights[i]));
            } else {
                ASSERT_FALSE(isFiniteHeight(rounded.surface.heights[i]));
            }
        }
    }
}

}  // namespace
}  // namespace asperity
