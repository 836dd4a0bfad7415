#include "ui/plot/CurveHistory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

int gapsIn(const std::vector<CurvePoint>& points) {
    int gaps = 0;
    for (const CurvePoint& point : points) {
        gaps += std::isnan(point.value) ? 1 : 0;
    }
    return gaps;
}

TEST(CurveHistory, KeepsASpikeOfOneTickAmongAHundredThousand) {
    CurveHistory history(10.0, 400);
    for (int i = 0; i < 100000; ++i) {
        const double value = i == 54321 ? 7.0 : i == 54323 ? -9.0 : 0.001 * (i % 3);
        history.add(1e-4 * i, value);
    }
    EXPECT_EQ(history.extent().high, 7.0);
    EXPECT_EQ(history.extent().low, -9.0);
    bool sawSpike = false;
    for (const CurvePoint& point : history.points()) {
        sawSpike = sawSpike || (point.value == 7.0 && std::abs(point.time - 5.4321) < 1e-9);
    }
    EXPECT_TRUE(sawSpike) << "the curve shows it at its own time";
    EXPECT_LE(history.points().size(), 800U);
}

TEST(CurveHistory, PointsAreInTheOrderOfTime) {
    CurveHistory history(1.0, 10);
    for (int i = 0; i < 997; ++i) {
        history.add(0.001 * i, std::sin(0.7 * i));
    }
    const std::vector<CurvePoint> points = history.points();
    ASSERT_GT(points.size(), 15U);
    for (std::size_t i = 1; i < points.size(); ++i) {
        EXPECT_LE(points[i - 1].time, points[i].time);
    }
}

TEST(CurveHistory, ForgetsWhatIsOlderThanItsSpan) {
    CurveHistory history(10.0, 100);
    history.add(0.0, 50.0);
    for (int i = 1; i <= 990; ++i) {
        history.add(0.01 * i, 1.0);
    }
    EXPECT_EQ(history.extent().high, 50.0) << "9.9 s old";
    history.add(10.05, 1.0);
    EXPECT_EQ(history.extent().high, 1.0) << "10 s old";
}

TEST(CurveHistory, ALeapAheadLeavesAGapAndAFarOneDropsTheCurve) {
    CurveHistory history(10.0, 100);
    history.add(1.0, 1.0);
    history.add(1.4, 2.0);
    EXPECT_EQ(gapsIn(history.points()), 0) << "less than a twentieth of the span";
    history.add(4.0, 3.0);
    EXPECT_EQ(gapsIn(history.points()), 1);
    EXPECT_EQ(history.points().size(), 4U);
    history.add(1000.0, 4.0);
    ASSERT_EQ(history.points().size(), 1U);
    EXPECT_EQ(history.points().front().value, 4.0);
}

TEST(CurveHistory, TimeThatGoesBackBeginsANewRun) {
    CurveHistory history(10.0, 100);
    history.add(1.0, 50.0);
    history.add(5.0, 100.0);
    history.add(3.0, 1.0);
    EXPECT_EQ(history.extent().high, 1.0) << "what came before belongs to the old run";
    EXPECT_EQ(history.newestTime(), 3.0);
    history.add(5.0, 2.0);
    EXPECT_EQ(history.extent().high, 2.0) << "and does not come back";
}

TEST(CurveHistory, LeavesOutWhatIsNotFinite) {
    CurveHistory history(10.0, 100);
    history.add(1.0, kNan);
    history.add(kNan, 1.0);
    history.add(std::numeric_limits<double>::infinity(), 1.0);
    history.add(2.0, -std::numeric_limits<double>::infinity());
    EXPECT_TRUE(history.isEmpty());
    EXPECT_TRUE(history.points().empty());
    history.add(2.0, 3.0);
    EXPECT_EQ(history.extent().low, 3.0);
    EXPECT_EQ(history.extent().high, 3.0);
}

TEST(CurveHistory, APartIsPutTogetherInPiecesThatKeepItsPeaks) {
    CurveHistory history(10.0, 4000);
    for (int i = 0; i < 10000; ++i) {
        history.add(1e-3 * i, i == 4321 ? 5.0 : 0.01 * (i % 2));
    }
    const std::vector<CurvePoint> all = history.points(0.0, 10.0, 100);
    EXPECT_LE(all.size(), 210U);
    EXPECT_GE(all.size(), 190U);
    const std::vector<CurvePoint> part = history.points(4.0, 5.0, 100);
    EXPECT_LE(part.size(), 220U);
    EXPECT_GE(part.size(), 190U) << "as fine as the part is short";
    EXPECT_NEAR(part.front().time, 4.0, 0.03);
    EXPECT_LE(part.front().time, 4.0) << "reaches both edges";
    EXPECT_GE(part.back().time, 4.999);
    for (const std::vector<CurvePoint>& points : {all, part}) {
        double highest = 0.0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            highest = std::max(highest, points[i].value);
            EXPECT_TRUE(i == 0 || points[i].time > points[i - 1].time);
        }
        EXPECT_EQ(highest, 5.0);
    }
    EXPECT_TRUE(history.points(20.0, 30.0, 10).size() <= 4U);
}

TEST(CurveHistory, PiecesStayTheSameAsTimeGoesOn) {
    CurveHistory history(1.0, 1000);
    for (int i = 0; i < 1000; ++i) {
        history.add(1e-3 * i, std::sin(0.9 * i));
    }
    const std::vector<CurvePoint> before = history.points(0.2, 0.8, 50);
    for (int i = 1000; i < 1100; ++i) {
        history.add(1e-3 * i, std::sin(0.9 * i));
    }
    const std::vector<CurvePoint> after = history.points(0.2, 0.8, 50);
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_EQ(before[i].time, after[i].time);
    }
}

TEST(CurveHistory, IsEmptyAfterClear) {
    CurveHistory history(10.0, 100);
    history.add(-3.0, 3.0);
    EXPECT_FALSE(history.isEmpty());
    EXPECT_EQ(history.points().size(), 1U) << "times below zero are times too";
    history.clear();
    EXPECT_TRUE(history.isEmpty());
    EXPECT_EQ(history.extent().high, 0.0);
    EXPECT_TRUE(history.points().empty());
}

}  // namespace
}  // namespace asperity
