#include "app/window/scene/SceneControl.h"

#include "tests/app/window/ControlFixture.h"
#include "tests/core/io/heightmap/SyntheticScans.h"
#include "tests/support/Places.h"
#include "tests/support/StepsScan.h"

#include <QAction>
#include <QMenu>

#include <vector>

namespace asperity::test {
namespace {

class SceneControlTest : public ControlFixture {
protected:
    SceneControl& scenes = stage.add<SceneControl>();
    QSignalSpy begun{&runs, &RunControl::begun};
    QSignalSpy failed{&scenes, &SceneControl::openFailed};
    QSignalSpy canceled{&scenes, &SceneControl::openCanceled};
};

/// An image of a Gwyddion file.
std::string levelImage(int number, const char* title) {
    const std::string key = "/" + std::to_string(number) + "/data";
    const std::string field =
        gwyObjectBytes("GwyDataField", gwyInteger("xres", 32) + gwyInteger("yres", 32) +
                                           gwyNumber("xreal", 64e-9) + gwyNumber("yreal", 64e-9) +
                                           gwyUnit("si_unit_xy", "m") + gwyUnit("si_unit_z", "m") +
                                           gwyNumbers("data", std::vector<double>(32 * 32, 0.0)));
    return gwyComponent(key, field) + gwyText(key + "/title", title);
}

TEST_F(SceneControlTest, OpensAFileAndShowsItsScene) {
    scenes.open(kSteps);
    EXPECT_EQ(runs.run(), nullptr) << "loads in the background";
    ASSERT_TRUE(eventually([this] { return begun.count() == 1; }));
    EXPECT_TRUE(window.windowTitle().startsWith("steps.gsf"));
    EXPECT_EQ(scenes.openError(), nullptr);
}

TEST_F(SceneControlTest, SaysWhyAFileCannotBeOpened) {
    scenes.open(folder.write("broken.gsf", "no scan at all"));
    ASSERT_TRUE(eventually([this] { return failed.count() == 1; }));
    EXPECT_NE(complaint().find("broken.gsf"), std::string::npos);
    EXPECT_THROW(std::rethrow_exception(scenes.openError()), std::exception);
    EXPECT_EQ(runs.run(), nullptr);
}

TEST_F(SceneControlTest, OpensTheChannelThatIsNamed) {
    scenes.open(kSteps, {.channel = "Phase"});
    ASSERT_TRUE(eventually([this] { return failed.count() == 1; }));
    EXPECT_NE(complaint().find("there is no channel 'Phase'"), std::string::npos);
    scenes.open(kSteps, {.channel = "Vicinal Au(111), steps of 0.235 nm"});
    EXPECT_TRUE(eventually([this] { return begun.count() == 1; }));
}

/// Another channel could not be opened at all.
TEST_F(SceneControlTest, OffersTheHeightChannelsOfTheScan) {
    const auto channelMenu = [this] { return window.findChild<QMenu*>("channels"); };
    scenes.open(kSteps);
    ASSERT_TRUE(eventually([this] { return begun.count() == 1; }));
    EXPECT_FALSE(channelMenu()->menuAction()->isEnabled());
    EXPECT_EQ(channelMenu()->menuAction()->toolTip(), "The file has no other height channel");
    scenes.open(
        folder.write("two.gwy", gwyFile(levelImage(0, "Height") + levelImage(1, "Z & sensor"))));
    ASSERT_TRUE(eventually([this] { return begun.count() == 2; }));
    ASSERT_TRUE(channelMenu()->menuAction()->isEnabled());
    const QList<QAction*> entries = channelMenu()->actions();
    ASSERT_EQ(entries.size(), 2);
    EXPECT_TRUE(entries[1]->isChecked()) << "the sensor's, by default";
    entries[0]->trigger();
    ASSERT_TRUE(eventually([this] { return begun.count() == 3; }));
    EXPECT_EQ(run().scene().description.sample.channel, "Height");
    EXPECT_TRUE(channelMenu()->actions().front()->isChecked());
}

TEST_F(SceneControlTest, NothingComesOfWhatIsCanceled) {
    scenes.cancelOpen();
    EXPECT_EQ(canceled.count(), 0) << "nothing is being loaded";
    scenes.open(kSteps);
    scenes.cancelOpen();
    EXPECT_EQ(canceled.count(), 1);
    EXPECT_EQ(told(), "Loading of steps.gsf canceled");
    QTest::qWait(500);  // longer than the file takes: nothing may come of it
    EXPECT_EQ(begun.count(), 0);
}

/// Another scan brought back polystyrene and the usual tip without a word.
TEST_F(SceneControlTest, AScanKeepsMaterialTipAndLeverAndSaysSo) {
    SceneDescription description = plainScene();
    description.sample.material.name = "mica";
    description.sample.material.elastic.youngsModulus = 54e9;
    description.tip.radius = 20e-9;
    description.setpoint = 2e-9;
    description.markers.push_back({.name = "edge"});
    runs.use({.scene = buildScene(description, flatMap()),
              .format = "made for the test",
              .sha256 = "",
              .notes = {}});
    scenes.open(kSteps);
    ASSERT_TRUE(eventually([this] { return begun.count() == 2; }));
    EXPECT_EQ(told().find("steps.gsf · as before: mica, tip of 20 nm, lever of 14"), 0U) << told();
    const SceneDescription& now = run().scene().description;
    EXPECT_EQ(now.sample.material.elastic.youngsModulus, 54e9);
    EXPECT_EQ(now.tip.radius, 20e-9);
    EXPECT_EQ(now.setpoint, 2e-9);
    EXPECT_TRUE(now.markers.empty()) << "they are of the scan before";
    scenes.open(dataFolder() / "scenes/silicone_rubber.toml");
    ASSERT_TRUE(eventually([this] { return begun.count() == 3; }));
    EXPECT_EQ(run().scene().description.sample.material.name, "silicone_rubber")
        << "a scene says what it is";
}

}  // namespace
}  // namespace asperity::test
