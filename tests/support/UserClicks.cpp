#include "tests/support/UserClicks.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QtTest>

#include <gtest/gtest.h>

namespace asperity::test {

namespace {

QAction* entryOf(const QList<QAction*>& actions, const QString& text) {
    for (QAction* action : actions) {
        if (QString(action->text()).remove('&').startsWith(text)) {
            return action;
        }
    }
    return nullptr;
}

}  // namespace

void UserClicks::click(QWidget& widget) { click(widget, widget.rect().center()); }

void UserClicks::click(QWidget& widget, const QPoint& place) {
    ASSERT_TRUE(widget.isVisible() && widget.isEnabled()) << widget.objectName().toStdString();
    ++clicks_;
    QTest::mouseClick(&widget, Qt::LeftButton, Qt::NoModifier, place);
    QTest::qWait(20);
}

void UserClicks::doubleClick(QWidget& widget, const QPoint& place) {
    ASSERT_TRUE(widget.isVisible() && widget.isEnabled()) << widget.objectName().toStdString();
    clicks_ += 2;
    QTest::mouseClick(&widget, Qt::LeftButton, Qt::NoModifier, place);
    QTest::mouseDClick(&widget, Qt::LeftButton, Qt::NoModifier, place);
    QTest::qWait(20);
}

void UserClicks::choose(const QMainWindow& window, const QStringList& path) {
    QMenuBar* const bar = window.menuBar();
    QAction* action = entryOf(bar->actions(), path.front());
    ASSERT_NE(action, nullptr) << path.front().toStdString();
    click(*bar, bar->actionGeometry(action).center());
    for (const QString& text : path.mid(1)) {
        QMenu* const menu = action->menu();
        ASSERT_TRUE(QTest::qWaitFor([menu] { return menu->isVisible(); }, 2000));
        action = entryOf(menu->actions(), text);
        ASSERT_NE(action, nullptr) << text.toStdString();
        ASSERT_TRUE(action->isEnabled()) << text.toStdString();
        click(*menu, menu->actionGeometry(action).center());
    }
}

void UserClicks::type(QWidget& widget, const QString& text) {
    ASSERT_TRUE(widget.isVisible() && widget.isEnabled()) << widget.objectName().toStdString();
    ++typed_;
    QTest::keyClicks(&widget, text);
}

}  // namespace asperity::test
