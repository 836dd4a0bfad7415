#include "core/surface/deformation/ContactHeight.h"

#include "core/Error.h"
#include "core/Units.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/core/surface/TestTip.h"
#include "tests/core/surface/deformation/WideScan.h"
#include "tests/support/DoubleLimits.h"
#include "tests/support/StorageError.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

using test::kNan;
using test::kTipRadius;
using test::kWideScan;
using test::kWideSize;

/// A plane through 0 at the scan's center, or a paraboloid there.
struct Shape {
    double slope = 0.0;
    double bend = 0.0;  ///< [1/m]

    [[nodiscard]] double height(double x, double y) const {
        const double s = x - 0.5 * kWideSize;
        const double t = y - 0.5 * kWideSize;
        return slope * s + 0.5 * bend * (s * s + t * t);
    }
};

/// The dilation by dense sampling alone: a lower bound, short by about step^2 / (2 R).
double sampledContactHeight(const BSplineSurface& surface, double x, double y) {
    constexpr int kSteps = 300;  // of 0.05 nm
    double highest = -1.0;
    for (int i = -kSteps; i <= kSteps; ++i) {
        for (int j = -kSteps; j <= kSteps; ++j) {
            const double dx = kTipRadius * i / kSteps;
            const double dy = kTipRadius * j / kSteps;
            const double rest = kTipRadius * kTipRadius - dx * dx - dy * dy;
            if (rest < 0.0 || !surface.contains(x + dx, y + dy)) {
                continue;
            }
            highest = std::max(highest, surface.at(x + dx, y + dy).height + std::sqrt(rest));
        }
    }
    return highest;
}

TEST(TipContactHeight, IsOneRadiusAboveALevelSurface) {
    const BSplineSurface surface = fitSurface(sampledMap(kWideScan, Shape{}));
    EXPECT_NEAR(tipContactHeight(surface, 77.3_nm, 40.1_nm, kTipRadius), kTipRadius, 1e-22);
}

TEST(TipContactHeight, OnASlopeIsTheRadiusOverTheCosine) {
    for (const double slope : {0.1, 1.0, 5.0}) {
        const BSplineSurface surface = fitSurface(sampledMap(kWideScan, Shape{.slope = slope}));
        const double expected =
            slope * (90.0_nm - 0.5 * kWideSize) + kTipRadius * std::hypot(1.0, slope);
        EXPECT_NEAR(tipContactHeight(surface, 90.0_nm, 60.0_nm, kTipRadius), expected,
                    1e-19 + test::storageErrorOf(surface).height);
    }
}

TEST(TipContactHeight, OnAHillTouchesWhereTheNormalPointsAtTheTip) {
    const double bend = -1.0 / 40.0_nm;
    const BSplineSurface surface = fitSurface(sampledMap(kWideScan, Shape{.bend = bend}));
    const double offset = 18.0_nm;  // of the position of contact from the apex
    const double slope = bend * offset;
    const double x = 0.5 * kWideSize + offset - kTipRadius * slope / std::hypot(1.0, slope);
    const double expected = 0.5 * bend * offset * offset + kTipRadius / std::hypot(1.0, slope);
    EXPECT_NEAR(tipContactHeight(surface, x, 0.5 * kWideSize, kTipRadius), expected,
                1e-19 + test::storageErrorOf(surface).height);
}

TEST(TipContactHeight, BridgesAValleyThatTheTipDoesNotFit) {
    const double valleyRadius = 5.0_nm;
    const BSplineSurface surface =
        fitSurface(sampledMap(kWideScan, Shape{.bend = 1.0 / valleyRadius}));
    // Highest s^2 / (2 r) + sqrt(R^2 - s^2): at sqrt(R^2 - s^2) = r.
    const double expected =
        0.5 * (kTipRadius * kTipRadius - valleyRadius * valleyRadius) / valleyRadius + valleyRadius;
    EXPECT_NEAR(tipContactHeight(surface, 0.5 * kWideSize, 0.5 * kWideSize, kTipRadius), expected,
                1e-18 + test::storageErrorOf(surface).height);
}

TEST(TipContactHeight, IsTheHighestOfAllContactsOnRoughGround) {
    const BSplineSurface surface = fitSurface(selfAffineMap(
        {.columns = 64, .rows = 64, .sizeX = 120.0_nm, .sizeY = 120.0_nm}, {.rms = 5.0_nm,
                                                                            .hurst = 0.7,
                                                                            .longestWave = 120.0_nm,
                                                                            .rollOffWave = 60.0_nm,
                                                                            .shortestWave = 6.0_nm,
                                                                            .seed = 2}));
    for (const auto& [x, y] : {std::pair{60.0_nm, 60.0_nm},
                               {31.0_nm, 94.0_nm},
                               {5.0_nm, 3.0_nm},
                               {117.0_nm, 60.0_nm},
                               {88.0_nm, 22.0_nm}}) {
        const double sampled = sampledContactHeight(surface, x, y);
        const double found = tipContactHeight(surface, x, y, kTipRadius);
        EXPECT_GE(found, sampled - 1e-21);
        EXPECT_NEAR(found, sampled, 0.01_nm);
    }
}

TEST(TipContactHeight, FindsAThinNeedleOffTheAxis) {
    HeightMap map = flatMap(kWideScan);
    map.heights[map.index(40, 55)] = 30.0_nm;
    const BSplineSurface surface = fitSurface(map);
    const double needleX = 55.5 * map.pitchX;
    const double needleY = (80 - 40 - 0.5) * map.pitchY;
    const double found = tipContactHeight(surface, needleX - 9.0_nm, needleY, kTipRadius);
    EXPECT_GT(found, 30.0_nm + 12.0_nm - 1e-18);  // the needle's top: sqrt(15^2 - 9^2) = 12
    EXPECT_LT(found, 30.0_nm + 14.0_nm);
}

TEST(TipContactHeight, BesideTheScanIsThatOfTheEdge) {
    const BSplineSurface surface = fitSurface(sampledMap(kWideScan, Shape{}));
    EXPECT_NEAR(tipContactHeight(surface, -9.0_nm, 50.0_nm, kTipRadius), 12.0_nm, 1e-20);
    EXPECT_NEAR(tipContactHeight(surface, 1.0_um, 50.0_nm, kTipRadius), kTipRadius, 1e-20);
}

TEST(TipContactHeight, RefusesWhatIsNoTipOrNoPosition) {
    const BSplineSurface surface = fitSurface(sampledMap(kWideScan, Shape{}));
    EXPECT_THROW((void)tipContactHeight(surface, 0.0, 0.0, 0.0), Error);
    EXPECT_THROW((void)tipContactHeight(surface, 0.0, 0.0, kNan), Error);
    EXPECT_THROW((void)tipContactHeight(surface, kNan, 0.0, kTipRadius), Error);
}

}  // namespace
}  // namespace asperity
