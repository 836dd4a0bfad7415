#include "core/Units.h"
#include "tests/vtkplugins/Fakes.h"
#include "vtkplugins/pictures/ChartAxis.h"
#include "vtkplugins/pictures/Decimation.h"
#include "vtkplugins/pictures/LabelPlacer.h"
#include "vtkplugins/pictures/RestingPatch.h"
#include "vtkplugins/pictures/Stretch.h"
#include "vtkplugins/pictures/Ticks.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace asperity {

TEST(Decimation, KeepsEveryPeakOfALongSeries) {
    Series series;
    for (int i = 0; i < 200000; ++i) {
        series.x.push_back(i);
        series.y.push_back(std::sin(1e-4 * i));
    }
    series.y[123457] = 7.0;  // one sample wide
    series.y[77777] = -5.0;
    const Series thinned = decimateMinMax(series, 1000);
    EXPECT_LE(thinned.y.size(), 4000U);
    EXPECT_EQ(thinned.x.size(), thinned.y.size());
    const auto highest = std::max_element(thinned.y.begin(), thinned.y.end());
    EXPECT_EQ(*highest, 7.0);
    EXPECT_EQ(thinned.x[static_cast<std::size_t>(highest - thinned.y.begin())], 123457.0);
    EXPECT_EQ(*std::min_element(thinned.y.begin(), thinned.y.end()), -5.0);
    EXPECT_TRUE(std::is_sorted(thinned.x.begin(), thinned.x.end()));
    EXPECT_EQ(thinned.x.front(), 0.0);
    EXPECT_EQ(thinned.x.back(), 199999.0);
}

TEST(Decimation, LeavesShortSeriesAlone) {
    const Series series{{3.0, 1.0, 2.0}, {1.0, 2.0, 3.0}};
    EXPECT_EQ(decimateMinMax(series, 10).x, series.x);
}

TEST(Ticks, AreRoundAndInsideTheRange) {
    EXPECT_EQ(niceTicks(0.0, 10.0, 5), (std::vector<double>{0.0, 2.0, 4.0, 6.0, 8.0, 10.0}));
    const std::vector<double> ticks = niceTicks(-4.2, 9.1, 8);
    EXPECT_GE(ticks.front(), -4.2);
    EXPECT_LE(ticks.back(), 9.1);
    EXPECT_NE(std::find(ticks.begin(), ticks.end(), 0.0), ticks.end());
    EXPECT_EQ(niceTicks(3.0, 3.0, 5), std::vector<double>{3.0});
    for (const double tick : niceTicks(0.31, 0.37, 1)) {
        EXPECT_GE(tick, 0.31);
        EXPECT_LE(tick, 0.37);
    }
    EXPECT_DOUBLE_EQ(niceBelow(0.3e-9), 0.2e-9);
    EXPECT_DOUBLE_EQ(niceBelow(5.0), 5.0);
}

TEST(Ticks, LabelsShareTheirDecimals) {
    EXPECT_EQ(tickLabels({0.0, 0.5, 1.0}), (std::vector<std::string>{"0.0", "0.5", "1.0"}));
    EXPECT_EQ(tickLabels({-20.0, 0.0, 20.0}), (std::vector<std::string>{"-20", "0", "20"}));
}

TEST(ChartAxis, ShowsSiValuesWithAPrefix) {
    const std::vector<double> forces{-4.0_nN, 0.0, 9.0_nN};
    const ChartAxis axis({"force", "N", false, 8}, forces);
    EXPECT_EQ(axis.title(), "force [nN]");
    EXPECT_NEAR(axis.place(9.0_nN), 9.0, 1e-12);
    EXPECT_LT(axis.low(), -4.0);
    EXPECT_GT(axis.high(), 9.0);
}

TEST(ChartAxis, LogarithmicAxesHaveDecadesAndNoPlaceForZero) {
    const std::vector<double> values{0.0, 0.01, 1000.0, -1.0};
    const ChartAxis axis({"error", "", true, 8}, values);
    EXPECT_EQ(axis.labels(), (std::vector<std::string>{"0.01", "0.1", "1", "10", "100", "1000"}));
    EXPECT_NEAR(axis.place(100.0), 2.0, 1e-12);
    EXPECT_TRUE(std::isnan(axis.place(0.0)));
    EXPECT_TRUE(std::isnan(axis.place(-1.0)));
}

TEST(ChartAxis, CategoriesStandUnderTheirNames) {
    const std::vector<double> values{0.0, 2.0};
    const ChartAxis axis({"", "", false, 8, {"oxide", "polystyrene", "rubber"}}, values);
    EXPECT_EQ(axis.labels(), (std::vector<std::string>{"oxide", "polystyrene", "rubber"}));
    EXPECT_EQ(axis.ticks(), (std::vector<double>{0.0, 1.0, 2.0}));
    EXPECT_LT(axis.low(), 0.0);
    EXPECT_GT(axis.high(), 2.0);
}

TEST(ChartAxis, ConstantAndMissingValuesStillGiveARange) {
    for (const std::vector<double>& values :
         {std::vector<double>{}, std::vector<double>{5.0, 5.0}, std::vector<double>{0.0},
          std::vector<double>{std::numeric_limits<double>::quiet_NaN()}}) {
        const ChartAxis axis({"x", "", false, 5}, values);
        EXPECT_LT(axis.low(), axis.high());
        EXPECT_GE(axis.ticks().size(), 2U);
    }
}

TEST(LabelPlacer, LabelsKeepClearOfDotsLinesAndEachOther) {
    const PixelRect inside{0.0, 0.0, 400.0, 300.0};
    LabelPlacer placer(inside, 9.0);
    const PixelPoint first{200.0, 150.0};
    const PixelPoint second{215.0, 152.0};
    placer.blockDot(first);
    placer.blockDot(second);
    placer.blockLine(second, {390.0, 152.0});
    const PixelRect a = placer.place(first, 80.0, 18.0);
    const PixelRect b = placer.place(second, 80.0, 18.0);
    EXPECT_FALSE(a.overlaps(b));
    for (const PixelRect& label : {a, b}) {
        EXPECT_FALSE(label.overlaps({210.5, 147.5, 9.0, 9.0}));
        EXPECT_FALSE(label.overlaps({215.0, 151.0, 175.0, 2.0}));
    }
}

namespace {

/// The plane at rest z = 0.3 x.
SurfacePatch slope() {
    SurfacePatch patch;
    patch.columns = 5;
    patch.rows = 4;
    for (int row = 0; row < patch.rows; ++row) {
        for (int column = 0; column < patch.columns; ++column) {
            patch.rest.emplace_back(column * 1.0_nm, row * 1.0_nm, 0.3 * column * 1.0_nm);
        }
    }
    return patch;
}

}  // namespace

// It drew displacements a hundred times as large on a surface that was not, and the tip a spindle.
TEST(Stretch, MultipliesAllHeightsAlike) {
    const Stretch stretch(10.0);
    const Vector3 drawn = stretch.point(Vector3(500.0_nm, 400.0_nm, 4.4_nm));
    EXPECT_LT((drawn - Vector3(500.0_nm, 400.0_nm, 44.0_nm)).norm(), 1e-20);
    EXPECT_EQ(Stretch(1.0).point(drawn), drawn);
}

TEST(Stretch, TurnsNormalsWithTheSurface) {
    // A plane of slope 0.1 becomes one of slope 0.4.
    const Vector3 normal = Stretch(4.0).normal(Vector3(-0.1, 0.0, 1.0).normalized());
    EXPECT_LT((normal - Vector3(-0.4, 0.0, 1.0).normalized()).norm(), 1e-12);
}

TEST(RestingPatch, FindsTheClosestPointAndWhatMovedWithIt) {
    const SurfacePatch patch = test::hertzDent().patch;
    const RestingPatch resting(patch);
    const Vector3 closest = resting.closest(Vector3(500.0_nm, 400.0_nm, 9.0_nm), Vector3::UnitZ());
    EXPECT_LT((closest - Vector3(500.0_nm, 400.0_nm, 5.0_nm)).norm(), 1e-20);
    EXPECT_NEAR(resting.at(patch.points, closest.x(), closest.y()).z(), 5.0_nm - 0.6_nm, 1e-18);
}

TEST(RestingPatch, KeepsItsBordersNormalBeyondThem) {
    const RestingPatch resting(slope());
    const Vector3 normal = Vector3(-0.3, 0.0, 1.0).normalized();
    for (const double x : {-30.0_nm, 0.0, 2.0_nm, 4.0_nm, 30.0_nm}) {
        for (const double y : {-30.0_nm, 0.0, 1.0_nm, 3.0_nm, 30.0_nm}) {
            EXPECT_LT((resting.normal(x, y) - normal).norm(), 1e-12) << x << ' ' << y;
        }
    }
}

}  // namespace asperity
