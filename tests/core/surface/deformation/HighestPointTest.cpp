#include "core/Error.h"
#include "core/Random.h"
#include "core/Units.h"
#include "core/surface/deformation/ContactHeight.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/core/surface/deformation/WideScan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {
namespace {

using test::kWideScan;
using test::kWideSize;

/// A plane through 0 at the scan's center.
struct CenteredSlope {
    double slope = 0.0;

    [[nodiscard]] double height(double x, double /*y*/) const {
        return slope * (x - 0.5 * kWideSize);
    }
};

TEST(HighestPoint, IsTheTopOfAHillBetweenPixels) {
    const EggBox shape{.amplitude = 5.0_nm,
                       .periodX = 160.0_nm,
                       .periodY = 160.0_nm,
                       .phaseX = 0.1,
                       .phaseY = -0.2};
    const SurfacePoint top = highestPoint(fitSurface(sampledMap(kWideScan, shape)), 0.1);
    const double k = 2.0 * M_PI / 160.0_nm;
    const bool first = top.x < 80.0_nm;  // two equal tops lie in the scan
    EXPECT_NEAR(top.x, ((first ? 0.5 : 1.5) * M_PI - 0.1) / k, 0.01_nm);
    EXPECT_NEAR(top.y, ((first ? 0.5 : 1.5) * M_PI + 0.2) / k, 0.01_nm);
    EXPECT_NEAR(top.height, 5.0_nm, 1e-4_nm);
}

TEST(HighestPoint, KeepsTheMarginToTheEdges) {
    const BSplineSurface surface = fitSurface(sampledMap(kWideScan, CenteredSlope{.slope = 0.5}));
    EXPECT_NEAR(highestPoint(surface, 0.1).x, 0.9 * kWideSize, 1e-20);
    EXPECT_NEAR(highestPoint(surface, 0.0).x, kWideSize, 1e-20);
    const SurfacePoint middle = highestPoint(surface, 0.5);
    EXPECT_NEAR(middle.x, 0.5 * kWideSize, 1e-20);
    EXPECT_THROW((void)highestPoint(surface, 0.6), Error);
    EXPECT_THROW((void)highestPoint(surface, -0.1), Error);
}

/// A hill of 3 x 3 pixels, the middle one of which holds no data.
HeightMap hillWithAHole() {
    HeightMap map = flatMap({.columns = 9, .rows = 9, .sizeX = 9.0_um, .sizeY = 9.0_um});
    for (int row = 5; row <= 7; ++row) {
        for (int column = 5; column <= 7; ++column) {
            map.heights[map.index(row, column)] = 50.0_nm;
        }
    }
    map.invalid.assign(81, false);
    map.invalid[map.index(6, 6)] = true;
    return map;
}

/// The tip of a scripted path never met the sample, but heights that were filled in.
TEST(HighestPoint, HoldsData) {
    const BSplineSurface surface = fitSurface(hillWithAHole());
    const SurfacePoint top = highestPoint(surface, 0.03);
    EXPECT_TRUE(surface.isMeasured(top.x, top.y)) << top.x << ' ' << top.y;
    EXPECT_GE(top.height, 49.9_nm) << "the spline rises between pixels";
    HeightMap empty = hillWithAHole();
    empty.invalid.assign(81, true);
    empty.invalid[0] = false;
    const BSplineSurface filled = fitSurface(empty);
    const SurfacePoint none = highestPoint(filled, 0.2);
    EXPECT_FALSE(filled.isMeasured(none.x, none.y)) << "only the corner does";
}

TEST(HighestPoint, IsDefinedOnALevelSurface) {
    const SurfacePoint position = highestPoint(fitSurface(flatMap(kWideScan)), 0.1);
    EXPECT_TRUE(position.x > 0.0 && position.x < kWideSize);
    const BSplineSurface pixel =
        fitSurface(flatMap({.columns = 1, .rows = 1, .sizeX = 1.0_nm, .sizeY = 1.0_nm}));
    EXPECT_NEAR(highestPoint(pixel, 0.5).x, 0.5_nm, 1e-22);
}

/// The first of the highest of all pixel centers, brought into the box, and of the middle.
double highestPixel(const BSplineSurface& surface, double margin) {
    double highest = surface.at(0.5 * surface.sizeX(), 0.5 * surface.sizeY()).height;
    const BSplineSurface::Grid& grid = surface.grid();
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const double x = std::clamp((column + 0.5) * grid.pitchX, margin * surface.sizeX(),
                                        (1.0 - margin) * surface.sizeX());
            const double y = std::clamp((row + 0.5) * grid.pitchY, margin * surface.sizeY(),
                                        (1.0 - margin) * surface.sizeY());
            highest = std::max(highest, surface.at(x, y).height);
        }
    }
    return highest;
}

/// The search skips what its bounds say lies lower.
TEST(HighestPoint, LosesNoPixelOfAnyScan) {
    Random random(20261126);
    for (int i = 0; i < 200; ++i) {
        HeightMap map = flatMap({.columns = 1 + static_cast<int>(random.uniform(0.0, 90.0)),
                                 .rows = 1 + static_cast<int>(random.uniform(0.0, 90.0)),
                                 .sizeX = 1.0_um,
                                 .sizeY = 1.3_um});
        const double steps = random.uniform(0.0, 2.0) < 1.0 ? 3.0 : 1e6;  // terraces, or noise
        for (double& height : map.heights) {
            height = std::floor(random.uniform(0.0, steps)) / steps * 1.0_nm;
        }
        const BSplineSurface surface = fitSurface(map);
        const double margin = random.uniform(0.0, 0.5);
        EXPECT_GE(highestPoint(surface, margin).height, highestPixel(surface, margin))
            << map.columns << " x " << map.rows << ", margin " << margin;
    }
}

}  // namespace
}  // namespace asperity
