#include "app/window/map/PixelCurveView.h"
#include "tests/ui/view/MapFixture.h"

namespace asperity::test {
namespace {

/// 4 x 2 pixels of 20 nm, from (20 nm, 40 nm) on.
struct PixelToolTest : MapFixture {
    PixelToolTest() {
        use(tool);
        tool.setPart(part());
    }
    static MappedPart part() {
        return {QRectF(QPointF(20e-9, 40e-9), QPointF(100e-9, 80e-9)), {4, 2}, "adhesion force"};
    }
    void click(double x, double y) { drag(x, y, x, y); }

    PixelTool tool;
};

TEST_F(PixelToolTest, AClickChoosesThePixelUnderIt) {
    QSignalSpy chosen(&tool, &PixelTool::pixelChosen);
    click(21, 79);
    ASSERT_EQ(chosen.count(), 1) << "once, not for the release as well";
    EXPECT_EQ(chosen.back().front().toPoint(), QPoint(0, 0)) << "row 0 is the far one";
    click(99, 41);
    EXPECT_EQ(tool.pixel(), QPoint(3, 1));
    click(50, 70);
    EXPECT_EQ(tool.pixel(), QPoint(1, 0));
}

TEST_F(PixelToolTest, ADragGoesFromPixelToPixel) {
    QSignalSpy chosen(&tool, &PixelTool::pixelChosen);
    drag(25, 75, 95, 45);
    EXPECT_EQ(chosen.front().front().toPoint(), QPoint(0, 0));
    EXPECT_EQ(tool.pixel(), QPoint(3, 1));
}

TEST_F(PixelToolTest, BesideTheMapThereIsNone) {
    QSignalSpy chosen(&tool, &PixelTool::pixelChosen);
    click(10, 60);
    click(60, 90);
    EXPECT_EQ(chosen.count(), 0);
    EXPECT_EQ(cursorAt(10, 60), Qt::ForbiddenCursor);
    EXPECT_EQ(cursorAt(50, 60), Qt::PointingHandCursor);
    tool.setPart(std::nullopt);
    click(50, 60);
    EXPECT_EQ(chosen.count(), 0);
}

TEST_F(PixelToolTest, AnotherMapForgetsThePixelAndAnotherQuantityDoesNot) {
    click(50, 70);
    MappedPart other = part();
    other.label = "stiffness";
    tool.setPart(other);
    EXPECT_TRUE(tool.pixel());
    other.pixels = {8, 4};
    tool.setPart(other);
    EXPECT_FALSE(tool.pixel());
}

}  // namespace
}  // namespace asperity::test
