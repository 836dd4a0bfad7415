#include "ui/shell/WindowLayout.h"

#include "app/window/live/LivePanels.h"
#include "tests/support/Waits.h"
#include "ui/shell/CardColumn.h"
#include "ui/shell/MainWindow.h"
#include "ui/shell/Menus.h"
#include "ui/shell/PageTabs.h"
#include "ui/view/SecondView.h"
#include "ui/view/ZoomView.h"
#include "ui/widgets/Card.h"

#include <QAction>
#include <QLabel>
#include <QMenu>
#include <QSplitter>
#include <QtTest>

#include <gtest/gtest.h>

#include <map>

namespace asperity::test {
namespace {

/// With a tool page and a side page, acting by View > Panels.
class WindowLayoutTest : public ::testing::Test {
protected:
    void SetUp() override {
        window.addTool(profile, QStringLiteral("Profile"));
        window.addSidePage(notes, QStringLiteral("Notes"));
        window.resize(1280, 800);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
        handleEvents();
    }
    QAction& entry(const QString& key) {
        auto* panels = window.findChild<QMenu*>("panels");
        Q_EMIT panels->aboutToShow();
        return *panels->findChild<QAction*>(key);
    }
    std::map<QString, bool> shown() {
        std::map<QString, bool> shown;
        for (const PanelSwitch& part : window.layout().switches()) {
            shown[part.key] = entry(part.key).isChecked();
            EXPECT_EQ(shown[part.key], part.isShown());
        }
        return shown;
    }
    std::map<QString, QList<int>> sizes() {
        handleEvents();
        std::map<QString, QList<int>> sizes;
        for (const QSplitter* splitter : window.layout().splitters()) {
            sizes[splitter->objectName()] = splitter->sizes();
        }
        return sizes;
    }

    MainWindow window;
    LivePanels panels{window};
    QLabel* profile = new QLabel(QStringLiteral("a profile"));
    QLabel* notes = new QLabel(QStringLiteral("some notes"));
};

TEST_F(WindowLayoutTest, EveryPartIsInTheMenuAndToolsAreHiddenAtFirst) {
    EXPECT_EQ(shown(), (std::map<QString, bool>{{"card/Force and position", true},
                                                {"card/Cantilever", true},
                                                {"card/Overview", true},
                                                {"side/Live", true},
                                                {"side/Notes", true},
                                                {"tool/Messages", false},
                                                {"tool/Profile", false},
                                                {"sides", true},
                                                {"tools", false}}));
}

TEST_F(WindowLayoutTest, HidingAllLeavesTheViewAndResettingBringsAllBack) {
    const auto before = shown();
    const auto room = sizes();
    const QSize view = panels.view().size();
    entry(QStringLiteral("tool/Profile")).trigger();
    EXPECT_TRUE(profile->isVisible());
    window.menus().entry("secondView").trigger();
    for (const auto& [key, was] : before) {
        QAction& part = entry(key);
        if (part.isChecked()) {
            part.trigger();
        }
    }
    for (const auto& [key, isShown] : shown()) {
        EXPECT_FALSE(isShown) << key.toStdString();
    }
    EXPECT_TRUE(eventually([this] { return panels.view().width() > 1200; }));
    EXPECT_FALSE(window.layout().sidePages().isVisible());
    window.layout().splitters().front()->setSizes({900, 300});
    entry(QStringLiteral("resetLayout")).trigger();
    EXPECT_EQ(shown(), before);
    EXPECT_EQ(sizes(), room);
    EXPECT_EQ(panels.view().size(), view);
    EXPECT_TRUE(panels.second().isVisible());
    EXPECT_EQ(window.layout().sidePages().pageOnTop(), QStringLiteral("Live"));
}

TEST_F(WindowLayoutTest, AHiddenCardLeavesItsRoomToTheOthers) {
    Card& first = *window.cards().front();
    const int before = first.height();
    entry(QStringLiteral("card/Cantilever")).trigger();
    EXPECT_TRUE(eventually([&] { return first.height() > before; }));
    EXPECT_FALSE(window.cards().at(1)->isVisible());
    entry(QStringLiteral("card/Cantilever")).trigger();
    EXPECT_TRUE(eventually([&] { return first.height() == before; })) << first.height();
}

TEST_F(WindowLayoutTest, ASplitterSharesOutTheRoomBetweenCards) {
    QSplitter& cards = window.layout().cards().splitter();
    QList<int> sizes = cards.sizes();
    sizes[0] -= 20;
    sizes[2] += 20;
    cards.setSizes(sizes);
    EXPECT_EQ(cards.sizes(), sizes);
}

TEST_F(WindowLayoutTest, AToolTakesRoomFromTheViewNotFromTheColumn) {
    const int column = window.layout().sidePages().width();
    const int view = panels.view().height();
    window.showTool(profile);
    EXPECT_TRUE(eventually([&] { return panels.view().height() < view - 100; }));
    EXPECT_EQ(window.layout().sidePages().width(), column);
    EXPECT_GT(profile->height(), 100);
}

}  // namespace
}  // namespace asperity::test
