#include "core/surface/closest/ClosestPointTracker.h"

#include "core/surface/closest/BoundsWindow.h"
#include "core/surface/closest/ClosestPointSearch.h"
#include "core/surface/closest/ContactPoints.h"
#include "core/surface/closest/ExhaustiveSearch.h"
#include "core/surface/closest/LocalClosestPoint.h"
#include "tests/core/surface/closest/RoughSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace asperity {
namespace {

using test::RoughMap;

Vector3 randomDirection(Random& random) {
    const Vector3 direction(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                            random.uniform(-1.0, 1.0));
    return direction / std::max(direction.norm(), 1e-3);
}

void expectSamePoint(const ClosestPoint& a, const ClosestPoint& b) {
    EXPECT_EQ(a.point, b.point);
    EXPECT_EQ(a.distance, b.distance);
    EXPECT_EQ(a.normal, b.normal);
    EXPECT_EQ(a.curvatures.largest, b.curvatures.largest);
    EXPECT_EQ(a.curvatures.smallest, b.curvatures.smallest);
    EXPECT_EQ(a.proof, b.proof);
}

/// Those that were sought: which others are found on the way depends on what was known before.
std::vector<ClosestPoint> within(const ClosestPointList& points, const SearchReach& reach) {
    std::vector<ClosestPoint> sought;
    std::ranges::copy_if(points.all(), std::back_inserter(sought), [&](const ClosestPoint& point) {
        return std::abs(point.distance) <= reach.limit(points.all().front());
    });
    return sought;
}

class ClosestPointTrackerOn : public testing::TestWithParam<RoughMap> {
protected:
    [[nodiscard]] Vector3 someQuery() {
        const Vector2 under = test::positionOn(surface_, random_);
        const double height = std::pow(10.0, random_.uniform(-0.5, 1.6)) * 1.0_nm;
        return {under.x(), under.y(), surface_.at(under.x(), under.y()).height + height};
    }
    /// Slides in steps of all sizes, turning now and then, with a jump in between.
    [[nodiscard]] Vector3 slid(const Vector3& query) {
        if (random_.uniform() < 0.01) {
            return someQuery();
        }
        if (random_.uniform() < 0.05) {
            direction_ = randomDirection(random_);
            step_ = std::pow(10.0, random_.uniform(-4.0, 0.0)) * 1.0_nm;
        }
        return query + step_ * direction_;
    }

    BSplineSurface surface_ = surfaceOf(GetParam());
    Random random_{17};
    Vector3 direction_ = Vector3::UnitX();
    double step_ = 0.01_nm;
};

/// A tracker saves time and changes nothing: the same bits come out.
TEST_P(ClosestPointTrackerOn, SaysWhatASearchOfItsOwnSays) {
    ClosestPointTracker forPoint;
    ClosestPointTracker forTip;
    SearchGuess guess;
    std::vector<SearchGuess> known;
    Vector3 query = someQuery();
    for (int i = 0; i < 3000; ++i) {
        const ClosestPoint closest = closestPoint(surface_, query, guess, forPoint);
        expectSamePoint(closest, closestPoint(surface_, query, guess));
        const TipSphere tip{.center = query, .radius = 8.0_nm};
        const ContactPoints points = contactPoints(surface_, tip, {10.0_nm}, known, forTip);
        const ContactPoints alone = contactPoints(surface_, tip, 10.0_nm, known);
        EXPECT_EQ(points.proof, alone.proof);
        ASSERT_EQ(points.list.all().size(), alone.list.all().size()) << query.transpose();
        known.clear();
        for (std::size_t k = 0; k < points.list.all().size(); ++k) {
            expectSamePoint(points.list.all()[k], alone.list.all()[k]);
            known.push_back(points.list.all()[k].guess());
        }
        guess = closest.guess();
        query = slid(query);
        ASSERT_FALSE(HasFailure()) << "query " << i;
    }
}

/// One that serves searches of several reaches in turn, too.
TEST_P(ClosestPointTrackerOn, ServesSeveralReaches) {
    ClosestPointTracker tracker;
    SearchGuess guess;
    Vector3 query = someQuery();
    for (int i = 0; i < 1500; ++i) {
        const ClosestPoint closest = closestPoint(surface_, query, guess, tracker);
        expectSamePoint(closest, closestPoint(surface_, query, guess));
        guess = closest.guess();
        const TipSphere tip{.center = query, .radius = 8.0_nm};
        const ContactPoints points = contactPoints(surface_, tip, {3.0_nm}, {}, tracker);
        const ContactPoints alone = contactPoints(surface_, tip, 3.0_nm, {});
        EXPECT_EQ(points.proof, alone.proof);
        ASSERT_EQ(points.list.all().size(), alone.list.all().size()) << query.transpose();
        for (std::size_t k = 0; k < points.list.all().size(); ++k) {
            expectSamePoint(points.list.all()[k], alone.list.all()[k]);
        }
        query = slid(query);
        ASSERT_FALSE(HasFailure()) << "query " << i;
    }
}

/// Wherever in the ball a query lies that has a closest point in its anchor: no other closest point
/// is in reach but in the cells that the ball leaves open.
TEST_P(ClosestPointTrackerOn, ABallHoldsForAllItsQueries) {
    int settled = 0;
    int open = 0;
    for (int i = 0; i < 5000; ++i) {
        const Vector3 query = someQuery();
        ClosestPointList points;
        points.add(localClosestPoint(surface_, query, {}), 0.0);
        const SearchReach reach{.behindNearest = random_.uniform(0.0, 3.0) * 1.0_nm};
        const double radius = std::pow(10.0, random_.uniform(-2.0, 0.3)) * 1.0_nm;
        ProvenBall ball;
        (void)completePoints(surface_, {query, radius}, reach, points, ball);
        for (int k = 0; k < 20 && ball.queries.radius > 0.0; ++k) {
            const double moved = k % 2 == 0 ? radius : radius * random_.uniform();
            const Vector3 near = query + 0.999999 * moved * randomDirection(random_).normalized();
            ClosestPointList there;
            there.add(localClosestPoint(surface_, near, points.all().front().guess()), 0.0);
            const ClosestPoint anchor = there.all().front();
            if (!ball.covers(near, reach, anchor)) {
                continue;
            }
            ClosestPointList inBall = there;
            const SearchProof proof = completePoints(surface_, near, reach, there);
            ASSERT_EQ(completePoints(surface_, near, reach, ball, inBall), proof);
            const auto found = within(there, reach);
            const auto foundInBall = within(inBall, reach);
            ASSERT_EQ(foundInBall.size(), found.size()) << near.transpose();
            for (std::size_t point = 0; point < found.size(); ++point) {
                ASSERT_EQ(foundInBall[point].point, found[point].point);
            }
            (ball.open.empty() ? settled : open) += 1;
        }
    }
    EXPECT_GT(settled, 100);
    EXPECT_GT(open, 100);
}

/// What is settled for a ball is settled for its highest and its lowest query, too.
TEST_P(ClosestPointTrackerOn, ABallSettlesNoMoreThanItsQueriesDo) {
    int settled = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vector3 query = someQuery();
        const ClosestPoint closest = localClosestPoint(surface_, query, {});
        const double radius = std::pow(10.0, random_.uniform(-1.0, 0.7)) * 1.0_nm;
        const double distance = std::abs(closest.distance);
        const BoundsWindow ball(surface_, query, distance + 2.0 * radius, radius);
        const auto around = [&](const BoundsWindow& window) {
            return window.settledAround(window.rowAt(closest.point.y()),
                                        window.columnAt(closest.point.x()));
        };
        const int ofBall = around(ball);
        settled += ofBall >= 0 ? 1 : 0;
        for (const double up : {radius, -radius}) {
            const BoundsWindow window(surface_, query + Vector3(0.0, 0.0, up), distance + radius);
            ASSERT_TRUE(ofBall < 0 || around(window) >= ofBall) << query.transpose();
        }
    }
    EXPECT_GT(settled, 20);
}

TEST_P(ClosestPointTrackerOn, ABallSaysNothingOfOtherQueries) {
    const Vector3 query = someQuery();
    const ClosestPoint closest = localClosestPoint(surface_, query, {});
    const double far = std::abs(closest.distance);
    const ProvenBall ball{.queries = {.center = query, .radius = 0.1_nm},
                          .reach = far + 0.5_nm,
                          .anchor = {.low = closest.point.head<2>() - Vector2::Constant(1.0_nm),
                                     .high = closest.point.head<2>() + Vector2::Constant(1.0_nm)}};
    ASSERT_TRUE(closest.converged);
    EXPECT_TRUE(ball.covers(query, {.behindNearest = 0.4_nm}, closest));
    EXPECT_FALSE(ball.covers(query, {.behindNearest = 0.6_nm}, closest)) << "reaches beyond";
    EXPECT_TRUE(ball.covers(query, {.farthest = far, .behindNearest = 0.6_nm}, closest));
    EXPECT_FALSE(ball.covers(query + Vector3(0.0, 0.0, 0.11_nm), {}, closest)) << "outside";
    ClosestPoint other = closest;
    other.point.x() += 1.1_nm;
    EXPECT_FALSE(ball.covers(query, {}, other)) << "another foot";
    other = closest;
    other.converged = false;
    EXPECT_FALSE(ball.covers(query, {}, other)) << "no foot";
}

std::vector<RoughMap> slidOver() {
    return {{.name = "Gentle", .columns = 60, .rows = 50, .range = 20.0_nm, .smoothing = 2.5},
            {.name = "Rough", .columns = 60, .rows = 50, .range = 8.0_nm, .smoothing = 1.0},
            {.name = "Steep", .columns = 40, .rows = 50, .range = 60.0_nm, .smoothing = 1.5},
            {.name = "NarrowPixels",
             .columns = 80,
             .rows = 30,
             .pitchX = 0.7_nm,
             .range = 10.0_nm,
             .smoothing = 2.0}};
}

TEST(ClosestPointTrackerCopy, HoldsTheSameProofs) {
    const BSplineSurface surface = surfaceOf(slidOver().front());
    ClosestPointTracker tracker;
    ClosestPointTracker assigned;
    Vector3 query(0.3 * surface.sizeX(), 0.5 * surface.sizeY(), surface.bounds().all().highest);
    int settled = 0;
    for (int i = 0; i < 1000; ++i) {
        const ClosestPoint closest = closestPoint(surface, query, {}, tracker);
        const ClosestPointTracker copied = tracker;
        assigned = tracker;
        const auto isSettledBy = [&](const ClosestPointTracker& any) {
            return any.settles(surface, query, {}, SearchEffort::Certified, closest);
        };
        EXPECT_EQ(isSettledBy(copied), isSettledBy(tracker));
        EXPECT_EQ(isSettledBy(assigned), isSettledBy(tracker));
        settled += isSettledBy(tracker) && !isSettledBy(ClosestPointTracker()) ? 1 : 0;
        query.x() += 0.02_nm;
    }
    EXPECT_GT(settled, 100);
}

INSTANTIATE_TEST_SUITE_P(Maps, ClosestPointTrackerOn, testing::ValuesIn(slidOver()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace asperity
