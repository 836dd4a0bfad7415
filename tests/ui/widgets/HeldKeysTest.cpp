#include "ui/widgets/HeldKeys.h"

#include <QKeyEvent>

#include <gtest/gtest.h>

namespace asperity {
namespace {

/// Key events as the watched object would get them.
class HeldKeysOnAnObject : public ::testing::Test {
protected:
    void send(QEvent::Type type, int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier,
              bool repeated = false) {
        QKeyEvent event(type, key, modifiers, {}, repeated);
        keys->eventFilter(&object, &event);
    }
    void press(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        send(QEvent::KeyPress, key, modifiers);
    }

    QObject object;
    HeldKeys* keys = new HeldKeys(&object);
};

TEST_F(HeldKeysOnAnObject, PointWhereTheyPullTogether) {
    press(Qt::Key_Right);
    press(Qt::Key_Up);
    press(Qt::Key_PageDown);
    EXPECT_EQ(keys->direction().right, 1.0);
    EXPECT_EQ(keys->direction().forward, 1.0);
    EXPECT_EQ(keys->direction().up, -1.0);
    press(Qt::Key_Left);
    EXPECT_EQ(keys->direction().right, 0.0) << "left and right at once";
}

TEST_F(HeldKeysOnAnObject, LetGoWhenReleasedButNotWhileTheKeyRepeats) {
    press(Qt::Key_PageUp);
    send(QEvent::KeyRelease, Qt::Key_PageUp, Qt::NoModifier, true);
    EXPECT_EQ(keys->direction().up, 1.0);
    send(QEvent::KeyRelease, Qt::Key_PageUp);
    EXPECT_EQ(keys->direction().up, 0.0);
}

TEST_F(HeldKeysOnAnObject, LetGoWhenTheFocusGoes) {
    press(Qt::Key_PageDown);
    ASSERT_EQ(keys->direction().up, -1.0);
    QFocusEvent out(QEvent::FocusOut);
    keys->eventFilter(&object, &out);
    EXPECT_EQ(keys->direction().up, 0.0);
}

TEST_F(HeldKeysOnAnObject, AreFinerWithShiftAndFasterWithCtrl) {
    press(Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_DOUBLE_EQ(keys->direction().right, 0.1);
    press(Qt::Key_Right, Qt::ControlModifier);
    EXPECT_DOUBLE_EQ(keys->direction().right, 5.0);
}

}  // namespace
}  // namespace asperity
