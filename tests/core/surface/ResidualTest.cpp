#include "core/Error.h"
#include "core/Random.h"
#include "core/Units.h"
#include "core/surface/HeightMap.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/fit/GaussianFilter.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/support/ScanMaps.h"
#include "tests/support/StorageError.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asperity {
namespace {

HeightMap noisyMap() {
    HeightMap map = flatMap({.columns = 50, .rows = 40, .sizeX = 100.0_nm, .sizeY = 120.0_nm});
    Random random(7);
    for (double& height : map.heights) {
        height = random.uniform(-1.0_nm, 1.0_nm);
    }
    return map;
}

TEST(Residual, IsWhatSmoothingTook) {
    const HeightMap map = noisyMap();
    const HeightMap smooth = smoothed(map, 2.0);
    const BSplineSurface surface = fitSurface(map, {2.0, 2.0});
    const HeightMap residual = residualOf(map, surface);
    for (std::size_t i = 0; i < map.heights.size(); ++i) {
        ASSERT_NEAR(residual.heights[i], map.heights[i] - smooth.heights[i],
                    test::storageErrorOf(surface).height + 1e-22);
    }
    EXPECT_EQ(residual.pitchX, map.pitchX);
    EXPECT_EQ(residual.pitchY, map.pitchY);
}

TEST(Residual, InSinglePrecisionIsTheSameButForRounding) {
    HeightMap map = noisyMap();
    for (double& height : map.heights) {
        height += 3.0_um;
    }
    map.heights[map.index(3, 4)] = std::numeric_limits<double>::quiet_NaN();
    const ScanMap scan = withInvalidPixelsFilled(test::singlePrecision(map));
    const BSplineSurface surface = fitSurface(scan, {2.0, 2.0});
    const HeightMap exact = residualOf(withInvalidPixelsFilled(map), surface);
    const ScanMap rounded = residualOf(scan, surface);
    EXPECT_EQ(rounded.datum, 0.0);
    EXPECT_TRUE(std::isnan(rounded.at(3, 4)));
    for (int column = 5; column < map.columns; ++column) {
        ASSERT_NEAR(rounded.at(3, column), exact.at(3, column), 0x1p-22 * 1.0_nm);
    }
}

TEST(Residual, OfASurfaceWithoutSmoothingIsRounding) {
    const BSplineSurface surface = fitSurface(noisyMap());
    for (const double height : residualOf(noisyMap(), surface).heights) {
        ASSERT_NEAR(height, 0.0, test::storageErrorOf(surface).height);
    }
}

TEST(Residual, APixelWithoutDataHasNone) {
    HeightMap map = noisyMap();
    map.invalid.assign(map.heights.size(), 0);
    map.invalid[map.index(3, 4)] = 1;
    map.heights[map.index(3, 4)] = std::numeric_limits<double>::quiet_NaN();
    const HeightMap residual = residualOf(map, fitSurface(map, {1.0, 1.0}));
    EXPECT_TRUE(std::isnan(residual.at(3, 4)));
    EXPECT_FALSE(residual.isValid(3, 4));
    EXPECT_TRUE(std::isfinite(residual.at(3, 5)));
}

TEST(Residual, RefusesTheSurfaceOfAnotherMap) {
    const HeightMap other = flatMap({.columns = 3, .rows = 3, .sizeX = 1.0_nm, .sizeY = 1.0_nm});
    EXPECT_THROW((void)residualOf(other, fitSurface(noisyMap())), Error);
    EXPECT_THROW((void)residualOf(HeightMap{}, fitSurface(noisyMap())), Error);
}

}  // namespace
}  // namespace asperity
