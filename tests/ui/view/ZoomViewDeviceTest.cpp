// What the user does to the view with mouse and keys.
#include "core/Units.h"
#include "tests/ui/view/ZoomViewFixture.h"

#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QWheelEvent>

#include <cmath>

namespace asperity::test {

namespace {

Vector3 firstMove(const QSignalSpy& dragged) {
    const QList<QVariant> move = dragged.value(0);
    return {move.value(0).toDouble(), move.value(1).toDouble(), move.value(2).toDouble()};
}

void drag(ZoomView& view, Qt::MouseButton button, const QPointF& from, const QPointF& to,
          Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    const auto send = [&](QEvent::Type type, const QPointF& at, Qt::MouseButtons down) {
        QMouseEvent event(type, at, button, down, modifiers);
        QApplication::sendEvent(&view, &event);
    };
    send(QEvent::MouseButtonPress, from, button);
    send(QEvent::MouseMove, to, button);
    send(QEvent::MouseButtonRelease, to, Qt::NoButton);
}

void turnWheel(ZoomView& view, double notches, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    const QPointF at = view.rect().center();
    QWheelEvent event(at, view.mapToGlobal(at.toPoint()), {}, QPoint(0, std::lround(120 * notches)),
                      Qt::NoButton, modifiers, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view, &event);
}

}  // namespace

TEST_F(ZoomViewTest, ADraggedTipStaysUnderThePointer) {
    view->showSnapshot(moments.away);
    for (const double turned : {0.0, 130.0, 250.0}) {
        drag(*view, Qt::RightButton, {200.0, 200.0}, {200.0 + turned, 190.0});
        const Vector3 tip = moments.away.sample.output.model.tip;
        const QPointF from = view->onScreen(tip);
        QSignalSpy dragged(view.get(), &ZoomView::tipDragged);
        drag(*view, Qt::LeftButton, from, from + QPointF(40.0, -25.0));
        ASSERT_EQ(dragged.count(), 1);
        const Vector3 move = firstMove(dragged);
        EXPECT_EQ(move.z(), 0.0);
        const QPointF to = view->onScreen(tip + move);
        EXPECT_NEAR(to.x() - from.x(), 40.0, 0.1);
        EXPECT_NEAR(to.y() - from.y(), -25.0, 0.1);
    }
}

TEST_F(ZoomViewTest, ShiftDragsATenthAsFar) {
    QSignalSpy dragged(view.get(), &ZoomView::tipDragged);
    drag(*view, Qt::LeftButton, {300.0, 300.0}, {340.0, 300.0});
    const Vector3 plain = firstMove(dragged);
    dragged.clear();
    drag(*view, Qt::LeftButton, {300.0, 300.0}, {340.0, 300.0}, Qt::ShiftModifier);
    EXPECT_LT((firstMove(dragged) - 0.1 * plain).norm(), 1e-6 * plain.norm());
    EXPECT_GT(plain.norm(), 1.0_nm);
}

TEST_F(ZoomViewTest, ThePictureStaysStillUnderADrag) {
    view->showSnapshot(moments.away);
    const ScanWindow before = view->window().value();
    QTest::mousePress(view.get(), Qt::LeftButton, Qt::NoModifier, {300, 300});
    view->showSnapshot(movedBy(moments.away, {18.0_nm, 0.0, 0.0}));
    EXPECT_TRUE(sameWindow(view->window().value(), before));
    QTest::mouseRelease(view.get(), Qt::LeftButton, Qt::NoModifier, {300, 300});
    view->showSnapshot(movedBy(moments.away, {18.0_nm, 0.0, 0.0}));
    EXPECT_FALSE(sameWindow(view->window().value(), before));
}

TEST_F(ZoomViewTest, TheWheelLiftsAndLowersTheTip) {
    QSignalSpy dragged(view.get(), &ZoomView::tipDragged);
    QSignalSpy lifted(view.get(), &ZoomView::lifted);
    turnWheel(*view, 1.0);
    turnWheel(*view, -2.0);
    turnWheel(*view, 1.0, Qt::ShiftModifier);
    ASSERT_EQ(lifted.count(), 3);
    EXPECT_EQ(lifted.at(0).at(0).toDouble(), 1.0);
    EXPECT_EQ(lifted.at(1).at(0).toDouble(), -2.0);
    EXPECT_NEAR(lifted.at(2).at(0).toDouble(), 0.1, 1e-12);
    EXPECT_TRUE(dragged.isEmpty());
}

TEST_F(ZoomViewTest, ControlWheelAndKeysZoom) {
    QSignalSpy dragged(view.get(), &ZoomView::tipDragged);
    QSignalSpy frames(view.get(), &ZoomView::frameChanged);
    const double first = view->halfWidth();
    turnWheel(*view, -1.0, Qt::ControlModifier);
    EXPECT_NEAR(view->halfWidth(), 1.2 * first, 1e-15);
    EXPECT_TRUE(dragged.isEmpty());
    settle();
    EXPECT_EQ(frames.count(), 1);
    EXPECT_NEAR(view->window()->right - view->window()->left, 2.4 * first, 1e-15);
    QTest::keyClick(view.get(), Qt::Key_Plus);
    EXPECT_NEAR(view->halfWidth(), first, 1e-15);
    QTest::keyClick(view.get(), Qt::Key_Minus);
    QTest::keyClick(view.get(), Qt::Key_Minus);
    EXPECT_NEAR(view->halfWidth(), 1.44 * first, 1e-15);
}

TEST_F(ZoomViewTest, ZoomsFromTheTipToTheWholeScan) {
    turnWheel(*view, -50.0, Qt::ControlModifier);
    EXPECT_DOUBLE_EQ(view->halfWidth(), 64.0_nm);
    EXPECT_DOUBLE_EQ(view->window()->left, 0.0);
    turnWheel(*view, 50.0, Qt::ControlModifier);
    EXPECT_GT(view->halfWidth(), 15.0_nm);
    EXPECT_LT(view->halfWidth(), 30.0_nm);
    view->showSnapshot(moments.deep);
    settle();
}

TEST_F(ZoomViewTest, RightDragTurnsTheView) {
    QSignalSpy dragged(view.get(), &ZoomView::tipDragged);
    const Vector3 corner(view->window()->left, view->window()->bottom, 0.0);
    const QPointF before = view->onScreen(corner);
    const Vector3 eye = view->camera().out();
    drag(*view, Qt::RightButton, {300.0, 300.0}, {380.0, 300.0});
    EXPECT_GT(QLineF(before, view->onScreen(corner)).length(), 20.0);
    EXPECT_TRUE(dragged.isEmpty());
    drag(*view, Qt::RightButton, {300.0, 300.0}, {300.0, -3000.0});
    EXPECT_GT(view->camera().out().z(), 0.1) << "above the surface";
    drag(*view, Qt::RightButton, {300.0, 300.0}, {300.0, 3000.0});
    EXPECT_GT(view->camera().out().z(), 0.9);
    view->resetCamera();
    EXPECT_EQ(view->camera().out(), eye);
    EXPECT_LT(QLineF(before, view->onScreen(corner)).length(), 0.1);
}

TEST_F(ZoomViewTest, ComesToRestByItself) {
    view->showSnapshot(moments.deep);
    settle();
    QSignalSpy frames(view.get(), &ZoomView::frameRendered);
    drag(*view, Qt::RightButton, {300.0, 300.0}, {330.0, 300.0});
    settle();
    EXPECT_GE(frames.count(), 2) << "one in motion, one at rest";
    const auto count = frames.count();
    QTest::qWait(300);  // longer than the view goes on after anything: none may follow
    EXPECT_EQ(frames.count(), count);
}

TEST_F(ZoomViewTest, LeavesOtherKeysAndTheMiddleButtonAlone) {
    QSignalSpy dragged(view.get(), &ZoomView::tipDragged);
    const Vector3 eye = view->camera().out();
    drag(*view, Qt::MiddleButton, {300.0, 300.0}, {350.0, 310.0});
    EXPECT_TRUE(dragged.isEmpty());
    EXPECT_EQ(view->camera().out(), eye);
    QKeyEvent other(QEvent::KeyPress, Qt::Key_Left, Qt::NoModifier);
    other.accept();
    QApplication::sendEvent(view.get(), &other);
    EXPECT_FALSE(other.isAccepted());
}

}  // namespace asperity::test
