#include "app/window/scene/SceneControl.h"
#include "tests/app/window/WindowFixture.h"

#include <QMessageBox>
#include <QPlainTextEdit>
#include <QSignalSpy>
#include <QToolButton>
#include <QtTest>

namespace asperity::test {
namespace {

TEST_F(Window, AnErrorIsCountedInTheBottomLineAndCanBeReadAgain) {
    openFlatScene();
    auto* badge = child<QToolButton>("messageBadge");
    EXPECT_FALSE(badge->isVisible());
    QSignalSpy failed(&stage.get<SceneControl>(), &SceneControl::openFailed);
    stage.get<SceneControl>().open(folder.write("broken.gsf", "no scan at all"));
    ASSERT_TRUE(eventually([&] { return failed.count() == 1; }));
    delete window.findChild<QMessageBox*>();
    ASSERT_TRUE(eventually([&] { return badge->isVisible(); }));
    EXPECT_EQ(badge->text(), QStringLiteral("1 error"));
    QTest::mouseClick(badge, Qt::LeftButton);
    auto* list = child<QPlainTextEdit>("messageList");
    ASSERT_TRUE(eventually([&] { return list->isVisible(); }));
    EXPECT_TRUE(list->toPlainText().contains(QStringLiteral("broken.gsf")));
    EXPECT_FALSE(badge->isVisible()) << "it is read";
}

}  // namespace
}  // namespace asperity::test
