#include "tests/app/window/WindowFixture.h"
#include "ui/view/ZoomView.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QComboBox>
#include <QPushButton>
#include <QtTest>

namespace asperity::test {
namespace {

TEST_F(Window, EscTakesTheForcesAwayAndTheButtonGivesThemBack) {
    openFlatScene();
    choose("hand", "Simulated device");
    QTest::keyClick(&window, Qt::Key_Escape);
    EXPECT_TRUE(eventually([this] { return state().find("forces off") != std::string::npos; }));
    EXPECT_FALSE(session.run()->settings().forcesOn);
    QTest::mouseClick(child<QPushButton>("forces"), Qt::LeftButton);
    EXPECT_TRUE(eventually([this] { return state().find("forces off") == std::string::npos; }));
    EXPECT_TRUE(session.run()->settings().forcesOn);
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
    const double x = session.run()->basePosition().x();
    const int rubber = material->findText("silicone rubber");
    ASSERT_GE(rubber, 0);
    material->setFocus();
    while (material->currentIndex() != rubber) {
        QTest::keyClick(material, material->currentIndex() < rubber ? Qt::Key_Down : Qt::Key_Up);
    }
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(session.run()->scene().description.sample.material.elastic.youngsModulus, 1e6);
    EXPECT_NEAR(session.run()->basePosition().x(), x, 1e-12);
    EXPECT_TRUE(eventually([this] { return far(); })) << state();
}

TEST_F(Window, TheForceGainReachesTheLoop) {
    openFlatScene();
    auto* gain = child<QAbstractSpinBox>("forceGain");
    gain->setFocus();
    gain->selectAll();
    QTest::keyClicks(gain, "250");
    QTest::keyClick(gain, Qt::Key_Return);
    EXPECT_DOUBLE_EQ(session.run()->settings().forceGain, 250.0);
}

TEST_F(Window, TheMenuGivesTheDeviceTheTipAndTakesItBack) {
    openFlatScene();
    QAction* tip = window.menus().tipControl;
    EXPECT_FALSE(tip->isChecked());
    tip->trigger();
    EXPECT_EQ(session.run()->settings().positionControl, PositionControl::Tip);
    tip->trigger();
    EXPECT_EQ(session.run()->settings().positionControl, PositionControl::Base);
}

TEST_F(Window, ForcesStayOffAndKnobsStayTurnedOverAnotherMaterial) {
    openFlatScene();
    Settings turned = session.run()->settings();
    turned.forceGain = 250.0;
    turned.positionGain = 0.5;
    session.run()->setSettings(turned);
    QTest::mouseClick(child<QPushButton>("forces"), Qt::LeftButton);
    session.runs().pause();
    auto* material = child<QComboBox>("material");
    QTest::keyClick(material, material->currentIndex() > 0 ? Qt::Key_Up : Qt::Key_Down);
    ASSERT_TRUE(changeEnds());
    EXPECT_FALSE(session.run()->settings().forcesOn);
    EXPECT_EQ(session.run()->settings().forceGain, 250.0);
    EXPECT_FALSE(session.run()->loop().running());
    const Vector3 waiting = session.run()->basePosition();
    session.runs().start();
    EXPECT_TRUE(
        eventually([this] { return session.run()->loop().snapshot().statistics.ticks > 5; }));
    EXPECT_LT((session.run()->basePosition() - waiting).norm(), 1e-15) << "whatever the gain";
    EXPECT_FALSE(child<QPushButton>("forces")->isChecked());
    openFlatScene();
    EXPECT_FALSE(session.run()->settings().forcesOn) << "nor does another scan give them back";
}

TEST_F(Window, TheViewHasTheKeysAgainOnceAKnobIsTurned) {
    openFlatScene();
    auto* device = child<QComboBox>("hand");
    device->setFocus();
    QTest::keyClick(device, Qt::Key_Down);
    EXPECT_TRUE(window.view().hasFocus());
}

TEST_F(Window, ALockedWindowKeepsItsScene) {
    openFlatScene();
    window.lock();
    const LiveRun* run = session.run();
    auto* material = child<QComboBox>("material");
    EXPECT_FALSE(material->isEnabled());
    QTest::keyClick(&window, Qt::Key_Space);
    EXPECT_TRUE(session.run()->loop().running());
    EXPECT_EQ(session.run(), run);
}

}  // namespace
}  // namespace asperity::test
