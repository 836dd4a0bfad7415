#include "tests/app/window/WindowFixture.h"

#include <QComboBox>
#include <QPushButton>
#include <QtTest>

namespace asperity::test {
namespace {

TEST_F(Window, EscTakesTheForcesAwayAndTheButtonGivesThemBack) {
    openFlatScene();
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
    live(500);
    const std::string ticks = text("ticks");
    live(500);
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

}  // namespace
}  // namespace asperity::test
