#include "core/Units.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/fit/BSplineFit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace asperity {
namespace {

const Vector2 kLow(0.0, 0.0);
const Vector2 kHigh(128.0_nm, 128.0_nm);

/// 64 x 64 pixels of 2 nm of a surface.
BSplineSurface surfaceOf(const std::function<double(double x, double y)>& height) {
    HeightMap map{.columns = 64, .rows = 64, .pitchX = 2.0_nm, .pitchY = 2.0_nm};
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            map.heights.push_back(
                height((column + 0.5) * map.pitchX, (map.rows - row - 0.5) * map.pitchY));
        }
    }
    return fitSurface(map);
}

BSplineSurface flatSurface() {
    return surfaceOf([](double, double) { return 0.0; });
}

/// A ray through a position of the world that comes from 1 um away.
SurfaceRay through(const Vector3& position, const Vector3& towards) {
    return {.origin = position - 1e-6 * towards.normalized(), .direction = towards};
}

TEST(SurfaceRay, MeetsAPlaneWhereItIs) {
    const double slope = 0.3;
    const BSplineSurface surface = surfaceOf([slope](double x, double) { return slope * x; });
    for (const Vector3& towards : {Vector3(0.0, 0.0, -1.0), Vector3(1.0, 0.3, -0.8),
                                   Vector3(-0.7, 0.9, -0.9), Vector3(0.2, -1.0, -0.25)}) {
        const Vector3 position(50.0_nm, 71.0_nm, slope * 50.0_nm);
        const auto hit = firstHit(surface, through(position, towards), kLow, kHigh);
        ASSERT_TRUE(hit) << towards.transpose();
        EXPECT_LT((*hit - position).norm(), 1e-15) << towards.transpose();
    }
}

TEST(SurfaceRay, MeetsTheNearSideOfASphere) {
    // A ball of 400 nm whose top stands 8 nm out of a level sample, on pixels of 1 nm.
    const double radius = 400.0_nm;
    const Vector3 center(64.0_nm, 64.0_nm, 8.0_nm - radius);
    HeightMap map{.columns = 128, .rows = 128, .pitchX = 1.0_nm, .pitchY = 1.0_nm};
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            const double x = column + 0.5 - 64.0;
            const double y = row + 0.5 - 64.0;
            map.heights.push_back(center.z() +
                                  std::sqrt(radius * radius - 1e-18 * (x * x + y * y)));
        }
    }
    const BSplineSurface surface = fitSurface(map);
    for (const Vector3& towards : {Vector3(0.0, 0.0, -1.0), Vector3(1.0, 0.4, -0.6)}) {
        const SurfaceRay ray = through({70.0_nm, 66.0_nm, 9.0_nm}, towards);
        const auto hit = firstHit(surface, ray, kLow, kHigh);
        ASSERT_TRUE(hit);
        const Vector3 arm = ray.origin - center;
        const Vector3 way = ray.direction.normalized();
        const double half = arm.dot(way);
        const double along = -half - std::sqrt(half * half - arm.squaredNorm() + radius * radius);
        EXPECT_LT((*hit - (ray.origin + along * way)).norm(), 1e-9 * 1e-3)
            << "far below 1 nm; the rest is the spline's";
    }
}

TEST(SurfaceRay, SeesTheHillBeforeWhatItHides) {
    const BSplineSurface surface = surfaceOf(
        [](double x, double) { return 10.0_nm * std::sin(2.0 * std::numbers::pi * x / 60.0_nm); });
    const SurfaceRay level{.origin = {-50.0_nm, 64.0_nm, 12.0_nm}, .direction = {1.0, 0.0, -0.05}};
    const auto hit = firstHit(surface, level, kLow, kHigh);
    ASSERT_TRUE(hit);
    EXPECT_LT(hit->x(), 16.0_nm) << "the first crest";
    EXPECT_NEAR(hit->z(), 12.0_nm - 0.05 * (hit->x() + 50.0_nm), 1e-14);
}

TEST(SurfaceRay, MeetsNothingBesideTheRectangleOrThroughTheCutFace) {
    const BSplineSurface surface = flatSurface();
    const Vector3 down = -Vector3::UnitZ();
    EXPECT_FALSE(firstHit(surface, {{-1.0_nm, 64.0_nm, 1e-6}, down}, kLow, kHigh));
    EXPECT_FALSE(firstHit(surface, {{64.0_nm, 64.0_nm, 1e-6}, Vector3::UnitZ()}, kLow, kHigh));
    EXPECT_TRUE(firstHit(surface, {{64.0_nm, 64.0_nm, 1e-6}, down}, kLow, kHigh));
    const SurfaceRay intoTheWall{.origin = {-20.0_nm, 64.0_nm, -1.0_nm},
                                 .direction = {1.0, 0.0, 0.2}};
    EXPECT_FALSE(firstHit(surface, intoTheWall, kLow, kHigh));
    const Vector2 low(60.0_nm, 60.0_nm);
    EXPECT_FALSE(firstHit(surface, {{30.0_nm, 64.0_nm, 1e-6}, down}, low, kHigh));
}

TEST(SurfaceRay, OfNoDirectionMeetsNothing) {
    const BSplineSurface surface = flatSurface();
    EXPECT_FALSE(firstHit(surface, {{64.0_nm, 64.0_nm, 1e-6}, Vector3::Zero()}, kLow, kHigh));
    EXPECT_FALSE(firstHit(surface, {{64.0_nm, NAN, 1e-6}, -Vector3::UnitZ()}, kLow, kHigh));
}

}  // namespace
}  // namespace asperity
