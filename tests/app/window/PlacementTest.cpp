#include "ui/shell/Dialogs.h"

#include <gtest/gtest.h>

#include <ostream>

namespace asperity {
namespace {

const QSize kWanted(1600, 1000);

TEST(Placement, AWindowOpensInTheMiddleAndInsideOfAnyScreen) {
    for (const QRect& screen : {QRect(0, 0, 1024, 700), QRect(0, 27, 1280, 773),
                                QRect(0, 0, 1920, 1080), QRect(1920, 0, 3840, 2160)}) {
        const QRect geometry = openingGeometry(kWanted, screen);
        EXPECT_TRUE(screen.contains(geometry)) << screen.width();
        EXPECT_GE(geometry.top() - screen.top(), 30) << "the title bar can be seen";
        EXPECT_LE(geometry.width(), kWanted.width());
        EXPECT_NEAR(geometry.center().x(), screen.center().x(), 1.0);
    }
    EXPECT_EQ(openingGeometry(kWanted, {0, 0, 3840, 2160}).size(), kWanted);
}

/// What is wanted is more than a usual screen has: it was opened on three quarters of one.
TEST(Placement, TheFirstWindowFillsAUsualScreen) {
    const QRect screen(0, 0, 1920, 1080);
    const QRect geometry = openingGeometry({2400, 1500}, screen);
    EXPECT_GE(geometry.width(), 0.98 * screen.width());
    EXPECT_GE(geometry.height(), 0.95 * screen.height());
}

TEST(Placement, AnotherWindowOpensBesideWhereThereIsRoom) {
    const QRect screen(0, 0, 3840, 2160);
    const QSize size(1080, 760);
    const QRect left(200, 100, 1600, 1000);
    const QRect onItsRight = placeBeside(left, size, screen);
    EXPECT_GT(onItsRight.left(), left.right());
    EXPECT_EQ(onItsRight.top(), left.top());
    EXPECT_EQ(onItsRight.size(), size);
    const QRect right(2000, 100, 1600, 1000);
    EXPECT_LT(placeBeside(right, size, screen).right(), right.left());
}

TEST(Placement, AnotherWindowStaysOnTheScreenWhereThereIsNoRoom) {
    for (const QRect& screen : {QRect(0, 0, 1024, 700), QRect(0, 0, 1600, 1000)}) {
        const QRect geometry = placeBeside(openingGeometry(kWanted, screen), {1080, 760}, screen);
        EXPECT_TRUE(screen.contains(geometry)) << screen.width();
        EXPECT_GE(geometry.right(), screen.right() - 10) << "over the window's right edge";
    }
    const QRect below = placeBeside({100, 900, 300, 300}, {400, 600}, {0, 0, 1600, 1000});
    EXPECT_LE(below.bottom(), 1000);
}

}  // namespace
}  // namespace asperity
