#include "app/window/RunControl.h"

#include "app/loading/SceneLoader.h"
#include "app/window/live/ControlBar.h"
#include "app/window/live/EngageBar.h"
#include "tests/app/window/ControlFixture.h"

#include <QDoubleSpinBox>
#include <QPushButton>

#include <limits>

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

TickSample tickAt(double time, double force, ContactBranch branch) {
    TickSample sample;
    sample.time = time;
    sample.output.estimate.force = Vector3(0.0, 0.0, force);
    sample.output.estimate.covariance = 1e-20 * Matrix3::Identity();
    sample.output.model.contact.branch = branch;
    return sample;
}

/// Noise made arrow and numbers wobble while nothing moved.
TEST(SteadyForce, IsTheMeanOfATenthOfASecondAndBeginsAnewWithAContact) {
    SteadyForce steady;
    TickSample sample = tickAt(0.0, 9e-9, ContactBranch::Far);
    steady.apply(sample.output);
    EXPECT_EQ(sample.output.estimate.force.z(), 9e-9) << "nothing was taken yet";
    for (int i = 0; i < 1000; ++i) {
        sample = tickAt(1e-3 * i, 5e-9 + (i % 2 == 0 ? 1e-9 : -1e-9), ContactBranch::Bonded);
        steady.take(sample);
    }
    steady.apply(sample.output);
    EXPECT_NEAR(sample.output.estimate.force.z(), 5e-9, 0.02e-9);
    EXPECT_EQ(sample.output.estimate.covariance, 1e-20 * Matrix3::Identity());
    sample = tickAt(1.0, -2e-9, ContactBranch::Far);
    steady.apply(sample.output);
    EXPECT_EQ(sample.output.estimate.force.z(), -2e-9) << "the mean is of the contact";
    steady.take(sample);
    for (int i = 1; i < 100; ++i) {
        sample = tickAt(1.0 + 1e-3 * i, 0.0, ContactBranch::Far);
        steady.take(sample);
    }
    steady.apply(sample.output);
    EXPECT_NEAR(sample.output.estimate.force.z(), -2e-9 / 100.0, 1e-20) << "all have one weight";
}

TEST(SteadyForce, IsNotSpoiltByAValueThatIsNoNumber) {
    SteadyForce steady;
    steady.take(tickAt(0.0, std::numeric_limits<double>::quiet_NaN(), ContactBranch::Bonded));
    steady.take(tickAt(1e-3, 3e-9, ContactBranch::Bonded));
    TickSample sample = tickAt(1e-3, 3e-9, ContactBranch::Bonded);
    steady.apply(sample.output);
    EXPECT_EQ(sample.output.estimate.force.z(), 3e-9);
}

}  // namespace
}  // namespace asperity::test
