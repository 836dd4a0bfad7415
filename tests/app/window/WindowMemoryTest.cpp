#include "app/window/session/WindowMemory.h"

#include "app/window/live/LivePanels.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/Waits.h"
#include "ui/shell/CardColumn.h"
#include "ui/shell/MainWindow.h"
#include "ui/shell/Menus.h"
#include "ui/shell/PageTabs.h"
#include "ui/shell/WindowLayout.h"
#include "ui/view/ZoomView.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/Theme.h"

#include <QAction>
#include <QLabel>
#include <QScreen>
#include <QSplitter>
#include <QtTest>

#include <gtest/gtest.h>

#include <vector>

namespace asperity::test {
namespace {

class WindowMemoryTest : public ::testing::Test {
protected:
    std::unique_ptr<QSettings> settings() {
        return std::make_unique<QSettings>(QString::fromStdString(folder.file("a.ini").string()),
                                           QSettings::IniFormat);
    }
    /// A session in which the user puts the window somewhere.
    void leaveAt(const QRect& geometry) {
        MainWindow window;
        LivePanels panels{window};
        const WindowMemory memory(window, panels, settings());
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
        window.setGeometry(geometry);
        window.cards().at(1)->setFolded(true);
        handleEvents();
    }

    ScratchFolder folder;
};

TEST_F(WindowMemoryTest, KeepsPlaceSizeAndFoldedPanels) {
    const QRect geometry(120, 90, 1100, 700);
    leaveAt(geometry);
    MainWindow window;
    LivePanels panels{window};
    const QRect first = window.geometry();
    const WindowMemory memory(window, panels, settings());
    EXPECT_EQ(window.geometry(), geometry);
    EXPECT_NE(first, geometry);
    EXPECT_FALSE(window.cards().at(0)->isFolded());
    EXPECT_TRUE(window.cards().at(1)->isFolded());
}

TEST_F(WindowMemoryTest, KeepsWhatIsHiddenWhatIsOnTopAndHowTheRoomIsShared) {
    const auto addPages = [](MainWindow& window) {
        window.addSidePage(new QLabel, QStringLiteral("Scene"));
        window.addSidePage(new QLabel, QStringLiteral("Haptics"));
        window.addTool(new QLabel(QStringLiteral("a profile")), QStringLiteral("Profile"));
        window.addTool(new QLabel(QStringLiteral("a table")), QStringLiteral("Force cycles"));
    };
    const auto sizes = [](MainWindow& window) {
        handleEvents();
        std::vector<QList<int>> found;
        for (const QSplitter* splitter : window.layout().splitters()) {
            found.push_back(splitter->sizes());
        }
        return found;
    };
    std::vector<QList<int>> left;
    {
        MainWindow window;
        LivePanels panels{window};
        addPages(window);
        const WindowMemory memory(window, panels, settings());
        window.setGeometry(100, 80, 1200, 800);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
        WindowLayout& layout = window.layout();
        layout.cards().setShown(*window.cards().at(2), false);
        window.showTool(layout.tools().pages().back().panel);
        layout.splitters().at(0)->setSizes({650, 540});
        layout.splitters().at(1)->setSizes({300, 250});
        left = sizes(window);
        window.showSidePage(layout.sidePages().pages().at(2).panel);
        layout.maximizer().toggle(*window.cards().front());
    }
    MainWindow window;
    LivePanels panels{window};
    addPages(window);
    const WindowMemory memory(window, panels, settings());
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    EXPECT_EQ(window.layout().sidePages().pageOnTop(), QStringLiteral("Haptics"));
    window.layout().sidePages().putOnTop(QStringLiteral("Live"));
    EXPECT_EQ(sizes(window), left);
    EXPECT_TRUE(window.cards().at(2)->isHidden());
    EXPECT_FALSE(window.cards().at(1)->isHidden());
    EXPECT_EQ(window.layout().tools().pageOnTop(), QStringLiteral("Force cycles"));
    EXPECT_EQ(window.layout().tools().count(), 1);
    EXPECT_FALSE(window.layout().maximizer().isActive());
}

TEST_F(WindowMemoryTest, FindsPagesByTheirFormerTitles) {
    settings()->setValue("window/shown/tool/Touches", true);
    settings()->setValue("window/onTop/tools", "Touches");
    MainWindow window;
    LivePanels panels{window};
    window.addTool(new QLabel(QStringLiteral("a table")), QStringLiteral("Force cycles"));
    window.addTool(new QLabel(QStringLiteral("a map")), QStringLiteral("Force map"));
    const WindowMemory memory(window, panels, settings());
    EXPECT_EQ(window.layout().tools().pageOnTop(), QStringLiteral("Force cycles"));
    EXPECT_EQ(window.layout().tools().count(), 1);
}

TEST_F(WindowMemoryTest, SplittersOfALargerScreenLeaveEveryPanelItsRoom) {
    {
        MainWindow window;
        LivePanels panels{window};
        const WindowMemory memory(window, panels, settings());
        window.setGeometry(0, 0, 3000, 1500);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
        window.layout().splitters().at(0)->setSizes({400, 2590});
        handleEvents();
    }
    MainWindow window;
    LivePanels panels{window};
    const WindowMemory memory(window, panels, settings());
    window.resize(900, 658);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    handleEvents();
    const QList<int> sizes = window.layout().splitters().at(0)->sizes();
    EXPECT_GE(sizes.at(0), panels.view().minimumSizeHint().width());
    EXPECT_GT(sizes.at(0), 200);
    EXPECT_GE(sizes.at(1), 372);
    EXPECT_EQ(window.width(), 900);
}

TEST_F(WindowMemoryTest, WritesAChoiceWhileTheProgramGoesOn) {
    MainWindow window;
    LivePanels panels{window};
    QAction& first =
        window.menus().add({MenuName::File, 0, 60}, "first",
                           {.text = "First", .isCheckable = true, .keptAs = "session/first"});
    first.setChecked(true);
    QAction& second =
        window.menus().add({MenuName::File, 0, 70}, "second",
                           {.text = "Second", .isCheckable = true, .keptAs = "other/second"});
    const WindowMemory memory(window, panels, settings());
    EXPECT_TRUE(first.isChecked()) << "as it is at first where nothing is kept";
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    const ThemeChoice before = theme::choice();
    theme::choose(ThemeChoice::Dark);
    first.setChecked(false);
    second.setChecked(true);
    window.setGeometry(130, 95, 1150, 720);
    const auto isWritten = [this](const char* line) {
        return eventually([&] {
            const std::filesystem::path file = folder.file("a.ini");
            return std::filesystem::exists(file) && contentOf(file).find(line) != std::string::npos;
        });
    };
    EXPECT_TRUE(isWritten("theme=dark"));
    EXPECT_TRUE(isWritten("first=false"));
    EXPECT_TRUE(isWritten("second=true"));
    EXPECT_TRUE(isWritten("geometry="));
    theme::choose(before);
}

TEST_F(WindowMemoryTest, BringsAWindowBackToAScreenThatHasBecomeSmaller) {
    leaveAt({900, 700, 4000, 3000});
    MainWindow window;
    LivePanels panels{window};
    const WindowMemory memory(window, panels, settings());
    EXPECT_TRUE(window.screen()->availableGeometry().contains(window.geometry()));
}

TEST_F(WindowMemoryTest, WithoutSettingsTheWindowOpensAsAtFirst) {
    MainWindow window;
    LivePanels panels{window};
    const QRect first = window.geometry();
    {
        const WindowMemory memory(
            window, panels,
            std::make_unique<QSettings>(QStringLiteral("/proc/none/a.ini"), QSettings::IniFormat));
        EXPECT_EQ(window.geometry(), first);
    }
    (void)folder.write("a.ini",
                       "[window]\ngeometry=no geometry\nsplitter\\sides=7\nshown\\sides=maybe\n"
                       "onTop\\tools=no page\n");
    const WindowMemory memory(window, panels, settings());
    EXPECT_EQ(window.geometry(), first);
}

}  // namespace
}  // namespace asperity::test
