#include "ui/shell/CheatSheet.h"

#include <QFile>
#include <QLineEdit>
#include <QPdfWriter>
#include <QTemporaryDir>
#include <QtTest>

#include <gtest/gtest.h>

namespace asperity {
namespace {

class CheatSheetTest : public ::testing::Test {
protected:
    void SetUp() override {
        sheet.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&sheet));
    }
    void search(const QString& words) {
        sheet.findChild<QLineEdit*>(QStringLiteral("searchKeys"))->setText(words);
    }
    bool lists(const char* text) { return sheet.text().contains(QString::fromUtf8(text)); }

    std::vector<HelpSection> sections{
        {QStringLiteral("Mouse"), {{QStringLiteral("Left drag"), QStringLiteral("moves the tip")}}},
        {QStringLiteral("Keys"),
         {{QStringLiteral("Ctrl+O"), QStringLiteral("opens <b>a</b> scan")},
          {QStringLiteral("Ctrl+Q"), QStringLiteral("quits")}}}};
    CheatSheet sheet{[this] { return sections; }, nullptr};
};

TEST_F(CheatSheetTest, ListsAllAsItIs) {
    for (const char* text : {"Mouse", "Left drag", "Ctrl+O", "opens <b>a</b> scan", "quits"}) {
        EXPECT_TRUE(lists(text)) << text;
    }
}

TEST_F(CheatSheetTest, ASearchKeepsTheLinesThatHoldAllWords) {
    search(QStringLiteral("scan OPENS"));
    EXPECT_TRUE(lists("Ctrl+O"));
    EXPECT_FALSE(lists("Ctrl+Q"));
    EXPECT_FALSE(lists("Mouse")) << "a title without lines goes, too";
    search(QStringLiteral("keys"));
    EXPECT_TRUE(lists("Ctrl+Q")) << "a title brings its lines";
    search(QStringLiteral("zzz"));
    EXPECT_EQ(sheet.text(), QStringLiteral("No entry contains “zzz”."));
}

TEST_F(CheatSheetTest, ListsTheWindowAsItIsWhenItOpens) {
    sheet.hide();
    sections[1].lines.push_back({QStringLiteral("F9"), QStringLiteral("is new")});
    sheet.show();
    EXPECT_TRUE(lists("is new"));
}

TEST_F(CheatSheetTest, Prints) {
    const QTemporaryDir folder;
    QPdfWriter paper(folder.filePath(QStringLiteral("keys.pdf")));
    sheet.print(paper);
    QFile file(folder.filePath(QStringLiteral("keys.pdf")));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_TRUE(file.readAll().startsWith("%PDF"));
}

}  // namespace
}  // namespace asperity
