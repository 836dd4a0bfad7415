#include "app/window/recording/RunPlot.h"

#include <QImage>
#include <QtTest>

#include <gtest/gtest.h>

namespace asperity {
namespace {

class RunPlotTest : public ::testing::Test {
protected:
    void SetUp() override {
        plot.resize(400, 160);
        plot.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&plot));
    }
    /// Whether something as dark as numbers is in a part of the picture; ticks are paler.
    bool hasText(const QRect& part) {
        constexpr int kDark = 150;  // of 255
        const QImage picture = plot.grab(part).toImage();
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                if (qGray(picture.pixel(x, y)) < kDark) {
                    return true;
                }
            }
        }
        return false;
    }

    const QRect left{0, 30, 40, 100};      ///< where the numbers of the vertical axis are
    const QRect bottom{60, 145, 320, 15};  ///< and those of the horizontal one
    RunPlot plot{{.title = QStringLiteral("Normal force"),
                  .xName = QStringLiteral("time"),
                  .xUnit = QStringLiteral("s"),
                  .yUnit = QStringLiteral("N"),
                  .smallest = 1e-12,
                  .order = RunPlotSetup::Order::Rising,
                  .toolTip = {}}};
};

TEST_F(RunPlotTest, AnEmptyPlotHasNoNumbers) {
    EXPECT_FALSE(hasText(left));
    EXPECT_FALSE(hasText(bottom));
    plot.setLines({{.name = QStringLiteral("run"),
                    .color = &ThemeColors::ink,
                    .points = {{0.0, -1e-9}, {1.0, 5e-9}, {2.0, 0.0}}}});
    EXPECT_TRUE(hasText(left));
    EXPECT_TRUE(hasText(bottom));
    plot.setLines({});
    EXPECT_FALSE(hasText(left));
    EXPECT_FALSE(hasText(bottom));
}

}  // namespace
}  // namespace asperity
