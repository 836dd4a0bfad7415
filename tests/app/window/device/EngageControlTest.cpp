#include "app/window/device/EngageControl.h"

#include "app/window/live/ControlBar.h"
#include "app/window/live/EngageBar.h"
#include "tests/app/window/ControlFixture.h"
#include "ui/view/ZoomView.h"
#include "ui/widgets/NumberBox.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>

#include <gmock/gmock.h>

#include <algorithm>
#include <string>

namespace asperity::test {
namespace {

class EngageControlTest : public ControlFixture {
protected:
    /// Frames until something holds.
    bool framesUntil(const std::function<bool()>& holds, int milliseconds = 20000) {
        return eventually(
            [&] {
                devices.advance(0.01);
                engaging.advance();
                return holds();
            },
            milliseconds);
    }
    const TickOutput& latest() { return run().loop().snapshot().sample.output; }
    double tickTime() { return run().loop().snapshot().sample.time; }
    std::string device() {
        return window.findChild<QComboBox*>("device")->currentText().toStdString();
    }
    QPushButton& button(const char* name) { return *window.findChild<QPushButton*>(name); }
    bool engaged() { return told().starts_with("Engaged"); }

    DeviceControl& devices = stage.add<DeviceControl>();
    EngageControl& engaging = stage.add<EngageControl>();
};

// It took 75 notches of the wheel, and more care than an AFM asks for.
TEST_F(EngageControlTest, EngagesFromFarInAboutTwoSecondsAndGivesTheTipBack) {
    useFlatScene();
    ASSERT_TRUE(framesUntil([this] { return latest().region() == TipRegion::Far; }));
    const Vector3 start = run().basePosition();
    panels.engage().setSetpoint(3e-9);
    const double begin = tickTime();
    button("engage").click();
    EXPECT_EQ(device(), "Scripted path");
    ASSERT_TRUE(framesUntil([this] { return engaged(); })) << told();
    EXPECT_LT(tickTime() - begin, 4.0);
    EXPECT_THAT(told(), testing::MatchesRegex("Engaged at .* nN ± .* \\(noise\\) ± 0\\.3 \\(k\\) "
                                              "\\(setpoint 3 nN\\)"));
    EXPECT_NEAR(std::stod(told().substr(std::string("Engaged at ").size())),
                latest().model.force.z() * 1e9, 0.3)
        << "the force that is there, with the detector's noise";
    EXPECT_EQ(device(), "Mouse and keyboard");
    EXPECT_NEAR(latest().model.force.z(), 3e-9, 0.2e-9) << "noise ended it up to 0.6 nN early";
    EXPECT_LT((run().basePosition() - start).head<2>().norm(), 1e-15);
    Q_EMIT panels.engage().holdChosen(false);
    const double engagedAt = run().basePosition().z();
    ASSERT_FALSE(framesUntil([] { return false; }, 300));
    EXPECT_NEAR(run().basePosition().z(), engagedAt, 1e-13) << "the tip stays";
}

/// At "5 nN" a drag pressed 243 nN on a wall, and lost a valley.
TEST_F(EngageControlTest, HoldsTheForceWhileTheTipIsDragged) {
    runs.use({.scene = buildScene(plainScene(), ridgedMap(6e-9)),
              .format = "made for the test",
              .sha256 = "",
              .notes = {}});
    button("engage").click();
    ASSERT_TRUE(framesUntil([this] { return engaged(); })) << told();
    ASSERT_NE(devices.feedback(), nullptr);
    const Vector3 start = run().basePosition();
    double strongest = 0.0;
    double weakest = 1.0;
    for (const int way : {1, -1}) {
        EXPECT_TRUE(framesUntil([&] {
            Q_EMIT panels.view().tipDragged(way * 5e-9, 0.0);
            const double force = latest().estimate.force.z();
            strongest = std::max(strongest, force);
            weakest = std::min(weakest, force);
            return way * (run().basePosition().x() - start.x()) > 30e-9;
        }));
    }
    EXPECT_LT(strongest, 20e-9);
    EXPECT_GT(weakest, -1e-9);
    const auto error = [this] { return window.findChild<QLabel*>("holdError")->text(); };
    EXPECT_TRUE(framesUntil([&] {
        runs.fetch();
        return error().endsWith("pN");
    })) << error().toStdString();
}

TEST_F(EngageControlTest, AnotherSetpointIsHeldAtOnce) {
    useFlatScene();
    button("engage").click();
    ASSERT_TRUE(framesUntil([this] { return engaged(); })) << told();
    window.findChild<QDoubleSpinBox*>("setpoint")->setValue(8.0);
    EXPECT_TRUE(framesUntil([this] { return latest().model.force.z() > 7.8e-9; }));
    EXPECT_EQ(devices.feedback()->setpoint(), 8e-9);
}

TEST_F(EngageControlTest, TheForceThatIsHeldIsThatOfTheRunWhateverARecordingHad) {
    useFlatScene();
    button("engage").click();
    ASSERT_TRUE(framesUntil([this] { return engaged(); })) << told();
    const double setpoint = devices.feedback()->setpoint();
    const Vector3 base = run().basePosition();
    SceneDescription other = plainScene();
    other.setpoint = 3.0 * setpoint;
    showRecordingOfOtherScan(other);
    Q_EMIT edits.changed();
    ASSERT_FALSE(framesUntil([] { return false; }, 100));
    runs.showLive();
    ASSERT_NE(devices.feedback(), nullptr);
    EXPECT_EQ(devices.feedback()->setpoint(), setpoint);
    EXPECT_NEAR(window.findChild<QDoubleSpinBox*>("setpoint")->value(), 1e9 * setpoint, 1e-9);
    EXPECT_LT((run().basePosition() - base).norm(), 1e-9);
    EXPECT_EQ(latest().region(), TipRegion::Contact);
}

/// The wheel asks for a height: the feedback ends, and says so.
TEST_F(EngageControlTest, TheWheelEndsTheFeedback) {
    useFlatScene();
    button("engage").click();
    ASSERT_TRUE(framesUntil([this] { return engaged(); })) << told();
    Q_EMIT panels.view().lifted(1.0);
    EXPECT_EQ(devices.feedback(), nullptr);
    EXPECT_FALSE(panels.engage().holdsForce());
    EXPECT_TRUE(told().starts_with("The height is held")) << told();
    Q_EMIT panels.engage().holdChosen(true);
    EXPECT_NE(devices.feedback(), nullptr);
}

TEST_F(EngageControlTest, TipPositionControlHoldsNoForceAndSaysWhy) {
    useFlatScene();
    button("engage").click();
    ASSERT_TRUE(framesUntil([this] { return engaged(); })) << told();
    runs.turn([](Settings& settings) { settings.positionControl = PositionControl::Tip; });
    ASSERT_TRUE(framesUntil([this] { return devices.feedback() == nullptr; }));
    EXPECT_TRUE(told().starts_with("Tip position control")) << told();
    Q_EMIT panels.engage().holdChosen(true);
    EXPECT_EQ(devices.feedback(), nullptr);
}

TEST_F(EngageControlTest, ASetpointIsTypedAsDeflectionOrVolts) {
    SceneDescription description = plainScene();
    description.detector.invOls = 50e-9;
    runs.use({.scene = buildScene(description, flatMap()),
              .format = "made for the test",
              .sha256 = "",
              .notes = {}});
    QComboBox& unit = *window.findChild<QComboBox*>("setpointUnit");
    QDoubleSpinBox& box = *window.findChild<QDoubleSpinBox*>("setpoint");
    ASSERT_EQ(unit.count(), 3);
    const double perForce = shownDeflectionPerForce(run().scene().belief.cantilever);
    unit.setCurrentIndex(1);
    Q_EMIT unit.activated(1);
    EXPECT_NEAR(box.value(), 5.0 * perForce, 1e-3 * box.value());
    EXPECT_DOUBLE_EQ(panels.engage().setpoint(), 5e-9) << "what is shown is rounded, not the force";
    unit.setCurrentIndex(2);
    Q_EMIT unit.activated(2);
    box.setValue(0.01);
    EXPECT_NEAR(panels.engage().setpoint(), 0.01 * 50e-9 / perForce, 1e-15);
    useFlatScene();
    EXPECT_EQ(unit.currentText().toStdString(), "nN");
    const QModelIndex volts = unit.model()->index(2, 0);
    EXPECT_FALSE(volts.flags().testFlag(Qt::ItemIsEnabled)) << "no sensitivity";
    EXPECT_FALSE(volts.data(Qt::ToolTipRole).toString().isEmpty()) << "it says why";
}

TEST_F(EngageControlTest, AnEmptiedRampIsTheUsualOneAgain) {
    useFlatScene();
    auto& rate = *window.findChild<GainSpinBox*>("rampRate");
    const double usual = rate.value();
    rate.setValue(3.0 * usual);
    ASSERT_FALSE(rate.isMuted());
    rate.setFocus();
    rate.selectAll();
    QTest::keyClick(&rate, Qt::Key_Delete);
    QTest::keyClick(&rate, Qt::Key_Return);
    EXPECT_TRUE(rate.isMuted());
    EXPECT_EQ(rate.value(), usual);
}

TEST_F(EngageControlTest, WithdrawsOutOfTheSamplesReachAlsoWhileItEngages) {
    useFlatScene();
    button("engage").click();
    ASSERT_TRUE(framesUntil([this] { return engaged(); })) << told();
    button("withdraw").click();
    EXPECT_EQ(told(), "Withdrawing") << "it is engaged no more";
    ASSERT_TRUE(framesUntil([this] { return run().basePosition().z() > 5e-9; }));
    EXPECT_EQ(latest().region(), TipRegion::Far);
    ASSERT_TRUE(framesUntil([this] { return told() == "Withdrawn"; })) << told();
    button("engage").click();
    ASSERT_TRUE(framesUntil([this] { return run().basePosition().z() < 4e-9; }));
    button("withdraw").click();
    EXPECT_EQ(device(), "Mouse and keyboard");
    ASSERT_TRUE(framesUntil([this] { return run().basePosition().z() > 5e-9; }));
}

/// A withdrawal was over in 0.2 s: nobody saw what happened.
TEST_F(EngageControlTest, ACycleTakesAboutFourSecondsAndGoesAsFarAsTheUserSays) {
    useFlatScene();
    auto& rate = *window.findChild<GainSpinBox*>("rampRate");
    auto& size = *window.findChild<GainSpinBox*>("rampSize");
    EXPECT_TRUE(rate.isMuted() && size.isMuted()) << "they suit the scene";
    ASSERT_TRUE(framesUntil([this] { return latest().region() == TipRegion::Far; }));
    const double top = run().basePosition().z();
    const auto isAt = [&](double height) {
        return std::abs(run().basePosition().z() - height) < 0.02 * top;
    };
    EXPECT_NEAR(panels.engage().ramp().size, top, 0.05 * top) << "it waits where a ramp begins";
    const double begin = tickTime();
    button("engage").click();
    ASSERT_TRUE(framesUntil([this] { return engaged(); })) << told();
    const double contact = tickTime();
    button("withdraw").click();
    ASSERT_TRUE(framesUntil([this] { return told() == "Withdrawn"; })) << told();
    const double cycle = tickTime() - begin;
    EXPECT_GT(tickTime() - contact, 1.0);
    EXPECT_GT(cycle, 3.0);
    EXPECT_LT(cycle, 6.0);
    size.setValue(3e9 * top);
    rate.setValue(10e9 * top);
    EXPECT_FALSE(rate.isMuted() || size.isMuted());
    button("withdraw").click();
    ASSERT_TRUE(framesUntil([this] { return told() == "Withdrawn"; })) << told();
    EXPECT_TRUE(framesUntil([&] { return isAt(3.0 * top); }));
    button("engage").click();
    ASSERT_TRUE(framesUntil([this] { return engaged(); })) << told();
    size.setValue(1.0);
    button("withdraw").click();
    ASSERT_TRUE(framesUntil([this] { return told() == "Withdrawn"; })) << told();
    EXPECT_TRUE(framesUntil([&] { return isAt(top); })) << "out of the sample's reach in any case";
}

TEST_F(EngageControlTest, AWithdrawalThatTheUserEndsInContactIsNoWithdrawal) {
    useFlatScene();
    button("engage").click();
    ASSERT_TRUE(framesUntil([this] { return engaged(); })) << told();
    button("withdraw").click();
    Q_EMIT panels.view().tipDragged(1e-12, 0.0);
    engaging.advance();
    EXPECT_TRUE(told().starts_with("Not withdrawn")) << told();
}

TEST_F(EngageControlTest, TheSetpointIsThatOfTheSceneAndStaysOverAnotherMaterial) {
    SceneDescription description = plainScene();
    description.setpoint = 2e-9;
    runs.use({.scene = buildScene(description, flatMap()),
              .format = "made for the test",
              .sha256 = "",
              .notes = {}});
    EXPECT_DOUBLE_EQ(panels.engage().setpoint(), 2e-9);
    window.findChild<QDoubleSpinBox*>("setpoint")->setValue(7.0);
    EXPECT_DOUBLE_EQ(run().scene().description.setpoint, 7e-9) << "at once";
    edits.change("softer", withMaterial(run().scene().description, {}));
    ASSERT_TRUE(changeEnds());
    EXPECT_DOUBLE_EQ(panels.engage().setpoint(), 7e-9);
    useFlatScene();
    EXPECT_DOUBLE_EQ(panels.engage().setpoint(), 5e-9) << "another scene";
}

TEST_F(EngageControlTest, AForceFeedbackDeviceApproachesByHand) {
    useFlatScene();
    auto& list = *window.findChild<QComboBox*>("device");
    Q_EMIT panels.controls().deviceChosen(list.findText("Simulated device"));
    ASSERT_TRUE(framesUntil([this] { return !button("engage").isEnabled(); }, 2000));
    EXPECT_NE(button("engage").toolTip().indexOf("force-feedback"), -1);
    Q_EMIT panels.controls().deviceChosen(list.findText("Mouse and keyboard"));
    EXPECT_TRUE(framesUntil([this] { return button("engage").isEnabled(); }, 2000));
}

TEST_F(EngageControlTest, AForceFeedbackDeviceEndsTheFeedbackAndHoldsNoForceOfItsOwn) {
    useFlatScene();
    button("engage").click();
    ASSERT_TRUE(framesUntil([this] { return devices.feedback() != nullptr; })) << told();
    auto& list = *window.findChild<QComboBox*>("device");
    Q_EMIT panels.controls().deviceChosen(list.findText("Simulated device"));
    EXPECT_EQ(devices.feedback(), nullptr);
    Q_EMIT panels.engage().holdChosen(true);
    EXPECT_EQ(devices.feedback(), nullptr);
    EXPECT_TRUE(told().starts_with("The operator holds the tip")) << told();
    EXPECT_FALSE(panels.engage().holdsForce());
}

TEST_F(EngageControlTest, WithoutARunNothingHappens) {
    button("engage").click();
    button("withdraw").click();
    EXPECT_EQ(complaint(), "");
}

TEST_F(EngageControlTest, TheSetpointThatIsShownIsHeldAlsoIfItWasTypedOnTheWayOrUndone) {
    useFlatScene();
    button("engage").click();
    window.findChild<QDoubleSpinBox*>("setpoint")->setValue(3.0);
    ASSERT_TRUE(framesUntil([this] { return engaged(); })) << told();
    EXPECT_EQ(devices.feedback()->setpoint(), 3e-9);
    window.findChild<QDoubleSpinBox*>("setpoint")->setValue(9.0);
    EXPECT_EQ(devices.feedback()->setpoint(), 9e-9);
    edits.undo();
    EXPECT_EQ(panels.engage().setpoint(), devices.feedback()->setpoint());
    EXPECT_TRUE(framesUntil([this] {
        return std::abs(latest().model.force.z() - panels.engage().setpoint()) < 0.3e-9;
    }));
}

TEST_F(EngageControlTest, AnotherMaterialIsEngagedAgainWhereTheForceWasHeld) {
    useFlatScene();
    button("engage").click();
    ASSERT_TRUE(framesUntil([this] { return engaged(); })) << told();
    ASSERT_TRUE(framesUntil([this] { return devices.feedback() != nullptr; }));
    SampleMaterial softer = run().scene().description.sample.material;
    softer.elastic.youngsModulus *= 0.5;
    edits.change("softer", withMaterial(run().scene().description, softer));
    ASSERT_TRUE(changeEnds());
    EXPECT_TRUE(framesUntil([this] { return devices.feedback() != nullptr; })) << told();
}

}  // namespace
}  // namespace asperity::test
