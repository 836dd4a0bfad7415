#include "app/window/ViewControl.h"
#include "app/window/live/StateBanner.h"
#include "tests/app/window/ControlFixture.h"
#include "ui/shell/MainWindow.h"
#include "ui/shell/MessagesPanel.h"

#include <QMessageBox>

#include <limits>

namespace asperity::test {
namespace {

class MessageControlTest : public ControlFixture {
protected:
    /// The texts, "kind: text".
    QStringList listed() {
        QStringList texts;
        for (const Message& message : window.messages().messages()) {
            texts << QStringLiteral("%1: %2").arg(static_cast<int>(message.kind)).arg(message.text);
        }
        return texts;
    }

    MessageControl& messages = stage.add<MessageControl>();
};

TEST_F(MessageControlTest, WhatTheWindowSaysIsKept) {
    window.tell(QStringLiteral("a note"));
    window.tell(QString());
    window.complain(QStringLiteral("a complaint"));
    EXPECT_EQ(listed(),
              (QStringList{QStringLiteral("0: a note"), QStringLiteral("2: a complaint")}));
    EXPECT_EQ(complaint(), "a complaint") << "and is shown in a box";
}

/// A refusal quotes what is in a damaged file, of any length. Its end says what was expected.
TEST(MainWindowMessages, AComplaintThatQuotesAFileIsCut) {
    const QString quoted = QStringLiteral("key %1\x1b[2J: expected a number\nTry again.");
    MainWindow window;
    window.complain(quoted.arg(QString(40000, QChar(0xe4))));
    ASSERT_EQ(window.messages().messages().size(), 1U);
    for (const QString& text :
         {window.messages().messages().front().text, window.findChild<QMessageBox*>()->text()}) {
        EXPECT_LE(text.toUtf8().size(), 1000);
        EXPECT_TRUE(text.contains(QStringLiteral("key ä")) && text.contains(QChar(0x2026)));
        EXPECT_TRUE(text.endsWith(QStringLiteral("\\e[2J: expected a number\nTry again.")));
    }
}

TEST_F(MessageControlTest, NotesOnAScanAreListedOnce) {
    const LoadedScene scene{.scene = buildScene(plainScene(), flatMap()),
                            .format = "made for the test",
                            .sha256 = "",
                            .notes = {"3 pixels hold no data"}};
    runs.use(scene);
    EXPECT_TRUE(listed().contains(QStringLiteral("0: 3 pixels hold no data")));
    runs.replace(scene);
    EXPECT_EQ(listed().count(QStringLiteral("0: 3 pixels hold no data")), 1);
}

TEST_F(MessageControlTest, FaultsAreErrorsAndTheirResetIsNoted) {
    useFlatScene();
    runs.pause();
    window.messages().clear();
    Settings broken = run().settings();
    broken.forceGain = std::numeric_limits<double>::quiet_NaN();
    run().loop().setSettings(broken);
    run().loop().step();
    messages.advance();
    messages.advance();
    ASSERT_EQ(listed().size(), 1) << listed().join('\n').toStdString();
    EXPECT_TRUE(listed().front().startsWith(QStringLiteral("2: Fault, forces are off: ")));
    EXPECT_EQ(window.messages().unreadErrors(), 1);
    run().loop().setSettings(run().settings());
    Q_EMIT panels.banner().rearmRequested();
    run().loop().step();
    messages.advance();
    EXPECT_EQ(listed().last(), QStringLiteral("0: The fault was reset"));
}

}  // namespace
}  // namespace asperity::test
