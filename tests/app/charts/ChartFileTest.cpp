#include "app/charts/ChartFile.h"

#include "app/commands/VirtualDisplay.h"
#include "core/Error.h"
#include "tests/app/exports/OtherProgram.h"
#include "tests/support/ScratchFolder.h"

#include <QColor>
#include <QHash>
#include <QImage>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace asperity {
namespace {

/// With one of each mark, and text that is no markup.
ChartPage page() {
    const Chart chart{.title = "A & <B>\x01",
                      .xLabel = "time",
                      .yLabel = "force",
                      .curves = {{.label = "film", .x = {0.0, 1.0}, .y = {0.0, 2e-9}},
                                 {.label = "dashed",
                                  .x = {0.0, 0.5, 0.75},
                                  .y = {0.0, 1e-9, -1e-9},
                                  .dashed = true},
                                 {.label = "dot", .x = {0.5}, .y = {1e-9}, .points = true},
                                 {.label = "ring", .x = {0.6}, .y = {1e-9}, .rings = true}},
                      .xUnit = "s",
                      .yUnit = "N"};
    return layOut(std::vector<Chart>(2, chart), {.width = 800.0, .height = 600.0});
}

TEST(ChartFile, IsWellFormedSvgWithLettersAsText) {
    const test::ScratchFolder folder;
    const auto path = folder.path() / "plot.svg";
    writeSvg(path, page());
    const std::string script =
        "import sys, xml.etree.ElementTree as tree\n"
        "root = tree.parse(sys.argv[1]).getroot()\n"
        "name = '{http://www.w3.org/2000/svg}'\n"
        "print(root.get('viewBox'), root.get('width'))\n"
        "print(len(root.findall(name + 'rect')), len(root.findall(name + 'circle')))\n"
        "print([t.text for t in root.findall(name + 'text')].count('A & <B>\\\\x01'))\n"
        "for line in root.findall(name + 'polyline'):\n"
        "    for point in line.get('points').split():\n"
        "        x, y = map(float, point.split(','))\n"
        "        assert 0 <= x <= 800 and 0 <= y <= 600\n";
    const auto program = folder.write("read.py", script);
    EXPECT_EQ(test::outputOf("python3 " + program.string() + " " + path.string()),
              "0 0 800 600 211.667mm\n1 8\n2\n");
}

TEST(ChartFile, HasTheColorsOfAPaletteWithinHtml) {
    const std::string svg = svgOf(page(), "\"two\" charts");
    EXPECT_NE(svg.find("aria-label=\"&quot;two&quot; charts\""), std::string::npos);
    const std::string blue = "\"" + styleColor(kLightPalette.blue) + "\"";
    EXPECT_NE(svg.find("stroke=" + blue), std::string::npos);
    EXPECT_NE(svgStyle(kDarkPalette)
                  .find("svg [stroke=" + blue + "]{stroke:" + styleColor(kDarkPalette.blue) + "}"),
              std::string::npos);
}

TEST(ChartFile, IsPdfWithFontsThatSaysNoTime) {
    const OffscreenApplication qt;
    const test::ScratchFolder folder;
    writePdf(folder.file("one.pdf"), page());
    for (int i = 0; i < 8; ++i) {
        qSetGlobalQHashSeed(-1);  // as another process has it, in the order of its hashes
        writePdf(folder.file("two.pdf"), page());
        ASSERT_EQ(test::contentOf(folder.file("one.pdf")), test::contentOf(folder.file("two.pdf")));
    }
    const std::string one = folder.file("one.pdf").string();
    const std::string text = test::outputOf("pdftotext " + one + " -");
    EXPECT_NE(text.find("film"), std::string::npos) << "four letters, no ligature";
    const std::string told = test::outputOf("pdfinfo " + one);
    EXPECT_EQ(told.find("CreationDate"), std::string::npos) << told;
    EXPECT_EQ(told.find("Qt"), std::string::npos) << told;
    EXPECT_NE(told.find("600 x 450 pts"), std::string::npos) << told;
    EXPECT_NE(test::outputOf("pdffonts " + one).find("DejaVuSans"), std::string::npos);
}

TEST(ChartFile, IsDrawnAtAnyResolution) {
    const OffscreenApplication qt;
    const QImage coarse = drawn(page());
    const QImage fine = drawn(page(), 2.0, true);
    EXPECT_EQ(coarse.size(), QSize(800, 600));
    EXPECT_EQ(fine.size(), QSize(1600, 1200));
    EXPECT_EQ(coarse.pixelColor(2, 2), QColor(Qt::white));
    EXPECT_EQ(fine.pixelColor(2, 2).alpha(), 0);
    const auto inkOf = [](const QImage& image) {
        double sum = 0.0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const QColor color = image.pixelColor(x, y);
                sum += color.alphaF() * (1.0 - color.lightnessF());
            }
        }
        return sum / image.width() / image.height();
    };
    EXPECT_GT(inkOf(coarse), 0.005);
    EXPECT_NEAR(inkOf(fine), inkOf(coarse), 0.1 * inkOf(coarse)) << "the same lines and letters";
}

TEST(ChartFile, IsWrittenWholeOrNotAtAll) {
    const OffscreenApplication qt;
    const test::ScratchFolder folder;
    writePng(folder.file("page.png"), page());
    EXPECT_EQ(test::contentOf(folder.file("page.png")).substr(1, 3), "PNG");
    EXPECT_THROW(writePng(folder.path() / "missing" / "page.png", page()), Error);
    EXPECT_THROW(writePdf(folder.path() / "missing" / "page.pdf", page()), Error);
    EXPECT_THROW(writeSvg(folder.path() / "missing" / "page.svg", page()), Error);
}

}  // namespace
}  // namespace asperity
