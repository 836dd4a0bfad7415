#include "app/window/device/HapticControl.h"

#include "app/window/device/DeviceControl.h"
#include "app/window/live/ControlBar.h"
#include "tests/app/window/ControlFixture.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLabel>

namespace asperity::test {
namespace {

class HapticControlTest : public ControlFixture {
protected:
    void turn(const char* column, double value) {
        Q_EMIT window.findChild<HapticPanel*>()->settingTurned(column, value);
    }
    std::string shown(const char* column) {
        return window.findChild<HapticPanel*>()
            ->findChild<QAbstractSpinBox*>(QStringLiteral("haptics.") + column)
            ->text()
            .toStdString();
    }
    std::string text(const char* name) {
        return window.findChild<HapticPanel*>()->findChild<QLabel*>(name)->text().toStdString();
    }
    void showPage() {
        window.show();
        window.showSidePage(window.findChild<HapticPanel*>());
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    }
    /// Lets frames go by until a label shows a value.
    bool comes(const char* label, const char* value) {
        return eventually([&] {
            runs.fetch();
            haptics.show();
            return text(label).find(value) != std::string::npos;
        });
    }

    DeviceControl& devices = stage.add<DeviceControl>();
    HapticControl& haptics = stage.add<HapticControl>();
};

TEST_F(HapticControlTest, KnobsReachTheRunAtOnce) {
    useFlatScene();
    const LiveRun* const before = runs.run();
    turn("force_gain", 250.0);
    EXPECT_EQ(run().settings().forceGain, 250.0);
    EXPECT_EQ(shown("force_gain"), "250");
    turn("clutched", 1.0);
    EXPECT_TRUE(run().settings().clutched);
    turn("guide_axis_x", 1.0);
    EXPECT_NEAR(run().settings().guide.axis.norm(), 1.0, 1e-12) << "of any length";
    EXPECT_EQ(runs.run(), before);
    EXPECT_EQ(edits.undoName(), "") << "a knob is of the run, not of the scene";
}

TEST_F(HapticControlTest, WhatNoSceneMayHaveIsRefused) {
    useFlatScene();
    turn("coupling_stiffness_n_m", 600.0);
    EXPECT_NE(complaint().find("proxy_damping_n_s_m above 0"), std::string::npos);
    EXPECT_EQ(shown("coupling_stiffness_n_m"), "0");
    EXPECT_FALSE(run().settings().coupling.couples());
    turn("proxy_damping_n_s_m", 3.0);
    turn("coupling_stiffness_n_m", 600.0);
    EXPECT_EQ(complaint(), "");
    EXPECT_TRUE(run().settings().coupling.couples());
}

TEST_F(HapticControlTest, AnotherRateIsAnotherRunThatCanBeUndone) {
    useFlatScene();
    Q_EMIT window.findChild<HapticPanel*>()->rateEntered(2000.0);
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(run().scene().timeStep(), 1.0 / 2000.0);
    EXPECT_EQ(edits.undoName(), "Rate: 2000 Hz");
    edits.undo();
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(shown("rate_hz"), "1000");
}

TEST_F(HapticControlTest, ShowsDeviceLoopAndEnergyWhileThePageIsSeen) {
    useFlatScene();
    showPage();
    EXPECT_TRUE(comes("hapticTick", "s")) << "a time";
    EXPECT_EQ(text("hapticDevice"), "without force feedback");
    EXPECT_EQ(text("hapticForce"), "none: the device only senses");
    EXPECT_EQ(text("hapticEnergy"), "–");
    auto& list = *window.findChild<QComboBox*>("device");
    Q_EMIT panels.controls().deviceChosen(list.findText("Simulated device"));
    EXPECT_TRUE(comes("hapticDevice", "1 mm : 1 nm")) << text("hapticDevice");
    EXPECT_TRUE(comes("hapticForce", "/ 3 N")) << text("hapticForce");
    EXPECT_TRUE(comes("hapticEnergy", "J")) << text("hapticEnergy");
    EXPECT_EQ(shown("position_gain"), "1e-6") << "the device's own gains";
}

TEST_F(HapticControlTest, WithoutARunNothingHappens) {
    turn("force_gain", 250.0);
    Q_EMIT window.findChild<HapticPanel*>()->rateEntered(2000.0);
    EXPECT_EQ(complaint(), "");
}

}  // namespace
}  // namespace asperity::test
