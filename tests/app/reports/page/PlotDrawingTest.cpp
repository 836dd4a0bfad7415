#include "app/reports/page/PlotDrawing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace asperity {
namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

Plot plotOf(std::vector<PlotPoint> points) {
    return {.description = "",
            .x = {"gap", "m"},
            .y = {"force", "N"},
            .curves = {{"curve", std::move(points), PlotInk::Orange}},
            .marks = {}};
}

/// The lines of the curve; its swatch in the legend is the first.
std::vector<DrawnLine> curveOf(const PlotDrawing& drawing) {
    std::vector<DrawnLine> lines;
    std::ranges::copy_if(drawing.lines, std::back_inserter(lines),
                         [](const DrawnLine& line) { return line.ink == PlotInk::Orange; });
    lines.erase(lines.begin());
    return lines;
}

bool hasText(const PlotDrawing& drawing, const std::string& text) {
    return std::ranges::any_of(drawing.texts,
                               [&](const DrawnText& drawn) { return drawn.text == text; });
}

TEST(PlotDrawing, HasRoundNumbersInFittingUnits) {
    const PlotDrawing drawing = layOut(plotOf({{-1e-9, -3e-9}, {1e-9, 5e-9}}));
    for (const char* text : {"gap [nm]", "force [nN]", "-1.0", "0.5", "-2", "4", "curve"}) {
        EXPECT_TRUE(hasText(drawing, text)) << text;
    }
}

TEST(PlotDrawing, HigherForcesLieHigherAndLargerGapsFartherRight) {
    const auto curve = curveOf(layOut(plotOf({{0.0, 0.0}, {1e-9, 1e-9}})));
    ASSERT_EQ(curve.size(), 1U);
    EXPECT_LT(curve[0].points[0].x, curve[0].points[1].x);
    EXPECT_GT(curve[0].points[0].y, curve[0].points[1].y);
}

TEST(PlotDrawing, IsCutAtItsRange) {
    Plot plot = plotOf({{-1.0, -1.0}, {3.0, 3.0}, {5.0, 5.0}, {1.0, 1.0}});
    plot.low = 0.0;
    plot.high = 2.0;
    const auto curve = curveOf(layOut(plot));
    ASSERT_EQ(curve.size(), 2U) << "it leaves the range and comes back";
    Plot within = plotOf({{0.0, 0.0}, {2.0, 2.0}});
    const auto whole = curveOf(layOut(within));
    for (const std::size_t end : {0U, 1U}) {
        EXPECT_NEAR(curve[0].points[end].x, whole[0].points[end].x, 1e-9);
        EXPECT_NEAR(curve[0].points[end].y, whole[0].points[end].y, 1e-9);
    }
}

TEST(PlotDrawing, HasItsMarksInSight) {
    Plot plot = plotOf({{0.0, 0.0}, {2.0, 1.0}});
    plot.marks = {{{1.0, -5.0}}, {{3.0, 0.0}}};
    const PlotDrawing drawing = layOut(plot);
    ASSERT_EQ(drawing.rings.size(), 1U) << "the other lies beside the range";
    EXPECT_LT(drawing.rings[0].place.y, drawing.height - 40.0);
}

TEST(PlotDrawing, IsPartedWhereAValueIsNotFinite) {
    EXPECT_EQ(curveOf(layOut(plotOf({{0, 0}, {1, 1}, {0, kNan}, {1, 2}, {2, 3}}))).size(), 2U);
}

TEST(PlotDrawing, OfNothingIsAxes) {
    for (const auto& points : {std::vector<PlotPoint>{}, {{kNan, kNan}}, {{1.0, 1.0}}}) {
        const PlotDrawing drawing = layOut(plotOf(points));
        EXPECT_GT(drawing.texts.size(), 4U);
        for (const DrawnLine& line : drawing.lines) {
            for (const PlotPoint& point : line.points) {
                EXPECT_TRUE(std::isfinite(point.x) && std::isfinite(point.y));
            }
        }
    }
}

}  // namespace
}  // namespace asperity
