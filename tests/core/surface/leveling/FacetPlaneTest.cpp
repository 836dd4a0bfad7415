#include "core/Error.h"
#include "core/Units.h"
#include "core/surface/leveling/PlaneFit.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/support/ScanMaps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace asperity {
namespace {

HeightMap tilted(HeightMap map, double slopeX, double slopeY) {
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            map.heights[map.index(row, column)] +=
                slopeX * (column + 0.5) * map.pitchX + slopeY * (map.rows - row - 0.5) * map.pitchY;
        }
    }
    return map;
}

/// Ridges with flanks: their flats cover most of it.
HeightMap obliqueGrating() {
    return sampledMap({.columns = 120, .rows = 80, .sizeX = 1200.0_nm, .sizeY = 1600.0_nm},
                      TrapezoidGrating{.pitch = 400.0_nm,
                                       .depth = 50.0_nm,
                                       .topWidth = 130.0_nm,
                                       .flankWidth = 40.0_nm,
                                       .angle = 0.3});
}

TEST(FacetPlane, OfATiltedPlaneIsThatPlane) {
    const HeightMap flat = flatMap({.columns = 9, .rows = 7, .sizeX = 90.0_nm, .sizeY = 140.0_nm});
    const PlaneFit plane = facetPlane(tilted(flat, 0.02, -0.05));
    EXPECT_NEAR(plane.slopeX, 0.02, 1e-14);
    EXPECT_NEAR(plane.slopeY, -0.05, 1e-14);
    EXPECT_NEAR(plane.at(0.0, 0.0), 0.0, 1e-22);
    EXPECT_EQ(facetPlane(flat).slopeX, 0.0);
}

TEST(FacetPlane, IsThatOfTheFlatsWhereALeastSquaresPlaneIsNot) {
    const HeightMap map = tilted(obliqueGrating(), 0.03, 0.01);
    const PlaneFit facet = facetPlane(map);
    EXPECT_NEAR(facet.slopeX, 0.03, 1e-5);
    EXPECT_NEAR(facet.slopeY, 0.01, 1e-5);
    const PlaneFit least = fitPlane(map);
    EXPECT_GT(std::hypot(least.slopeX - 0.03, least.slopeY - 0.01), 1e-3);
    EXPECT_EQ(facet.mean, least.mean);
}

TEST(FacetPlane, LeavesOutPixelsWithoutData) {
    HeightMap map = tilted(obliqueGrating(), 0.03, 0.01);
    map.heights[map.index(3, 5)] = std::numeric_limits<double>::quiet_NaN();
    map.invalid.assign(map.heights.size(), false);
    for (int column = 0; column < map.columns; ++column) {
        map.invalid[map.index(10, column)] = true;
        map.heights[map.index(10, column)] = 1.0 * column;  // [m]
    }
    EXPECT_NEAR(facetPlane(map).slopeX, 0.03, 1e-5);
    EXPECT_NEAR(facetPlane(map).slopeY, 0.01, 1e-5);
}

/// The same definition, square by square; the first mean agrees with libgwyddion 2.71, which gives
/// these numbers for this map.
TEST(FacetPlane, IsTheFixedPointOfGwyddionsWeightedMean) {
    HeightMap map{.columns = 7, .rows = 6, .pitchX = 2.0, .pitchY = 0.5, .heights = {}};
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            map.heights.push_back(7.0 + 0.6 * column - 0.1 * row +
                                  0.04 * std::sin(0.7 * column + 0.3 * row));
        }
    }
    map.heights[map.index(1, 2)] += 4.0;
    map.heights[map.index(3, 5)] += 2.5;
    const auto next = [&map](const Vector2& slope) {
        std::vector<Vector2> slopes;
        double square = 0.0;
        for (int row = 1; row < map.rows; ++row) {
            for (int column = 1; column < map.columns; ++column) {
                const double a = map.at(row - 1, column - 1);
                const double b = map.at(row - 1, column);
                const double c = map.at(row, column - 1);
                const double d = map.at(row, column);
                slopes.emplace_back((b + d - a - c) / 2.0 / map.pitchX,
                                    (a + b - c - d) / 2.0 / map.pitchY);
                square += (slopes.back() - slope).squaredNorm();
            }
        }
        const double width = square / static_cast<double>(slopes.size()) / 20.0;
        Vector2 sum = Vector2::Zero();
        double weights = 0.0;
        for (const Vector2& one : slopes) {
            const double weight = std::exp(-(one - slope).squaredNorm() / width);
            sum += weight * one;
            weights += weight;
        }
        return Vector2(sum / weights);
    };
    const Vector2 first = next(Vector2::Zero());
    EXPECT_NEAR(first.x(), 0.29425043896177688, 1e-14);
    EXPECT_NEAR(first.y(), 0.20952211866807588, 1e-14);
    const PlaneFit plane = facetPlane(map);
    const Vector2 slope(plane.slopeX, plane.slopeY);
    EXPECT_GT((slope - first).norm(), 1e-5);
    EXPECT_LT((next(slope) - slope).norm(), 1e-6);
}

TEST(FacetPlane, OfSinglePrecisionAgreesWithDouble) {
    const HeightMap map = tilted(obliqueGrating(), 0.03, 0.01);
    const PlaneFit fine = facetPlane(map);
    const PlaneFit coarse = facetPlane(test::singlePrecision(map));
    EXPECT_NEAR(coarse.slopeX, fine.slopeX, 1e-6);
    EXPECT_NEAR(coarse.slopeY, fine.slopeY, 1e-6);
}

TEST(FacetPlane, OfASingleLineIsLevel) {
    const HeightMap line = flatMap({.columns = 5, .rows = 1, .sizeX = 5.0_nm, .sizeY = 1.0_nm});
    EXPECT_EQ(facetPlane(line).slopeX, 0.0);
    EXPECT_THROW((void)facetPlane(HeightMap{}), Error);
}

}  // namespace
}  // namespace asperity
