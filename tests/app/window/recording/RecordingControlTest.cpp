#include "app/window/recording/RecordingControl.h"

#include "app/window/live/ControlBar.h"
#include "core/io/tables/CsvTable.h"
#include "tests/app/window/ControlFixture.h"
#include "ui/shell/Menus.h"

#include <QAction>

namespace asperity::test {
namespace {

class RecordingControlTest : public ControlFixture {
protected:
    void SetUp() override {
        recordings.setFolder(folder.path() / "recordings");
        useFlatScene();
    }
    /// A frame after so many more ticks.
    void advance(long ticks) {
        const auto made = [this] { return run().loop().snapshot().statistics.ticks; };
        const long end = made() + ticks;
        ASSERT_TRUE(eventually([&] { return made() >= end; }));
        runs.fetch();
        recordings.advance();
    }
    static std::filesystem::path folderOf(const QSignalSpy& spy, int which = 0) {
        return spy.at(which).at(0).toString().toStdString();
    }

    RecordingControl& recordings = stage.add<RecordingControl>();
    QSignalSpy finished{&recordings, &RecordingControl::finished};
    QSignalSpy saved{&recordings, &RecordingControl::lastSecondsSaved};
};

TEST_F(RecordingControlTest, RecordsFromOneWishToTheOther) {
    advance(50);
    const double before = run().loop().snapshot().sample.time;
    Q_EMIT panels.controls().recordingChosen(true);
    EXPECT_TRUE(window.menus().entry("record").isChecked());
    advance(100);
    Q_EMIT panels.controls().recordingChosen(false);
    EXPECT_FALSE(window.menus().entry("record").isChecked());
    ASSERT_EQ(finished.count(), 1);
    EXPECT_EQ(folderOf(finished).parent_path(), folder.path() / "recordings");
    const std::vector<double> times =
        readCsv(folderOf(finished) / "force_log.csv").numbers("time_s");
    ASSERT_GT(times.size(), 10U);
    EXPECT_GT(times.front(), before);
    EXPECT_GT(recordings.writingTime(), 0.0);
    EXPECT_TRUE(recordings.failure().isEmpty());
}

TEST_F(RecordingControlTest, TheEndOfTheRunEndsItsRecording) {
    recordings.start({folder.path() / "mine"});
    advance(50);
    useFlatScene();
    ASSERT_EQ(finished.count(), 1);
    EXPECT_EQ(folderOf(finished), folder.path() / "mine");
    EXPECT_NE(told().find("mine has ended"), std::string::npos) << told();
    useFlatScene();
    EXPECT_EQ(told().find("mine"), std::string::npos) << told();
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "mine/summary.json"));
}

TEST_F(RecordingControlTest, SaysWhyItCannotRecord) {
    recordings.start({folder.write("taken", "a file") / "mine"});
    EXPECT_FALSE(recordings.failure().isEmpty());
    EXPECT_EQ(complaint(), recordings.failure().toStdString());
    EXPECT_FALSE(window.menus().entry("record").isChecked());
    EXPECT_EQ(finished.count(), 0);
}

TEST_F(RecordingControlTest, SavesTheLastSecondsWheneverThePersonWants) {
    advance(100);
    window.menus().entry("saveLastSeconds").trigger();
    ASSERT_TRUE(eventually([this] {
        advance(10);
        return saved.count() == 1;
    }));
    EXPECT_GT(readCsv(folderOf(saved) / "force_log.csv").rows(), 10U);
    EXPECT_NE(told().find("ticks are saved in"), std::string::npos) << told();
}

}  // namespace
}  // namespace asperity::test
