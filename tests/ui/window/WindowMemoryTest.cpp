#include "ui/window/WindowMemory.h"

#include "tests/support/ScratchFolder.h"
#include "ui/panels/Card.h"
#include "ui/window/MainWindow.h"

#include <QScreen>
#include <QtTest>

#include <gtest/gtest.h>

namespace asperity::test {
namespace {

class WindowMemoryTest : public ::testing::Test {
protected:
    std::unique_ptr<QSettings> settings() {
        return std::make_unique<QSettings>(QString::fromStdString(folder.file("a.ini").string()),
                                           QSettings::IniFormat);
    }
    /// A session in which the user puts the window somewhere.
    void leaveAt(const QRect& place) {
        MainWindow window;
        const WindowMemory memory(window, settings());
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
        window.setGeometry(place);
        window.cards().at(1)->setFolded(true);
        QTest::qWait(50);
    }

    ScratchFolder folder;
};

TEST_F(WindowMemoryTest, KeepsPlaceSizeAndFoldedPanels) {
    const QRect place(120, 90, 1100, 700);
    leaveAt(place);
    MainWindow window;
    const QRect first = window.geometry();
    const WindowMemory memory(window, settings());
    EXPECT_EQ(window.geometry(), place);
    EXPECT_NE(first, place);
    EXPECT_FALSE(window.cards().at(0)->isFolded());
    EXPECT_TRUE(window.cards().at(1)->isFolded());
}

TEST_F(WindowMemoryTest, BringsAWindowBackToAScreenThatHasBecomeSmaller) {
    leaveAt({900, 700, 4000, 3000});
    MainWindow window;
    const WindowMemory memory(window, settings());
    EXPECT_TRUE(window.screen()->availableGeometry().contains(window.geometry()));
}

TEST_F(WindowMemoryTest, WithoutSettingsTheWindowOpensAsAtFirst) {
    MainWindow window;
    const QRect first = window.geometry();
    {
        const WindowMemory memory(
            window,
            std::make_unique<QSettings>(QStringLiteral("/proc/none/a.ini"), QSettings::IniFormat));
        EXPECT_EQ(window.geometry(), first);
    }
    (void)folder.write("a.ini", "[window]\ngeometry=no geometry\n");
    const WindowMemory memory(window, settings());
    EXPECT_EQ(window.geometry(), first);
}

}  // namespace
}  // namespace asperity::test
