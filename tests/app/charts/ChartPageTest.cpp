#include "app/charts/ChartPage.h"

#include "app/charts/ChartPen.h"
#include "core/Error.h"
#include "vtkplugins/pictures/Palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace asperity {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

std::vector<Chart> charts(std::size_t count) {
    const Chart chart{.title = "A & <B>",
                      .xLabel = "time",
                      .yLabel = "force",
                      .curves = {{.label = "Fx",
                                  .x = {0.0, 0.25, 0.5, 0.75, 1.0},
                                  .y = {0.0, 2e-9, kNothing, -1e-9, 3e-9}},
                                 {.label = "dot", .x = {0.5}, .y = {1e-9}, .points = true}},
                      .xUnit = "s",
                      .yUnit = "N"};
    return std::vector<Chart>(count, chart);
}

ChartSheet sheetOf(double width, double height) { return {.width = width, .height = height}; }

template <class Part>
std::vector<Part> all(const ChartPage& page) {
    std::vector<Part> all;
    for (const auto& part : page.parts) {
        if (const Part* const one = std::get_if<Part>(&part)) {
            all.push_back(*one);
        }
    }
    return all;
}

std::vector<ChartPage::Line> linesOf(const ChartPage& page) { return all<ChartPage::Line>(page); }
std::vector<ChartPage::Dot> dotsOf(const ChartPage& page) { return all<ChartPage::Dot>(page); }
std::vector<ChartPage::Text> textsOf(const ChartPage& page) { return all<ChartPage::Text>(page); }

bool hasText(const ChartPage& page, const std::string& text) {
    return std::ranges::any_of(textsOf(page),
                               [&text](const auto& drawn) { return drawn.text == text; });
}

TEST(ChartPage, KeepsAllInsideOfThePage) {
    for (const auto& [width, height] : {std::pair{1280, 800}, {400, 300}, {300, 1200}}) {
        const ChartPage page = layOut(charts(4), sheetOf(width, height));
        for (const ChartPage::Line& line : linesOf(page)) {
            for (const ChartPage::Point& point : line.points) {
                EXPECT_TRUE(point.x >= 0.0 && point.x <= width && point.y >= 0.0 &&
                            point.y <= height)
                    << width << ": " << point.x << ' ' << point.y;
            }
        }
        for (const ChartPage::Text& text : textsOf(page)) {
            EXPECT_TRUE(text.at.x > 0.0 && text.at.x < width && text.at.y > 0.0 &&
                        text.at.y < height)
                << text.text;
        }
    }
}

TEST(ChartPage, NamesAxesWithTheUnitThatIsShown) {
    const ChartPage page = layOut(charts(1), sheetOf(800, 600));
    EXPECT_TRUE(hasText(page, "force [nN]"));
    EXPECT_TRUE(hasText(page, "time [s]"));
    EXPECT_TRUE(hasText(page, "Fx"));
}

TEST(ChartPage, HoldsTheHeightsAndNamesThatAChartAsksFor) {
    std::vector<Chart> some = charts(1);
    some[0].yUnit.clear();
    some[0].yHolds = {0.0, 40.0};
    some[0].xNames = {"oxide", "rubber"};
    const ChartPage page = layOut(some, sheetOf(800, 600));
    EXPECT_TRUE(hasText(page, "40"));
    EXPECT_TRUE(hasText(page, "oxide"));
    EXPECT_TRUE(hasText(page, "rubber"));
    EXPECT_FALSE(hasText(page, "0.5"));
}

TEST(ChartPage, PartsACurveWhereItHasNoValue) {
    const ChartPage page = layOut(charts(1), sheetOf(800, 600));
    const auto ofTwo = std::ranges::count_if(linesOf(page), [](const ChartPage::Line& line) {
        return line.color == seriesColor(kLightPalette, 0) && line.points.size() == 2;
    });
    EXPECT_EQ(ofTwo, 3);  // two pieces and the legend's line
    EXPECT_EQ(dotsOf(page).size(), 2U);
}

TEST(ChartPage, LeavesOutWhatIsNotAskedFor) {
    ChartSheet sheet = sheetOf(800, 600);
    sheet.parts = {.bars = false, .labels = false, .grid = false};
    const ChartPage page = layOut(charts(1), sheet);
    EXPECT_TRUE(textsOf(page).empty());
    EXPECT_EQ(linesOf(page).size(), 2U);
    EXPECT_EQ(dotsOf(page).size(), 1U);
}

TEST(ChartPage, RefusesAPageThatNobodyCouldRead) {
    EXPECT_THROW((void)layOut(charts(4), sheetOf(200, 100)), Error);
    std::vector<Chart> wrong = charts(1);
    wrong.front().curves.front().x.pop_back();
    EXPECT_THROW((void)layOut(wrong, sheetOf(800, 600)), Error);
}

Chart chartOf(std::vector<double> x, std::vector<double> y) {
    return {.title = "",
            .xLabel = "gap",
            .yLabel = "force",
            .curves = {{.label = "curve",
                        .x = std::move(x),
                        .y = std::move(y),
                        .color = kLightPalette.orange}},
            .xUnit = "m",
            .yUnit = "N"};
}

ChartPage pageOf(const Chart& chart) { return layOut({{chart}}, sheetOf(800, 600)); }

/// The lines of the curve without that in the legend.
std::vector<ChartPage::Line> curveOf(const ChartPage& page) {
    std::vector<ChartPage::Line> lines;
    std::ranges::copy_if(linesOf(page), std::back_inserter(lines), [](const ChartPage::Line& line) {
        return line.color == kLightPalette.orange;
    });
    lines.pop_back();
    return lines;
}

TEST(ChartPage, HigherForcesLieHigherAndLargerGapsFartherRight) {
    const auto curve = curveOf(pageOf(chartOf({0.0, 1e-9}, {0.0, 1e-9})));
    ASSERT_EQ(curve.size(), 1U);
    EXPECT_LT(curve[0].points[0].x, curve[0].points[1].x);
    EXPECT_GT(curve[0].points[0].y, curve[0].points[1].y);
}

TEST(ChartPage, IsCutAtItsRange) {
    Chart chart = chartOf({-1.0, 3.0, 5.0, 1.0}, {-1.0, 3.0, 5.0, 1.0});
    chart.xRange = {.low = 0.0, .high = 2.0};
    const auto curve = curveOf(pageOf(chart));
    ASSERT_EQ(curve.size(), 2U) << "it leaves the range and comes back";
    Chart within = chartOf({0.0, 2.0}, {0.0, 2.0});
    within.xRange = chart.xRange;
    const auto whole = curveOf(pageOf(within));
    for (const std::size_t end : {0U, 1U}) {
        EXPECT_NEAR(curve[0].points[end].x, whole[0].points[end].x, 1e-9);
        EXPECT_NEAR(curve[0].points[end].y, whole[0].points[end].y, 1e-9);
    }
}

TEST(ChartPage, HasItsRingsInSight) {
    Chart chart = chartOf({0.0, 2.0}, {0.0, 1.0});
    chart.xRange = {.low = 0.0, .high = 2.0};
    chart.curves.push_back({.label = "", .x = {1.0, 3.0}, .y = {-5.0, 0.0}, .rings = true});
    const ChartPage page = pageOf(chart);
    ASSERT_EQ(dotsOf(page).size(), 1U) << "the other lies beside the range";
    EXPECT_GT(dotsOf(page)[0].line, 0.0);
    EXPECT_LT(dotsOf(page)[0].center.y, page.height - 40.0);
}

TEST(ChartPage, IsPartedWhereAValueIsNotFinite) {
    EXPECT_EQ(curveOf(pageOf(chartOf({0, 1, 0, 1, 2}, {0, 1, kNothing, 2, 3}))).size(), 2U);
}

TEST(ChartPage, OfNothingIsAxes) {
    for (const auto& values : {std::vector<double>{}, {kNothing}, {1.0}}) {
        Chart chart = chartOf(values, values);
        for (const bool isLogarithmic : {false, true}) {
            chart.logX = chart.logY = isLogarithmic;
            const ChartPage page = pageOf(chart);
            EXPECT_GT(textsOf(page).size(), 4U);
            for (const ChartPage::Line& line : linesOf(page)) {
                for (const ChartPage::Point& point : line.points) {
                    EXPECT_TRUE(std::isfinite(point.x) && std::isfinite(point.y));
                }
            }
        }
    }
    EXPECT_TRUE(layOut({}, {}).parts.empty());
}

TEST(ChartPage, HasAZeroLineBetweenValuesOfBothSigns) {
    const auto mutedOf = [](const ChartPage& page) {
        return std::ranges::count_if(linesOf(page), [](const ChartPage::Line& line) {
            return line.color == kLightPalette.muted && line.width < 1.0;
        });
    };
    Chart chart = chartOf({1.0, 2.0}, {-1.0, 1.0});
    ChartSheet sheet = sheetOf(400, 260);
    EXPECT_EQ(mutedOf(layOut({{chart}}, sheet)), 1);
    chart.curves[0].y[0] = 0.5;
    EXPECT_EQ(mutedOf(layOut({{chart}}, sheet)), 0);
}

TEST(ChartPage, KeepsEveryPeak) {
    Chart chart = chartOf({}, {});
    for (int i = 0; i < 50000; ++i) {
        chart.curves[0].x.push_back(i);
        chart.curves[0].y.push_back(i == 31234 ? 10.0 : 0.0);
    }
    const ChartPage page = pageOf(chart);
    const auto curve = curveOf(page);
    ASSERT_EQ(curve.size(), 1U);
    EXPECT_LT(curve[0].points.size(), 10000U);
    const auto [highest, lowest] = std::ranges::minmax(curve[0].points, {}, &ChartPage::Point::y);
    EXPECT_GT(lowest.y - highest.y, page.height / 2);
}

TEST(ChartPage, NamesDotsThatLieOnLogarithmicAxes) {
    Chart chart = chartOf({1e-7, 1e-5, 1e-2, 0.0}, {40.0, 3.0, 0.2, 1.0});
    chart.curves[0].points = true;
    chart.curves[0].pointLabels = {"Hertz", "Maugis", "half space", "nowhere"};
    chart.logX = chart.logY = true;
    const ChartPage page = pageOf(chart);
    EXPECT_TRUE(hasText(page, "Hertz") && hasText(page, "half space"));
    EXPECT_FALSE(hasText(page, "nowhere"));
    chart.curves[0].pointLabels.pop_back();
    EXPECT_THROW((void)pageOf(chart), Error);
}

TEST(ChartPage, HoldsLongTexts) {
    Chart chart = chartOf({0.0, 1.0}, {0.0, 1.0});
    for (int i = 0; i < 12; ++i) {
        chart.title += "a rather long title ";
        chart.yNames.push_back("a name of a row that needs much room " + std::to_string(i));
        chart.xNames.push_back("a long name " + std::to_string(i));
    }
    chart.yLabel = chart.title;
    const ChartPage page = pageOf(chart);
    const auto& lines = curveOf(page);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_GT(lines[0].points[1].x - lines[0].points[0].x, 20.0) << "there is room for the curve";
    double before = -100.0;
    for (const ChartPage::Text& text : textsOf(page)) {
        const double width = estimatedWidth(text.text, text.size);
        EXPECT_LT(width, 1.2 * (text.upright ? page.height : page.width)) << text.text;
        if (text.text.starts_with("a long name")) {
            EXPECT_GT(text.at.x - 0.5 * width, before) << text.text;
            before = text.at.x + 0.5 * width;
        }
    }
}

TEST(ChartPage, CellsAreDividedAsTheSharesSay) {
    const std::vector<ChartKey> keys{{{0, 158, 115}, "good"}, {{213, 94, 0}, "bad"}};
    Chart chart{.title = "A law",
                .xLabel = "tip radius",
                .yLabel = "modulus",
                .curves = {},
                .xNames = {"1 nm", "10 nm"},
                .yNames = {"1 kPa"}};
    addShares(chart, 0, 0, std::vector{3.0, 1.0}, keys);
    addShares(chart, 1, 0, std::vector<double>{}, keys);
    const ChartPage page =
        layOut({{chart}}, {.width = 800.0, .height = 600.0, .title = "Maps", .keys = keys});
    const auto boxes = all<ChartPage::Box>(page);
    ASSERT_EQ(boxes.size(), 2U) << "an empty cell";
    EXPECT_NEAR(boxes[0].height / boxes[1].height, 3.0, 1e-9);
    EXPECT_NEAR(boxes[1].top + boxes[1].height, boxes[0].top, 1e-9);
    EXPECT_LT(boxes[0].left + boxes[0].width, 450.0);
    EXPECT_TRUE(hasText(page, "Maps") && hasText(page, "good") && hasText(page, "10 nm"));
}

TEST(ChartAxis, ShowsSiValuesWithAPrefix) {
    const std::vector<double> forces{-4.0e-9, 0.0, 9.0e-9};
    const ChartAxis axis({"force", "N", false, 8}, forces);
    EXPECT_EQ(axis.title(), "force [nN]");
    EXPECT_NEAR(axis.position(9.0e-9), 9.0, 1e-12);
    EXPECT_LT(axis.low(), -4.0);
    EXPECT_GT(axis.high(), 9.0);
}

TEST(ChartAxis, LogarithmicAxesHaveDecadesAndNoZero) {
    const std::vector<double> values{0.0, 0.01, 1000.0, -1.0};
    const ChartAxis axis({"error", "", true, 8}, values);
    EXPECT_EQ(axis.labels(), (std::vector<std::string>{"0.01", "0.1", "1", "10", "100", "1000"}));
    EXPECT_NEAR(axis.position(100.0), 2.0, 1e-12);
    EXPECT_TRUE(std::isnan(axis.position(0.0)));
    EXPECT_TRUE(std::isnan(axis.position(-1.0)));
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
    constexpr double kDot = 9.0;
    LabelPlacer placer({0.0, 0.0, 400.0, 300.0});
    const ChartPage::Point first{200.0, 150.0};
    const ChartPage::Point second{215.0, 152.0};
    placer.blockDot(first, kDot);
    placer.blockDot(second, kDot);
    placer.blockLine(second, {390.0, 152.0});
    const Area a = placer.place(first, kDot, 80.0, 18.0);
    const Area b = placer.place(second, kDot, 80.0, 18.0);
    EXPECT_FALSE(a.overlaps(b));
    for (const Area& label : {a, b}) {
        EXPECT_FALSE(label.overlaps({210.5, 147.5, 9.0, 9.0}));
        EXPECT_FALSE(label.overlaps({215.0, 151.0, 175.0, 2.0}));
    }
}

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

}  // namespace
}  // namespace asperity
