#include "tests/vtkplugins/NeedsDisplay.h"
#include "ui/view/PixelView.h"

#include <QWheelEvent>
#include <QtTest>

#include <gtest/gtest.h>

namespace asperity::test {
namespace {

class Gestures : public ::testing::Test {
protected:
    void SetUp() override { ASPERITY_NEEDS_DISPLAY(); }
    void move(const QPoint& to, Qt::MouseButton button, Qt::KeyboardModifiers modifiers = {}) {
        QMouseEvent event(QEvent::MouseMove, to, Qt::NoButton, button, modifiers);
        QApplication::sendEvent(&widget, &event);
    }
    void turnWheel(int notches, Qt::KeyboardModifiers modifiers) {
        QWheelEvent event({10.0, 10.0}, {10.0, 10.0}, {}, {0, 120 * notches}, Qt::NoButton,
                          modifiers, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&widget, &event);
    }

    GestureWidget widget;
    QSignalSpy dragged{&widget, &GestureWidget::dragged};
    QSignalSpy turned{&widget, &GestureWidget::turned};
    QSignalSpy lifted{&widget, &GestureWidget::lifted};
    QSignalSpy zoomed{&widget, &GestureWidget::zoomed};
};

TEST_F(Gestures, TheLeftButtonDragsAndTheRightOneTurns) {
    QTest::mousePress(&widget, Qt::LeftButton, {}, {10, 10});
    EXPECT_TRUE(widget.isDragging());
    move({14, 7}, Qt::LeftButton);
    move({24, 7}, Qt::LeftButton, Qt::ShiftModifier);
    QTest::mouseRelease(&widget, Qt::LeftButton, {}, {24, 7});
    EXPECT_FALSE(widget.isDragging());
    ASSERT_EQ(dragged.count(), 2);
    EXPECT_EQ(dragged[0][0].toPointF(), QPointF(4.0, -3.0));
    EXPECT_EQ(dragged[1][0].toPointF(), QPointF(1.0, 0.0)) << "a tenth with Shift";
    QTest::mousePress(&widget, Qt::RightButton, {}, {10, 10});
    EXPECT_FALSE(widget.isDragging());
    move({15, 10}, Qt::RightButton);
    ASSERT_EQ(turned.count(), 1);
    EXPECT_EQ(turned[0][0].toPointF(), QPointF(5.0, 0.0));
}

TEST_F(Gestures, TheWheelLiftsAndWithCtrlItZooms) {
    turnWheel(-2, Qt::NoModifier);
    turnWheel(1, Qt::ShiftModifier);
    turnWheel(3, Qt::ControlModifier);
    ASSERT_EQ(lifted.count(), 2);
    EXPECT_EQ(lifted[0][0].toDouble(), -2.0);
    EXPECT_EQ(lifted[1][0].toDouble(), 0.1);
    ASSERT_EQ(zoomed.count(), 1);
    EXPECT_EQ(zoomed[0][0].toDouble(), 3.0);
}

TEST_F(Gestures, PlusAndMinusZoom) {
    QTest::keyClick(&widget, Qt::Key_Plus);
    QTest::keyClick(&widget, Qt::Key_Minus);
    QTest::keyClick(&widget, Qt::Key_A);
    ASSERT_EQ(zoomed.count(), 2);
    EXPECT_EQ(zoomed[0][0].toDouble(), 1.0);
    EXPECT_EQ(zoomed[1][0].toDouble(), -1.0);
}

}  // namespace
}  // namespace asperity::test
