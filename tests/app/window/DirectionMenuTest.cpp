#include "app/window/live/LivePanels.h"
#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"
#include "ui/shell/MainWindow.h"
#include "ui/shell/Menus.h"
#include "ui/view/ViewOptionsMenu.h"
#include "ui/view/ZoomView.h"
#include "ui/widgets/NumberBox.h"

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
        panels.showScene(&scene, QStringLiteral("a flat sample"));
        window.show();
        window.activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
        panels.view().setFocus();
    }
    void TearDown() override { panels.showScene(nullptr, {}); }

    Scene scene = buildScene(plainScene(), flatMap());
    MainWindow window;
    LivePanels panels{window};
};

TEST_F(DirectionMenuTest, KeysLookFromTheSides) {
    const auto eyeAfter = [this](Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::keyClick(&panels.view(), key, modifiers);
        return panels.view().camera().out();
    };
    EXPECT_LT((eyeAfter(Qt::Key_1) + Vector3::UnitY()).norm(), 1e-12);
    EXPECT_LT((eyeAfter(Qt::Key_3) - Vector3::UnitX()).norm(), 1e-12);
    EXPECT_LT((eyeAfter(Qt::Key_7) - Vector3::UnitZ()).norm(), 1e-12);
    EXPECT_LT((eyeAfter(Qt::Key_1, Qt::ControlModifier) - Vector3::UnitY()).norm(), 1e-12);
    EXPECT_LT((eyeAfter(Qt::Key_3, Qt::ControlModifier) + Vector3::UnitX()).norm(), 1e-12);
    EXPECT_LT((eyeAfter(Qt::Key_7, Qt::ControlModifier) + Vector3::UnitZ()).norm(), 1e-12);
    EXPECT_FALSE(panels.view().camera().hasPerspective());
    QTest::keyClick(&panels.view(), Qt::Key_5);
    EXPECT_TRUE(panels.view().camera().hasPerspective());
    QTest::keyClick(&panels.view(), Qt::Key_5);
    EXPECT_FALSE(panels.view().camera().hasPerspective());
    QTest::keyClick(&panels.view(), Qt::Key_Home);
    EXPECT_EQ(panels.view().camera().out(), ViewCamera().out());
}

TEST_F(DirectionMenuTest, DigitsTypedIntoANumberBoxStayThere) {
    const Vector3 before = panels.view().camera().out();
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
    EXPECT_EQ(panels.view().camera().out(), before);
    EXPECT_FALSE(panels.view().camera().hasPerspective());
}

}  // namespace
}  // namespace asperity::test
