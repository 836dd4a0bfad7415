#include "app/window/device/PathControl.h"

#include "app/window/live/ControlBar.h"
#include "app/window/live/EngageBar.h"
#include "core/io/recording/PackedTables.h"
#include "tests/app/window/ControlFixture.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

#include <algorithm>
#include <cmath>

namespace asperity::test {
namespace {

class PathControlTest : public ControlFixture {
protected:
    PathControlTest() { stage.play(10); }

    std::string shown(const char* list) {
        return window.findChild<QComboBox*>(list)->currentText().toStdString();
    }

    /// Follows a path of a file to its end, at a force.
    void followAtAForce(const std::filesystem::path& file) {
        paths.chooseFile(QString::fromStdString(file.string()));
        QComboBox& hold = *window.findChild<QComboBox*>("pathHold");
        hold.setCurrentIndex(0);
        Q_EMIT hold.activated(0);
        button("startPath").click();
        ASSERT_TRUE(eventually([this] { return told() == "Path done"; })) << told();
    }
    QPushButton& button(const char* name) { return *window.findChild<QPushButton*>(name); }
    QDoubleSpinBox& box(const char* name) { return *window.findChild<QDoubleSpinBox*>(name); }
    bool isMoving() {
        return window.findChild<QLabel*>("pathProgress")->text().startsWith("Line 1");
    }

    DeviceControl& devices = stage.add<DeviceControl>();
    EngageControl& engaging = stage.add<EngageControl>();
    PathControl& paths = stage.add<PathControl>();
};

/// To choose a path drove the tip at once.
TEST_F(PathControlTest, AChosenPathIsShownAndStartsWhenTold) {
    useFlatScene();
    const Vector3 start = run().basePosition();
    Q_EMIT panels.controls().pathChosen(2);
    EXPECT_EQ(shown("path"), "Raster");
    EXPECT_EQ(window.shownTool(), &paths.page());
    Q_EMIT devices.pathWanted();
    EXPECT_EQ(shown("device"), "Mouse and keyboard");
    EXPECT_FALSE(eventually([&] { return run().basePosition() != start; }, 300));
    button("startPath").click();
    EXPECT_EQ(shown("device"), "Scripted path");
    button("stopPath").click();
    EXPECT_EQ(shown("device"), "Mouse and keyboard");
    EXPECT_EQ(told(), "Path stopped");
}

TEST_F(PathControlTest, AnApproachEndsAtTheSetpointOfTheWindow) {
    useFlatScene();
    box("setpoint").setValue(2.0);
    Q_EMIT panels.controls().pathChosen(0);
    EXPECT_EQ(shown("path"), "Approach");
    box("pathSpeed").setValue(30.0);
    button("startPath").click();
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
    EXPECT_TRUE(eventually([this] { return told() == "Path done"; })) << told();
    EXPECT_EQ(shown("device"), "Mouse and keyboard");
}

TEST_F(PathControlTest, ALineEngagesHoldsTheForceAndIsPlottedThereAndBack) {
    useFlatScene();
    Q_EMIT panels.controls().pathChosen(1);
    box("pathLength").setValue(20.0);
    box("pathSpeed").setValue(40.0);
    const Vector3 start = run().basePosition();
    button("startPath").click();
    ASSERT_TRUE(eventually([this] { return devices.feedback() != nullptr && isMoving(); }));
    double farthest = 0.0;
    double worst = 0.0;
    ASSERT_TRUE(eventually([&] {
        const TickOutput& out = run().loop().snapshot().sample.output;
        farthest = std::max(farthest, out.base.position.x() - start.x());
        worst = std::max(worst, std::abs(out.estimate.force.z() - 5e-9));
        return told() == "Path done";
    })) << told();
    EXPECT_NEAR(farthest, 20e-9, 1e-9);
    EXPECT_LT(worst, 1.5e-9);
    EXPECT_NE(devices.feedback(), nullptr) << "the force is held on";
    EXPECT_EQ(shown("device"), "Mouse and keyboard");
    const QStringList rows = paths.page().forces().table().tabSeparated().split('\n');
    EXPECT_GT(rows.size(), 300) << "half a second each way";
    const QStringList middle = rows.at(rows.size() / 2).split('\t');
    ASSERT_EQ(middle.size(), 4);
    EXPECT_LT(middle[1].toDouble(), 0.0) << "friction is against the motion";
    EXPECT_GT(middle[3].toDouble(), 0.0);
    EXPECT_NEAR(middle[0].toDouble() + middle[2].toDouble(), 20e-9, 0.5e-9);
}

TEST_F(PathControlTest, AtAConstantHeightTheTipStaysWhereItIs) {
    useFlatScene();
    Q_EMIT panels.controls().pathChosen(1);
    QComboBox& hold = *window.findChild<QComboBox*>("pathHold");
    hold.setCurrentIndex(1);
    Q_EMIT hold.activated(1);
    EXPECT_FALSE(box("pathLoad").isEnabled());
    box("pathLength").setValue(10.0);
    const Vector3 start = run().basePosition();
    button("startPath").click();
    ASSERT_TRUE(eventually([this] { return told() == "Path done"; })) << told();
    EXPECT_EQ(devices.feedback(), nullptr);
    EXPECT_NEAR(run().basePosition().z(), start.z(), 1e-15);
}

TEST_F(PathControlTest, ALineThatLeavesTheSampleSaysSo) {
    useFlatScene();
    Q_EMIT panels.controls().pathChosen(1);
    button("startPath").click();
    ASSERT_TRUE(eventually([this] { return isMoving(); }));
    devices.withdraw({.rate = 20e-9});
    EXPECT_TRUE(eventually([this] { return told().starts_with("Path ended"); })) << told();
}

TEST_F(PathControlTest, ASlideAtHighLoadProposesFiveSetpointsUntilALoadIsTyped) {
    useFlatScene();
    Q_EMIT panels.controls().pathChosen(3);
    EXPECT_EQ(shown("path"), "Slide at high load");
    EXPECT_DOUBLE_EQ(box("pathLoad").value(), 25.0);
    box("pathLoad").setValue(8.0);
    Q_EMIT panels.controls().pathChosen(1);
    EXPECT_DOUBLE_EQ(box("pathLoad").value(), 8.0);
}

TEST_F(PathControlTest, FollowsTheFileThatIsChosen) {
    useFlatScene();
    const auto file =
        folder.write("path.csv", "time_s,x_m,y_m,z_m\n0,40e-9,60e-9,9e-9\n0.2,50e-9,60e-9,9e-9\n");
    paths.chooseFile(QString::fromStdString(file.string()));
    EXPECT_EQ(shown("path"), "");
    EXPECT_EQ(shown("pathKind"), "path.csv");
    EXPECT_FALSE(box("pathLength").isEnabled());
    button("startPath").click();
    EXPECT_TRUE(eventually(
        [this] { return (run().basePosition() - Vector3(50e-9, 60e-9, 9e-9)).norm() < 1e-15; }));
}

/// At a force the file's heights count for nothing.
TEST_F(PathControlTest, FollowsTheFileAtAForceFromItsFirstPosition) {
    useFlatScene();
    const auto file =
        folder.write("path.csv", "time_s,x_m,y_m,z_m\n0,40e-9,60e-9,9e-9\n0.2,50e-9,70e-9,99e-9\n");
    ASSERT_NO_FATAL_FAILURE(followAtAForce(file));
    EXPECT_LT((run().basePosition().head<2>() - Vector2(50e-9, 70e-9)).norm(), 0.2e-9);
    EXPECT_NEAR(run().loop().snapshot().sample.output.estimate.force.z(), 5e-9, 1.5e-9);
}

TEST_F(PathControlTest, RefusesAPathInOtherUnitsAndKeepsTheDevice) {
    useFlatScene();
    const auto file = folder.write("path.csv", "time_s,x_m,y_m,z_m\n0,50,60,3\n1,51,60,3\n");
    paths.chooseFile(QString::fromStdString(file.string()));
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
    paths.chooseFile("no such file");
    EXPECT_EQ(complaint(), "");
}

/// It waited for an engagement, and a later one of the user began it.
TEST_F(PathControlTest, APathWhoseApproachIsWithdrawnEnds) {
    useFlatScene();
    Q_EMIT panels.controls().pathChosen(1);
    button("startPath").click();
    button("withdraw").click();
    EXPECT_TRUE(eventually([this] { return !button("stopPath").isEnabled(); }));
    button("engage").click();
    ASSERT_TRUE(eventually([this] { return told().starts_with("Engaged"); })) << told();
    EXPECT_FALSE(eventually([this] { return isMoving(); }, 500));
}

TEST_F(PathControlTest, EngageEndsAPathAndKeepsItsApproach) {
    useFlatScene();
    Q_EMIT panels.controls().pathChosen(1);
    button("startPath").click();
    ASSERT_TRUE(eventually([this] { return isMoving(); }));
    button("engage").click();
    EXPECT_TRUE(eventually([this] { return told().starts_with("Path ended"); })) << told();
    EXPECT_TRUE(eventually([this] { return told().starts_with("Engaged"); })) << told();
}

TEST_F(PathControlTest, AFileMayBeginAtAnyTime) {
    useFlatScene();
    const auto file =
        folder.write("path.csv", "time_s,x_m,y_m,z_m\n3,64e-9,64e-9,9e-9\n3.3,74e-9,64e-9,9e-9\n");
    ASSERT_NO_FATAL_FAILURE(followAtAForce(file));
    EXPECT_NEAR(run().basePosition().x(), 74e-9, 0.2e-9);
}

TEST_F(PathControlTest, WhatIsChosenIsOfItsScan) {
    useFlatScene();
    const auto file =
        folder.write("path.csv", "time_s,x_m,y_m,z_m\n0,40e-9,60e-9,9e-9\n1,50e-9,60e-9,9e-9\n");
    paths.chooseFile(QString::fromStdString(file.string()));
    EXPECT_EQ(window.findChild<QComboBox*>("pathHold")->currentText(), "Height");
    box("pathSpeed").setValue(60.0);
    edits.change("softer", withMaterial(run().scene().description, {}));
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(shown("pathKind"), "path.csv") << "the same scan";
    EXPECT_EQ(box("pathSpeed").value(), 60.0);
    SceneDescription other = plainScene();
    other.sample.file = "other.gsf";
    runs.use({.scene = buildScene(other, hillyMap()),
              .format = "made for the test",
              .sha256 = "",
              .notes = {}});
    EXPECT_EQ(shown("pathKind"), "Slide");
    EXPECT_EQ(window.findChild<QComboBox*>("pathHold")->currentText(), "Force");
    EXPECT_EQ(window.findChild<QComboBox*>("pathKind")->findText("path.csv"), -1);
}

TEST_F(PathControlTest, ARasterHasItsLinesWhereverItIsChosen) {
    useFlatScene();
    QComboBox& kinds = *window.findChild<QComboBox*>("pathKind");
    kinds.setCurrentIndex(2);
    Q_EMIT kinds.activated(2);
    EXPECT_EQ(window.findChild<QSpinBox*>("pathLines")->value(), 8);
    EXPECT_GT(paths.page().request().lines.pitch, 0.0);
}

TEST_F(PathControlTest, AnApproachThatDoesNotReachItsLoadSaysSo) {
    useFlatScene();
    Q_EMIT panels.controls().pathChosen(0);
    box("pathLoad").setValue(9e5);
    box("pathSpeed").setValue(200.0);
    button("startPath").click();
    EXPECT_TRUE(eventually([this] { return told().starts_with("Approach ended"); })) << told();
}

}  // namespace
}  // namespace asperity::test
