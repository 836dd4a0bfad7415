#include "ui/view/ViewFrame.h"

#include "core/Units.h"

#include <gtest/gtest.h>

namespace asperity {

namespace {

constexpr double kSlack = 0.35;

bool contains(const ScanWindow& window, const Vector2& position) {
    return position.x() >= window.left && position.x() <= window.right &&
           position.y() >= window.bottom && position.y() <= window.top;
}

}  // namespace

TEST(ViewFrame, StartsInTheMiddleOfTheScan) {
    const ViewFrame frame(1.0_um, 0.5_um, 40.0_nm);
    EXPECT_EQ(frame.center(), Vector2(0.5_um, 0.25_um));
    EXPECT_NEAR(frame.window().left, 460.0_nm, 1e-15);
    EXPECT_NEAR(frame.window().top, 290.0_nm, 1e-15);
}

TEST(ViewFrame, RestsWhileTheTipStaysInTheMiddle) {
    ViewFrame frame(1.0_um, 1.0_um, 40.0_nm);
    frame.follow({513.0_nm, 487.0_nm}, kSlack);
    EXPECT_EQ(frame.center(), Vector2(0.5_um, 0.5_um));
}

TEST(ViewFrame, GoesWithTheTipInModestSteps) {
    ViewFrame frame(1.0_um, 1.0_um, 40.0_nm);
    double last = frame.center().x();
    int steps = 0;
    for (int tick = 0; tick < 600; ++tick) {
        const double x = 500.0_nm + 0.5_nm * tick;
        frame.follow({x, 0.5_um}, kSlack);
        const double step = frame.center().x() - last;
        EXPECT_LE(step, 5.0_nm);
        EXPECT_LE(x - frame.center().x(), 14.1_nm);
        steps += step > 0.0 ? 1 : 0;
        last = frame.center().x();
    }
    EXPECT_LT(steps, 75);
    EXPECT_GT(steps, 40);
}

TEST(ViewFrame, GoesStraightToATipOutsideOfIt) {
    ViewFrame frame(1.0_um, 1.0_um, 40.0_nm);
    frame.follow({200.0_nm, 700.0_nm}, kSlack);
    EXPECT_EQ(frame.center(), Vector2(200.0_nm, 700.0_nm));
}

TEST(ViewFrame, StaysWithinTheScan) {
    ViewFrame frame(1.0_um, 1.0_um, 40.0_nm);
    frame.follow({3.0_nm, 1.2_um}, kSlack);
    EXPECT_DOUBLE_EQ(frame.window().left, 0.0);
    EXPECT_DOUBLE_EQ(frame.window().top, 1.0_um);
    EXPECT_NEAR(frame.window().right, 80.0_nm, 1e-15);
}

TEST(ViewFrame, WidensToTheWholeScanAndNoFurther) {
    ViewFrame frame(1.0_um, 0.5_um, 40.0_nm);
    frame.setHalfWidth(3.0_um);
    EXPECT_DOUBLE_EQ(frame.halfWidth(), 0.5_um);
    EXPECT_DOUBLE_EQ(frame.window().left, 0.0);
    EXPECT_DOUBLE_EQ(frame.window().right, 1.0_um);
    EXPECT_DOUBLE_EQ(frame.window().bottom, 0.0);
    EXPECT_DOUBLE_EQ(frame.window().top, 0.5_um);
}

TEST(ViewFrame, AWindowAroundAPlaceIsCutOffAtTheEdges) {
    const ScanWindow inside{.left = 0.0, .right = 10.0, .bottom = 0.0, .top = 10.0};
    const ScanWindow corner = windowAround({9.0, -5.0}, 2.0, inside);
    EXPECT_TRUE(sameWindow(corner, {.left = 7.0, .right = 10.0, .bottom = 0.0, .top = 2.0}));
    EXPECT_TRUE(contains(corner, {9.0, 0.0}));
    EXPECT_FALSE(sameWindow(corner, inside));
}

}  // namespace asperity
