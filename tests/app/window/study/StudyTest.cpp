#include "core/Units.h"
#include "tests/app/ProgramRun.h"
#include "tests/app/window/study/StudyFixture.h"
#include "ui/shell/Menus.h"
#include "ui/view/ZoomView.h"

#include <QAction>
#include <QComboBox>
#include <QInputDialog>
#include <QPushButton>
#include <QSpinBox>
#include <QtTest>

#include <algorithm>

namespace asperity::test {
namespace {

/// A device that can be pulled out.
class LooseDevice final : public HapticDevice {
public:
    [[nodiscard]] DeviceSpecification specification() const noexcept override {
        return kSensesOnly;
    }
    DeviceState advance(double /*timeStep*/) noexcept override { return {.connected = false}; }
};

TEST_F(WindowWithStudy, IsDoneFromBeginningToEndByMouseAndEnter) {
    openFlatScene();
    const SceneDescription before = stage.run()->scene().description;
    start(shortStudy());
    EXPECT_EQ(text("trialTask"), "Task B on polystyrene");
    doTrial();
    ASSERT_EQ(trials().size(), 1U);
    const TrialRecord first = trials().front();
    EXPECT_TRUE(first.counts());
    EXPECT_EQ(first.device, "window");
    EXPECT_LT(first.error, 3.0_nm);
    EXPECT_LT(first.errorPercent, 6.0);
    EXPECT_GT(first.time, 1.0);
    EXPECT_GT(first.largestForce, 1.0_nN) << "the snap-in is felt";
    EXPECT_NE(text("trialError"), "–");
    pressButton();
    doTrial();
    pressButton();
    EXPECT_TRUE(action().starts_with("Leave")) << action();
    pressButton();
    EXPECT_FALSE(window.menus().entry("trial").isEnabled());
    EXPECT_EQ(stage.run()->scene().description, before);
    EXPECT_TRUE(child<QComboBox>("material")->isEnabled());
}

TEST_F(WindowWithStudy, ItsTrialsReplayToTheBit) {
    start(shortStudy());
    doTrial();
    const std::string trial = (out() / "trials" / "001").string();
    EXPECT_TRUE(std::filesystem::exists(trial + "/trajectory.csv"));
    const ProgramRun replay =
        runProgram("replay " + trial + " --out " + (folder.path() / "replayed").string());
    EXPECT_EQ(replay.exitCode, 0) << replay.output;
    EXPECT_NE(replay.output.find("identical"), std::string::npos) << replay.output;
}

TEST_F(WindowWithStudy, OnTheSimulatedDeviceHasItsScaleAndTheDeviceStays) {
    openFlatScene();
    choose("device", "Simulated device");
    start(shortStudy());
    const auto isAtScale = [this] {
        const Settings& knobs = stage.run()->settings();
        return knobs.positionGain == study.scale.positionGain &&
               knobs.forceGain == study.scale.forceGain && knobs.coupling.couples();
    };
    EXPECT_TRUE(isAtScale());
    doTrial();
    pressButton();
    EXPECT_TRUE(isAtScale());
    EXPECT_EQ(child<QComboBox>("device")->currentText(), QStringLiteral("Simulated device"));
    const TrialRecord first = trials().front();
    EXPECT_TRUE(first.counts());
    EXPECT_LT(first.error, 3.0_nm);
    EXPECT_EQ(first.scale.positionGain, study.scale.positionGain);
    EXPECT_GT(first.coupling.stiffness, 0.0);
}

TEST_F(WindowWithStudy, AStruckOutTrialIsKeptWithItsReasonAndComesAgain) {
    start(shortStudy());
    pressButton();
    ASSERT_TRUE(runsFor(0.2));
    pressButton();
    QTest::mouseClick(child<QPushButton>("strikeOut"), Qt::LeftButton);
    auto* dialog = window.findChild<QInputDialog*>("strikeOutDialog");
    ASSERT_NE(dialog, nullptr);
    dialog->setTextValue("the phone, it \"rang\"");
    dialog->accept();
    ASSERT_EQ(trials().size(), 1U);
    EXPECT_EQ(trials()[0].struckOut, "the phone, it \"rang\"");
    EXPECT_NE(text("trialNote").find("rang"), std::string::npos);
    pressButton();
    EXPECT_NE(text("trialPlace").find("attempt 2"), std::string::npos) << text("trialPlace");
    pressButton();
    ASSERT_TRUE(runsFor(0.2));
    pressButton();
    ASSERT_EQ(trials().size(), 2U);
    EXPECT_TRUE(trials()[1].counts());
    EXPECT_EQ(trials()[1].plan.attempt, 2);
    EXPECT_TRUE(std::filesystem::exists(out() / "trials" / "001_2" / "trajectory.csv"));
}

TEST_F(WindowWithStudy, ASecondPressRightAfterTheFirstDoesNothing) {
    start(shortStudy());
    pressButton();
    for (int i = 0; i < 5; ++i) {
        QTest::keyClick(&panels.view(), Qt::Key_Return);
    }
    EXPECT_TRUE(isInTrial()) << action();
    ASSERT_TRUE(runsFor(0.6));  // of ticks, which lag behind the window's clock on a busy machine
    EXPECT_TRUE(isInTrial()) << action();
    pressButton();
    EXPECT_GT(trials().at(0).time, 0.5);
}

TEST_F(WindowWithStudy, TheLastTrialCanBeStruckOutUntilTheNextOneBegins) {
    start(shortStudy());
    pressButton();
    pressButton();
    pressButton();
    ASSERT_TRUE(isReady()) << action();
    ASSERT_TRUE(child<QPushButton>("strikeOut")->isEnabled());
    QTest::mouseClick(child<QPushButton>("strikeOut"), Qt::LeftButton);
    auto* dialog = window.findChild<QInputDialog*>("strikeOutDialog");
    ASSERT_NE(dialog, nullptr);
    dialog->setTextValue("too soon");
    dialog->accept();
    EXPECT_NE(text("trialPlace").find("trial 1 of 2"), std::string::npos) << text("trialPlace");
    EXPECT_NE(text("trialPlace").find("attempt 2"), std::string::npos) << text("trialPlace");
    EXPECT_FALSE(child<QPushButton>("strikeOut")->isEnabled());
}

TEST_F(WindowWithStudy, AFaultEndsItsTrialIsKeptAndTheTrialComesAgain) {
    start(shortStudy());
    pressButton();
    ASSERT_TRUE(runsFor(0.1));
    stage.run()->takeDevice([] { return std::make_unique<LooseDevice>(); });
    ASSERT_TRUE(eventually([this] { return action().starts_with("Next"); })) << action();
    ASSERT_EQ(trials().size(), 1U);
    EXPECT_EQ(trials()[0].fault, Fault::DeviceLost);
    pressButton();
    EXPECT_TRUE(isReady()) << action();
    EXPECT_NE(text("trialPlace").find("attempt 2"), std::string::npos) << text("trialPlace");
}

TEST_F(WindowWithStudy, APauseEndsTheTrialAndGoingOnBringsItAgain) {
    start(shortStudy());
    pressButton();
    ASSERT_TRUE(runsFor(0.1));
    QTest::mouseClick(child<QPushButton>("pauseStudy"), Qt::LeftButton);
    EXPECT_TRUE(action().starts_with("Continue")) << action();
    ASSERT_EQ(trials().size(), 1U);
    EXPECT_EQ(trials()[0].struckOut, "paused");
    QTest::mouseClick(child<QPushButton>("pauseStudy"), Qt::LeftButton);
    EXPECT_TRUE(isReady()) << action();
}

TEST_F(WindowWithStudy, ForcesThatAreSwitchedOffEndTheTrial) {
    openFlatScene();
    choose("device", "Simulated device");
    start(shortStudy());
    pressButton();
    ASSERT_TRUE(runsFor(0.2));
    press(Qt::Key_Escape);
    ASSERT_TRUE(eventually([this] { return action().starts_with("Next"); })) << action();
    EXPECT_EQ(trials().at(0).struckOut, "forces were switched off");
    EXPECT_FALSE(stage.run()->settings().forcesOn);
    pressButton();
    EXPECT_TRUE(isReady()) << action();
    EXPECT_FALSE(stage.run()->settings().forcesOn) << "nobody has switched them on";
    pressButton();
    EXPECT_TRUE(isReady()) << action();
    EXPECT_NE(text("trialInstruction").find("Forces are off"), std::string::npos);
    QTest::mouseClick(child<QPushButton>("forces"), Qt::LeftButton);
    pressButton();
    EXPECT_TRUE(isInTrial()) << action();
    press(Qt::Key_Escape);
    QTest::mouseClick(child<QPushButton>("leaveStudy"), Qt::LeftButton);
    EXPECT_FALSE(stage.run()->settings().forcesOn) << "after the study neither";
}

TEST_F(WindowWithStudy, TheTimeLimitEndsATrialThatCounts) {
    Study quick = shortStudy();
    quick.timeLimit = 1.0;
    start(quick);
    pressButton();
    double shown = shownTime();
    double longest = 0.0;  // from one frame to the next [s]
    ASSERT_TRUE(eventually([&] {
        longest = std::max(longest, shownTime() - shown);
        shown = shownTime();
        return action().starts_with("Next");
    })) << action();
    EXPECT_TRUE(trials().at(0).timedOut);
    EXPECT_TRUE(trials().at(0).counts());
    EXPECT_GE(trials().at(0).time, 1.0);
    EXPECT_LT(trials().at(0).time, 1.0 + (2.0 * longest)) << "not two frames after its limit";
}

TEST_F(WindowWithStudy, ItBeginsWithATrainingThatKeepsNothingAndEndsByItself) {
    Study trained = shortStudy();
    trained.training = 1.5;
    start(trained);
    EXPECT_EQ(text("trialTask"), "Try the program");
    const double before = tip().z();
    turnWheel(-3);
    EXPECT_TRUE(eventually([&] { return tip().z() < before - 1.0_nm; }, 1000)) << "it moves";
    ASSERT_TRUE(eventually([this] { return isReady(); }, 5000)) << action();
    EXPECT_TRUE(isAtStart());
    EXPECT_FALSE(std::filesystem::exists(out() / "trials.csv"));
}

TEST_F(WindowWithStudy, GoesOnWhereItWasLeft) {
    start(shortStudy());
    doTrial();
    pressButton();
    pressButton();
    ASSERT_TRUE(isInTrial());
    QTest::mouseClick(child<QPushButton>("leaveStudy"), Qt::LeftButton);
    ASSERT_EQ(trials().size(), 2U);
    EXPECT_EQ(trials()[1].struckOut, "left");
    EXPECT_NE(text("studyState").find("valid trials: 1"), std::string::npos) << text("studyState");
    EXPECT_EQ(child<QSpinBox>("studyParticipant")->value(), 1);
    start(study);
    EXPECT_NE(text("trialPlace").find("trial 2 of 2"), std::string::npos) << text("trialPlace");
    EXPECT_NE(text("trialPlace").find("attempt 2"), std::string::npos) << text("trialPlace");
}

}  // namespace
}  // namespace asperity::test
