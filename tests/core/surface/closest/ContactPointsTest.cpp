#include "core/surface/closest/ContactPoints.h"

#include "core/surface/closest/ClosestPointSearch.h"
#include "core/surface/closest/LocalClosestPoint.h"
#include "tests/core/surface/TestTip.h"
#include "tests/core/surface/closest/RoughSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace asperity {
namespace {

using test::kTipRadius;

constexpr double kReach = 10.0_nm;
/// What a spline through pixels misses of a shape with kinks, ten pixels from them [m].
constexpr double kFit = 1e-3_nm;

constexpr int kScanPixels = 120;
constexpr double kPitch = 1.0_nm;
constexpr double kMiddle = 0.5 * kScanPixels * kPitch;
constexpr ScanSize kScan{.columns = kScanPixels,
                         .rows = kScanPixels,
                         .sizeX = kScanPixels * kPitch,
                         .sizeY = kScanPixels * kPitch};

/// A surface by its height over positions counted from the middle of the scan.
struct Shape {
    std::function<double(double x, double y)> above;

    [[nodiscard]] double height(double x, double y) const {
        return above(x - kMiddle, y - kMiddle);
    }
};

BSplineSurface surfaceOf(const std::function<double(double, double)>& above) {
    return fitSurface(sampledMap(kScan, Shape{above}));
}

/// Contact points of a tip over the middle of the scan.
ContactPoints contactPointsAt(const BSplineSurface& surface, double height) {
    return contactPoints(surface, {.center = {kMiddle, kMiddle, height}, .radius = kTipRadius},
                         kReach, {});
}

/// Whether a closest point stands at (x, y), counted from the middle.
bool standsAt(const ContactPoints& points, double x, double y, double tolerance) {
    return std::ranges::any_of(points.list.all(), [&](const ClosestPoint& closest) {
        return std::hypot(closest.point.x() - kMiddle - x, closest.point.y() - kMiddle - y) <
               tolerance;
    });
}

TEST(ContactPoints, InASymmetricalGrooveStandOnBothFlanks) {
    constexpr double kSlope = 1.0;
    const BSplineSurface groove = surfaceOf([](double x, double) { return kSlope * std::abs(x); });
    const double height = 15.0_nm * std::sqrt(2.0);
    const ContactPoints points = contactPointsAt(groove, height);
    EXPECT_EQ(points.proof, SearchProof::Nearest);
    ASSERT_EQ(points.list.all().size(), 2U);
    EXPECT_TRUE(standsAt(points, 0.5 * height, 0.0, kFit));
    EXPECT_TRUE(standsAt(points, -0.5 * height, 0.0, kFit));
    for (const ClosestPoint& closest : points.list.all()) {
        EXPECT_NEAR(closest.distance, 15.0_nm, kFit);
        EXPECT_EQ(closest.proof, SearchProof::NotSought);
    }
}

TEST(ContactPoints, OnARidgeAreOne) {
    const BSplineSurface ridge =
        surfaceOf([](double x, double) { return -x * x / (2.0 * 8.0_nm); });
    const ContactPoints points = contactPointsAt(ridge, kTipRadius);
    EXPECT_EQ(points.proof, SearchProof::Nearest);
    ASSERT_EQ(points.list.all().size(), 1U);
    EXPECT_TRUE(standsAt(points, 0.0, 0.0, kFit));
}

/// A ball that rises from a level surface. Where it is steeper than 45 degrees, a cone takes its
/// place, so that a spline can follow.
struct Ball {
    Vector3 center = Vector3::Zero();  ///< x and y from the scan's middle [m]
    double radius = 0.0;               ///< [m]

    [[nodiscard]] double height(double x, double y) const {
        const double across = std::hypot(x - center.x(), y - center.y());
        return center.z() + (across < radius * M_SQRT1_2
                                 ? std::sqrt(radius * radius - across * across)
                                 : radius * M_SQRT2 - across);
    }
};

BSplineSurface surfaceOf(const std::vector<Ball>& balls, double level) {
    return surfaceOf([&](double x, double y) {
        double height = level;
        for (const Ball& ball : balls) {
            height = std::max(height, ball.height(x, y));
        }
        return height;
    });
}

TEST(ContactPoints, BetweenTwoParticlesTouchBoth) {
    const std::vector<Ball> balls{{.center = {-22.0_nm, 0.0, 0.0}, .radius = 20.0_nm},
                                  {.center = {22.0_nm, 0.0, 0.0}, .radius = 20.0_nm}};
    const BSplineSurface surface = surfaceOf(balls, 0.0);
    const double height = std::sqrt(35.0 * 35.0 - 22.0 * 22.0) * 1.0_nm;
    const ContactPoints points = contactPointsAt(surface, height);
    EXPECT_EQ(points.proof, SearchProof::Nearest);
    ASSERT_EQ(points.list.all().size(), 2U);
    const double offset = 22.0_nm * 15.0 / 35.0;
    EXPECT_TRUE(standsAt(points, offset, 0.0, 10.0 * kFit));
    EXPECT_TRUE(standsAt(points, -offset, 0.0, 10.0 * kFit));
    EXPECT_NEAR(points.list.all().front().distance, 15.0_nm, kFit);
}

/// Least distance of (0, z) from a curve, by looking at positions 1e-5 nm apart.
double offsetOfNearest(double z, const std::function<double(double)>& curve) {
    double best = 0.0;
    double least = std::hypot(0.0, z - curve(0.0));
    for (double offset = 0.0; offset < 30.0_nm; offset += 1e-5_nm) {
        const double distance = std::hypot(offset, z - curve(offset));
        if (distance < least) {
            least = distance;
            best = offset;
        }
    }
    return best;
}

TEST(ContactPoints, InAPitOfAnEggBoxAreFour) {
    constexpr double kAmplitude = 12.0_nm;
    constexpr double kWave = 2.0 * M_PI / 40.0_nm;
    const BSplineSurface surface = surfaceOf(
        [](double x, double y) { return -kAmplitude * std::cos(kWave * x) * std::cos(kWave * y); });
    const double height = 6.0_nm;
    const double offset =
        offsetOfNearest(height, [](double x) { return -kAmplitude * std::cos(kWave * x); });
    ASSERT_GT(offset, 5.0_nm);
    const ContactPoints points = contactPointsAt(surface, height);
    EXPECT_EQ(points.proof, SearchProof::Nearest);
    ASSERT_EQ(points.list.all().size(), 4U);
    for (const double side : {-offset, offset}) {
        EXPECT_TRUE(standsAt(points, side, 0.0, 10.0 * kFit));
        EXPECT_TRUE(standsAt(points, 0.0, side, 10.0 * kFit));
    }
}

/// Balls of 8 nm in a ring, ball i farther from a point over the middle by behind[i].
struct Ring {
    static constexpr double kRadius = 40.0_nm;
    static constexpr double kBall = 8.0_nm;
    static constexpr double kHeight = 60.0_nm;  ///< of the point over the balls' centers
    static constexpr double kBallReach = 3.0_nm;
    std::vector<double> behind;  ///< [m]

    [[nodiscard]] static double nearest() { return std::hypot(kRadius, kHeight) - kBall; }

    [[nodiscard]] Vector3 center(std::size_t i) const {
        const double turn =
            2.0 * M_PI * (static_cast<double>(i) + 0.2) / static_cast<double>(behind.size());
        const double away = nearest() + kBall + behind[i];
        return {kRadius * std::cos(turn), kRadius * std::sin(turn),
                kHeight - std::sqrt(away * away - kRadius * kRadius)};
    }
    [[nodiscard]] BSplineSurface surface() const {
        std::vector<Ball> balls;
        for (std::size_t i = 0; i < behind.size(); ++i) {
            balls.push_back({.center = center(i), .radius = kBall});
        }
        return surfaceOf(balls, -12.0_nm);
    }
    [[nodiscard]] ContactPoints points() const {
        const BSplineSurface balls = surface();
        return contactPoints(balls, {.center = {kMiddle, kMiddle, kHeight}, .radius = nearest()},
                             kBallReach, {});
    }
    /// Position of the closest point on ball i, from the scan's middle.
    [[nodiscard]] Vector2 closest(std::size_t i) const {
        const double away = nearest() + kBall + behind[i];
        return center(i).head<2>() * (1.0 - kBall / away);
    }
};

TEST(ContactPoints, AreInTheOrderOfTheirDistance) {
    const Ring ring{{0.4_nm, 1.6_nm, 0.0, 2.4_nm, 1.2_nm, 2.0_nm, 0.8_nm}};
    const ContactPoints points = ring.points();
    const std::array<std::size_t, 4> order{2, 0, 6, 4};
    ASSERT_GE(points.list.all().size(), order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const ClosestPoint& closest = points.list.all()[i];
        const Vector2 position = closest.point.head<2>() - Vector2::Constant(kMiddle);
        EXPECT_LT((position - ring.closest(order[i])).norm(), 0.1_nm) << i;
        EXPECT_NEAR(closest.distance, Ring::nearest() + ring.behind[order[i]], 0.01_nm) << i;
    }
}

/// However much nearer another one is: what a point bears is between it and the tip.
TEST(ContactPoints, AreAllWithinReachOfTheTip) {
    const Ring ring{{0.0, 4.2_nm, 2.7_nm}};
    const BSplineSurface balls = ring.surface();
    const auto pointsOf = [&](double radius, double reach) {
        return contactPoints(balls, {.center = {kMiddle, kMiddle, Ring::kHeight}, .radius = radius},
                             reach, {});
    };
    EXPECT_EQ(pointsOf(Ring::nearest(), 3.0_nm).list.all().size(), 2U);
    EXPECT_EQ(pointsOf(Ring::nearest() + 4.3_nm, 0.0).list.all().size(), 3U) << "the tip presses";
    const ContactPoints all = pointsOf(Ring::nearest(), 4.3_nm);
    EXPECT_EQ(all.proof, SearchProof::Nearest);
    ASSERT_EQ(all.list.all().size(), 3U);
    EXPECT_NEAR(all.list.all()[2].distance, Ring::nearest() + 4.2_nm, 0.01_nm);
}

TEST(ContactPoints, SaveTimeButChangeNothingWithKnownGuesses) {
    const Ring ring{{0.4_nm, 1.6_nm, 0.0, 2.4_nm}};
    const BSplineSurface surface = ring.surface();
    const TipSphere tip{.center = {kMiddle, kMiddle, Ring::kHeight}, .radius = Ring::nearest()};
    const ContactPoints cold = contactPoints(surface, tip, Ring::kBallReach, {});
    ASSERT_EQ(cold.list.all().size(), 4U);
    std::vector<SearchGuess> known;
    for (const ClosestPoint& closest : cold.list.all()) {
        known.insert(known.begin(), closest.guess());
    }
    const ContactPoints warm = contactPoints(surface, tip, Ring::kBallReach, known);
    EXPECT_EQ(warm.proof, SearchProof::Nearest);
    ASSERT_EQ(warm.list.all().size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_LT((warm.list.all()[i].point - cold.list.all()[i].point).norm(), 1e-9 * kPitch);
    }
}

TEST(ContactPoints, AreFoundThoughTheKnownGuessLeadsFarAway) {
    const BSplineSurface wall = surfaceOf(
        [](double x, double) { return 30.0_nm * (1.0 + std::tanh((x - 45.0_nm) / 2.0_nm)); });
    const Vector3 query(kMiddle, kMiddle, kTipRadius);
    const SearchGuess onTheWall{kMiddle + 42.5_nm, kMiddle, true};
    ASSERT_GT(localClosestPoint(wall, query, onTheWall).distance, kTipRadius + kReach);
    const ContactPoints points = contactPoints(wall, {query, kTipRadius}, kReach, {&onTheWall, 1});
    EXPECT_EQ(points.proof, SearchProof::Nearest);
    EXPECT_NEAR(points.list.all().front().distance, kTipRadius, 0.01_nm);
}

TEST(ContactPoints, OutOfReachSaySo) {
    const BSplineSurface level = surfaceOf([](double, double) { return 0.0; });
    EXPECT_EQ(contactPointsAt(level, kTipRadius + 0.99 * kReach).proof, SearchProof::Nearest);
    const ContactPoints far = contactPointsAt(level, kTipRadius + 1.01 * kReach);
    EXPECT_EQ(far.proof, SearchProof::OutOfReach);
    ASSERT_EQ(far.list.all().size(), 1U);
    EXPECT_NEAR(far.list.all().front().distance, kTipRadius + 1.01 * kReach, 1e-9_nm);
}

/// However deep the tip is in the sample: its closest point is the nearest way out.
TEST(ContactPoints, FarBelowTheSurfaceAreTheNearest) {
    const BSplineSurface rough = surfaceOf([](double x, double y) {
        return 30.0_nm * std::sin(x / 6.0_nm) * std::cos(y / 5.0_nm) + 0.5 * std::abs(x);
    });
    Random random(23);
    ClosestPointTracker tracker;
    int proven = 0;
    for (int i = 0; i < 200; ++i) {
        const Vector2 position(random.uniform(20.0_nm, 100.0_nm),
                               random.uniform(20.0_nm, 100.0_nm));
        const double deep = kTipRadius + kReach + random.uniform(0.0, 60.0_nm);
        const TipSphere tip{.center = {position.x(), position.y(),
                                       rough.at(position.x(), position.y()).height - deep},
                            .radius = kTipRadius};
        const ClosestPoint nearest = closestPoint(rough, tip.center, {});
        for (const ContactPoints& points : {contactPoints(rough, tip, kReach, {}),
                                            contactPoints(rough, tip, {kReach}, {}, tracker)}) {
            ASSERT_NE(points.proof, SearchProof::OutOfReach);
            if (points.proof == SearchProof::Nearest) {
                ++proven;
                ASSERT_NEAR(points.list.all().front().distance, nearest.distance, 1e-9_nm);
            }
        }
    }
    EXPECT_GT(proven, 300);
}

/// More known closest points than the search keeps apart leave it room for the ball of a tracker.
TEST(ContactPoints, OfAWideTipOverManyBumpsFindRoom) {
    constexpr double kPeriod = 12.0_nm;
    const BSplineSurface bumps = surfaceOf([](double x, double y) {
        return 1.0_nm * std::cos(x / kPeriod * 2.0 * std::numbers::pi) *
               std::cos(y / kPeriod * 2.0 * std::numbers::pi);
    });
    std::vector<SearchGuess> known;
    for (int i = -3; i <= 3; ++i) {
        for (int k = -3; k <= 3; ++k) {
            known.push_back({kMiddle + i * kPeriod, kMiddle + k * kPeriod, true});
        }
    }
    ClosestPointTracker tracker;
    const TipSphere tip{.center = {kMiddle, kMiddle, 400.0_nm}, .radius = 399.0_nm};
    EXPECT_EQ(contactPoints(bumps, tip, {kReach}, known, tracker).list.all().size(), kMaxMinima);
}

TEST(ContactPoints, OfAPointThatIsNoneAreNotConverged) {
    const BSplineSurface level = surfaceOf([](double, double) { return 0.0; });
    const ContactPoints none =
        contactPoints(level, {.center = Vector3::Constant(NAN), .radius = kTipRadius}, kReach, {});
    EXPECT_EQ(none.proof, SearchProof::NotConverged);
}

TEST(ClosestPointList, KeepsTheNearestInOrderAndNoClosestPointTwice) {
    const auto closestPointAt = [](double x, double distance) {
        ClosestPoint closest;
        closest.point = {x, 0.0, 0.0};
        closest.distance = distance;
        return closest;
    };
    ClosestPointList list;
    for (const double position : {5.0, 3.0, -7.0, 4.0, 1.0, 6.0}) {
        list.add(closestPointAt(position, -position), 0.5);
    }
    list.add(closestPointAt(3.4, 0.1), 0.5);  // as good as the one at 3
    const auto positions = [&list] {
        std::vector<double> result;
        for (const ClosestPoint& closest : list.all()) {
            result.push_back(closest.point.x());
        }
        return result;
    };
    EXPECT_EQ(positions(), (std::vector<double>{1.0, 3.0, 4.0, 5.0, 6.0, -7.0}));
    EXPECT_FALSE(list.hasLeftOut(1000.0));
    for (std::size_t i = 0; i < kMaxMinima; ++i) {
        list.add(closestPointAt(100.0 + static_cast<double>(i), 10.0 + static_cast<double>(i)),
                 0.5);
    }
    EXPECT_EQ(list.all().size(), kMaxMinima);
    EXPECT_FALSE(list.hasLeftOut(15.9)) << "all as near as that have room";
    EXPECT_TRUE(list.hasLeftOut(16.0));
}

/// In a pit that is the same all around, the order in which its points are found must not matter.
TEST(ClosestPointList, OrdersPointsOfOneDistanceByTheirPosition) {
    const auto at = [](double x, double y) {
        ClosestPoint closest;
        closest.point = {x, y, 0.0};
        closest.distance = 1.0;
        return closest;
    };
    std::vector<ClosestPoint> points = {at(-2.0, 1.0), at(-2.0, 3.0), at(2.0, -1.0)};
    for (int turn = 0; turn < 3; ++turn) {
        std::rotate(points.begin(), points.begin() + 1, points.end());
        ClosestPointList list;
        for (const ClosestPoint& point : points) {
            list.add(point, 0.5);
        }
        ASSERT_EQ(list.all().size(), 3U);
        EXPECT_EQ(list.all()[0].point.y(), 1.0);
        EXPECT_EQ(list.all()[1].point.y(), 3.0);
        EXPECT_EQ(list.all()[2].point.x(), 2.0);
    }
}

/// Of two spikes nearer to each other than a fiftieth of the tip's radius one counts, and it says
/// so.
TEST(ContactPoints, SaysThatOneCountsForItsNeighbor) {
    const auto spikes = [](double apart) {
        return surfaceOf([apart](double x, double y) {
            const auto spike = [&](double at) {
                const double away = std::hypot(x - at, y) / 3.0_nm;
                return 5.0_nm * std::exp(-away * away);
            };
            return spike(-0.5 * apart) + spike(0.5 * apart);
        });
    };
    constexpr double kBlunt = 1000.0_nm;
    const auto under = [&](double apart) {
        return contactPoints(spikes(apart),
                             {.center = {kMiddle, kMiddle, kBlunt + 6.0_nm}, .radius = kBlunt},
                             3.0_nm, {});
    };
    const ContactPoints near = under(16.0_nm);
    EXPECT_EQ(near.list.all().size(), 1U);
    EXPECT_TRUE(near.joined);
    const ContactPoints apart = under(30.0_nm);
    EXPECT_EQ(apart.list.all().size(), 2U);
    EXPECT_FALSE(apart.joined);
}

}  // namespace
}  // namespace asperity
