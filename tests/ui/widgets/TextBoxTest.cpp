#include "ui/widgets/NumberBox.h"

#include <QKeyEvent>
#include <QtTest>

#include <gtest/gtest.h>

namespace asperity {
namespace {

/// Whether the line wants a key that is also a shortcut of the window.
bool wants(TextBox& line, int key) {
    QKeyEvent event(QEvent::ShortcutOverride, key, Qt::ControlModifier);
    event.ignore();
    QCoreApplication::sendEvent(&line, &event);
    return event.isAccepted();
}

TEST(TextBox, LeavesUndoToTheWindowWhileNothingTypedIsToBeUndone) {
    TextBox line;
    line.setText(QStringLiteral("polystyrene"));
    EXPECT_FALSE(wants(line, Qt::Key_Z));
    EXPECT_FALSE(wants(line, Qt::Key_Y));
    QTest::keyClicks(&line, "2");
    EXPECT_TRUE(wants(line, Qt::Key_Z));
    EXPECT_TRUE(wants(line, Qt::Key_A)) << "all other keys are as in any line";
    line.setText(QStringLiteral("polystyrene 2"));  // it counts
    EXPECT_FALSE(wants(line, Qt::Key_Z));
}

}  // namespace
}  // namespace asperity
