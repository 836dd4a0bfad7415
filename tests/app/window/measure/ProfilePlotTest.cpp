#include "app/window/measure/ProfilePlot.h"

#include "tests/support/PixelCount.h"
#include "ui/plot/CopyablePlot.h"
#include "ui/widgets/Theme.h"

#include <QImage>
#include <QWidget>

#include <gtest/gtest.h>

#include <limits>
#include <utility>

namespace asperity {
namespace {

TEST(ProfilePlot, CopiesDistancesAndHeights) {
    ProfilePlot plot;
    const ProfileCurve first{
        "Line 1", 0, {{0.0, 1e-9}, {2e-9, std::numeric_limits<double>::quiet_NaN()}, {4e-9, 3e-9}}};
    plot.setCurves({first}, 0);
    ASSERT_NE(CopyablePlot::of(&plot.canvas()), nullptr);
    EXPECT_EQ(CopyablePlot::of(&plot.canvas())->data(), QStringLiteral("distance [m]\theight [m]\n"
                                                                       "0\t1e-09\n"
                                                                       "2e-09\t\n"
                                                                       "4e-09\t3e-09\n"));
    plot.setCurves({first, {"Line 2", 1, {{0.0, 5e-9}, {1e-9, 6e-9}}}}, 1);
    EXPECT_EQ(CopyablePlot::of(&plot.canvas())->data(),
              QStringLiteral("distance, Line 1 [m]\theight, Line 1 [m]\tdistance, Line 2 [m]\t"
                             "height, Line 2 [m]\n"
                             "0\t1e-09\t0\t5e-09\n"
                             "2e-09\t\t1e-09\t6e-09\n"
                             "4e-09\t3e-09\t\t\n"));
}

TEST(ProfilePlot, DrawsEachLineInItsColor) {
    ProfilePlot plot;
    plot.resize(400, 200);
    const auto pixelsIn = [&plot](const QColor& color) {
        plot.grab();  // lays it out
        return test::pixelsLike(plot.canvas().grab().toImage(), color);
    };
    const ProfileCurve first{"Line 1", 0, {{0.0, 1e-9}, {4e-9, 1e-9}}};
    plot.setCurves({first}, 0);
    EXPECT_GT(pixelsIn(theme::colors().blue), 200);
    EXPECT_EQ(pixelsIn(theme::colors().orange), 0);
    const ProfileCurve second{"Line 2", 1, {{0.0, 3e-9}, {4e-9, 3e-9}}};
    plot.setCurves({first, second}, 0);  // the selected one is drawn stronger
    EXPECT_GT(pixelsIn(theme::colors().blue), 200);
    plot.setCurves({first, second}, 1);
    EXPECT_GT(pixelsIn(theme::colors().orange), 200);
    plot.setCurves({}, -1);
    EXPECT_EQ(pixelsIn(theme::colors().blue), 0);
}

/// At an end of the line there is room on one side only.
TEST(ProfilePlot, TheLettersOfTheCursorsStandWithinThePlot) {
    constexpr int kLetter = 14;  // with its distance from the line [px]
    ProfilePlot plot;
    plot.resize(400, 200);
    plot.setCurves({{"Line 1", 0, {{0.0, 1e-9}, {4e-9, 3e-9}}}}, 0);
    const auto inkAtBothEnds = [&plot] {
        plot.grab();  // lays it out
        const QImage drawn = plot.canvas().grab().toImage();
        const int right = drawn.width() - kLetter - 2;
        const auto inkIn = [&drawn](int left) {
            return test::pixelsLike(drawn.copy(left, 2, kLetter, 16), theme::colors().ink);
        };
        return std::pair(inkIn(2), inkIn(right));
    };
    plot.setCursors({2e-9, 2e-9});
    const auto [noneLeft, noneRight] = inkAtBothEnds();
    for (const ProfilePlot::Cursors& ends :
         {ProfilePlot::Cursors{0.0, 4e-9}, ProfilePlot::Cursors{4e-9, 0.0}}) {
        plot.setCursors(ends);
        const auto [left, right] = inkAtBothEnds();
        EXPECT_GT(left, noneLeft + 8);
        EXPECT_GT(right, noneRight + 8);
    }
}

}  // namespace
}  // namespace asperity
