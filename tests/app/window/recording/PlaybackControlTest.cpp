#include "app/window/recording/PlaybackControl.h"

#include "app/recording/RunPlayback.h"
#include "app/window/device/EngageControl.h"
#include "app/window/recording/RecordingControl.h"
#include "core/io/tables/CsvTable.h"
#include "tests/app/window/ControlFixture.h"
#include "ui/shell/Menus.h"

#include <QAction>
#include <QPushButton>
#include <QToolButton>

#include <functional>

namespace asperity::test {
namespace {

/// The last seconds of a run on a flat sample, without the views of a window.
class PlaybackControlTest : public ControlFixture {
protected:
    void SetUp() override {
        recordings.setFolder(folder.path() / "recordings");
        useFlatScene();
    }
    /// Frames until something holds.
    bool framesUntil(const std::function<bool()>& holds, int milliseconds = 20000) {
        return eventually(
            [&] {
                devices.advance(0.01);
                engaging.advance();
                if (!runs.showsRecording()) {
                    runs.fetch();
                }
                recordings.advance();
                playback.advance(0.01);
                return holds();
            },
            milliseconds);
    }
    void engage() {
        ASSERT_TRUE(framesUntil([this] { return region() == TipRegion::Far; }));
        window.findChild<QPushButton*>("engage")->click();
        ASSERT_TRUE(framesUntil([this] { return told().starts_with("Engaged"); })) << told();
    }
    TipRegion region() { return run().loop().snapshot().sample.output.region(); }
    QAction& replay() { return window.menus().entry("replayLastJump"); }
    ContactBranch branch() { return runs.shown().sample.output.model.contact.branch; }

    RecordingControl& recordings = stage.add<RecordingControl>();
    DeviceControl& devices = stage.add<DeviceControl>();
    EngageControl& engaging = stage.add<EngageControl>();
    PlaybackControl& playback = stage.add<PlaybackControl>();
};

TEST_F(PlaybackControlTest, SaysThatThereWasNoJump) {
    ASSERT_TRUE(framesUntil([this] { return run().loop().snapshot().statistics.ticks > 100; }));
    replay().trigger();
    EXPECT_EQ(told(), "There was no snap-in or pull-off in the last 10 s");
    EXPECT_FALSE(runs.showsRecording());
    EXPECT_TRUE(run().loop().running());
}

TEST_F(PlaybackControlTest, PlaysTheLastSnapInAgainInSlowMotion) {
    engage();
    replay().trigger();
    ASSERT_TRUE(framesUntil([this] { return playback.tick().has_value(); })) << told();
    EXPECT_FALSE(run().loop().running());
    EXPECT_TRUE(runs.openRecording().empty()) << "it is on no disk";
    EXPECT_EQ(&runs.scene(), &run().scene());
    EXPECT_EQ(playback.page().bar().speed(), 0.1);
    const double begin = runs.shown().sample.time;
    EXPECT_EQ(branch(), ContactBranch::Far);
    const auto* play = window.findChild<QToolButton*>("playRecording");
    ASSERT_TRUE(framesUntil([play] { return play->isChecked(); }));
    ASSERT_TRUE(framesUntil([this] { return branch() == ContactBranch::Bonded; }));
    EXPECT_NEAR(runs.shown().sample.time - begin, 0.2, 0.05);
    window.menus().refresh();
    EXPECT_NE(replay().toolTip().toStdString().find("back to the live tip"), std::string::npos);
}

TEST_F(PlaybackControlTest, BackFromTheReplayTheForceIsStillHeld) {
    engage();
    const FeedbackDevice* const feedback = devices.feedback();
    ASSERT_NE(feedback, nullptr);
    replay().trigger();
    ASSERT_TRUE(framesUntil([this] { return playback.tick().has_value(); })) << told();
    const double time = run().loop().snapshot().sample.time;
    const Vector3 base = run().basePosition();
    ASSERT_FALSE(framesUntil([] { return false; }, 100));
    EXPECT_EQ(run().loop().snapshot().sample.time, time) << "the live run rests";
    window.findChild<QToolButton*>("backToLive")->click();
    EXPECT_TRUE(run().loop().running());
    EXPECT_EQ(devices.feedback(), feedback);
    EXPECT_EQ(region(), TipRegion::Contact);
    EXPECT_LT((run().basePosition() - base).norm(), 1e-9);
    EXPECT_EQ(playback.shown(), nullptr);
}

TEST_F(PlaybackControlTest, ARecordingGoesOnAfterTheReplay) {
    recordings.start({folder.path() / "mine"});
    engage();
    replay().trigger();
    ASSERT_TRUE(framesUntil([this] { return playback.tick().has_value(); })) << told();
    EXPECT_TRUE(recordings.isWriting());
    window.findChild<QToolButton*>("backToLive")->click();
    const double back = run().loop().snapshot().sample.time;
    ASSERT_TRUE(framesUntil([&] { return run().loop().snapshot().sample.time > back + 0.1; }));
    recordings.finish();
    const std::vector<double> times =
        readCsv(folder.path() / "mine/force_log.csv").numbers("time_s");
    EXPECT_GT(times.back(), back + 0.09);
    EXPECT_TRUE(complaint().empty()) << "no tick is missing";
}

}  // namespace
}  // namespace asperity::test
