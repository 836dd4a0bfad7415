#include "ui/plot/CurveHistory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::test {
namespace {

QVector<QPointF> line(int count) {
    QVector<QPointF> points;
    for (int i = 0; i < count; ++i) {
        points.append({static_cast<double>(i), 0.0});
    }
    return points;
}

TEST(ThinnedLine, KeepsAPeakOfOneTick) {
    QVector<QPointF> points = line(10'000);
    points[4321].setY(7.0);
    points[4322].setY(-3.0);
    const QVector<QPointF> thin = thinned(points, 0, points.size(), 100);
    EXPECT_LE(thin.size(), 302);
    EXPECT_TRUE(thin.contains(points[4321]));
    EXPECT_TRUE(thin.contains(points[4322]));
    EXPECT_EQ(thin.front(), points.front());
    EXPECT_EQ(thin.back(), points.back());
    EXPECT_TRUE(
        std::is_sorted(thin.begin(), thin.end(),
                       [](const QPointF& one, const QPointF& two) { return one.x() < two.x(); }));
}

TEST(ThinnedLine, StaysPartedWhereAForceIsNotKnown) {
    QVector<QPointF> points = line(10'000);
    points[5000].setY(std::numeric_limits<double>::quiet_NaN());
    const QVector<QPointF> thin = thinned(points, 0, points.size(), 100);
    EXPECT_EQ(std::count_if(thin.begin(), thin.end(),
                            [](const QPointF& point) { return std::isnan(point.y()); }),
              1);
}

TEST(ThinnedLine, LeavesAShortOneAndTakesOnlyTheRange) {
    const QVector<QPointF> points = line(50);
    EXPECT_EQ(thinned(points, 10, 20, 100), points.mid(10, 10));
}

}  // namespace
}  // namespace asperity::test
