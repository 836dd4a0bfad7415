#include "app/window/device/PathControl.h"

#include "app/window/live/ControlBar.h"
#include "core/io/recording/PackedTables.h"
#include "tests/app/window/ControlFixture.h"

#include <QComboBox>

#include <algorithm>

namespace asperity::test {
namespace {

class PathControlTest : public ControlFixture {
protected:
    std::string shown(const char* list) {
        return window.findChild<QComboBox*>(list)->currentText().toStdString();
    }

    DeviceControl& devices = stage.add<DeviceControl>();
    PathControl& paths = stage.add<PathControl>();
};

TEST_F(PathControlTest, FollowsAPlannedPath) {
    useFlatScene();
    Q_EMIT panels.controls().pathChosen(2);
    EXPECT_EQ(shown("device"), "Scripted path");
    EXPECT_EQ(shown("path"), "Raster");
    Q_EMIT devices.pathWanted();
    EXPECT_EQ(shown("path"), "Approach");
}

TEST_F(PathControlTest, AnApproachEndsAtTheSetpointOfTheWindow) {
    useFlatScene();
    panels.engage().setSetpoint(2e-9);
    Q_EMIT panels.controls().pathChosen(0);
    EXPECT_EQ(shown("path"), "Approach");
    ASSERT_NE(devices.approaching(), nullptr);
    const Vector3 start = run().basePosition();
    double strongest = 0.0;
    EXPECT_TRUE(eventually([&] {
        const TickOutput& out = run().loop().snapshot().sample.output;
        strongest = std::max(strongest, out.estimate.force.z());
        return devices.approaching()->phase() == ApproachPhase::Retract;
    }));
    EXPECT_NEAR(strongest, 2e-9, 0.6e-9);
    EXPECT_LT((run().basePosition() - start).head<2>().norm(), 1e-15) << "straight down";
}

TEST_F(PathControlTest, FollowsTheFileThatIsChosen) {
    useFlatScene();
    const auto file =
        folder.write("path.csv", "time_s,x_m,y_m,z_m\n0,40e-9,60e-9,9e-9\n0.2,50e-9,60e-9,9e-9\n");
    paths.followFile(QString::fromStdString(file.string()));
    EXPECT_EQ(shown("path"), "");
    EXPECT_TRUE(eventually(
        [this] { return (run().basePosition() - Vector3(50e-9, 60e-9, 9e-9)).norm() < 1e-15; }));
}

TEST_F(PathControlTest, RefusesAPathInOtherUnitsAndKeepsTheDevice) {
    useFlatScene();
    const auto file = folder.write("path.csv", "time_s,x_m,y_m,z_m\n0,50,60,3\n1,51,60,3\n");
    paths.followFile(QString::fromStdString(file.string()));
    EXPECT_NE(complaint().find("meters"), std::string::npos);
    EXPECT_EQ(shown("device"), "Mouse and keyboard");
}

/// What `asperity explore` leaves of a run on a sphere, with a path of the base.
std::filesystem::path runOnASphere(ScratchFolder& folder, const std::string& rows) {
    (void)folder.write("scene.toml", "[sample]\nshape = \"sphere\"\nshape_radius_m = 50e-9\n");
    (void)folder.write("summary.json", R"({"input": {"sha256": ""}})");
    return folder.write("force_log.csv", "time_s,base_x_m,base_y_m,base_z_m\n" + rows);
}

/// Its path was followed without a word, or said to be in other units than meters.
TEST_F(PathControlTest, OfARecordingOnAnotherSampleBothAreNamed) {
    useFlatScene();
    const std::string both = "recorded on sphere of radius 50 nm; followed on ";
    const auto replay = [this](const std::filesystem::path& log) { paths.replayRecording(log); };
    replay(runOnASphere(folder, "0,40e-9,60e-9,9e-9\n0.2,50e-9,60e-9,9e-9\n"));
    EXPECT_NE(told().find("Another scan: " + both), std::string::npos) << told();
    EXPECT_EQ(shown("device"), "Scripted path");
    EXPECT_EQ(complaint(), "");
    replay(runOnASphere(folder, "0,40e-6,60e-6,9e-9\n0.2,50e-6,60e-6,9e-9\n"));
    const std::string far = complaint();
    EXPECT_NE(far.find("leaves the scan by more than its width: " + both), std::string::npos)
        << far;
    EXPECT_EQ(far.find("meters"), std::string::npos) << far;
}

/// The window ended: of a compact recording it is read after the log.
TEST_F(PathControlTest, ADamagedManifestIsSaidAndTheDeviceKept) {
    useFlatScene();
    const std::string rows = "0,40e-9,60e-9,9e-9\n0.2,50e-9,60e-9,9e-9\n";
    const std::filesystem::path log = runOnASphere(folder, rows);
    const std::filesystem::path packed = folder.file("recording.h5");
    packTables(
        {.input = folder.write("tick_input.csv", "time_s\n0\n0.2\n"), .log = log, .energy = {}},
        packed);
    for (const char* manifest : {"{", R"({"complete": 1e999})"}) {
        const std::filesystem::path file = folder.write("recording.json", manifest);
        for (const std::filesystem::path& chosen : {packed, log}) {
            paths.replayRecording(chosen);
            const std::string said = complaint();
            EXPECT_NE(said.find(file.string() + ": "), std::string::npos) << chosen << said;
            EXPECT_EQ(shown("device"), "Mouse and keyboard");
        }
    }
}

TEST_F(PathControlTest, WithoutARunNothingHappens) {
    Q_EMIT panels.controls().pathChosen(1);
    paths.followFile("no such file");
    EXPECT_EQ(complaint(), "");
}

}  // namespace
}  // namespace asperity::test
