#include "ui/window/PageTabs.h"

#include "tests/support/Waits.h"

#include <QLabel>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTabBar>
#include <QtTest>

#include <gtest/gtest.h>

namespace asperity {
namespace {

class PageTabsTest : public ::testing::Test {
protected:
    PageTabsTest() {
        tabs.setTabsClosable(true);
        tabs.addPage(profile, QStringLiteral("Profile"), false);
        tabs.addPage(roughness, QStringLiteral("Roughness"), false);
        tabs.addPage(touches, QStringLiteral("Touches"), false);
        holder.resize(400, 300);
        tabs.resize(400, 300);
        holder.show();
    }
    QStringList titles() {
        QStringList titles;
        for (int i = 0; i < tabs.count(); ++i) {
            titles << tabs.tabText(i);
        }
        return titles;
    }

    QWidget holder;
    PageTabs tabs{"tools", &holder};
    QLabel* profile = new QLabel(QStringLiteral("profile"));
    QLabel* roughness = new QLabel(QStringLiteral("roughness"));
    QLabel* touches = new QLabel(QStringLiteral("touches"));
};

TEST_F(PageTabsTest, HasNoPlaceInTheWindowUntilAPageIsWanted) {
    EXPECT_FALSE(tabs.isVisible());
    tabs.showPage(roughness);
    EXPECT_TRUE(tabs.isVisible());
    EXPECT_TRUE(roughness->isVisible());
    EXPECT_EQ(tabs.pageOnTop(), QStringLiteral("Roughness"));
}

TEST_F(PageTabsTest, PagesKeepTheirOrderWhateverIsShownFirst) {
    tabs.showPage(touches);
    tabs.showPage(profile);
    tabs.showPage(roughness);
    EXPECT_EQ(titles(), QStringList({"Profile", "Roughness", "Touches"}));
    EXPECT_EQ(tabs.pageOnTop(), QStringLiteral("Roughness"));
    tabs.setShown(profile, false);
    EXPECT_EQ(titles(), QStringList({"Roughness", "Touches"}));
    EXPECT_FALSE(profile->isVisible());
}

TEST_F(PageTabsTest, ItGoesWithItsLastPage) {
    tabs.showPage(touches);
    Q_EMIT tabs.tabCloseRequested(0);
    EXPECT_FALSE(tabs.isShown(touches));
    EXPECT_FALSE(tabs.isVisible());
}

TEST_F(PageTabsTest, ClosedItKeepsItsPagesAndOpensForEachThatIsWanted) {
    tabs.showPage(touches);
    tabs.setOpen(false);
    EXPECT_FALSE(tabs.isVisible());
    EXPECT_TRUE(tabs.isShown(touches));
    tabs.setOpen(true);
    EXPECT_TRUE(touches->isVisible());
    tabs.setOpen(false);
    tabs.showPage(profile);
    EXPECT_TRUE(profile->isVisible());
}

TEST_F(PageTabsTest, OpenedWithoutAPageItShowsTheFirst) {
    tabs.setOpen(true);
    EXPECT_EQ(titles(), QStringList({"Profile"}));
    tabs.reset();
    EXPECT_EQ(titles(), QStringList());
    EXPECT_FALSE(tabs.isVisible());
}

TEST_F(PageTabsTest, APageThatIsTooLargeIsScrolled) {
    touches->setMinimumSize(900, 700);
    tabs.showPage(touches);
    test::handleEvents();
    auto* area = qobject_cast<QScrollArea*>(touches->parentWidget()->parentWidget());
    ASSERT_NE(area, nullptr);
    EXPECT_EQ(touches->width(), 900);
    EXPECT_LE(area->width(), 400);
}

TEST_F(PageTabsTest, ADoubleClickOnATabAsksForRoom) {
    tabs.showPage(profile);
    test::handleEvents();
    QSignalSpy enlarged(&tabs, &PageTabs::enlargeRequested);
    QTest::mouseDClick(tabs.tabBar(), Qt::LeftButton, Qt::NoModifier,
                       tabs.tabBar()->tabRect(0).topLeft() + QPoint(8, 8));
    EXPECT_EQ(enlarged.count(), 1);
    QTest::mouseDClick(tabs.tabBar(), Qt::LeftButton, Qt::NoModifier,
                       tabs.tabBar()->rect().bottomRight() - QPoint(2, 2));
    EXPECT_EQ(enlarged.count(), 1) << "beside the tabs";
}

}  // namespace
}  // namespace asperity
