#include "core/surface/closest/BoundsWindow.h"

#include "core/surface/closest/LocalClosestPoint.h"
#include "tests/core/surface/closest/RoughSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace asperity {
namespace {

using test::RoughMap;

/// Blocks of a window in which the distance can only grow hold no point nearer than the closest
/// point, and blocks that are left out hold none within the window's distance.
class BoundsWindowOf : public testing::TestWithParam<RoughMap> {
protected:
    BSplineSurface surface_ = surfaceOf(GetParam());
    Random random_{10};

    struct Window {
        const BoundsWindow& bounds;
        int row = 0;     ///< of the closest point's block
        int column = 0;  ///< of the closest point's block
        int settled = -1;
    };
    /// Whether a position lies in a block that is settled around the closest point.
    [[nodiscard]] static bool isSettled(const Window& window, double x, double y) {
        return std::max(std::abs(window.bounds.rowAt(y) - window.row),
                        std::abs(window.bounds.columnAt(x) - window.column)) <= window.settled;
    }
    /// Whether the window holds the position's block and says that it reaches so near.
    [[nodiscard]] static bool isReached(const BoundsWindow& window, double x, double y) {
        const int row = window.rowAt(y);
        const int column = window.columnAt(x);
        return row >= 0 && row < window.rows().count && column >= 0 &&
               column < window.columns().count &&
               ((window.reaching(row) >> static_cast<unsigned>(column)) & 1U) != 0;
    }
};

TEST_P(BoundsWindowOf, LeavesOutNoPositionWithinItsDistanceAndSettlesNoneThatIsNearer) {
    int settled = 0;
    for (int i = 0; i < 60; ++i) {
        const Vector2 under = test::positionOn(surface_, random_);
        const Vector3 query(under.x(), under.y(),
                            surface_.at(under.x(), under.y()).height +
                                std::pow(10.0, random_.uniform(-1.0, 1.8)) * 1.0_nm);
        const ClosestPoint closest = localClosestPoint(surface_, query, {});
        const double distance = std::abs(closest.distance) + 3.0_nm;
        const BoundsWindow bounds(surface_, query, distance);
        const int row = bounds.rowAt(closest.point.y());
        const int column = bounds.columnAt(closest.point.x());
        const Window window{.bounds = bounds,
                            .row = row,
                            .column = column,
                            .settled = bounds.settledAround(row, column)};
        settled += static_cast<int>(window.settled >= 0);
        for (int k = 0; k < 2000; ++k) {
            const Vector2 position = test::positionOn(surface_, random_);
            const Vector3 point(position.x(), position.y(),
                                surface_.at(position.x(), position.y()).height);
            const double away = (point - query).norm();
            if (away <= distance) {
                ASSERT_TRUE(isReached(bounds, position.x(), position.y())) << position.transpose();
                ASSERT_TRUE(bounds.reaches(bounds.rowAt(position.y()),
                                           bounds.columnAt(position.x()), away));
                if (closest.converged && isSettled(window, position.x(), position.y())) {
                    ASSERT_GE(away, std::abs(closest.distance) * (1.0 - kSameDistance));
                    // On the straight line from there the distance only grows.
                    const Vector2 way = position - closest.point.head<2>();
                    const LocalModel there = HalfSquaredDistance(surface_, query)(position);
                    ASSERT_GE(there.gradient.dot(way), -1e-9 * away * way.norm());
                }
            }
        }
    }
    EXPECT_GT(settled, 5);
}

std::vector<RoughMap> windowMaps() {
    return {
        {.name = "Gentle", .columns = 40, .rows = 35, .range = 20.0_nm, .smoothing = 2.0},
        {.name = "Rough", .columns = 40, .rows = 35, .range = 8.0_nm, .smoothing = 0.9},
        {.name = "Wide", .columns = 300, .rows = 40, .range = 30.0_nm, .smoothing = 4.0},
        {.name = "FarOff",
         .columns = 40,
         .rows = 35,
         .range = 5.0_nm,
         .offset = 1e-3,
         .smoothing = 1.0},
        {.name = "Even", .columns = 40, .rows = 35, .range = 1.0_pm},
    };
}

INSTANTIATE_TEST_SUITE_P(Surfaces, BoundsWindowOf, testing::ValuesIn(windowMaps()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace asperity
