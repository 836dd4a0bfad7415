#include "core/Random.h"
#include "core/Units.h"
#include "core/surface/closest/ClosestPointSearch.h"
#include "core/surface/closest/LocalClosestPoint.h"
#include "core/surface/closest/PartSearch.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/synthetic/SyntheticSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace asperity {
namespace {

constexpr int kSpikePixels = 128;
constexpr double kSpikePitch = 4.0_nm;
constexpr int kSpikeRow = 50;
constexpr int kSpikeColumn = 60;

HeightMap roughMap() {
    HeightMap map = flatMap({.columns = kSpikePixels,
                             .rows = kSpikePixels,
                             .sizeX = kSpikePixels * kSpikePitch,
                             .sizeY = kSpikePixels * kSpikePitch});
    Random random(3);
    for (double& height : map.heights) {
        height = random.normal() * 1.0_nm;
    }
    return map;
}

/// A scan with one pixel 1.3 mm above all others: a flipped bit of its file. The spline rings
/// around it, over ten pixels, in walls as steep.
BSplineSurface spiked() {
    HeightMap map = roughMap();
    map.heights[map.index(kSpikeRow, kSpikeColumn)] = 1.3e-3;
    return fitSurface(std::move(map));
}

std::vector<Vector3> queries() {
    const Vector3 spike((kSpikeColumn + 0.5) * kSpikePitch,
                        (kSpikePixels - kSpikeRow - 0.5) * kSpikePitch, 0.0);
    Random random(7);
    std::vector<Vector3> positions;
    for (int i = 0; i < 60; ++i) {
        const double height = std::pow(10.0, random.uniform(-8.0, -2.5));
        positions.push_back(spike +
                            Vector3(random.normal() * 10.0_nm, random.normal() * 10.0_nm, height));
        positions.emplace_back(random.uniform() * kSpikePixels * kSpikePitch,
                               random.uniform() * kSpikePixels * kSpikePitch, height);
    }
    return positions;
}

/// Distance of the nearest pixel center on the surface.
double nearestPixel(const BSplineSurface& surface, const Vector3& query) {
    double nearest = std::numeric_limits<double>::infinity();
    for (int row = 0; row < kSpikePixels; ++row) {
        for (int column = 0; column < kSpikePixels; ++column) {
            const double x = (column + 0.5) * kSpikePitch;
            const double y = (row + 0.5) * kSpikePitch;
            const Vector3 point(x, y, surface.at(x, y).height);
            nearest = std::min(nearest, (point - query).norm());
        }
    }
    return nearest;
}

TEST(Spike, ClosestPointIsNearestOrSaidNotToBe) {
    const BSplineSurface surface = spiked();
    for (const Vector3& query : queries()) {
        const ClosestPoint closest = closestPoint(surface, query, {});
        EXPECT_TRUE(closest.point.allFinite());
        EXPECT_NEAR((closest.point - query).norm(), std::abs(closest.distance), 1e-15);
        const double pixel = nearestPixel(surface, query);
        if (closest.certified()) {
            EXPECT_LE(std::abs(closest.distance), pixel * (1.0 + kSameDistance));
        } else {
            EXPECT_TRUE(mayMissPoints(closest.proof) || closest.proof == SearchProof::NotConverged);
            EXPECT_LE(std::abs(closest.distance), pixel * 1.01) << query.transpose();
        }
    }
}

/// Looks into all cells of a surface.
int evaluationsOf(const BSplineSurface& surface, const Vector3& query) {
    ClosestPointList points;
    points.add(localClosestPoint(surface, query, {}), 0.0);
    PartSearch search(surface, query, {}, points);
    const CellBounds::Level& cells = surface.bounds().level(0);
    for (int row = 0; row < cells.rows; ++row) {
        for (int column = 0; column < cells.columns; ++column) {
            const CellIndex cell{.row = row, .column = column};
            PartBatch batch;
            loadCells(surface.grid(), {&cell, 1}, batch);
            search.lookInto(batch, 1U);
        }
    }
    return search.evaluations();
}

TEST(Spike, SearchesTakeABoundedNumberOfLooks) {
    constexpr int kLastDescent = 100;
    HeightMap steep = roughMap();
    for (double& height : steep.heights) {
        height *= 1e6;
    }
    for (const BSplineSurface& surface : {spiked(), fitSurface(std::move(steep))}) {
        int most = 0;
        for (const Vector3& query : queries()) {
            most = std::max(most, evaluationsOf(surface, query));
        }
        EXPECT_LE(most, PartSearch::kMaxEvaluations + kLastDescent);
    }
}

}  // namespace
}  // namespace asperity
