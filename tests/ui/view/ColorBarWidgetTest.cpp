#include "tests/ui/widgets/PanelSamples.h"
#include "ui/view/ColorScale.h"
#include "ui/widgets/Theme.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

ColorScale scaleOfHeights() {
    return {.quantity = QStringLiteral("height"),
            .unit = QStringLiteral("m"),
            .low = 2e-9,
            .high = 8e-9,
            .colors = {Qt::blue, Qt::yellow},
            .dataLow = 2e-9,
            .dataHigh = 8e-9,
            .rule = {},
            .note = {}};
}

/// Pixels of the color of an arrow beyond an end: beside the bar there is nothing else of it.
int pixelsBeside(const ColorBarWidget& bar, const QColor& color, bool atRight) {
    const QImage picture = const_cast<ColorBarWidget&>(bar).grab().toImage();
    int count = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int i = 0; i < 13; ++i) {
            const int x = atRight ? picture.width() - 1 - i : i;
            count += picture.pixelColor(x, y) == color ? 1 : 0;
        }
    }
    return count;
}

TEST(ColorBarWidget, MarksTheEndsThatValuesLieBeyond) {
    ColorBarWidget bar;
    bar.resize(300, bar.sizeHint().height());
    ColorScale scale = scaleOfHeights();
    bar.setScale(scale);
    EXPECT_EQ(pixelsBeside(bar, Qt::blue, false), 0);
    EXPECT_EQ(pixelsBeside(bar, Qt::yellow, true), 0);
    scale.dataHigh = 9e-9;
    bar.setScale(scale);
    EXPECT_EQ(pixelsBeside(bar, Qt::blue, false), 0);
    EXPECT_GT(pixelsBeside(bar, Qt::yellow, true), 5);
    EXPECT_TRUE(bar.toolTip().contains(QStringLiteral("An arrow marks")));
    EXPECT_TRUE(bar.toolTip().contains(QStringLiteral("2 nm to 9 nm"))) << "the values";
    scale.dataLow = 1e-9;
    bar.setScale(scale);
    EXPECT_GT(pixelsBeside(bar, Qt::blue, false), 5);
}

TEST(ColorBarWidget, SaysHowItsRangeWasChosenAndWhyThereAreNoValues) {
    ColorBarWidget bar;
    ColorScale scale = scaleOfHeights();
    bar.setScale(scale);
    EXPECT_TRUE(bar.remark().isEmpty());
    scale.rule = QStringLiteral("1–99 %");
    bar.setScale(scale);
    EXPECT_EQ(bar.remark(), QStringLiteral("1–99 %"));
    scale.note = QStringLiteral("no contact");
    bar.setScale(scale);
    EXPECT_EQ(bar.remark(), QStringLiteral("no contact"));
    bar.setScale({});
    EXPECT_TRUE(bar.remark().isEmpty());
    EXPECT_FALSE(bar.toolTip().isEmpty()) << "of every reading";
}

TEST(ColorBarWidget, ShowsAnglesInDegreesAndAnotherChannelInItsOwnUnit) {
    ColorBarWidget bar;
    ColorScale scale = scaleOfHeights();
    scale.quantity = QStringLiteral("slope");
    scale.unit = QStringLiteral("rad");
    bar.setScale(scale);
    EXPECT_EQ(bar.heading(), QStringLiteral("slope [°]"));
    scale.quantity = QStringLiteral("Phase");
    scale.unit = QStringLiteral("mV");
    bar.setScale(scale);
    EXPECT_EQ(bar.heading(), QStringLiteral("Phase [mV]"));
    scale.unit = QStringLiteral("1");
    bar.setScale(scale);
    EXPECT_EQ(bar.heading(), QStringLiteral("Phase"));
}

TEST(ColorBarWidget, NamesTheQuantityWithItsPrefix) {
    ColorBarWidget bar;
    EXPECT_TRUE(bar.heading().isEmpty());
    bar.setScale({.quantity = QStringLiteral("displacement"),
                  .unit = QStringLiteral("m"),
                  .low = -400e-12,
                  .high = 0.0,
                  .colors = {Qt::red, Qt::white}});
    EXPECT_EQ(bar.heading(), QStringLiteral("displacement [pm]"));
}

TEST(ColorBarWidget, RunsFromTheFirstColorToTheLast) {
    ColorBarWidget bar;
    bar.resize(200, bar.sizeHint().height());
    EXPECT_EQ(test::pixelsLike(bar.grab().toImage(), Qt::red), 0) << "nothing to show yet";
    bar.setScale({.quantity = QStringLiteral("height"),
                  .unit = QStringLiteral("m"),
                  .low = 0.0,
                  .high = 1e-9,
                  .colors = {Qt::red, Qt::blue}});
    const QImage image = bar.grab().toImage();
    int reds = 0;
    int blues = 0;
    for (int y = 0; y < image.height(); ++y) {
        reds += test::pixelsLike(image.copy(15, y, 1, 1), Qt::red);
        blues += test::pixelsLike(image.copy(184, y, 1, 1), Qt::blue);
    }
    EXPECT_GE(reds, 8);
    EXPECT_GE(blues, 8);
}

}  // namespace
}  // namespace asperity
