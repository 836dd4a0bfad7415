#include "tests/ui/view/MapFixture.h"
#include "ui/view/ShapeTool.h"
#include "ui/widgets/Theme.h"

namespace asperity {
namespace {

struct RectangleToolTest : test::ShapeFixture<RectangleTool> {
    void expectRectangle(double left, double bottom, double right, double top) {
        const QRectF drawn = tool.rectangle();
        expectPoints(drawn.topLeft(), drawn.bottomRight(), left, bottom, right, top);
    }
};

TEST_F(RectangleToolTest, ADragInAnyDirectionDrawsIt) {
    drag(100, 90, 20, 30);
    expectRectangle(20, 30, 100, 90);
    EXPECT_GT(test::pixelsLike(map.grab().toImage(), toQColor(kLightPalette.green)), 100);
}

TEST_F(RectangleToolTest, AClickDrawsNothingAndKeepsIt) {
    expectAClickKeepsIt();
    expectRectangle(20, 30, 100, 90);
}

TEST_F(RectangleToolTest, ShiftMakesASquare) {
    drag(20, 30, 60, 50, Qt::ShiftModifier);
    expectRectangle(20, 30, 60, 70);
}

TEST_F(RectangleToolTest, CornersAndSidesCanBeDragged) {
    drag(20, 30, 100, 90);
    drag(100, 90, 110, 80);
    expectRectangle(20, 30, 110, 80);
    drag(20, 30, 30, 40);
    expectRectangle(30, 40, 110, 80);
    drag(30, 60, 50, 75);
    expectRectangle(50, 40, 110, 80);
    drag(80, 80, 60, 120);
    expectRectangle(50, 40, 110, 120);
}

TEST_F(RectangleToolTest, ItsInsideMovesItAndItStaysOnTheScan) {
    drag(20, 30, 60, 70);
    drag(40, 50, 50, 45);
    expectRectangle(30, 25, 70, 65);
    drag(50, 45, 5, 100);
    expectRectangle(0, 80, 40, 120);
    test::dragMouse(map, pixel(100, 10), pixel(100, 10) + QPointF(500.0, 500.0));
    expectRectangle(100, 0, 128, 10);
}

TEST_F(RectangleToolTest, TheCursorSaysWhatADragWouldDo) {
    drag(20, 30, 100, 90);
    EXPECT_EQ(cursorAt(60, 60), Qt::SizeAllCursor);
    EXPECT_EQ(cursorAt(20, 60), Qt::SizeHorCursor);
    EXPECT_EQ(cursorAt(60, 90), Qt::SizeVerCursor);
    EXPECT_EQ(cursorAt(20, 30), Qt::SizeBDiagCursor);
    EXPECT_EQ(cursorAt(20, 90), Qt::SizeFDiagCursor);
    EXPECT_EQ(cursorAt(115, 115), Qt::CrossCursor);
    drag(20, 90, 20, 10);  // past the other side
    EXPECT_EQ(cursorAt(20, 10), Qt::SizeBDiagCursor);
    EXPECT_EQ(cursorAt(20, 30), Qt::SizeFDiagCursor);
}

}  // namespace
}  // namespace asperity
