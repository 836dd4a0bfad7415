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
    plot.setProfile({{0.0, 1e-9}, {2e-9, std::numeric_limits<double>::quiet_NaN()}, {4e-9, 3e-9}});
    ASSERT_NE(CopyablePlot::of(&plot.canvas()), nullptr);
    EXPECT_EQ(CopyablePlot::of(&plot.canvas())->data(), QStringLiteral("distance [m]\theight [m]\n"
                                                                       "0\t1e-09\n"
                                                                       "2e-09\t\n"
                                                                       "4e-09\t3e-09\n"));
}

/// At an end of the line there is room on one side only.
TEST(ProfilePlot, TheLettersOfTheCursorsStandWithinThePlot) {
    constexpr int kLetter = 14;  // with its distance from the line [px]
    ProfilePlot plot;
    plot.resize(400, 200);
    plot.setProfile({{0.0, 1e-9}, {4e-9, 3e-9}});
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
