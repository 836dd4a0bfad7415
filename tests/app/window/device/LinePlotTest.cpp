#include "app/window/device/LinePlot.h"

#include "tests/ui/widgets/MouseEvents.h"
#include "ui/widgets/Theme.h"

#include <QImage>
#include <QLabel>
#include <QToolButton>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asperity {
namespace {

constexpr double kPlottedLength = 1e-6;    ///< of a line [m]
constexpr double kSmallestHeight = 1e-10;  ///< extent of the value axis [m]

LinePlot::Setup heightsAlongALine() {
    return {.title = QStringLiteral("Height"),
            .unit = QStringLiteral("m"),
            .smallest = kSmallestHeight};
}

/// 0 to 10 nm forward, and as far as `backTo` [m] at -1 nm backward.
LinePlot::Ways rampAndBack(int points, double backTo = 0.0) {
    LinePlot::Ways ways;
    for (int i = 0; i < points; ++i) {
        const double share = static_cast<double>(i) / (points - 1);
        ways.trace.append({share * kPlottedLength, share * 10e-9});
        ways.retrace.append({kPlottedLength - share * (kPlottedLength - backTo), -1e-9});
    }
    return ways;
}

class LinePlotTest : public ::testing::Test {
protected:
    void SetUp() override {
        plot.resize(400, 200);
        plot.grab();  // lays out
    }
    /// Returns the pixel of a share of the line while nothing is zoomed.
    [[nodiscard]] QPointF at(double share) { return {share * plot.canvas().width(), 40.0}; }
    [[nodiscard]] double shownHeights() const { return plot.shown().y.high - plot.shown().y.low; }

    const double nan = std::numeric_limits<double>::quiet_NaN();
    LinePlot plot{heightsAlongALine()};
};

TEST_F(LinePlotTest, RangesOverBothWaysAndAtLeastOverTheSmallestExtent) {
    plot.setWays({.trace = {{0.0, 1e-9}, {5e-7, nan}, {1e-6, 4e-9}},
                  .retrace = {{1e-6, -3e-9}, {0.0, 2e-9}}},
                 kPlottedLength);
    EXPECT_EQ(plot.shown().x.low, 0.0);
    EXPECT_EQ(plot.shown().x.high, kPlottedLength);
    EXPECT_LT(plot.shown().y.low, -3e-9);
    EXPECT_GT(plot.shown().y.high, 4e-9);
    EXPECT_LT(shownHeights(), 1.5 * 7e-9);
    plot.setWays({.trace = {{0.0, 5e-9}, {1e-6, 5.001e-9}}, .retrace = {}}, kPlottedLength);
    EXPECT_LT(plot.shown().y.low, 5e-9);
    EXPECT_GT(plot.shown().y.high, 5.001e-9);
    EXPECT_GE(shownHeights(), kSmallestHeight);
    EXPECT_LT(shownHeights(), 1.5 * kSmallestHeight);
}

TEST_F(LinePlotTest, CopiesBothWays) {
    plot.setWays({.trace = {{0.0, 1e-9}, {2e-9, nan}, {4e-9, 3e-9}}, .retrace = {{4e-9, 2e-9}}},
                 4e-9);
    ASSERT_NE(CopyablePlot::of(&plot.canvas()), nullptr);
    EXPECT_EQ(CopyablePlot::of(&plot.canvas())->data(), plot.table().tabSeparated());
    EXPECT_EQ(
        plot.table().tabSeparated(),
        QStringLiteral("distance [m]\tHeight, trace [m]\tdistance back [m]\tHeight, retrace [m]\n"
                       "0\t1e-09\t4e-09\t2e-09\n"
                       "2e-09\t\t\t\n"
                       "4e-09\t3e-09\t\t\n"));
}

TEST_F(LinePlotTest, ThePointerReadsWhatIsThereOfALongLine) {
    plot.setWays(rampAndBack(100'000), kPlottedLength);
    plot.grab();  // lays out with numbers
    EXPECT_TRUE(plot.reading().isEmpty());
    test::sendMouse(plot.canvas(), QEvent::MouseMove, at(0.5), Qt::NoButton);
    const QString both = plot.reading();
    EXPECT_TRUE(both.startsWith(QStringLiteral("0.50 µm"))) << both.toStdString();
    EXPECT_TRUE(both.contains(QStringLiteral("trace 5.00 nm"))) << both.toStdString();
    EXPECT_TRUE(both.contains(QStringLiteral("retrace -1.00 nm"))) << both.toStdString();
    plot.setWays(rampAndBack(100'000, 6e-7), kPlottedLength);
    const QString onTheWayBack = plot.reading();
    EXPECT_TRUE(onTheWayBack.contains(QStringLiteral("trace 5.00 nm")));
    EXPECT_FALSE(onTheWayBack.contains(QStringLiteral("retrace"))) << onTheWayBack.toStdString();
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&plot.canvas(), &leave);
    EXPECT_TRUE(plot.reading().isEmpty());
}

TEST_F(LinePlotTest, KeepsAZoomUntilTheLengthIsAnother) {
    const auto* button = plot.findChild<QToolButton*>(QStringLiteral("resetZoom"));
    ASSERT_NE(button, nullptr);
    plot.setWays(rampAndBack(100), kPlottedLength);
    plot.grab();  // lays out with numbers
    EXPECT_TRUE(button->isHidden());
    test::dragMouse(plot.canvas(), at(0.2), at(0.4) + QPointF(0.0, 2.0));
    plot.setWays(rampAndBack(50), kPlottedLength);
    EXPECT_NEAR(plot.shown().x.low, 0.2 * kPlottedLength, 0.01 * kPlottedLength);
    EXPECT_NEAR(plot.shown().x.high, 0.4 * kPlottedLength, 0.01 * kPlottedLength);
    EXPECT_FALSE(button->isHidden());
    plot.setWays(rampAndBack(50), 2.0 * kPlottedLength);
    EXPECT_EQ(plot.shown().x.low, 0.0);
    EXPECT_EQ(plot.shown().x.high, 2.0 * kPlottedLength);
    EXPECT_TRUE(button->isHidden());
}

TEST_F(LinePlotTest, DrawsNothingWithoutValues) {
    const auto pictureOf = [this](const LinePlot::Ways& ways) {
        plot.setWays(ways, kPlottedLength);
        plot.grab();  // lays out with numbers or without
        plot.setWays(ways, kPlottedLength);
        plot.grab();
        return plot.canvas().grab().toImage();
    };
    const double infinity = std::numeric_limits<double>::infinity();
    const QImage empty = pictureOf({});
    EXPECT_EQ(pictureOf({.trace = {{0.0, nan}, {1e-6, infinity}}, .retrace = {{nan, 1.0}}}), empty);
    EXPECT_NE(pictureOf(rampAndBack(100)), empty);
    EXPECT_EQ(pictureOf({}), empty);

    LinePlot tiny({.title = QStringLiteral("Height"), .unit = QStringLiteral("m")});
    tiny.resize(400, 200);
    tiny.setWays({.trace = {{0.0, 1e-300}, {1e-300, nan}, {2e-300, 3e-300}}, .retrace = {}},
                 2e-300);
    tiny.grab();
    for (const AxisRange& range : {tiny.shown().x, tiny.shown().y}) {
        EXPECT_LT(range.low, range.high);
        EXPECT_TRUE(std::isfinite(range.high - range.low));
    }
}

TEST_F(LinePlotTest, TheLegendTakesTheColorsOfAnotherTheme) {
    plot.setWays(rampAndBack(100), kPlottedLength);
    const auto* title = plot.findChild<QLabel*>();
    ASSERT_NE(title, nullptr);
    EXPECT_TRUE(title->text().contains(QStringLiteral("Height</b> [nm]")));
    for (const ThemeChoice choice : {ThemeChoice::Dark, ThemeChoice::Desktop}) {
        theme::choose(choice);
        const QString text = title->text();
        EXPECT_TRUE(text.contains(theme::colors().blue.name())) << text.toStdString();
        EXPECT_TRUE(text.contains(theme::colors().orange.name())) << text.toStdString();
    }
}

}  // namespace
}  // namespace asperity
