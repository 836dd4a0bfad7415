#include "ui/shell/CheatSheet.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(ActionHelp, ListsEntriesWithKeysMenuByMenuWithThePathBelow) {
    QMenuBar bar;
    QMenu* file = bar.addMenu(QStringLiteral("&File"));
    QAction* open = file->addAction(QStringLiteral("&Open…"));
    open->setShortcut(QKeySequence(QStringLiteral("Ctrl+O")));
    open->setToolTip(QStringLiteral("Opens a scan"));
    file->addSeparator();
    file->addAction(QStringLiteral("without a key"));
    QAction* deep = file->addMenu(QStringLiteral("&Guide"))->addAction(QStringLiteral("A && &B"));
    deep->setShortcuts({QKeySequence(Qt::Key_F5), QKeySequence(Qt::Key_G)});
    bar.addMenu(QStringLiteral("&Empty"))->addAction(QStringLiteral("no key either"));

    const std::vector<MenuHelp> menus = helpOf(bar);
    ASSERT_EQ(menus.size(), 1U);
    EXPECT_EQ(menus[0].menu, QStringLiteral("File"));
    ASSERT_EQ(menus[0].entries.size(), 2U);
    EXPECT_EQ(menus[0].entries[0].keys, QStringLiteral("Ctrl+O"));
    EXPECT_EQ(menus[0].entries[0].text, QStringLiteral("Open…"));
    EXPECT_EQ(menus[0].entries[0].tip, QStringLiteral("Opens a scan"));
    EXPECT_EQ(menus[0].entries[1].keys, QStringLiteral("F5, G"));
    EXPECT_EQ(menus[0].entries[1].text, QStringLiteral("Guide › A & B"));
    EXPECT_EQ(menus[0].entries[1].tip, QString());
    EXPECT_EQ(entriesOf(bar).size(), 4U) << "entries without keys, too, but no menus";
}

}  // namespace
}  // namespace asperity
