#include "core/surface/measure/Profile.h"

#include "core/Error.h"
#include "core/Units.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/support/ScanMaps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asperity {
namespace {

/// z = 0.5 x - 0.25 y at the pixel centers.
HeightMap slope() {
    HeightMap map = flatMap({.columns = 6, .rows = 5, .sizeX = 60.0_nm, .sizeY = 100.0_nm});
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            map.heights[map.index(row, column)] =
                0.5 * (column + 0.5) * map.pitchX - 0.25 * (map.rows - row - 0.5) * map.pitchY;
        }
    }
    return map;
}

Profile ofMap(const HeightMap& map, const Vector2& from, const Vector2& to, int samples) {
    return profileOf(bilinearField(map).at, from, to, samples);
}

TEST(Profile, HasEvenDistancesAndBothEnds) {
    const Profile profile = profileOf([](double x, double y) { return 10.0 * x + y; },
                                      Vector2(1.0, 2.0), Vector2(4.0, 6.0), 6);
    ASSERT_EQ(profile.heights.size(), 6U);
    EXPECT_EQ(profile.length(), 5.0);
    for (std::size_t i = 0; i < 6; ++i) {
        const auto share = static_cast<double>(i) / 5.0;
        EXPECT_NEAR(profile.distance(i), 5.0 * share, 1e-15);
        EXPECT_NEAR(profile.heights[i], 12.0 + 34.0 * share, 1e-14);
    }
    EXPECT_EQ(profile.heights.back(), 46.0);
    EXPECT_EQ(profile.position(5), Vector2(4.0, 6.0));
}

TEST(Profile, OfAMapIsBilinearBetweenPixelCenters) {
    const HeightMap map = slope();
    const Vector2 from(7.0_nm, 13.0_nm);
    const Vector2 to(53.0_nm, 88.0_nm);
    const Profile profile = ofMap(map, from, to, 40);
    for (std::size_t i = 0; i < profile.heights.size(); ++i) {
        const Vector2 position = profile.position(i);
        EXPECT_NEAR(profile.heights[i], 0.5 * position.x() - 0.25 * position.y(), 1e-23);
    }
    EXPECT_EQ(bilinearField(map).at(35.0_nm, 30.0_nm), map.at(3, 3));
}

TEST(Profile, OfAMapIsLevelBeyondTheOutermostCentersAndEndsWithTheScan) {
    const HeightMap map = slope();
    EXPECT_EQ(bilinearField(map).at(0.0, 0.0), map.at(4, 0));
    EXPECT_EQ(bilinearField(map).at(60.0_nm, 100.0_nm), map.at(0, 5));
    EXPECT_TRUE(std::isnan(bilinearField(map).at(-0.1_nm, 50.0_nm)));
    EXPECT_TRUE(std::isnan(bilinearField(map).at(30.0_nm, 100.1_nm)));
}

TEST(Profile, OfAMapInSinglePrecisionCountsFromItsDatum) {
    const HeightMap map = slope();
    const ScanMap single = test::singlePrecision(map);
    const BSplineSurface surface = fitSurface(map);
    for (const Vector2& at : {Vector2(20.0_nm, 40.0_nm), Vector2(33.0_nm, 71.0_nm)}) {
        const double exact = bilinearField(map).at(at.x(), at.y());
        EXPECT_NEAR(bilinearField(single).at(at.x(), at.y()), exact, 1e-15);
        EXPECT_NEAR(bilinearField(surface).at(at.x(), at.y()), exact, 1e-15);
    }
}

TEST(Profile, HasNoHeightWhereAPixelHoldsNoData) {
    HeightMap map = slope();
    map.heights[map.index(2, 2)] = std::numeric_limits<double>::quiet_NaN();
    map.invalid.assign(map.heights.size(), false);
    map.invalid[map.index(0, 0)] = true;
    EXPECT_TRUE(std::isnan(bilinearField(map).at(26.0_nm, 51.0_nm)));
    EXPECT_TRUE(std::isnan(bilinearField(map).at(2.0_nm, 95.0_nm)));
    // On the center of the next pixel the one without data has no weight.
    EXPECT_EQ(bilinearField(map).at(35.0_nm, 50.0_nm), map.at(2, 3));
}

TEST(Profile, OfASurfaceIsItsHeight) {
    HeightMap map = slope();
    map.invalid.assign(map.heights.size(), false);
    map.invalid[map.index(2, 2)] = true;
    const BSplineSurface surface = fitSurface(map);
    const Profile profile =
        profileOf(fieldOf(surface).at, Vector2(5.0_nm, 90.0_nm), Vector2(75.0_nm, 90.0_nm), 8);
    EXPECT_NEAR(profile.heights[3], 0.5 * 35.0_nm - 0.25 * 90.0_nm, 1e-15);
    EXPECT_TRUE(std::isnan(profile.heights[7]));
    EXPECT_TRUE(std::isnan(
        profileOf(fieldOf(surface).at, Vector2(25.0_nm, 50.0_nm), Vector2(45.0_nm, 50.0_nm), 2)
            .heights[0]));
}

TEST(Profile, RefusesALineWithoutLengthOrSamples) {
    const auto flat = [](double, double) { return 0.0; };
    const Vector2 a(1.0, 1.0);
    EXPECT_THROW((void)profileOf(flat, a, a, 5), Error);
    EXPECT_THROW((void)profileOf(flat, a, Vector2(2.0, 1.0), 1), Error);
    EXPECT_THROW((void)profileOf(flat, a, Vector2(std::numeric_limits<double>::infinity(), 1.0), 5),
                 Error);
}

TEST(Profile, UsuallyHasASampleAPixel) {
    EXPECT_EQ(usualSamples(1.0, 2.0, Vector2(0.0, 0.0), Vector2(3.0, 8.0)), 6);
    EXPECT_EQ(usualSamples(1.0, 1.0, Vector2(0.0, 0.0), Vector2(0.1, 0.0)), 2);
}

}  // namespace
}  // namespace asperity
