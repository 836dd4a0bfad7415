#include "app/window/RunControl.h"

#include "app/loading/SceneLoader.h"
#include "app/window/live/ControlBar.h"
#include "app/window/live/EngageBar.h"
#include "tests/app/window/ControlFixture.h"

#include <QDoubleSpinBox>
#include <QPushButton>

#include <functional>
#include <string>
#include <vector>

namespace asperity::test {
namespace {

class RunControlTest : public ControlFixture {};

TEST_F(RunControlTest, TellsThatARunBeginsBeforeItsLoopDoesAndEndsAfterIt) {
    EXPECT_EQ(runs.run(), nullptr);
    int begun = 0;
    int ended = 0;
    const auto rests = [this] { EXPECT_FALSE(run().loop().running()); };
    QObject::connect(&runs, &RunControl::begun, [&] { rests(), ++begun; });
    QObject::connect(&runs, &RunControl::ending, [&] { rests(), ++ended; });
    useFlatScene();
    EXPECT_TRUE(run().loop().running());
    EXPECT_EQ(begun, 1);
    EXPECT_EQ(ended, 0);
    useFlatScene();
    EXPECT_EQ(begun, 2);
    EXPECT_EQ(ended, 1);
    runs.end();
    EXPECT_EQ(runs.run(), nullptr);
    EXPECT_EQ(ended, 2);
}

TEST_F(RunControlTest, TheSinkGetsEveryTickInOrder) {
    std::vector<double> times;
    stage.onTick([&times](const TickSample& sample) { times.push_back(sample.time); });
    useFlatScene();
    ASSERT_TRUE(eventually([&] {
        runs.fetch();
        return times.size() > 20;
    }));
    runs.end();
    for (std::size_t i = 1; i < times.size(); ++i) {
        EXPECT_NEAR(times[i] - times[i - 1], times[1] - times[0], 1e-9) << i;
    }
}

TEST_F(RunControlTest, PausesAndGoesOnAsThePersonWants) {
    useFlatScene();
    Q_EMIT panels.controls().runningChosen(false);
    EXPECT_FALSE(run().loop().running());
    Q_EMIT panels.controls().runningChosen(true);
    EXPECT_TRUE(run().loop().running());
}

TEST_F(RunControlTest, BehindARecordingTheRunStaysAsItIs) {
    useFlatScene();
    const LiveRun* const live = runs.run();
    SceneDescription other = plainScene();
    other.setpoint = 77e-9;
    showRecordingOfOtherScan(other);
    EXPECT_TRUE(runs.showsRecording());
    EXPECT_EQ(runs.openRecording(), folder.file("recording"));
    EXPECT_EQ(runs.run(), live);
    EXPECT_FALSE(run().loop().running());
    EXPECT_EQ(runs.scene().description.setpoint, 77e-9);
    EXPECT_EQ(edits.wanted()->setpoint, 77e-9);
    const Vector3 base = run().basePosition();
    const long ticks = run().loop().snapshot().statistics.ticks;
    SceneDescription next = *edits.wanted();
    next.setpoint = 88e-9;
    edits.change("Setpoint", next);
    EXPECT_NE(told().find("back to the live tip"), std::string::npos) << told();
    EXPECT_EQ(edits.wanted()->setpoint, 77e-9);
    EXPECT_EQ(run().basePosition(), base);
    EXPECT_EQ(run().loop().snapshot().statistics.ticks, ticks);
    runs.showLive();
    EXPECT_FALSE(runs.showsRecording());
    EXPECT_TRUE(runs.openRecording().empty());
    EXPECT_EQ(runs.run(), live);
    EXPECT_TRUE(run().loop().running());
    EXPECT_EQ(*edits.wanted(), run().scene().description);
    EXPECT_EQ(runs.scene().description.setpoint, plainScene().setpoint);
    EXPECT_TRUE(edits.undoName().isEmpty()) << "the recording is no change of the scene";
}

TEST_F(RunControlTest, ARunThatWasPausedIsPausedAfterARecording) {
    useFlatScene();
    runs.pause();
    showRecordingOfOtherScan();
    showRecordingOfOtherScan();  // another one
    runs.showLive();
    EXPECT_FALSE(run().loop().running());
    showRecordingOfOtherScan();
    runs.start();
    EXPECT_FALSE(runs.showsRecording());
    EXPECT_TRUE(run().loop().running());
}

TEST_F(RunControlTest, PutsBackWhatFeaturesSetAside) {
    std::vector<std::string> heard;
    for (const char* const name : {"first", "second"}) {
        runs.beforeRecording([&heard, name]() -> std::function<void()> {
            heard.emplace_back(std::string("aside ") + name);
            return [&heard, name] { heard.emplace_back(std::string("back ") + name); };
        });
    }
    const QObject listener;
    QObject::connect(&runs, &RunControl::ending, &listener,
                     [&heard] { heard.emplace_back("ending"); });
    useFlatScene();
    showRecordingOfOtherScan();
    useFlatScene();  // the run ends while the recording is shown
    const std::vector<std::string> expected{"aside second", "aside first", "back first",
                                            "back second", "ending"};
    EXPECT_EQ(heard, expected);
}

TEST_F(RunControlTest, ShowsTheKnobsThatItTurns) {
    useFlatScene();
    runs.turn([](Settings& settings) { settings.forceGain = 250.0; });
    EXPECT_EQ(run().settings().forceGain, 250.0);
    EXPECT_EQ(window.findChild<QDoubleSpinBox*>("forceGain")->value(), 250.0);
    runs.setForces(false);
    EXPECT_FALSE(window.findChild<QPushButton*>("forces")->isChecked());
}

TEST_F(RunControlTest, ForcesSwitchedOffWhileTheFirstSceneLoadsStayOff) {
    runs.setForces(false);
    useFlatScene();
    EXPECT_FALSE(run().settings().forcesOn);
    EXPECT_FALSE(panels.controls().forcesOn());
}

TEST_F(RunControlTest, NothingCanBePressedBeforeThereIsAScene) {
    EXPECT_FALSE(panels.controls().isEnabled());
    EXPECT_FALSE(panels.engage().isEnabled());
    EXPECT_EQ(window.findChild<QDoubleSpinBox*>("positionGain")->value(), 1.0);
    useFlatScene();
    EXPECT_TRUE(panels.controls().isEnabled());
    EXPECT_TRUE(panels.engage().isEnabled());
}

TEST_F(RunControlTest, ForcesThatAreOffStayOffOverAnotherScene) {
    useFlatScene();
    runs.setForces(false);
    useFlatScene();
    EXPECT_FALSE(run().settings().forcesOn);
}

TEST_F(RunControlTest, TheSceneChangedHasPlaceKnobsAndPauseOfTheOneBefore) {
    useFlatScene();
    runs.pause();
    runs.turn([](Settings& settings) { settings.forceGain = 250.0; });
    const Vector2 position = run().basePosition().head<2>();
    std::vector<std::string> heard;
    QObject::connect(&runs, &RunControl::begun, [&] { heard.emplace_back("begun"); });
    QObject::connect(&runs, &RunControl::rebuilt, [&] { heard.emplace_back("rebuilt"); });
    SceneDescription softer = run().scene().description;
    softer.sample.material.elastic.youngsModulus *= 0.5;
    runs.replace(withDescription(run().loaded(), softer));
    EXPECT_EQ(heard, (std::vector<std::string>{"begun", "rebuilt"}));
    EXPECT_EQ(run().settings().forceGain, 250.0);
    EXPECT_LT((run().basePosition().head<2>() - position).norm(), 1e-15);
    EXPECT_FALSE(run().loop().running());
}

}  // namespace
}  // namespace asperity::test
