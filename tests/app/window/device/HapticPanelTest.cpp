#include "app/window/device/HapticControl.h"
#include "core/scene/SceneDescription.h"

#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <string>
#include <type_traits>

namespace asperity {
namespace {

class HapticPanelTest : public ::testing::Test {
protected:
    template <class Widget>
    Widget& control(const std::string& name) {
        auto* found = panel.findChild<Widget*>(QString::fromStdString(name));
        EXPECT_NE(found, nullptr) << name;
        return *found;
    }
    std::string text(const char* name) { return control<QLabel>(name).text().toStdString(); }
    void type(const std::string& name, const char* number) {
        auto& box = control<QAbstractSpinBox>(name);
        box.selectAll();
        QTest::keyClicks(&box, QString::fromUtf8(number));
        QTest::keyClick(&box, Qt::Key_Return);
    }

    HapticPanel panel;
};

/// A knob that scenes have and no page shows could be turned in a file only.
TEST_F(HapticPanelTest, HasEveryKnobOfAScene) {
    const Settings any;
    int count = 0;
    listSettings(any, [&](const SettingField& field, const auto& /*value*/) {
        if (field.key != nullptr) {
            auto& knob = control<QWidget>(std::string("haptics.") + field.column);
            EXPECT_FALSE(knob.toolTip().isEmpty()) << field.column;
            ++count;
        }
    });
    EXPECT_GT(count, 20);
}

TEST_F(HapticPanelTest, ShowsKnobsAndEmitsNothing) {
    const QSignalSpy turned(&panel, &HapticPanel::settingTurned);
    Settings settings = defaultScene().settings;
    settings.forceGain = 250.0;
    settings.coupling = {.stiffness = 600.0, .damping = 1.5, .proxyDamping = 3.0};
    settings.positionControl = PositionControl::Tip;
    settings.clutched = true;
    settings.clutchButton = 2;
    settings.guide.kind = FixtureKind::Line;
    panel.showSettings(settings);
    EXPECT_EQ(control<QAbstractSpinBox>("haptics.force_gain").text(), "250");
    EXPECT_EQ(control<QAbstractSpinBox>("haptics.coupling_stiffness_n_m").text(), "600");
    EXPECT_EQ(control<QComboBox>("haptics.tip_control").currentText(), "tip");
    EXPECT_TRUE(control<QCheckBox>("haptics.clutched").isChecked());
    EXPECT_EQ(control<QComboBox>("haptics.clutch_button").currentText(), "button 2");
    EXPECT_EQ(control<QComboBox>("haptics.dead_man_button").currentText(), "none");
    EXPECT_EQ(control<QComboBox>("haptics.guide").currentText(), "line");
    EXPECT_EQ(control<QAbstractSpinBox>("haptics.guide_capture_m").text(), "50");
    EXPECT_TRUE(turned.isEmpty());
}

TEST_F(HapticPanelTest, GivesWhatIsTurnedInSiUnits) {
    const QSignalSpy turned(&panel, &HapticPanel::settingTurned);
    panel.showDevice("a device", true);
    panel.showSettings(defaultScene().settings);
    type("haptics.guide_capture_m", "80");
    Q_EMIT control<QComboBox>("haptics.dead_man_button").activated(1);
    control<QCheckBox>("haptics.clutched").click();
    ASSERT_EQ(turned.count(), 3);
    EXPECT_EQ(turned[0][0], "guide_capture_m");
    EXPECT_NEAR(turned[0][1].toDouble(), 80e-9, 1e-20);
    EXPECT_EQ(turned[1][0], "dead_man_button");
    EXPECT_EQ(turned[1][1].toDouble(), 0.0);
    EXPECT_EQ(turned[2][1].toDouble(), 1.0);
    const QSignalSpy rate(&panel, &HapticPanel::rateEntered);
    panel.showRate(1000.0);
    type("haptics.rate_hz", "2000");
    ASSERT_EQ(rate.count(), 1);
    EXPECT_EQ(rate[0][0].toDouble(), 2000.0);
}

TEST_F(HapticPanelTest, WhatNeedsMotorsIsDisabledWithoutThemAndSaysWhy) {
    panel.showDevice("mouse", false);
    auto& limit = control<QWidget>("haptics.max_force_n");
    EXPECT_FALSE(limit.isEnabledTo(&panel));
    EXPECT_TRUE(limit.toolTip().contains("force-feedback"));
    panel.showDevice("a device", true);
    EXPECT_TRUE(limit.toolTip().contains("weaker device")) << "what it is";
    EXPECT_TRUE(limit.isEnabledTo(&panel));
    panel.refuseGuide("no coupling");
    EXPECT_FALSE(control<QWidget>("haptics.guide").isEnabledTo(&panel));
    panel.refuseGuide({});
    EXPECT_TRUE(control<QWidget>("haptics.guide").isEnabledTo(&panel));
}

TEST_F(HapticPanelTest, SaysWhyTheForceIsLimited) {
    TickOutput output;
    output.deviceForce = Vector3(0.0, 0.0, 1.5);
    panel.showTick(output, 3.0);
    EXPECT_EQ(text("hapticForce"), "1.5 N / 3 N");
    EXPECT_EQ(text("hapticState"), "not limited");
    output.forceState = ForceState::Limited;
    panel.showTick(output, 3.0);
    EXPECT_EQ(text("hapticState"), "force at its limit");
    output.fault = Fault::VelocityTrip;
    panel.showTick(output, 0.0);
    EXPECT_EQ(text("hapticState"), "device too fast: forces switched off");
    EXPECT_EQ(text("hapticForce"), "none: the device only senses");
}

TEST_F(HapticPanelTest, ShowsEnergyAndLoop) {
    EXPECT_EQ(text("hapticEnergy"), "–");
    panel.showEnergy(PortEnergy{.dissipated = -0.012, .spring = 0.004, .warned = true});
    EXPECT_EQ(text("hapticEnergy"), "none; the coupling supplied 12 mJ");
    EXPECT_EQ(text("hapticSpring"), "4 mJ");
    panel.showEnergy(std::nullopt);
    EXPECT_EQ(text("hapticEnergy"), "–");
    LoopStatistics statistics;
    statistics.tickTime = {.median = 12e-6, .p99 = 35e-6, .largest = 1e-4};
    statistics.lateness = {.median = 5e-8, .p99 = 2e-5, .largest = 1e-3};
    statistics.overruns = 3;
    panel.showLoop(statistics);
    EXPECT_EQ(text("hapticTick"), "12 µs / 35 µs");
    EXPECT_EQ(text("hapticLate"), "50 ns / 20 µs");
    EXPECT_EQ(text("hapticMissed"), "3");
}

}  // namespace
}  // namespace asperity
