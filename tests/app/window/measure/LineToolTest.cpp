#include "app/window/measure/ProfileControl.h"
#include "tests/ui/view/MapFixture.h"
#include "ui/widgets/Theme.h"

namespace asperity {
namespace {

struct LineToolTest : test::ShapeFixture<LineTool> {
    void expectLine(double x1, double y1, double x2, double y2) {
        ASSERT_FALSE(tool.isEmpty());
        expectPoints(tool.line().p1(), tool.line().p2(), x1, y1, x2, y2);
    }
};

TEST_F(LineToolTest, ADragDrawsTheLineAndShowsIt) {
    const int before = test::pixelsLike(map.grab().toImage(), toQColor(kLightPalette.blue));
    drag(20, 30, 100, 90);
    expectLine(20, 30, 100, 90);
    EXPECT_GT(test::pixelsLike(map.grab().toImage(), toQColor(kLightPalette.blue)), before + 80);
}

TEST_F(LineToolTest, AClickDrawsNothingAndKeepsTheLine) {
    expectAClickKeepsIt();
    expectLine(20, 30, 100, 90);
}

TEST_F(LineToolTest, ShiftKeepsItHorizontalOrVertical) {
    drag(20, 30, 100, 40, Qt::ShiftModifier);
    expectLine(20, 30, 100, 30);
    drag(110, 110, 100, 20, Qt::ShiftModifier);
    expectLine(110, 110, 110, 20);
}

TEST_F(LineToolTest, ItsEndsCanBeDragged) {
    drag(20, 30, 100, 90);
    drag(100, 90, 60, 100);
    expectLine(20, 30, 60, 100);
    drag(20, 30, 10, 10);
    expectLine(10, 10, 60, 100);
}

TEST_F(LineToolTest, InItsMiddleItIsMovedWholeAndStaysOnTheScan) {
    drag(20, 30, 100, 30);
    drag(60, 30, 70, 60);
    expectLine(30, 60, 110, 60);
    drag(70, 60, 127, 60);
    expectLine(48, 60, 128, 60);
}

TEST_F(LineToolTest, StaysOnTheScan) {
    test::dragMouse(map, pixel(60, 60), pixel(60, 60) + QPointF(1000.0, -1000.0));
    expectLine(60, 60, 128, 128);
}

TEST_F(LineToolTest, TheCursorSaysWhatADragWouldDo) {
    drag(20, 30, 100, 30);
    EXPECT_EQ(cursorAt(100, 30), Qt::PointingHandCursor);
    EXPECT_EQ(cursorAt(60, 30), Qt::SizeAllCursor);
    EXPECT_EQ(cursorAt(60, 90), Qt::CrossCursor);
    EXPECT_TRUE(map.toolTipAt(pixel(60, 90)).contains(QStringLiteral("profile line")));
}

}  // namespace
}  // namespace asperity
