
#include "app/window/live/LivePanels.h"
#include "app/window/live/StateBanner.h"
#include "core/scene/Scene.h"
#include "tests/support/ShortDoubleClicks.h"
#include "tests/support/TestScenes.h"
#include "tests/support/Waits.h"
#include "ui/shell/CardColumn.h"
#include "ui/shell/MainWindow.h"
#include "ui/shell/PageTabs.h"
#include "ui/shell/WindowLayout.h"
#include "ui/view/ZoomView.h"
#include "ui/widgets/Card.h"

#include <QApplication>
#include <QSplitter>
#include <QTabBar>
#include <QToolButton>
#include <QtTest>

#include <gtest/gtest.h>

#include <vector>

namespace asperity::test {
namespace {

class MaximizerTest : public ::testing::Test {
protected:
    void SetUp() override {
        panels.showScene(&scene, QStringLiteral("a flat sample"));
        window.resize(1280, 800);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
        QApplication::setActiveWindow(&window);
        handleEvents();
    }
    QToolButton& headingOf(Card& card) { return *card.findChild<QToolButton*>(); }
    void doubleClick(Card& card) {
        QToolButton& heading = headingOf(card);
        const QPoint words(heading.width() - 8, heading.height() / 2);
        QTest::mouseClick(&heading, Qt::LeftButton, Qt::NoModifier, words);
        QTest::mouseDClick(&heading, Qt::LeftButton, Qt::NoModifier, words);
        handleEvents();
    }
    /// Position and size of all panels.
    std::vector<QRect> geometries() {
        handleEvents();
        std::vector<QRect> geometries{geometryOf(panels.view()), geometryOf(panels.banner())};
        for (const Card* card : window.cards()) {
            geometries.push_back(geometryOf(*card));
        }
        return geometries;
    }
    static QRect geometryOf(const QWidget& panel) {
        return {panel.mapTo(panel.window(), QPoint()), panel.size()};
    }

    const ShortDoubleClicks quick;
    Scene scene = buildScene(plainScene(), flatMap());
    MainWindow window;
    LivePanels panels{window};
};

TEST_F(MaximizerTest, ADoubleClickOnATitleGivesThePanelTheWholeMiddleAndAnotherOnePutsItBack) {
    QSplitter& column = window.layout().cards().splitter();
    QList<int> sizes = column.sizes();
    column.setSizes({sizes[0] + 30, sizes[1] - 10, sizes[2] - 20});  // as a user left it
    window.cards().at(1)->setFolded(true);
    const std::vector<QRect> before = geometries();
    for (Card* card : window.cards()) {
        const bool wasFolded = card->isFolded();
        doubleClick(*card);
        EXPECT_TRUE(window.layout().maximizer().isActive());
        EXPECT_GT(card->width(), 1200);
        EXPECT_GT(card->height(), 550);
        EXPECT_FALSE(card->isFolded());
        EXPECT_TRUE(panels.banner().isVisible()) << "a fault must show";
        EXPECT_FALSE(panels.view().isVisible());
        doubleClick(*card);
        EXPECT_EQ(card->isFolded(), wasFolded);
        EXPECT_TRUE(panels.view().isVisible());
        QTest::qWait(2 * QApplication::doubleClickInterval());  // no click may fold it later
        EXPECT_EQ(geometries(), before) << card->title().toStdString();
    }
}

TEST_F(MaximizerTest, EscPutsItBackUnlessItIsTheEmergencyStop) {
    const std::vector<QRect> before = geometries();
    Card& card = *window.cards().front();
    doubleClick(card);
    QTest::keyClick(&window, Qt::Key_Escape);
    EXPECT_FALSE(window.layout().maximizer().isActive());
    EXPECT_TRUE(panels.view().hasFocus()) << "the keys move the device again";
    EXPECT_EQ(geometries(), before);
    panels.setEmergencyStop(true);
    doubleClick(card);
    QTest::keyClick(&window, Qt::Key_Escape);
    EXPECT_TRUE(window.layout().maximizer().isActive());
    window.findChild<QToolButton*>(QStringLiteral("backFromEnlarged"))->click();
    EXPECT_FALSE(window.layout().maximizer().isActive());
    doubleClick(card);
    panels.setEmergencyStop(false);
    QTest::keyClick(&window, Qt::Key_Escape);
    EXPECT_FALSE(window.layout().maximizer().isActive());
}

TEST_F(MaximizerTest, ADoubleClickOnATabEnlargesAllTools) {
    auto* page = new QLabel(QStringLiteral("a profile"));
    window.addTool(page, QStringLiteral("Profile"));
    window.showTool(page);
    const std::vector<QRect> before = geometries();
    QTabBar& bar = *window.layout().tools().tabBar();
    const auto doubleClickTab = [&] {
        QTest::mouseDClick(&bar, Qt::LeftButton, Qt::NoModifier,
                           bar.tabRect(0).topLeft() + QPoint(8, 8));
        handleEvents();
    };
    doubleClickTab();
    EXPECT_GT(page->width(), 1200);
    doubleClickTab();
    EXPECT_EQ(geometries(), before);
}

TEST_F(MaximizerTest, APageThatIsAskedForBringsTheWindowBack) {
    auto* page = new QLabel(QStringLiteral("a profile"));
    window.addTool(page, QStringLiteral("Profile"));
    doubleClick(*window.cards().front());
    window.showTool(page);
    EXPECT_TRUE(page->isVisible());
    EXPECT_TRUE(panels.view().isVisible());
}

}  // namespace
}  // namespace asperity::test
