#include "ui/window/DirectionMenu.h"

#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"
#include "ui/panels/NumberBox.h"
#include "ui/view/ZoomView.h"
#include "ui/window/MainWindow.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QApplication>
#include <QLineEdit>
#include <QtTest>

#include <gtest/gtest.h>

namespace asperity::test {
namespace {

class DirectionMenuTest : public ::testing::Test {
protected:
    void SetUp() override {
        window.showScene(&scene, QStringLiteral("a flat sample"));
        window.show();
        window.activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
        window.view().setFocus();
    }
    void TearDown() override { window.showScene(nullptr, {}); }

    Scene scene = buildScene(plainScene(), flatMap());
    MainWindow window;
};

TEST_F(DirectionMenuTest, KeysLookFromTheSides) {
    const auto eyeAfter = [this](Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::keyClick(&window.view(), key, modifiers);
        return window.view().camera().out();
    };
    EXPECT_LT((eyeAfter(Qt::Key_1) + Vector3::UnitY()).norm(), 1e-12);
    EXPECT_LT((eyeAfter(Qt::Key_3) - Vector3::UnitX()).norm(), 1e-12);
    EXPECT_LT((eyeAfter(Qt::Key_7) - Vector3::UnitZ()).norm(), 1e-12);
    EXPECT_LT((eyeAfter(Qt::Key_1, Qt::ControlModifier) - Vector3::UnitY()).norm(), 1e-12);
    EXPECT_LT((eyeAfter(Qt::Key_3, Qt::ControlModifier) + Vector3::UnitX()).norm(), 1e-12);
    EXPECT_LT((eyeAfter(Qt::Key_7, Qt::ControlModifier) + Vector3::UnitZ()).norm(), 1e-12);
    EXPECT_FALSE(window.view().camera().hasPerspective());
    QTest::keyClick(&window.view(), Qt::Key_5);
    EXPECT_TRUE(window.view().camera().hasPerspective());
    QTest::keyClick(&window.view(), Qt::Key_5);
    EXPECT_FALSE(window.view().camera().hasPerspective());
    QTest::keyClick(&window.view(), Qt::Key_Home);
    EXPECT_EQ(window.view().camera().out(), ViewCamera().out());
}

TEST_F(DirectionMenuTest, DigitsTypedIntoANumberBoxStayThere) {
    const Vector3 before = window.view().camera().out();
    NumberBox* box = nullptr;
    for (NumberBox* found : window.findChildren<NumberBox*>()) {
        if (found->isVisible() && found->isEnabled()) {
            box = found;
        }
    }
    ASSERT_NE(box, nullptr);
    auto* letters = box->findChild<QLineEdit*>();
    letters->setFocus();
    letters->selectAll();
    QTest::keyClicks(letters, QStringLiteral("1357"));
    EXPECT_TRUE(letters->text().startsWith(QStringLiteral("1357")))
        << letters->text().toStdString();
    EXPECT_EQ(window.view().camera().out(), before);
    EXPECT_FALSE(window.view().camera().hasPerspective());
}

}  // namespace
}  // namespace asperity::test
