#include "tests/support/UserClicks.h"

#include "tests/support/Waits.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QTimer>
#include <QToolButton>
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
    handleEvents();
}

void UserClicks::doubleClick(QWidget& widget, const QPoint& place) {
    ASSERT_TRUE(widget.isVisible() && widget.isEnabled()) << widget.objectName().toStdString();
    clicks_ += 2;
    QTest::mouseClick(&widget, Qt::LeftButton, Qt::NoModifier, place);
    QTest::mouseDClick(&widget, Qt::LeftButton, Qt::NoModifier, place);
    handleEvents();
}

void UserClicks::choose(const QMainWindow& window, const QStringList& path) {
    QMenuBar* const bar = window.menuBar();
    QAction* action = entryOf(bar->actions(), path.front());
    ASSERT_NE(action, nullptr) << path.front().toStdString();
    click(*bar, bar->actionGeometry(action).center());
    for (const QString& text : path.mid(1)) {
        QMenu* const menu = action->menu();
        ASSERT_TRUE(eventually([menu] { return menu->isVisible(); }));
        action = entryOf(menu->actions(), text);
        ASSERT_NE(action, nullptr) << text.toStdString();
        ASSERT_TRUE(action->isEnabled()) << text.toStdString();
        click(*menu, menu->actionGeometry(action).center());
    }
}

void UserClicks::choose(QToolButton& button, const QString& text) {
    QMenu* const menu = button.menu();
    QAction* const action = entryOf(menu->actions(), text);
    ASSERT_NE(action, nullptr) << text.toStdString();
    onceReady([menu] { return menu->isVisible(); },
              [&, menu] { click(*menu, menu->actionGeometry(action).center()); });
    click(button);  // runs the menu's event loop
}

void UserClicks::type(QWidget& widget, const QString& text) {
    ASSERT_TRUE(widget.isVisible() && widget.isEnabled()) << widget.objectName().toStdString();
    ++typed_;
    QTest::keyClicks(&widget, text);
}

namespace {

constexpr int kPoll = 10;             // [ms]
constexpr int kLongestWait = 10'000;  // [ms]

void waitOn(std::function<bool()> ready, std::function<void()> todo, int waited) {
    QTimer::singleShot(kPoll, qApp, [ready = std::move(ready), todo = std::move(todo), waited] {
        if (ready()) {
            todo();
        } else if (waited < kLongestWait) {
            waitOn(ready, todo, waited + kPoll);
        } else {
            ADD_FAILURE() << "what should have opened did not";
        }
    });
}

}  // namespace

void onceReady(std::function<bool()> ready, std::function<void()> todo) {
    waitOn(std::move(ready), std::move(todo), 0);
}

}  // namespace asperity::test
