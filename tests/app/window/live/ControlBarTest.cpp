#include "app/window/live/ControlBar.h"

#include "core/scene/Settings.h"
#include "tests/ui/widgets/PanelSamples.h"
#include "ui/widgets/NumberBox.h"

#include <QApplication>
#include <QComboBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>

#include <gtest/gtest.h>

namespace asperity {
namespace {

/// One notch of the wheel away from the user. @return whether the widget used it
bool turnWheelOver(QWidget& widget) {
    const QPointF position = widget.rect().center();
    QWheelEvent event(position, widget.mapToGlobal(position.toPoint()), {}, {0, 120}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&widget, &event);
    return event.isAccepted();
}

class ControlBarTest : public ::testing::Test {
protected:
    void SetUp() override {
        bar.setMaterials({QStringLiteral("polystyrene"), QStringLiteral("silicon")});
        bar.setDevices({QStringLiteral("mouse and keyboard"), QStringLiteral("scripted")});
        bar.setPaths({QStringLiteral("approach"), QStringLiteral("raster")});
    }

    template <class Widget>
    Widget& child(const char* name) {
        auto* widget = bar.findChild<Widget*>(QString::fromUtf8(name));
        EXPECT_NE(widget, nullptr) << name;
        return *widget;
    }

    ControlBar bar;
};

TEST_F(ControlBarTest, WhatAProgramSetsEmitsNothing) {
    const QSignalSpy running(&bar, &ControlBar::runningChosen);
    const QSignalSpy forces(&bar, &ControlBar::forcesChosen);
    const QSignalSpy material(&bar, &ControlBar::materialChosen);
    const QSignalSpy device(&bar, &ControlBar::deviceChosen);
    const QSignalSpy path(&bar, &ControlBar::pathChosen);
    const QSignalSpy knob(&bar, &ControlBar::knobTurned);
    const QSignalSpy recording(&bar, &ControlBar::recordingChosen);
    bar.setMaterials({QStringLiteral("a"), QStringLiteral("b")});
    bar.setRunning(true);
    bar.setForcesOn(false);
    bar.setMaterial(1);
    bar.setDevice(1);
    bar.setPath(1);
    bar.setKnobs({.positionGain = 2e-6, .forceGain = 1e8});
    bar.setRecording(true);
    for (const QSignalSpy* spy :
         {&running, &forces, &material, &device, &path, &knob, &recording}) {
        EXPECT_EQ(spy->count(), 0);
    }
    EXPECT_EQ(child<QPushButton>("startPause").text(), QStringLiteral("Pause"));
    EXPECT_EQ(child<QPushButton>("forces").text(), QStringLiteral("Forces are off"));
    EXPECT_FALSE(child<QPushButton>("forces").isChecked());
    EXPECT_EQ(child<QComboBox>("material").currentText(), QStringLiteral("b"));
    EXPECT_EQ(child<QComboBox>("device").currentText(), QStringLiteral("scripted"));
    EXPECT_EQ(child<QComboBox>("path").currentText(), QStringLiteral("raster"));
    EXPECT_DOUBLE_EQ(child<GainSpinBox>("forceGain").value(), 1e8);
    EXPECT_DOUBLE_EQ(child<GainSpinBox>("positionGain").value(), 2e-6);
    EXPECT_EQ(child<QPushButton>("record").text(), QStringLiteral("Recording"));
}

TEST_F(ControlBarTest, StartAndPauseTakeTurns) {
    QSignalSpy chosen(&bar, &ControlBar::runningChosen);
    auto& button = child<QPushButton>("startPause");
    EXPECT_EQ(button.text(), QStringLiteral("Start"));
    QTest::mouseClick(&button, Qt::LeftButton);
    QTest::mouseClick(&button, Qt::LeftButton);
    ASSERT_EQ(chosen.count(), 2);
    EXPECT_TRUE(chosen[0][0].toBool());
    EXPECT_FALSE(chosen[1][0].toBool());
    EXPECT_EQ(button.text(), QStringLiteral("Start"));
}

TEST_F(ControlBarTest, AClickSwitchesForcesAndRecording) {
    QSignalSpy forces(&bar, &ControlBar::forcesChosen);
    QSignalSpy recording(&bar, &ControlBar::recordingChosen);
    QTest::mouseClick(&child<QPushButton>("forces"), Qt::LeftButton);
    QTest::mouseClick(&child<QPushButton>("record"), Qt::LeftButton);
    ASSERT_EQ(forces.count(), 1);
    EXPECT_FALSE(forces[0][0].toBool());
    EXPECT_EQ(child<QPushButton>("forces").text(), QStringLiteral("Forces are off"));
    ASSERT_EQ(recording.count(), 1);
    EXPECT_TRUE(recording[0][0].toBool());
}

TEST_F(ControlBarTest, AChoiceWithTheKeyboardIsThePersons) {
    QSignalSpy material(&bar, &ControlBar::materialChosen);
    QSignalSpy device(&bar, &ControlBar::deviceChosen);
    QSignalSpy path(&bar, &ControlBar::pathChosen);
    QSignalSpy file(&bar, &ControlBar::pathFileRequested);
    QTest::keyClick(&child<QComboBox>("material"), Qt::Key_Down);
    QTest::keyClick(&child<QComboBox>("device"), Qt::Key_Down);
    QTest::keyClick(&child<QComboBox>("path"), Qt::Key_Down);
    QTest::mouseClick(&child<QToolButton>("pathFile"), Qt::LeftButton);
    for (QSignalSpy* spy : {&material, &device, &path}) {
        ASSERT_EQ(spy->count(), 1);
        EXPECT_EQ((*spy)[0][0].toInt(), 1);
    }
    EXPECT_EQ(file.count(), 1);
}

TEST_F(ControlBarTest, GainsStepLikeOneTwoFive) {
    bar.setKnobs({.forceGain = 1e8});
    QSignalSpy turned(&bar, &ControlBar::knobTurned);
    auto& box = child<GainSpinBox>("forceGain");
    for (int i = 0; i < 4; ++i) {
        QTest::keyClick(&box, Qt::Key_Up);
    }
    ASSERT_EQ(turned.count(), 4);
    EXPECT_EQ(turned[0][0].toString(), QStringLiteral("force_gain"));
    EXPECT_DOUBLE_EQ(turned[0][1].toDouble(), 2e8);
    EXPECT_DOUBLE_EQ(turned[1][1].toDouble(), 5e8);
    EXPECT_DOUBLE_EQ(turned[2][1].toDouble(), 1e9);
    EXPECT_DOUBLE_EQ(turned[3][1].toDouble(), 2e9);
    for (int i = 0; i < 5; ++i) {
        QTest::keyClick(&box, Qt::Key_Down);
    }
    EXPECT_DOUBLE_EQ(box.value(), 5e7);
}

TEST_F(ControlBarTest, BetweenTheStepsTheNextStepComes) {
    GainSpinBox box(1e-12, 1e3);
    box.setValue(3e-6);
    box.stepBy(1);
    EXPECT_DOUBLE_EQ(box.value(), 5e-6);
    box.setValue(3e-6);
    box.stepBy(-1);
    EXPECT_DOUBLE_EQ(box.value(), 2e-6);
    box.setValue(7.0);
    box.stepBy(1);
    EXPECT_DOUBLE_EQ(box.value(), 10.0);
    box.setValue(1e-12);
    box.stepBy(-1);
    EXPECT_DOUBLE_EQ(box.value(), 1e-12) << "the least";
}

TEST_F(ControlBarTest, AGainCanBeTyped) {
    QSignalSpy turned(&bar, &ControlBar::knobTurned);
    auto& box = child<GainSpinBox>("positionGain");
    box.selectAll();
    QTest::keyClicks(&box, QStringLiteral("3.5e-5"));
    EXPECT_EQ(turned.count(), 0) << "not before it is whole";
    QTest::keyClick(&box, Qt::Key_Return);
    ASSERT_EQ(turned.count(), 1);
    EXPECT_EQ(turned[0][0].toString(), QStringLiteral("position_gain"));
    EXPECT_DOUBLE_EQ(turned[0][1].toDouble(), 3.5e-5);
    EXPECT_EQ(box.text(), QStringLiteral("3.5e-5"));
    box.selectAll();
    QTest::keyClicks(&box, QStringLiteral("oops"));
    QTest::keyClick(&box, Qt::Key_Return);
    EXPECT_DOUBLE_EQ(box.value(), 3.5e-5);
    EXPECT_EQ(turned.count(), 1);
}

TEST_F(ControlBarTest, TheWheelChangesOnlyWhatHasTheFocus) {
    bar.setMaterial(1);
    bar.setKnobs({.forceGain = 1e8});
    const QSignalSpy material(&bar, &ControlBar::materialChosen);
    const QSignalSpy gain(&bar, &ControlBar::knobTurned);
    auto& combo = child<QComboBox>("material");
    auto& box = child<GainSpinBox>("forceGain");
    bar.show();
    QApplication::setActiveWindow(&bar);
    bar.setFocus();
    EXPECT_FALSE(turnWheelOver(combo)) << "the window may use it";
    EXPECT_FALSE(turnWheelOver(box));
    EXPECT_EQ(combo.currentIndex(), 1);
    EXPECT_DOUBLE_EQ(box.value(), 1e8);
    EXPECT_EQ(material.count() + gain.count(), 0);
    EXPECT_FALSE(combo.hasFocus() || box.hasFocus());
    combo.setFocus();
    ASSERT_TRUE(combo.hasFocus());
    EXPECT_TRUE(turnWheelOver(combo));
    EXPECT_EQ(material.count(), 1);
    box.setFocus();
    EXPECT_TRUE(turnWheelOver(box));
    EXPECT_DOUBLE_EQ(box.value(), 2e8);
}

TEST_F(ControlBarTest, FitsASmallWindowWithNothingCutOff) {
    bar.resize(1280, bar.sizeHint().height());
    EXPECT_LE(bar.minimumSizeHint().width(), 1280);
    bar.setRunning(true);
    bar.setForcesOn(false);
    bar.setRecording(true);
    bar.grab();
    for (const char* name : {"startPause", "forces", "record"}) {
        auto& button = child<QPushButton>(name);
        EXPECT_GE(button.width(), button.sizeHint().width()) << name;
        EXPECT_LE(button.mapTo(&bar, button.rect().bottomRight()).x(), bar.width()) << name;
    }
}

TEST_F(ControlBarTest, TakesTwoLinesInANarrowWindow) {
    const int line = bar.heightForWidth(1600);
    EXPECT_GT(bar.heightForWidth(800), line);
    bar.resize(800, bar.heightForWidth(800));
    bar.grab();
    for (const auto* widget : bar.findChildren<QWidget*>()) {
        if (widget->parentWidget() == &bar) {
            EXPECT_TRUE(bar.rect().contains(widget->geometry()));
        }
    }
}

}  // namespace
}  // namespace asperity
