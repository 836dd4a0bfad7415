#include "ui/shell/ManualWindow.h"

#include "tests/support/ScratchFolder.h"

#include <QPushButton>
#include <QSignalSpy>
#include <QTextBrowser>
#include <QUrl>

#include <gtest/gtest.h>

#include <tuple>

namespace asperity::test {
namespace {

class ManualWindowTest : public ::testing::Test {
protected:
    void follow(const char* link) {
        auto* page = manual.findChild<QTextBrowser*>(QStringLiteral("manualPage"));
        Q_EMIT page->anchorClicked(QUrl(QString::fromUtf8(link)));
    }

    ScratchFolder folder;
    ManualWindow manual{folder.path(), nullptr};
    QSignalSpy missing{&manual, &ManualWindow::missing};
};

TEST_F(ManualWindowTest, ShowsAPageAndFollowsItsLinks) {
    std::ignore = folder.write("README.md", "# Documentation\n\n[steps](first_steps.md)\n");
    std::ignore = folder.write("first_steps.md", "# First steps\n\nOpen a scan.\n");
    ASSERT_TRUE(manual.open(QStringLiteral("README.md")));
    EXPECT_TRUE(manual.text().startsWith(QStringLiteral("Documentation")));
    follow("first_steps.md#example");
    EXPECT_TRUE(manual.text().contains(QStringLiteral("Open a scan.")));
    manual.findChild<QPushButton*>(QStringLiteral("manualBack"))->click();
    EXPECT_TRUE(manual.text().startsWith(QStringLiteral("Documentation")));
    EXPECT_EQ(missing.count(), 0);
}

TEST_F(ManualWindowTest, SaysThatItIsNotInstalled) {
    EXPECT_FALSE(manual.open(QStringLiteral("README.md")));
    ASSERT_EQ(missing.count(), 1);
    EXPECT_TRUE(missing[0][0].toString().contains(QStringLiteral("not installed")));
    std::ignore = folder.write("README.md", "# Documentation\n");
    ASSERT_TRUE(manual.open(QStringLiteral("README.md")));
    follow("../CHANGELOG.md");
    ASSERT_EQ(missing.count(), 2);
    EXPECT_TRUE(manual.text().startsWith(QStringLiteral("Documentation"))) << "the page stays";
}

}  // namespace
}  // namespace asperity::test
