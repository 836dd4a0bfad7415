#include "tests/app/window/WindowFixture.h"
#include "ui/shell/Menus.h"
#include "ui/view/ZoomView.h"

#include <QAction>
#include <QComboBox>
#include <QPushButton>
#include <QtTest>

namespace asperity::test {
namespace {

TEST_F(Window, EscTakesTheForcesAwayAndTheButtonGivesThemBack) {
    openFlatScene();
    choose("device", "Simulated device");
    QTest::keyClick(&window, Qt::Key_Escape);
    EXPECT_TRUE(eventually([this] { return state().find("forces off") != std::string::npos; }));
    EXPECT_FALSE(stage.run()->settings().forcesOn);
    QTest::mouseClick(child<QPushButton>("forces"), Qt::LeftButton);
    EXPECT_TRUE(eventually([this] { return state().find("forces off") == std::string::npos; }));
    EXPECT_TRUE(stage.run()->settings().forcesOn);
}

TEST_F(Window, PausesAndGoesOn) {
    openFlatScene();
    QTest::mouseClick(child<QPushButton>("startPause"), Qt::LeftButton);
    EXPECT_TRUE(eventually([this] { return state().find("paused") != std::string::npos; }));
    live(500);  // longer than numbers stay as they are
    const std::string ticks = text("ticks");
    live(500);  // in which they would change
    EXPECT_EQ(text("ticks"), ticks);
    QTest::mouseClick(child<QPushButton>("startPause"), Qt::LeftButton);
    EXPECT_TRUE(eventually([&] { return text("ticks") != ticks; }));
    EXPECT_EQ(state().find("paused"), std::string::npos);
}

TEST_F(Window, AnotherMaterialIsAnotherSceneAtTheSamePlace) {
    openFlatScene();
    auto* material = child<QComboBox>("material");
    const double x = stage.run()->basePosition().x();
    const int rubber = material->findText("silicone rubber");
    ASSERT_GE(rubber, 0);
    material->setFocus();
    while (material->currentIndex() != rubber) {
        QTest::keyClick(material, material->currentIndex() < rubber ? Qt::Key_Down : Qt::Key_Up);
    }
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(stage.run()->scene().description.sample.material.elastic.youngsModulus, 1e6);
    EXPECT_NEAR(stage.run()->basePosition().x(), x, 1e-12);
    EXPECT_TRUE(eventually([this] { return far(); })) << state();
}

TEST_F(Window, TheForceGainReachesTheLoop) {
    openFlatScene();
    auto* gain = child<QAbstractSpinBox>("forceGain");
    gain->setFocus();
    gain->selectAll();
    QTest::keyClicks(gain, "250");
    QTest::keyClick(gain, Qt::Key_Return);
    EXPECT_DOUBLE_EQ(stage.run()->settings().forceGain, 250.0);
}

TEST_F(Window, TheMenuGivesTheDeviceTheTipAndTakesItBack) {
    openFlatScene();
    QAction* tip = &window.menus().entry("tipControl");
    EXPECT_FALSE(tip->isChecked());
    tip->trigger();
    EXPECT_EQ(stage.run()->settings().positionControl, PositionControl::Tip);
    tip->trigger();
    EXPECT_EQ(stage.run()->settings().positionControl, PositionControl::Base);
}

TEST_F(Window, ForcesStayOffAndKnobsStayTurnedOverAnotherMaterial) {
    openFlatScene();
    Settings turned = stage.run()->settings();
    turned.forceGain = 250.0;
    turned.positionGain = 0.5;
    stage.run()->setSettings(turned);
    QTest::mouseClick(child<QPushButton>("forces"), Qt::LeftButton);
    stage.runs().pause();
    auto* material = child<QComboBox>("material");
    QTest::keyClick(material, material->currentIndex() > 0 ? Qt::Key_Up : Qt::Key_Down);
    ASSERT_TRUE(changeEnds());
    EXPECT_FALSE(stage.run()->settings().forcesOn);
    EXPECT_EQ(stage.run()->settings().forceGain, 250.0);
    EXPECT_FALSE(stage.run()->loop().running());
    const Vector3 waiting = stage.run()->basePosition();
    stage.runs().start();
    EXPECT_TRUE(eventually([this] { return stage.run()->loop().snapshot().statistics.ticks > 5; }));
    EXPECT_LT((stage.run()->basePosition() - waiting).norm(), 1e-15) << "whatever the gain";
    EXPECT_FALSE(child<QPushButton>("forces")->isChecked());
    openFlatScene();
    EXPECT_FALSE(stage.run()->settings().forcesOn) << "nor does another scan give them back";
}

TEST_F(Window, TheViewHasTheKeysAgainOnceAKnobIsTurned) {
    openFlatScene();
    auto* device = child<QComboBox>("device");
    device->setFocus();
    QTest::keyClick(device, Qt::Key_Down);
    EXPECT_TRUE(panels.view().hasFocus());
}

TEST_F(Window, ALockedWindowKeepsItsScene) {
    openFlatScene();
    panels.lock();
    window.lock();
    const LiveRun* run = stage.run();
    auto* material = child<QComboBox>("material");
    EXPECT_FALSE(material->isEnabled());
    QTest::keyClick(&window, Qt::Key_Space);
    EXPECT_TRUE(stage.run()->loop().running());
    EXPECT_EQ(stage.run(), run);
}

}  // namespace
}  // namespace asperity::test
