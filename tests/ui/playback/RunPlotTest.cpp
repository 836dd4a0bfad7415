#include "ui/playback/RunPlot.h"

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
    /// Whether a part of the picture has one color.
    bool isBlank(const QRect& part) {
        const QImage picture = plot.grab(part).toImage();
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                if (picture.pixel(x, y) != picture.pixel(0, 0)) {
                    return false;
                }
            }
        }
        return true;
    }
    bool hasNumbers() { return !isBlank(left) || !isBlank(bottom); }

    const QRect left{0, 30, 30, 100};     ///< where the numbers of the vertical axis are
    const QRect bottom{30, 148, 340, 8};  ///< and those of the horizontal one
    RunPlot plot{{.title = QStringLiteral("Normal force"),
                  .xName = QStringLiteral("time"),
                  .xUnit = QStringLiteral("s"),
                  .yUnit = QStringLiteral("N"),
                  .smallest = 1e-12,
                  .order = RunPlotSetup::Order::Rising,
                  .toolTip = {}}};
};

TEST_F(RunPlotTest, AnEmptyPlotHasNoNumbers) {
    EXPECT_FALSE(hasNumbers());
    plot.setLines({{.name = QStringLiteral("run"),
                    .color = &ThemeColors::ink,
                    .points = {{0.0, -1e-9}, {1.0, 5e-9}, {2.0, 0.0}}}});
    EXPECT_FALSE(isBlank(left));
    EXPECT_FALSE(isBlank(bottom));
    plot.setLines({});
    EXPECT_FALSE(hasNumbers());
}

}  // namespace
}  // namespace asperity
