#include "app/exports/PlotPage.h"

#include "app/exports/PlotFile.h"
#include "core/Error.h"
#include "tests/app/exports/OtherProgram.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
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

PictureSpec specOf(int width, int height, double dpi = 96.0) {
    return {.size = {.width = width, .height = height}, .dpi = dpi};
}

bool hasText(const PlotPage& page, const std::string& text) {
    return std::ranges::any_of(page.texts,
                               [&text](const auto& drawn) { return drawn.text == text; });
}

TEST(PlotPage, KeepsAllInsideOfThePage) {
    for (const auto& [width, height] : {std::pair{1280, 800}, {400, 300}, {300, 1200}}) {
        const PlotPage page = plotPage(charts(4), specOf(width, height));
        for (const PlotPage::Line& line : page.lines) {
            for (const PlotPage::Point& point : line.points) {
                EXPECT_TRUE(point.x >= 0.0 && point.x <= width && point.y >= 0.0 &&
                            point.y <= height)
                    << width << ": " << point.x << ' ' << point.y;
            }
        }
        for (const PlotPage::Text& text : page.texts) {
            EXPECT_TRUE(text.at.x > 0.0 && text.at.x < width && text.at.y > 0.0 &&
                        text.at.y < height)
                << text.text;
        }
    }
}

TEST(PlotPage, NamesAxesWithTheUnitThatIsShown) {
    const PlotPage page = plotPage(charts(1), specOf(800, 600));
    EXPECT_TRUE(hasText(page, "force [nN]"));
    EXPECT_TRUE(hasText(page, "time [s]"));
    EXPECT_TRUE(hasText(page, "Fx"));
}

TEST(PlotPage, HoldsTheHeightsAndNamesThatAChartAsksFor) {
    std::vector<Chart> some = charts(1);
    some[0].yUnit.clear();
    some[0].yHolds = {0.0, 40.0};
    some[0].xNames = {"oxide", "rubber"};
    const PlotPage page = plotPage(some, specOf(800, 600));
    EXPECT_TRUE(hasText(page, "40"));
    EXPECT_TRUE(hasText(page, "oxide"));
    EXPECT_TRUE(hasText(page, "rubber"));
    EXPECT_FALSE(hasText(page, "0.5"));
}

TEST(PlotPage, PartsACurveWhereItHasNoValue) {
    const PlotPage page = plotPage(charts(1), specOf(800, 600));
    const auto ofTwo = std::ranges::count_if(page.lines, [](const PlotPage::Line& line) {
        return line.color == seriesColor(kLightPalette, 0) && line.points.size() == 2;
    });
    EXPECT_EQ(ofTwo, 3);  // two pieces and the legend's line
    EXPECT_EQ(page.dots.size(), 2U);
}

TEST(PlotPage, LeavesOutWhatIsNotAskedFor) {
    PictureSpec spec = specOf(800, 600);
    spec.parts = {.bars = false, .labels = false, .grid = false};
    const PlotPage page = plotPage(charts(1), spec);
    EXPECT_TRUE(page.texts.empty());
    EXPECT_EQ(page.lines.size(), 2U);
    EXPECT_EQ(page.dots.size(), 1U);
}

TEST(PlotPage, HasTheSameLettersAtAnyResolution) {
    const PlotPage coarse = plotPage(charts(1), specOf(400, 300, 96.0));
    const PlotPage fine = plotPage(charts(1), specOf(1250, 938, 300.0));
    EXPECT_NEAR(coarse.texts.front().size, fine.texts.front().size, 0.05);
}

TEST(PlotPage, RefusesAPageThatNobodyCouldRead) {
    EXPECT_THROW((void)plotPage(charts(4), specOf(200, 100)), Error);
    EXPECT_THROW((void)plotPage(charts(4), specOf(800, 600, 600.0)), Error);
    std::vector<Chart> wrong = charts(1);
    wrong.front().curves.front().x.pop_back();
    EXPECT_THROW((void)plotPage(wrong, specOf(800, 600)), Error);
}

TEST(PlotFile, IsWellFormedSvgWithLettersAsText) {
    const test::ScratchFolder folder;
    const auto path = folder.path() / "plot.svg";
    writeSvg(path, plotPage(charts(2), specOf(800, 600)), false);
    const std::string script =
        "import sys, xml.etree.ElementTree as tree\n"
        "root = tree.parse(sys.argv[1]).getroot()\n"
        "name = '{http://www.w3.org/2000/svg}'\n"
        "print(root.get('viewBox'), root.get('width'))\n"
        "print(len(root.findall(name + 'rect')), len(root.findall(name + 'circle')))\n"
        "print([t.text for t in root.findall(name + 'text')].count('A & <B>'))\n"
        "for line in root.findall(name + 'polyline'):\n"
        "    for point in line.get('points').split():\n"
        "        x, y = map(float, point.split(','))\n"
        "        assert 0 <= x <= 800 and 0 <= y <= 600\n";
    const auto program = folder.write("read.py", script);
    EXPECT_EQ(test::outputOf("python3 " + program.string() + " " + path.string()),
              "0 0 800 600 211.667mm\n1 4\n2\n");
}

}  // namespace
}  // namespace asperity
