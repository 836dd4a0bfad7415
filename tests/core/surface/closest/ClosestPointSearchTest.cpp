#include "core/surface/closest/ClosestPointSearch.h"

#include "core/Units.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/support/DoubleLimits.h"
#include "tests/support/StorageError.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

using test::kInfinity;
using test::kNan;

constexpr double kQuadricSize = 100.0_nm;
constexpr ScanSize kQuadricScan{
    .columns = 40, .rows = 50, .sizeX = kQuadricSize, .sizeY = kQuadricSize};

/// z = slopeX x + slopeY y + bendX x^2 / 2 + bendY y^2 / 2 about the scan's center: a shape that
/// the spline holds but for the rounding of its control heights.
struct Quadric {
    double slopeX = 0.0;
    double slopeY = 0.0;
    double bendX = 0.0;  ///< [1/m]
    double bendY = 0.0;  ///< [1/m]

    [[nodiscard]] double height(double x, double y) const {
        const double s = x - 0.5 * kQuadricSize;
        const double t = y - 0.5 * kQuadricSize;
        return slopeX * s + slopeY * t + 0.5 * (bendX * s * s + bendY * t * t);
    }
    [[nodiscard]] Vector3 point(double x, double y) const { return {x, y, height(x, y)}; }
    [[nodiscard]] Vector3 normal(double x, double y) const {
        return Vector3(-slopeX - bendX * (x - 0.5 * kQuadricSize),
                       -slopeY - bendY * (y - 0.5 * kQuadricSize), 1.0)
            .normalized();
    }
};

BSplineSurface quadricSurface(const Quadric& shape) {
    return fitSurface(sampledMap(kQuadricScan, shape));
}

SearchGuess guessAt(double x, double y) { return {.x = x, .y = y, .valid = true}; }

/// How far a closest point may lie off because the surface is kept in single precision: what a
/// change of slope moves it by at this distance, ten times that close to a center of curvature.
double closestPointError(const BSplineSurface& surface, double distance) {
    const test::StorageError storage = test::storageErrorOf(surface);
    return 10.0 * (storage.height + std::abs(distance) * storage.slope);
}

struct ExpectedClosestPoint {
    Vector3 point;
    Vector3 normal;
    double distance = 0.0;  ///< [m]
};

void expectPoint(const BSplineSurface& surface, const ClosestPoint& closest,
                 const ExpectedClosestPoint& expected) {
    constexpr double kMaxBend = 1.0 / 20.0_nm;
    const test::StorageError storage = test::storageErrorOf(surface);
    const double position = 1e-12 * kQuadricSize + closestPointError(surface, expected.distance);
    EXPECT_TRUE(closest.converged);
    EXPECT_TRUE(closest.insideScan);
    EXPECT_TRUE(closest.certified());
    EXPECT_LT((closest.point - expected.point).norm(), position);
    EXPECT_LT((closest.normal - expected.normal).norm(),
              1e-11 + storage.slope + kMaxBend * position);
    EXPECT_NEAR(closest.distance, expected.distance, 1e-12 * kQuadricSize + storage.height);
}

TEST(ClosestPoint, OnATiltedPlaneLiesAlongTheNormal) {
    for (const double degrees : {0.0, 30.0, 80.0}) {
        const Quadric plane{.slopeX = std::tan(degrees * M_PI / 180.0) * 0.8,
                            .slopeY = std::tan(degrees * M_PI / 180.0) * 0.6};
        const BSplineSurface surface = quadricSurface(plane);
        const Vector3 point = plane.point(40.0_nm, 61.0_nm);
        const Vector3 normal = plane.normal(40.0_nm, 61.0_nm);
        for (const double distance : {15.0_nm, 1.0_pm, 0.0, -2.0_nm}) {
            const Vector3 query = point + distance * normal;
            expectPoint(surface, closestPoint(surface, query, {}), {point, normal, distance});
            expectPoint(surface, closestPoint(surface, query, guessAt(55.0_nm, 20.0_nm)),
                        {point, normal, distance});
        }
    }
}

TEST(ClosestPoint, OnAHillLiesAlongTheNormalAtAnyDistance) {
    const Quadric hill{.slopeX = 0.2, .bendX = -1.0 / 30.0_nm, .bendY = -1.0 / 20.0_nm};
    const BSplineSurface surface = quadricSurface(hill);
    for (const auto& [x, y] : {std::pair{50.0_nm, 50.0_nm}, {33.0_nm, 71.0_nm}}) {
        for (const double distance : {0.0, 15.0_nm, 400.0_nm, -3.0_nm}) {
            const Vector3 normal = hill.normal(x, y);
            const Vector3 query = hill.point(x, y) + distance * normal;
            expectPoint(surface, closestPoint(surface, query, guessAt(x + 3.0_nm, y - 4.0_nm)),
                        {hill.point(x, y), normal, distance});
        }
    }
}

TEST(ClosestPoint, InAValleyLiesAlongTheNormalUpToTheCenterOfCurvature) {
    const Quadric valley{.bendX = 1.0 / 40.0_nm};
    const BSplineSurface surface = quadricSurface(valley);
    const double x = 58.0_nm;
    const double y = 31.0_nm;
    for (const double distance : {15.0_nm, 35.0_nm, -30.0_nm}) {
        const Vector3 normal = valley.normal(x, y);
        const Vector3 query = valley.point(x, y) + distance * normal;
        expectPoint(surface, closestPoint(surface, query, guessAt(x + 1.0_nm, y)),
                    {valley.point(x, y), normal, distance});
    }
}

TEST(ClosestPoint, OnASphericalCapPointsToTheCenter) {
    struct Cap {
        [[nodiscard]] double height(double x, double y) const {
            const double r2 = (x - 0.5 * kQuadricSize) * (x - 0.5 * kQuadricSize) +
                              (y - 0.5 * kQuadricSize) * (y - 0.5 * kQuadricSize);
            return std::sqrt(90.0_nm * 90.0_nm - r2);
        }
    };
    const ScanSize fine{.columns = 200, .rows = 200, .sizeX = kQuadricSize, .sizeY = kQuadricSize};
    const BSplineSurface surface = fitSurface(sampledMap(fine, Cap{}));
    const Vector3 center(0.5 * kQuadricSize, 0.5 * kQuadricSize, 0.0);
    const Vector3 direction = Vector3(0.3, -0.2, 1.0).normalized();
    const ClosestPoint closest = closestPoint(surface, center + 105.0_nm * direction, {});
    EXPECT_TRUE(closest.converged);
    // the spline's own distance from the sphere, and rounding
    const test::StorageError storage = test::storageErrorOf(surface);
    EXPECT_NEAR(closest.distance, 15.0_nm, 1e-7_nm + storage.height);
    EXPECT_LT((closest.normal - direction).norm(), 1e-6 + storage.slope);
}

TEST(ClosestPoint, OfAConvexSurfaceDoesNotDependOnTheStart) {
    const Quadric hill{.slopeX = -0.3, .bendX = -1.0 / 25.0_nm, .bendY = -1.0 / 60.0_nm};
    const BSplineSurface surface = quadricSurface(hill);
    const Vector3 query = hill.point(45.0_nm, 52.0_nm) + 15.0_nm * hill.normal(45.0_nm, 52.0_nm);
    const double tolerance = 1e-12 * kQuadricSize + closestPointError(surface, 15.0_nm);
    const Vector3 first = closestPoint(surface, query, guessAt(45.0_nm, 52.0_nm)).point;
    for (int i = 0; i <= 14; ++i) {
        for (int j = 0; j <= 14; ++j) {
            const ClosestPoint closest =
                closestPoint(surface, query, guessAt(i * 7.0_nm, j * 7.0_nm));
            ASSERT_TRUE(closest.converged);
            ASSERT_LT((closest.point - hill.point(45.0_nm, 52.0_nm)).norm(), tolerance);
            ASSERT_LT((closest.point - first).norm(), 1e-12 * kQuadricSize);
        }
    }
}

TEST(ClosestPoint, LeavesTheBottomOfAValleyThatIsTheFarthestPoint) {
    const double radius = 10.0_nm;
    const Quadric valley{.bendX = 1.0 / radius};
    const BSplineSurface surface = quadricSurface(valley);
    const double height =
        2.5 * radius;  // above the center of curvature: two closest points on the flanks
    const Vector3 query(0.5 * kQuadricSize, 40.0_nm, height);
    const ClosestPoint closest = closestPoint(surface, query, guessAt(0.5 * kQuadricSize, 40.0_nm));
    EXPECT_TRUE(closest.converged);
    const double offset = std::sqrt(2.0 * radius * (height - radius));
    const double tolerance = 1e-11 * kQuadricSize + closestPointError(surface, closest.distance);
    EXPECT_NEAR(std::abs(closest.point.x() - 0.5 * kQuadricSize), offset, tolerance);
    EXPECT_NEAR(closest.point.y(), 40.0_nm, tolerance);
}

TEST(ClosestPoint, BesideTheScanStandsOnItsEdge) {
    const Quadric plane{.slopeX = 0.5};
    const BSplineSurface surface = quadricSurface(plane);
    const Vector3 normal = plane.normal(0.0, 0.0);
    const Vector3 inside = plane.point(99.0_nm, 30.0_nm) + 1.0_nm * normal;
    EXPECT_TRUE(closestPoint(surface, inside, {}).insideScan);

    const Vector3 outside = plane.point(104.0_nm, 30.0_nm) + 10.0_nm * normal;
    const ClosestPoint closest = closestPoint(surface, outside, {});
    EXPECT_FALSE(closest.insideScan);
    EXPECT_TRUE(closest.converged);
    EXPECT_EQ(closest.point.x(), kQuadricSize);
    EXPECT_NEAR(closest.point.y(), 30.0_nm,
                1e-12 * kQuadricSize + closestPointError(surface, closest.distance));
    EXPECT_NEAR(closest.distance, (outside - plane.point(kQuadricSize, 30.0_nm)).norm(),
                1e-12 * kQuadricSize + test::storageErrorOf(surface).height);

    // The query lies over the scan, but its closest point on the continued plane would not.
    const Vector3 overhanging = plane.point(102.0_nm, 30.0_nm) + 10.0_nm * normal;
    ASSERT_LT(overhanging.x(), kQuadricSize);
    EXPECT_FALSE(closestPoint(surface, overhanging, {}).insideScan);
}

TEST(ClosestPoint, BesideACornerStandsOnTheCorner) {
    const BSplineSurface surface = quadricSurface(Quadric{});
    const ClosestPoint closest = closestPoint(surface, Vector3(-5.0_nm, -7.0_nm, 3.0_nm), {});
    EXPECT_EQ(closest.point.x(), 0.0);
    EXPECT_EQ(closest.point.y(), 0.0);
    EXPECT_FALSE(closest.insideScan);
    EXPECT_TRUE(closest.converged);
    EXPECT_NEAR(closest.distance, std::sqrt(83.0) * 1.0_nm, 1e-20);
}

TEST(ClosestPoint, AWarmStartNearTheClosestPointTakesFewSteps) {
    const Quadric hill{.bendX = -1.0 / 30.0_nm, .bendY = 1.0 / 70.0_nm};
    const BSplineSurface surface = quadricSurface(hill);
    const Vector3 query = hill.point(45.0_nm, 52.0_nm) + 15.0_nm * hill.normal(45.0_nm, 52.0_nm);
    const ClosestPoint closest = closestPoint(surface, query, guessAt(45.1_nm, 52.0_nm));
    EXPECT_GE(closest.iterations, 1);
    EXPECT_LE(closest.iterations, 4);
}

TEST(ClosestPoint, OfAQueryThatIsNoPointSaysSo) {
    const BSplineSurface surface = quadricSurface(Quadric{.slopeX = 0.1});
    for (const Vector3& query :
         {Vector3(kNan, 0.0, 0.0), Vector3(0.0, 0.0, kInfinity), Vector3(1e200, 1e200, 1e200)}) {
        const ClosestPoint closest = closestPoint(surface, query, guessAt(1.0_nm, 1.0_nm));
        EXPECT_FALSE(closest.converged);
        EXPECT_TRUE(closest.point.allFinite());
        EXPECT_TRUE(closest.normal.allFinite());
        EXPECT_TRUE(std::isfinite(closest.distance));
    }
    const Vector3 query(50.0_nm, 50.0_nm, 20.0_nm);
    const ClosestPoint fromNan = closestPoint(surface, query, guessAt(kNan, kInfinity));
    EXPECT_EQ(fromNan.point, closestPoint(surface, query, {}).point);
}

}  // namespace
}  // namespace asperity
