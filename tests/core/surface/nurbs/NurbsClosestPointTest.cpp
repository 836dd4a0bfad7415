#include "core/surface/nurbs/NurbsClosestPoint.h"

#include "core/Random.h"
#include "core/Units.h"
#include "core/surface/closest/ClosestPointSearch.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/nurbs/NurbsDescent.h"
#include "core/surface/nurbs/NurbsShapes.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/core/surface/nurbs/TiltedFrame.h"
#include "tests/core/surface/nurbs/UnevenNet.h"
#include "tests/support/DoubleLimits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace asperity {
namespace {

using test::kFrame;
using test::kInfinity;
using test::kNan;
using test::kRadius;

/// Knots of a uniform cubic with this many control points, none repeated.
std::vector<double> uniformKnots(int controls) {
    std::vector<double> knots(static_cast<std::size_t>(controls) + 4);
    std::iota(knots.begin(), knots.end(), 0.0);
    return knots;
}

/// A height field as a surface in space, between the outermost pixel centers.
NurbsSurface heightFieldSurface(const BSplineSurface& field) {
    const int columns = field.grid().columns;
    const int rows = field.grid().rows;
    NurbsSurface::Net net{.degreeU = 3,
                          .degreeV = 3,
                          .knotsU = uniformKnots(columns + 2),
                          .knotsV = uniformKnots(rows + 2),
                          .points = {},
                          .weights = {}};
    for (int row = -1; row <= rows; ++row) {
        for (int column = -1; column <= columns; ++column) {
            net.points.emplace_back((column + 0.5) * field.grid().pitchX,
                                    (row + 0.5) * field.grid().pitchY, field.control(row, column));
        }
    }
    return NurbsSurface(net);
}

Vector3 onUnitSphere(Random& random) {
    return Vector3(random.normal(), random.normal(), random.normal()).normalized();
}

/// The closest point, which must be proven, of unit normal, and on the surface where u, v say.
NurbsClosestPoint provenPoint(const NurbsSurface& surface, const Vector3& query) {
    const NurbsClosestPoints points = nearestPoints(surface, query, {});
    EXPECT_EQ(points.proof(), SearchProof::Nearest);
    const NurbsClosestPoint& closest = points.nearest();
    EXPECT_TRUE(closest.closest.certified());
    EXPECT_TRUE(closest.closest.converged);
    EXPECT_NEAR(closest.closest.normal.norm(), 1.0, 1e-14);
    EXPECT_EQ(closest.closest.point, surface.at(closest.u, closest.v).point);
    return closest;
}

TEST(NurbsClosestPoint, OfASphereLiesOnTheLineFromItsCenter) {
    const NurbsSurface sphere = sphereSurface(kFrame, kRadius);
    Random random(1);
    for (const double distance : {1.0_pm, 15.0_nm, 3.0 * kRadius, 1.0, -1.0_pm, -0.9 * kRadius}) {
        for (int i = 0; i < 200; ++i) {
            const Vector3 direction = onUnitSphere(random);
            const Vector3 query = kFrame.center + (kRadius + distance) * direction;
            const NurbsClosestPoint closest = provenPoint(sphere, query);
            const double reach = kRadius + std::abs(distance);
            ASSERT_NEAR(closest.closest.distance, distance, 1e-13 * std::max(kRadius, distance));
            ASSERT_LT((closest.closest.normal - direction).norm(), 1e-10 * reach / kRadius);
            ASSERT_TRUE(closest.closest.insideScan);
        }
    }
}

TEST(NurbsClosestPoint, OfASphereIsAsGoodAtThePolesAndOnTheSeam) {
    const NurbsSurface sphere = sphereSurface(kFrame, kRadius);
    const Vector3 pole = kFrame.axis();
    for (const double sign : {1.0, -1.0}) {
        for (const double off : {0.0, 1e-16, 1e-12, 1e-9, 1e-6, 1e-4, 1e-2}) {
            for (const double turn : {0.1, 2.0, 3.0, 5.9}) {
                const Vector3 around =
                    std::cos(turn) * kFrame.first + std::sin(turn) * kFrame.second;
                const Vector3 direction = (sign * pole + off * around).normalized();
                const NurbsClosestPoint closest =
                    provenPoint(sphere, kFrame.center + 1.1 * kRadius * direction);
                EXPECT_NEAR(closest.closest.distance, 0.1 * kRadius, 1e-13 * kRadius);
                EXPECT_LT((closest.closest.normal - direction).norm(), 1e-10) << off << ' ' << turn;
                EXPECT_TRUE(closest.closest.insideScan);
            }
        }
    }
    for (const double off : {-1e-3, -1e-9, -1e-12, -1e-15, 0.0, 1e-15, 1e-12, 1e-9, 1e-3}) {
        const Vector3 direction = (kFrame.first + off * kFrame.second + 0.3 * pole).normalized();
        const NurbsClosestPoint closest =
            provenPoint(sphere, kFrame.center + 1.1 * kRadius * direction);
        EXPECT_NEAR(closest.closest.distance, 0.1 * kRadius, 1e-13 * kRadius);
        EXPECT_LT((closest.closest.normal - direction).norm(), 1e-12);
        EXPECT_TRUE(closest.closest.insideScan);
    }
}

TEST(NurbsClosestPoint, OnAPlaneOfEightyDegreesLiesAlongTheNormal) {
    const double slope = 80.0 * std::numbers::pi / 180.0;
    const Vector3 up(std::cos(slope), 0.0, std::sin(slope));
    const NurbsSurface plane =
        planeSurface(Vector3::Zero(), 300.0_nm * up, 300.0_nm * Vector3::UnitY());
    const Vector3 normal(-std::sin(slope), 0.0, std::cos(slope));
    Random random(2);
    for (int i = 0; i < 1000; ++i) {
        const Vector3 point =
            300.0_nm * (random.uniform() * up + random.uniform() * Vector3::UnitY());
        const double distance = 50.0_nm * random.normal();
        const NurbsClosestPoint closest = provenPoint(plane, point + distance * normal);
        ASSERT_NEAR(closest.closest.distance, distance, 1e-13 * 300.0_nm);
        ASSERT_LT((closest.closest.point - point).norm(), 1e-12 * 300.0_nm);
        ASSERT_LT((closest.closest.normal - normal).norm(), 1e-14);
    }
}

TEST(NurbsClosestPoint, BeyondAnEdgeIsHeldBackByIt) {
    const NurbsSurface plane =
        planeSurface(Vector3::Zero(), 100.0_nm * Vector3::UnitX(), 100.0_nm * Vector3::UnitY());
    const NurbsClosestPoint side = provenPoint(plane, Vector3(130.0_nm, 40.0_nm, 40.0_nm));
    EXPECT_FALSE(side.closest.insideScan);
    EXPECT_NEAR(side.closest.distance, 50.0_nm, 1e-12_nm);
    const NurbsClosestPoint corner = provenPoint(plane, Vector3(-20.0_nm, -20.0_nm, -10.0_nm));
    EXPECT_FALSE(corner.closest.insideScan);
    EXPECT_NEAR(corner.closest.distance, -30.0_nm, 1e-12_nm);
}

TEST(NurbsClosestPoint, OfACylinderLiesOnTheLineFromItsAxis) {
    const double length = 5.0 * kRadius;
    const NurbsSurface cylinder = cylinderSurface(kFrame, kRadius, length);
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const double turn = 2.0 * std::numbers::pi * random.uniform();
        const Vector3 out = std::cos(turn) * kFrame.first + std::sin(turn) * kFrame.second;
        const Vector3 axisPoint = kFrame.center + (random.uniform() - 0.5) * length * kFrame.axis();
        const double distance = kRadius * (3.0 * random.uniform() - 0.99);
        const NurbsClosestPoint closest =
            provenPoint(cylinder, axisPoint + (kRadius + distance) * out);
        ASSERT_NEAR(closest.closest.distance, distance, 1e-13 * 5.0 * kRadius);
        ASSERT_LT((closest.closest.normal - out).norm(), 1e-11);
    }
}

/// Signed distance from a torus about the frame's axis, and its nearer rim.
double torusDistance(double radius, double tube, const Vector3& query) {
    const Vector3 arm = query - kFrame.center;
    const double up = arm.dot(kFrame.axis());
    const double out = (arm - up * kFrame.axis()).norm();
    return std::hypot(out - radius, up) - tube;
}

/// Ten thousand queries all over: a certified answer is right, and nearly all are certified.
TEST(NurbsClosestPoint, OfATorusIsNeverCertifiedAndWrong) {
    const double tube = 60.0_nm;
    const NurbsSurface torus = torusSurface(kFrame, kRadius, tube);
    Random random(4);
    int certified = 0;
    for (int i = 0; i < 10000; ++i) {
        const Vector3 query =
            kFrame.center +
            2.5 * kRadius *
                Vector3(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5);
        const NurbsClosestPoints points = nearestPoints(torus, query, {});
        const double expected = torusDistance(kRadius, tube, query);
        ASSERT_NEAR(points.nearest().closest.distance, expected, 2e-13 * kRadius);
        certified += points.nearest().closest.certified() ? 1 : 0;
    }
    EXPECT_EQ(certified, 10000);
}

TEST(NurbsClosestPoint, AtTheCenterOfASphereIsOneOfMany) {
    const NurbsSurface sphere = sphereSurface(kFrame, kRadius);
    const NurbsClosestPoints points = nearestPoints(sphere, kFrame.center, {});
    EXPECT_EQ(points.proof(), SearchProof::TooManyPoints);
    EXPECT_NEAR(points.nearest().closest.distance, -kRadius, 1e-13 * kRadius);
    const NurbsSurface cylinder = cylinderSurface(kFrame, kRadius, kRadius);
    const NurbsClosestPoints line = nearestPoints(cylinder, kFrame.center, {});
    EXPECT_EQ(line.proof(), SearchProof::TooManyPoints);
    EXPECT_NEAR(line.nearest().closest.distance, -kRadius, 1e-13 * kRadius);
}

TEST(NurbsClosestPoint, OnASurfaceHasNoDistance) {
    const NurbsSurface sphere = sphereSurface(kFrame, kRadius);
    Random random(5);
    for (int i = 0; i < 200; ++i) {
        const NurbsClosestPoint closest =
            provenPoint(sphere, sphere.at(random.uniform(), random.uniform()).point);
        ASSERT_NEAR(closest.closest.distance, 0.0, 1e-14 * kRadius);
    }
    EXPECT_NEAR(provenPoint(sphere, sphere.at(0.3, 1.0).point).closest.distance, 0.0,
                1e-14 * kRadius);
}

TEST(NurbsClosestPoint, FarAwayIsStillTheNearestPoint) {
    const NurbsSurface sphere = sphereSurface(kFrame, kRadius);
    Random random(6);
    for (const double distance : {1e-3, 1.0, 1e3}) {
        for (int i = 0; i < 20; ++i) {
            const Vector3 direction = onUnitSphere(random);
            const NurbsClosestPoint closest =
                provenPoint(sphere, kFrame.center + distance * direction);
            ASSERT_NEAR(closest.closest.distance, distance - kRadius, 1e-15 * distance);
        }
    }
    EXPECT_TRUE(std::isfinite(
        nearestPoints(sphere, Vector3(1e49, -1e49, 1e49), {}).nearest().closest.distance));
}

TEST(NurbsClosestPoint, OfNoPointIsMeaningless) {
    const NurbsSurface sphere = sphereSurface(kFrame, kRadius);
    for (const double value : {kNan, kInfinity, -kInfinity, 1e60}) {
        const NurbsClosestPoints points = nearestPoints(sphere, Vector3(0.0, value, 0.0), {});
        EXPECT_EQ(points.proof(), SearchProof::NotConverged);
        EXPECT_FALSE(points.nearest().closest.certified());
        EXPECT_TRUE(points.nearest().closest.point.allFinite());
    }
}

/// In a groove between two equal slopes there are two closest points, as a tip meets them.
TEST(NurbsClosestPoint, InAGrooveIsOneOfTwo) {
    NurbsSurface::Net net{.degreeU = 1,
                          .degreeV = 1,
                          .knotsU = {0.0, 0.0, 1.0, 2.0, 2.0},
                          .knotsV = {0.0, 0.0, 1.0, 1.0},
                          .points = {},
                          .weights = {}};
    for (const double y : {0.0, 100.0_nm}) {
        net.points.emplace_back(-50.0_nm, y, 50.0_nm);
        net.points.emplace_back(0.0, y, 0.0);
        net.points.emplace_back(50.0_nm, y, 50.0_nm);
    }
    const NurbsSurface groove(net);
    const double distance = 20.0_nm * std::numbers::sqrt2 / 2.0;
    const NurbsClosestPoints points = nearestPoints(groove, Vector3(0.0, 40.0_nm, 20.0_nm),
                                                    {.within = 15.0_nm, .sameWithin = 0.3_nm});
    ASSERT_EQ(points.all().size(), 2U);
    EXPECT_EQ(points.proof(), SearchProof::Nearest);
    for (const NurbsClosestPoint& closest : points.all()) {
        EXPECT_NEAR(closest.closest.distance, distance, 1e-12_nm);
        EXPECT_NEAR(std::abs(closest.closest.point.x()), 10.0_nm, 1e-12_nm);
    }
    const Vector3 aside(1.0_nm, 40.0_nm, 20.0_nm);
    EXPECT_EQ(nearestPoints(groove, aside, {.within = 14.5_nm}).all().size(), 1U);
    EXPECT_EQ(nearestPoints(groove, aside, {.within = 15.5_nm}).all().size(), 2U);
}

TEST(NurbsClosestPoint, ARidgeIsNearestToAllThatIsAboveIt) {
    const NurbsSurface roof({.degreeU = 1,
                             .degreeV = 1,
                             .knotsU = {0.0, 0.0, 1.0, 2.0, 2.0},
                             .knotsV = {0.0, 0.0, 1.0, 1.0},
                             .points = {{-50.0_nm, 0.0, 0.0},
                                        {0.0, 0.0, 50.0_nm},
                                        {50.0_nm, 0.0, 0.0},
                                        {-50.0_nm, 100.0_nm, 0.0},
                                        {0.0, 100.0_nm, 50.0_nm},
                                        {50.0_nm, 100.0_nm, 0.0}},
                             .weights = {}});
    for (const double aside : {0.0, 3.0_nm, -9.0_nm}) {
        const NurbsClosestPoints points = nearestPoints(roof, Vector3(aside, 30.0_nm, 60.0_nm), {});
        EXPECT_EQ(points.proof(), SearchProof::Nearest);
        EXPECT_NEAR(points.nearest().closest.distance, std::hypot(aside, 10.0_nm), 1e-12_nm);
    }
}

/// Not one shape of these is symmetric: the proof is held against a dense sampling.
TEST(NurbsClosestPoint, OfAWildSurfaceIsNoFartherThanAnySample) {
    Random random(7);
    for (int shape = 0; shape < 60; ++shape) {
        // One after the other: the numbers are drawn in this order.
        const NurbsSurface surface(test::unevenNet([&random](int i, int j) {
            const double x = 10.0_nm * i + 4.0_nm * random.normal();
            const double y = 10.0_nm * j + 4.0_nm * random.normal();
            const double z = 8.0_nm * random.normal();
            return test::WeightedPoint{Vector3(x, y, z), std::exp(0.5 * random.normal())};
        }));
        for (int i = 0; i < 20; ++i) {
            const Vector3 query(60.0_nm * random.uniform(), 40.0_nm * random.uniform(),
                                20.0_nm * random.normal());
            const NurbsClosestPoints points = nearestPoints(surface, query, {});
            EXPECT_EQ(points.proof(), SearchProof::Nearest);
            const double found = std::abs(points.nearest().closest.distance);
            double sampled = 1.0;
            constexpr int kSamples = 40;
            for (int k = 0; k <= kSamples; ++k) {
                for (int l = 0; l <= kSamples; ++l) {
                    const double u = static_cast<double>(k) / kSamples;
                    const double v = static_cast<double>(l) / kSamples;
                    sampled = std::min(sampled, (surface.at(u, v).point - query).norm());
                }
            }
            ASSERT_LE(found, sampled * (1.0 + 1e-13));
            const NurbsDescent descent(surface, query);
            for (int start = 0; start < 8; ++start) {
                const NurbsMinimum other =
                    descent.from(Vector2(random.uniform(), random.uniform()));
                ASSERT_LE(found, other.distance + 1e-13 * 60.0_nm);
            }
            ASSERT_GT(found, sampled - 2.5_nm);
        }
    }
}

TEST(NurbsClosestPoint, OfAHeightFieldIsThatOfTheHeightField) {
    const BSplineSurface field =
        fitSurface(sampledMap({.columns = 40, .rows = 30, .sizeX = 80.0_nm, .sizeY = 60.0_nm},
                              EggBox{.amplitude = 3.0_nm, .periodX = 30.0_nm, .periodY = 25.0_nm}));
    const NurbsSurface surface = heightFieldSurface(field);
    Random random(8);
    for (int i = 0; i < 500; ++i) {
        const Vector3 query(80.0_nm * (0.1 + 0.8 * random.uniform()),
                            60.0_nm * (0.1 + 0.8 * random.uniform()),
                            4.0_nm + 6.0_nm * random.uniform());
        const NurbsClosestPoint closest = provenPoint(surface, query);
        const ClosestPoint expected = closestPoint(
            field, query,
            {.x = closest.closest.point.x(), .y = closest.closest.point.y(), .valid = true});
        ASSERT_TRUE(expected.converged);
        ASSERT_NEAR(closest.closest.distance, expected.distance, 1e-13 * 80.0_nm);
        ASSERT_LT((closest.closest.point - expected.point).norm(), 1e-11 * 80.0_nm);
        ASSERT_LT((closest.closest.normal - expected.normal).norm(), 1e-10);
        const HeightSample sample = field.at(expected.point.x(), expected.point.y());
        const PrincipalCurvatures bend = surface.curvatures(closest.u, closest.v);
        ASSERT_NEAR(bend.largest, principalCurvatures(sample).largest, 1e-9 / 1.0_nm);
        ASSERT_NEAR(bend.smallest, principalCurvatures(sample).smallest, 1e-9 / 1.0_nm);
    }
}

/// Seven flat sides of a trough, each as near to its axis as the next.
TEST(NurbsClosestPoint, MoreThanHaveRoomAreTooManyPoints) {
    constexpr int kSides = 7;
    NurbsSurface::Net net{.degreeU = 1, .degreeV = 1, .knotsV = {0.0, 0.0, 1.0, 1.0}};
    net.knotsU.push_back(0.0);
    for (int i = 0; i <= kSides; ++i) {
        net.knotsU.push_back(i);
    }
    net.knotsU.push_back(kSides);
    for (const double y : {0.0, 100.0_nm}) {
        for (int i = 0; i <= kSides; ++i) {
            const double angle = std::numbers::pi * (1.0 + static_cast<double>(i) / kSides);
            net.points.emplace_back(20.0_nm * std::cos(angle), y, 20.0_nm * std::sin(angle));
        }
    }
    const NurbsSurface trough(net);
    const Vector3 axis(0.1_nm, 50.0_nm, 0.2_nm);
    EXPECT_EQ(nearestPoints(trough, axis, {}).proof(), SearchProof::Nearest);
    const NurbsClosestPoints points = nearestPoints(trough, axis, {.within = 25.0_nm});
    EXPECT_EQ(points.all().size(), kMaxContactPoints);
    EXPECT_EQ(points.proof(), SearchProof::TooManyPoints);
}

}  // namespace
}  // namespace asperity
