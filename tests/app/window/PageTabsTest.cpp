#include "ui/shell/PageTabs.h"

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
        tabs.addPage(cycles, QStringLiteral("Force cycles"), false);
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
    QLabel* cycles = new QLabel(QStringLiteral("cycles"));
};

TEST_F(PageTabsTest, HasNoPlaceInTheWindowUntilAPageIsWanted) {
    EXPECT_FALSE(tabs.isVisible());
    tabs.showPage(roughness);
    EXPECT_TRUE(tabs.isVisible());
    EXPECT_TRUE(roughness->isVisible());
    EXPECT_EQ(tabs.pageOnTop(), QStringLiteral("Roughness"));
}

TEST_F(PageTabsTest, PagesKeepTheirOrderWhateverIsShownFirst) {
    tabs.showPage(cycles);
    tabs.showPage(profile);
    tabs.showPage(roughness);
    EXPECT_EQ(titles(), QStringList({"Profile", "Roughness", "Force cycles"}));
    EXPECT_EQ(tabs.pageOnTop(), QStringLiteral("Roughness"));
    tabs.setShown(profile, false);
    EXPECT_EQ(titles(), QStringList({"Roughness", "Force cycles"}));
    EXPECT_FALSE(profile->isVisible());
}

TEST_F(PageTabsTest, ItGoesWithItsLastPage) {
    tabs.showPage(cycles);
    Q_EMIT tabs.tabCloseRequested(0);
    EXPECT_FALSE(tabs.isShown(cycles));
    EXPECT_FALSE(tabs.isVisible());
}

TEST_F(PageTabsTest, ClosedItKeepsItsPagesAndOpensForEachThatIsWanted) {
    tabs.showPage(cycles);
    tabs.setOpen(false);
    EXPECT_FALSE(tabs.isVisible());
    EXPECT_TRUE(tabs.isShown(cycles));
    tabs.setOpen(true);
    EXPECT_TRUE(cycles->isVisible());
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
    cycles->setMinimumSize(900, 700);
    tabs.showPage(cycles);
    test::handleEvents();
    auto* area = qobject_cast<QScrollArea*>(cycles->parentWidget()->parentWidget());
    ASSERT_NE(area, nullptr);
    EXPECT_EQ(cycles->width(), 900);
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
