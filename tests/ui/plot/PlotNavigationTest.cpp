#include "ui/plot/PlotNavigation.h"

#include "tests/ui/widgets/MouseEvents.h"

#include <QSignalSpy>
#include <QtTest>

#include <gtest/gtest.h>

namespace asperity {
namespace {

using test::sendMouse;
using test::sendWheel;

/// A canvas of 200 x 100 pixels that shows 0..20 along and -1..1 up.
struct PlotNavigationTest : ::testing::Test {
    void SetUp() override {
        canvas.resize(200, 100);
        navigation.fit(kWhole);
    }
    void drag(const QPoint& from, const QPoint& to, Qt::MouseButton button,
              Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        sendMouse(canvas, QEvent::MouseButtonPress, from, button, modifiers);
        sendMouse(canvas, QEvent::MouseMove, to, button, modifiers);
        sendMouse(canvas, QEvent::MouseButtonRelease, to, button, modifiers);
    }
    void expectShown(double left, double right, double low, double high) {
        const PlotWindow& shown = navigation.fit(kWhole);
        EXPECT_NEAR(shown.x.low, left, 1e-9);
        EXPECT_NEAR(shown.x.high, right, 1e-9);
        EXPECT_NEAR(shown.y.low, low, 1e-9);
        EXPECT_NEAR(shown.y.high, high, 1e-9);
    }

    static constexpr PlotWindow kWhole{{0.0, 20.0}, {-1.0, 1.0}};
    QWidget canvas;
    PlotNavigation navigation{canvas};
};

TEST_F(PlotNavigationTest, ShowsAllUntilAUserZooms) {
    expectShown(0.0, 20.0, -1.0, 1.0);
    EXPECT_FALSE(navigation.isZoomed());
    EXPECT_NEAR(navigation.fit({{0.0, 40.0}, {-1.0, 1.0}}).x.high, 40.0, 0.0);
}

TEST_F(PlotNavigationTest, TheWheelZoomsAboutThePointer) {
    sendWheel(canvas, {50, 25}, 1);
    expectShown(5.0 - 5.0 / 1.25, 5.0 + 15.0 / 1.25, 0.5 - 1.5 / 1.25, 0.5 + 0.5 / 1.25);
    EXPECT_TRUE(navigation.isZoomed());
    sendWheel(canvas, {50, 25}, -1);
    expectShown(0.0, 20.0, -1.0, 1.0);
}

TEST_F(PlotNavigationTest, CtrlAndShiftZoomOneAxis) {
    sendWheel(canvas, {100, 50}, 2, Qt::ControlModifier);
    expectShown(10.0 - 10.0 / 1.5625, 10.0 + 10.0 / 1.5625, -1.0, 1.0);
    navigation.reset();
    sendWheel(canvas, {100, 50}, 2, Qt::ShiftModifier);
    expectShown(0.0, 20.0, -1.0 / 1.5625, 1.0 / 1.5625);
}

TEST_F(PlotNavigationTest, ADragZoomsIntoARectangle) {
    drag({20, 25}, {120, 75}, Qt::LeftButton);
    expectShown(2.0, 12.0, -0.5, 0.5);
}

TEST_F(PlotNavigationTest, AFlatDragZoomsAlongItsLongSide) {
    drag({20, 50}, {120, 52}, Qt::LeftButton);
    expectShown(2.0, 12.0, -1.0, 1.0);
}

TEST_F(PlotNavigationTest, AClickZoomsNothing) {
    drag({20, 50}, {22, 51}, Qt::LeftButton);
    EXPECT_FALSE(navigation.isZoomed());
}

TEST_F(PlotNavigationTest, ADoubleClickShowsAllAgain) {
    drag({20, 25}, {120, 75}, Qt::LeftButton);
    QSignalSpy changed(&navigation, &PlotNavigation::windowChanged);
    sendMouse(canvas, QEvent::MouseButtonDblClick, {30, 30}, Qt::LeftButton);
    expectShown(0.0, 20.0, -1.0, 1.0);
    EXPECT_EQ(changed.count(), 1);
}

TEST_F(PlotNavigationTest, TheRightButtonOrCtrlPans) {
    drag({100, 50}, {90, 60}, Qt::RightButton);
    expectShown(1.0, 21.0, -0.8, 1.2);
    drag({100, 50}, {110, 40}, Qt::LeftButton, Qt::ControlModifier);
    expectShown(0.0, 20.0, -1.0, 1.0);
}

TEST_F(PlotNavigationTest, NeverShowsBeyondItsLimits) {
    QWidget other;
    other.resize(200, 100);
    PlotNavigation limited(other, AxisRange{0.0, 20.0});
    limited.fit(kWhole);
    sendWheel(other, {100, 50}, 2);
    sendMouse(other, QEvent::MouseButtonPress, {0, 50}, Qt::RightButton);
    sendMouse(other, QEvent::MouseMove, {190, 50}, Qt::RightButton);
    EXPECT_NEAR(limited.fit(kWhole).x.low, 0.0, 1e-12);
    EXPECT_LE(limited.fit(kWhole).x.high, 20.0);
    sendWheel(other, {100, 50}, -40);
    EXPECT_LE(limited.fit(kWhole).x.high, 20.0);
}

TEST_F(PlotNavigationTest, TheCursorIsUnderThePointerAndGoesWithIt) {
    EXPECT_FALSE(navigation.cursor());
    sendMouse(canvas, QEvent::MouseMove, {50, 10}, Qt::NoButton);
    EXPECT_NEAR(navigation.cursor().value(), 5.0, 1e-9);
    EXPECT_NEAR(navigation.pixelOf(5.0), 50.0, 1e-9);
    EXPECT_NEAR(navigation.xOf(50.0), 5.0, 1e-9);
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&canvas, &leave);
    EXPECT_FALSE(navigation.cursor());
}

}  // namespace
}  // namespace asperity
