#include "ui/shell/MessagesPanel.h"

#include "tests/ui/widgets/PanelSamples.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextLayout>
#include <QtTest>

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(MessageLog, KeepsTheNewestAndCountsWhatRepeats) {
    MessageLog log;
    log.add(MessageKind::Note, QStringLiteral("the same"));
    log.add(MessageKind::Note, QStringLiteral("the same"));
    log.add(MessageKind::Error, QStringLiteral("the same"));
    ASSERT_EQ(log.messages().size(), 2U);
    EXPECT_EQ(log.messages().front().count, 2);
    for (std::size_t i = 0; i < MessageLog::kMaxMessages + 20; ++i) {
        log.add(MessageKind::Note, QString::number(i));
    }
    EXPECT_EQ(log.messages().size(), MessageLog::kMaxMessages);
    EXPECT_EQ(log.messages().front().text, QStringLiteral("20"));
    log.add(MessageKind::Note, QString(1000000, 'x'));
    EXPECT_EQ(log.messages().back().text.size(), MessageLog::kMaxLength + 1);
    EXPECT_TRUE(log.messages().back().text.endsWith(QStringLiteral("…")));
}

class MessagesPanelTest : public ::testing::Test {
protected:
    void show() {
        panel.resize(500, 200);
        panel.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    }
    QPlainTextEdit& list() {
        return *panel.findChild<QPlainTextEdit*>(QStringLiteral("messageList"));
    }
    void click(const char* button) {
        panel.findChild<QPushButton*>(QString::fromUtf8(button))->click();
    }

    MessageLog log;
    MessagesPanel panel{log};
    MessageBadge badge{log};
};

TEST_F(MessagesPanelTest, ListsTimeKindAndTextOfWhatCameBeforeAndAfterItOpened) {
    log.add(MessageKind::Note, QStringLiteral("scan.gsf"));
    show();
    log.add(MessageKind::Error, QStringLiteral("no such file\n<b>bold</b>"));
    const QStringList lines = panel.text().split('\n');
    ASSERT_EQ(lines.size(), 3);
    EXPECT_TRUE(
        QRegExp(QStringLiteral("\\d\\d:\\d\\d:\\d\\d  note  scan.gsf")).exactMatch(lines[0]))
        << lines[0].toStdString();
    EXPECT_TRUE(lines[1].endsWith(QStringLiteral("  error  no such file")));
    EXPECT_EQ(lines[2], QStringLiteral("    <b>bold</b>")) << "plain text";
    log.add(MessageKind::Error, QStringLiteral("no such file\n<b>bold</b>"));
    EXPECT_TRUE(panel.text().endsWith(QStringLiteral("(2 times)")));
}

TEST_F(MessagesPanelTest, ListsFromASeverityOn) {
    show();
    log.add(MessageKind::Note, QStringLiteral("one"));
    log.add(MessageKind::Warning, QStringLiteral("two"));
    log.add(MessageKind::Error, QStringLiteral("three"));
    auto* kinds = panel.findChild<QComboBox*>(QStringLiteral("messageKinds"));
    EXPECT_EQ(panel.text().split('\n').size(), 3);
    kinds->setCurrentIndex(1);
    EXPECT_EQ(panel.text().split('\n').size(), 2);
    EXPECT_FALSE(panel.text().contains(QStringLiteral("one")));
    kinds->setCurrentIndex(2);
    log.add(MessageKind::Note, QStringLiteral("four"));
    EXPECT_TRUE(panel.text().endsWith(QStringLiteral("three"))) << panel.text().toStdString();
}

TEST_F(MessagesPanelTest, CopiesWhatIsSelectedOrAll) {
    show();
    log.add(MessageKind::Note, QStringLiteral("one"));
    log.add(MessageKind::Note, QStringLiteral("two"));
    click("copyMessages");
    EXPECT_EQ(QApplication::clipboard()->text(), panel.text());
    ASSERT_TRUE(list().find(QStringLiteral("one"), QTextDocument::FindBackward));
    click("copyMessages");
    EXPECT_EQ(QApplication::clipboard()->text(), QStringLiteral("one"));
    click("clearMessages");
    EXPECT_EQ(panel.text(), QString());
    EXPECT_TRUE(log.messages().empty());
}

TEST_F(MessagesPanelTest, LongMessagesWrap) {
    show();
    log.add(MessageKind::Note, QString(QStringLiteral("word ")).repeated(100));
    EXPECT_EQ(list().lineWrapMode(), QPlainTextEdit::WidgetWidth);
    EXPECT_GT(list().document()->firstBlock().layout()->lineCount(), 3);
}

TEST_F(MessagesPanelTest, ErrorsAreUnreadUntilThePanelIsInSight) {
    EXPECT_TRUE(badge.isHidden());
    log.add(MessageKind::Warning, QStringLiteral("a refusal"));
    EXPECT_TRUE(badge.isHidden());
    log.add(MessageKind::Error, QStringLiteral("one"));
    EXPECT_FALSE(badge.isHidden());
    EXPECT_EQ(badge.text(), QStringLiteral("1 error"));
    log.add(MessageKind::Error, QStringLiteral("two"));
    EXPECT_EQ(badge.text(), QStringLiteral("2 errors"));
    show();
    EXPECT_TRUE(badge.isHidden());
    log.add(MessageKind::Error, QStringLiteral("three"));
    EXPECT_TRUE(badge.isHidden()) << "it is seen at once";
    panel.hide();
    log.add(MessageKind::Error, QStringLiteral("four"));
    EXPECT_EQ(badge.text(), QStringLiteral("1 error"));
}

TEST_F(MessagesPanelTest, AUserWhoReadsFurtherUpIsNotCarriedAway) {
    show();
    for (int i = 0; i < 100; ++i) {
        log.add(MessageKind::Note, QString::number(i));
    }
    QScrollBar& bar = *list().verticalScrollBar();
    EXPECT_EQ(bar.value(), bar.maximum());
    bar.setValue(10);
    log.add(MessageKind::Note, QStringLiteral("another"));
    EXPECT_EQ(bar.value(), 10);
}

}  // namespace
}  // namespace asperity
