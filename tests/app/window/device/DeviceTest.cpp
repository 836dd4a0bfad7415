#include "app/window/device/PathControl.h"
#include "app/window/live/ControlBar.h"
#include "app/window/live/OverviewPanel.h"
#include "tests/app/window/WindowFixture.h"
#include "ui/view/OverviewMap.h"
#include "ui/view/ZoomView.h"

#include <QComboBox>
#include <QPushButton>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace asperity::test {
namespace {

TEST_F(Window, KeysBringTheTipIntoContactAndBack) {
    openFlatScene();
    ASSERT_TRUE(eventually([this] { return std::abs(number("forceZ")) < 0.5e-9; }));
    press(Qt::Key_PageDown);
    ASSERT_TRUE(eventually([this] { return inContact() && number("forceZ") > 5e-9; })) << state();
    release(Qt::Key_PageDown);
    EXPECT_EQ(text("distanceName"), "indentation");
    EXPECT_GT(number("distance"), 0.0);
    EXPECT_GT(number("contactRadius"), 0.5e-9);

    double strongestPull = 0.0;
    press(Qt::Key_PageUp);
    ASSERT_TRUE(eventually([&] {
        strongestPull = std::min(strongestPull, number("forceZ"));
        return far();
    })) << state();
    release(Qt::Key_PageUp);
    EXPECT_LT(strongestPull, -2e-9) << "the sample holds on before it lets go";
    EXPECT_TRUE(eventually([this] { return std::abs(number("forceZ")) < 0.5e-9; }));
}

TEST_F(Window, TheWheelBringsTheTipIntoContactAndBack) {
    openFlatScene();
    ASSERT_TRUE(eventually([this] {
        turnWheel(-1);
        return inContact();
    })) << state();
    ASSERT_TRUE(eventually([this] {
        turnWheel(1);
        return far();
    })) << state();
}

TEST_F(Window, ShiftMakesTheWheelTenTimesFiner) {
    openFlatScene();
    const auto climb = [this](int notches, Qt::KeyboardModifiers modifiers) {
        EXPECT_TRUE(baseRests());
        const double before = stage.run()->basePosition().z();
        for (int i = 0; i < std::abs(notches); ++i) {
            turnWheel(notches > 0 ? 1 : -1, modifiers);
        }
        EXPECT_TRUE(baseRests());
        return stage.run()->basePosition().z() - before;
    };
    const double coarse = climb(1, Qt::NoModifier);
    const double back = climb(-10, Qt::ShiftModifier);
    EXPECT_GT(coarse, 0.0);
    EXPECT_NEAR(back, -coarse, 1e-3 * coarse);
}

// 75 notches led from where a run begins to the contact.
TEST_F(Window, AFewNotchesOfTheWheelLeadToTheContact) {
    openFlatScene();
    int notches = 0;
    while (!inContact() && notches < 40) {
        turnWheel(-1);
        ++notches;
        ASSERT_TRUE(runsFor(0.15));
    }
    EXPECT_TRUE(inContact()) << state();
    EXPECT_LE(notches, 20);
}

TEST_F(Window, AReleasedKeyStopsTheTip) {
    openFlatScene();
    const double start = stage.run()->basePosition().x();
    press(Qt::Key_Right);
    ASSERT_TRUE(
        eventually([&] { return std::abs(stage.run()->basePosition().x() - start) > 1e-9; }));
    release(Qt::Key_Right);
    ASSERT_TRUE(baseRests());
    const double rest = stage.run()->basePosition().x();
    ASSERT_TRUE(runsFor(0.2));
    EXPECT_NEAR(stage.run()->basePosition().x(), rest, 1e-13);
}

TEST_F(Window, DraggingMovesTheTipAlongTheSample) {
    openFlatScene();
    const Vector3 before = stage.run()->basePosition();
    const QPoint middle = panels.view().rect().center();
    drag(middle, middle + QPoint(40, 0));
    ASSERT_TRUE(baseRests());
    const Vector3 way = stage.run()->basePosition() - before;
    EXPECT_GT(way.head<2>().norm(), 1e-9);
    EXPECT_NEAR(way.z(), 0.0, 1e-13);
}

TEST_F(Window, ADoubleClickOnTheScanTravelsThere) {
    openFlatScene();
    OverviewMap& map = panels.overview().map();
    const QPoint corner(map.width() / 2 + map.height() / 4, map.height() / 4);
    QSignalSpy chosen(&panels.overview(), &OverviewPanel::positionChosen);
    QTest::mouseDClick(&map, Qt::LeftButton, Qt::NoModifier, corner);
    ASSERT_EQ(chosen.count(), 1);
    const Vector2 position(chosen[0][0].toDouble(), chosen[0][1].toDouble());
    EXPECT_TRUE(eventually(
        [&] { return (stage.run()->basePosition().head<2>() - position).norm() < 0.05e-9; }));
    EXPECT_TRUE(far());
}

TEST_F(Window, AScriptedPathGoesIntoContactAndBack) {
    openFlatScene();
    auto* device = child<QComboBox>("device");
    device->setFocus();
    QTest::keyClick(device, Qt::Key_Down);
    EXPECT_EQ(device->currentText().toStdString(), "Mouse and keyboard") << "until it starts";
    Q_EMIT panels.controls().pathChosen(0);
    QTest::mouseClick(child<QPushButton>("startPath"), Qt::LeftButton);
    EXPECT_EQ(device->currentText().toStdString(), "Scripted path");
    ASSERT_TRUE(eventually([this] { return inContact(); })) << state();
    EXPECT_TRUE(eventually([this] { return far(); })) << state();
}

TEST_F(Window, TheMouseMovesNothingWhileTheRunPauses) {
    openFlatScene();
    ASSERT_TRUE(runsFor(0.3));
    stage.runs().pause();
    const Vector3 before = stage.run()->basePosition();
    turnWheel(-200);
    drag({300, 300}, {360, 300});
    Q_EMIT panels.overview().positionChosen(20e-9, 20e-9);
    stage.runs().start();
    ASSERT_TRUE(runsFor(0.5));
    EXPECT_LT((stage.run()->basePosition() - before).norm(), 1e-13);
}

TEST_F(Window, AJourneyEndsAtItsPlaceWhateverHappensOnTheWay) {
    openFlatScene();
    const Vector2 position(90e-9, 40e-9);
    Q_EMIT panels.overview().positionChosen(20e-9, 100e-9);
    ASSERT_TRUE(runsFor(0.7));
    Q_EMIT panels.overview().positionChosen(position.x(), position.y());
    ASSERT_TRUE(runsFor(0.6));
    Settings settings = stage.run()->settings();
    settings.positionGain = 3.0;
    stage.run()->setSettings(settings);
    const Vector3 end = waitingPosition(stage.run()->scene(), position);
    EXPECT_TRUE(eventually([&] { return (stage.run()->basePosition() - end).norm() < 0.01e-9; }));
    EXPECT_TRUE(far()) << state();
}

TEST_F(Window, APathIsFollowedInPlacesOfTheScanWhateverTheGain) {
    openFlatScene();
    Settings settings = stage.run()->settings();
    settings.positionGain = 0.5;
    stage.run()->setSettings(settings);
    ASSERT_TRUE(runsFor(0.1));
    const Vector3 end(70e-9, 50e-9, 12e-9);
    stage.get<PathControl>().follow({{0.0, {40e-9, 50e-9, 9e-9}}, {0.5, end}});
    EXPECT_TRUE(eventually([&] { return (stage.run()->basePosition() - end).norm() < 1e-15; }));
    Q_EMIT panels.controls().knobTurned(QStringLiteral("position_gain"), 4.0);
    EXPECT_EQ(stage.run()->settings().positionGain, 0.5) << "a path is no hand";
}

}  // namespace
}  // namespace asperity::test
