#include "app/window/device/PathControl.h"
#include "app/window/live/ControlBar.h"
#include "tests/app/window/ControlFixture.h"
#include "ui/view/ZoomView.h"

#include <QComboBox>
#include <QDoubleSpinBox>
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
    const double engagedAt = run().basePosition().z();
    ASSERT_FALSE(framesUntil([] { return false; }, 300));
    EXPECT_NEAR(run().basePosition().z(), engagedAt, 1e-13) << "the tip stays";
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

TEST_F(EngageControlTest, WithoutARunNothingHappens) {
    button("engage").click();
    button("withdraw").click();
    EXPECT_EQ(complaint(), "");
}

}  // namespace
}  // namespace asperity::test
