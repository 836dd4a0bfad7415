#include "app/loading/ComparedRun.h"
#include "app/recording/Bundle.h"
#include "app/recording/RunComparison.h"
#include "app/runs/RunFolder.h"
#include "app/window/export/ExportControl.h"
#include "app/window/export/ExportDialog.h"
#include "app/window/live/CyclePanel.h"
#include "app/window/live/ForcePanel.h"
#include "app/window/live/OverviewPanel.h"
#include "app/window/recording/PlaybackControl.h"
#include "app/window/recording/RecordingControl.h"
#include "app/window/scene/SceneControl.h"
#include "app/window/session/SessionControl.h"
#include "core/io/scene/SceneFile.h"
#include "core/io/tables/CsvTable.h"
#include "tests/app/ProgramRun.h"
#include "tests/app/window/WindowFixture.h"
#include "tests/core/io/heightmap/SyntheticScans.h"
#include "tests/support/ShippedScene.h"
#include "ui/shell/Menus.h"
#include "ui/view/ColorsMenu.h"
#include "ui/view/ZoomView.h"
#include "ui/widgets/PageParts.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSlider>
#include <QToolButton>
#include <QtTest>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace asperity::test {
namespace {

/// The window with two recorded runs, made once.
class Playback : public Window {
protected:
    static void SetUpTestSuite() {
        scratch = std::make_unique<ScratchFolder>();
        explore("polystyrene");
        explore("silicon");
        log = std::make_unique<CsvTable>(readCsv(of("polystyrene") / run_files::kLog));
    }
    static void TearDownTestSuite() {
        log.reset();
        scratch.reset();
    }
    static void explore(const std::string& scene) {
        const ProgramRun made = runProgram("explore --no-pictures " + shippedScene(scene).string() +
                                           " --duration 2 --out " + of(scene).string());
        ASSERT_EQ(made.exitCode, 0) << made.output;
    }
    static std::filesystem::path of(const std::string& scene) { return scratch->file(scene); }

    void look() {
        stage.get<PlaybackControl>().look(of("polystyrene") / run_files::kLog);
        ASSERT_TRUE(
            eventually([this] { return stage.get<PlaybackControl>().tick() == 0U; }, 60000));
    }
    /// A session is kept whose scene is another than that of the recording.
    void keepSilicon() {
        stage.get<SessionControl>().keepIn(folder.file("kept"));
        stage.get<SceneControl>().open(shippedScene("silicon"));
        ASSERT_TRUE(eventually(
            [this] { return std::filesystem::exists(folder.file("kept/session.toml")); }, 60000));
    }
    /// Opens another scene than that of the recordings, and waits until its model is known.
    void openSilicon() {
        stage.get<SceneControl>().open(shippedScene("silicon"));
        ASSERT_TRUE(eventually(
            [this] { return stage.run() != nullptr && !stage.run()->loaded().needs.pending; },
            60000));
    }
    /// To the setpoint and back.
    void touch() {
        QTest::mouseClick(child<QPushButton>("engage"), Qt::LeftButton);
        ASSERT_TRUE(eventually([this] { return inContact(); }, 20000)) << state();
        QTest::mouseClick(child<QPushButton>("withdraw"), Qt::LeftButton);
        ASSERT_TRUE(eventually([this] { return told() == "Withdrawn"; }, 20000)) << told();
    }
    [[nodiscard]] SceneDescription kept() { return readScene(folder.file("kept/session.toml")); }
    void lookAtBundle() {
        writeBundle(of("polystyrene"), {}, folder.file("run.zip"));
        stage.get<PlaybackControl>().look(folder.file("run.zip"));
        ASSERT_TRUE(
            eventually([this] { return stage.get<PlaybackControl>().tick() == 0U; }, 60000));
    }
    void click(const char* button) {
        QTest::mouseClick(child<QToolButton>(button), Qt::LeftButton);
    }
    bool shows(std::size_t tick) {
        return eventually([this, tick] { return stage.get<PlaybackControl>().tick() == tick; });
    }
    std::size_t tick() { return stage.get<PlaybackControl>().tick().value(); }
    /// What the log has of the tick that is shown.
    double logged(const char* column) { return log->number(tick(), column); }
    QString reading(const char* name) {
        return stage.get<PlaybackControl>().page().readings().text(name);
    }

    static std::unique_ptr<ScratchFolder> scratch;
    static std::unique_ptr<CsvTable> log;
};

std::unique_ptr<ScratchFolder> Playback::scratch;
std::unique_ptr<CsvTable> Playback::log;

TEST_F(Playback, AnyMomentIsShownAsTheLogHasIt) {
    look();
    EXPECT_FALSE(stage.run()->loop().running());
    auto* slider = child<QSlider>("recordingTime");
    EXPECT_EQ(slider->maximum() + 1, static_cast<int>(log->rows()));
    for (const int wanted : {1500, 3, 900, 901, 1900}) {
        slider->setValue(wanted);
        ASSERT_TRUE(shows(static_cast<std::size_t>(wanted)));
        const TickOutput& output = stage.runs().shown().sample.output;
        EXPECT_EQ(output.estimate.force.z(), logged("est_fz_n"));
        const double rounding = 0.006e-9 + 0.006 * std::abs(logged("est_fz_n"));
        EXPECT_TRUE(eventually([&] {  // the panels draw every second frame
            return std::abs(number("forceZ") - logged("est_fz_n")) <= rounding;
        })) << number("forceZ");
        const RunPlot& plot = stage.get<PlaybackControl>().page().forcePlot();
        ASSERT_TRUE(plot.moment());
        EXPECT_EQ(plot.moment()->x(), logged("time_s"));
        const QString time = QStringLiteral("%1 s").arg(logged("time_s"), 0, 'f', 3);
        EXPECT_EQ(reading("recordingMoment"), time);
        EXPECT_TRUE(state().starts_with("Recording, t = " + time.toStdString())) << state();
        EXPECT_TRUE(window.windowTitle().startsWith("Recording, t = " + time));
    }
}

TEST_F(Playback, ButtonsGoToTheEvents) {
    look();
    click("stepDeepest");
    ASSERT_TRUE(eventually([this] { return tick() > 0; }));
    double deepest = 0.0;
    std::size_t at = 0;
    for (std::size_t row = 0; row < log->rows(); ++row) {
        const double indentation = log->number(row, "indentation_m");
        at = indentation > deepest ? row : at;
        deepest = std::max(deepest, indentation);
    }
    EXPECT_EQ(tick(), at);
    EXPECT_TRUE(reading("recordingDistance").startsWith("indentation"));
    const QString force = reading("recordingForce");
    const QString deviation = force.section(QStringLiteral(" ± "), 1).trimmed();
    EXPECT_GE(deviation.section(' ', 0, 0).toDouble(), 0.1 * force.section(' ', 0, 0).toDouble())
        << "the lever is known to a tenth: " << force.toStdString();
    click("stepSnapIn");
    ASSERT_TRUE(eventually([this, at] { return tick() < at; }));
    EXPECT_GT(tick(), 0U);
    click("stepEnd");
    ASSERT_TRUE(shows(log->rows() - 1));
    click("stepStart");
    ASSERT_TRUE(shows(0));
}

TEST_F(Playback, PlaysToItsEnd) {
    look();
    child<QSlider>("recordingTime")->setValue(1800);
    ASSERT_TRUE(shows(1800));
    click("playRecording");
    ASSERT_TRUE(shows(log->rows() - 1));
    EXPECT_TRUE(eventually([this] { return !child<QToolButton>("playRecording")->isChecked(); }));
}

TEST_F(Playback, WhatIsExportedIsOfTheMomentThatIsShown) {
    look();
    click("stepDeepest");
    ASSERT_TRUE(eventually([this] { return tick() > 0; }));
    // The seconds before it are computed, too.
    ASSERT_TRUE(eventually([this] { return stage.runs().shownTicks().size() == tick() + 1; }));
    stage.get<ExportControl>().ask();
    ExportDialog* const dialog = stage.get<ExportControl>().dialog();
    ASSERT_NE(dialog, nullptr);
    const auto select = [dialog](const char* list, int index) {
        dialog->findChild<QComboBox*>(list)->setCurrentIndex(index);
    };
    select("exportSubject", static_cast<int>(ExportSubject::Forces));
    select("exportFormat", dialog->findChild<QComboBox*>("exportFormat")->findData("csv"));
    dialog->findChild<QLineEdit*>("exportFolder")
        ->setText(QString::fromStdString(folder.path().string()));
    dialog->findChild<QLineEdit*>("exportName")->setText("{file}_{view}");
    dialog->findChild<QPushButton*>("exportWrite")->click();
    ASSERT_TRUE(eventually([this] { return told().starts_with("Exported to"); })) << told();
    const CsvTable table = readCsv(folder.file("polystyrene_forces.csv"));
    EXPECT_EQ(table.rows(), tick() + 1) << "all before it, as the panels have them";
    EXPECT_EQ(table.number(table.rows() - 1, "time_s"), logged("time_s"));
}

TEST_F(Playback, TheLiveTipComesBack) {
    look();
    click("stepDeepest");
    ASSERT_TRUE(eventually([this] { return tick() > 0; }));
    click("backToLive");
    EXPECT_EQ(stage.get<PlaybackControl>().shown(), nullptr);
    EXPECT_TRUE(stage.run()->loop().running());
    EXPECT_TRUE(eventually([this] { return far(); })) << state();
    EXPECT_FALSE(window.windowTitle().startsWith("Recording"))
        << window.windowTitle().toStdString();
    EXPECT_FALSE(child<QToolButton>("compareRuns")->isEnabled());
    EXPECT_FALSE(stage.runs().showsRecording());
}

TEST_F(Playback, TheLiveTipCannotBeMovedMeanwhile) {
    look();
    const auto canMove = [this] {
        return child<QPushButton>("engage")->isEnabled() &&
               child<QPushButton>("withdraw")->isEnabled() && child<QWidget>("path")->isEnabled() &&
               window.menus().entry("followPathFile").isEnabled();
    };
    ASSERT_TRUE(eventually([this] { return !child<QPushButton>("engage")->isEnabled(); }));
    for (const char* const button : {"engage", "withdraw"}) {
        EXPECT_FALSE(child<QPushButton>(button)->isEnabled());
        EXPECT_TRUE(child<QPushButton>(button)->toolTip().contains("back to the live tip"));
    }
    EXPECT_FALSE(child<QWidget>("path")->isEnabled());
    EXPECT_FALSE(window.menus().entry("followPathFile").isEnabled());
    EXPECT_EQ(text("hint").find("move the tip"), std::string::npos) << text("hint");
    Q_EMIT panels.overview().positionChosen(50e-9, 50e-9);
    EXPECT_NE(told().find("back to the live tip"), std::string::npos) << told();
    click("backToLive");
    EXPECT_TRUE(eventually(canMove));
    EXPECT_NE(text("hint").find("move the tip"), std::string::npos) << text("hint");
}

TEST_F(Playback, TheSessionThatIsKeptIsTheOneBeforeTheLook) {
    keepSilicon();
    lookAtBundle();
    live(600);  // longer than until a session is kept
    EXPECT_EQ(kept().sample.material.name, readScene(shippedScene("silicon")).sample.material.name);
    stage.runs().end();  // as at the end of the program
    live(600);
    EXPECT_EQ(kept().sample.material.name, readScene(shippedScene("silicon")).sample.material.name);
}

TEST_F(Playback, BackAtTheLiveTipTheSessionIsKeptOn) {
    keepSilicon();
    lookAtBundle();
    click("backToLive");
    stage.runs().turn([](Settings& settings) { settings.correctionBandwidth = 3.0; });
    EXPECT_TRUE(eventually([this] { return kept().settings.correctionBandwidth == 3.0; }));
    EXPECT_EQ(kept().sample.material.name, readScene(shippedScene("silicon")).sample.material.name);
}

TEST_F(Playback, TheLiveSceneComesBackAsItWas) {
    openSilicon();
    touch();
    SurfaceLook colors = panels.colors().look();
    colors.of(SurfaceQuantity::Height).pinned = true;
    panels.colors().choose(colors);
    panels.view().setHalfWidth(123e-9);
    stage.runs().turn([](Settings& settings) { settings.correctionBandwidth = 3.0; });
    stage.runs().pause();
    stage.runs().fetch();
    const auto loaded = stage.run()->shared();
    const SceneDescription description = loaded->scene.description;
    const auto model = loaded->scene.model;
    const Vector3 base = stage.run()->basePosition();
    const long ticks = stage.run()->loop().snapshot().statistics.ticks;
    const auto cycles = [this] { return panels.forces().cycles().plot().cycles().size(); };
    panels.forces().cycles().refresh();
    const std::size_t drawn = cycles();
    ASSERT_GT(drawn, 0U);
    const QString title = window.windowTitle();
    const QString undo = stage.edits().undoName();

    look();
    EXPECT_EQ(stage.runs().scene().description.sample.material.name, "polystyrene");
    EXPECT_EQ(stage.run()->shared(), loaded) << "the live run stays";
    click("stepDeepest");
    ASSERT_TRUE(eventually([this] { return tick() > 0; }));
    click("backToLive");

    EXPECT_EQ(stage.runs().shared(), loaded);
    EXPECT_EQ(loaded->scene.description, description);
    EXPECT_EQ(loaded->scene.model, model);
    EXPECT_FALSE(loaded->needs.pending);
    EXPECT_EQ(stage.run()->settings().correctionBandwidth, 3.0);
    EXPECT_EQ(stage.run()->basePosition(), base);
    EXPECT_EQ(stage.run()->loop().snapshot().statistics.ticks, ticks) << "paused, as before";
    EXPECT_EQ(panels.view().halfWidth(), 123e-9);
    EXPECT_EQ(panels.colors().look(), colors);
    EXPECT_EQ(cycles(), drawn);
    EXPECT_EQ(window.windowTitle(), title);
    EXPECT_EQ(stage.edits().undoName(), undo) << "to look is no change of the scene";
}

TEST_F(Playback, AnotherSceneThatIsOpenedEndsTheLook) {
    openSilicon();
    look();
    stage.get<SceneControl>().open(shippedScene("polystyrene"));
    ASSERT_TRUE(eventually([this] { return !stage.runs().showsRecording(); }, 60000));
    EXPECT_EQ(stage.run()->scene().description.sample.material.name, "polystyrene");
    EXPECT_TRUE(stage.run()->loop().running());
    stage.edits().undo();
    EXPECT_TRUE(eventually(
        [this] { return stage.run()->scene().description.sample.material.name == "silicon"; },
        60000))
        << "the live scene before";
}

/// The loop rests meanwhile, and time is that of the ticks.
TEST_F(Playback, ARecordingThatGoesOnLosesNothingByALook) {
    openSilicon();
    stage.get<RecordingControl>().start({folder.file("mine")});
    ASSERT_TRUE(runsFor(0.3));
    look();
    live(300);
    click("backToLive");
    ASSERT_TRUE(runsFor(0.3));
    stage.get<RecordingControl>().finish();
    const std::vector<double> times =
        readCsv(folder.file("mine") / run_files::kLog).numbers("time_s");
    ASSERT_GT(times.back() - times.front(), 0.55);
    const ProgramRun replayed = runProgram("replay " + folder.file("mine").string() + " --out " +
                                           folder.file("again").string());
    EXPECT_EQ(replayed.exitCode, 0) << replayed.output;
}

TEST_F(Playback, TimesCountFromTheStartOfTheRecording) {
    openSilicon();
    ASSERT_TRUE(runsFor(1.0));
    stage.get<RecordingControl>().start({folder.file("mine")});
    ASSERT_TRUE(runsFor(0.3));
    stage.get<RecordingControl>().finish();
    stage.get<PlaybackControl>().look(folder.file("mine"));
    ASSERT_TRUE(eventually([this] { return stage.get<PlaybackControl>().tick() == 0U; }, 60000));
    EXPECT_EQ(reading("recordingMoment"), QStringLiteral("0.000 s"));
    EXPECT_TRUE(eventually([this] { return state().starts_with("Recording, t = 0.000 s"); }))
        << state();
    EXPECT_EQ(stage.get<PlaybackControl>().page().forcePlot().moment()->x(), 0.0);
    EXPECT_EQ(stage.runs().shownTicks().front().time, 0.0);
}

TEST_F(Playback, AFilmIsOfTheRecordingThatIsOpen) {
    look();
    stage.get<ExportControl>().ask();
    ExportDialog* const dialog = stage.get<ExportControl>().dialog();
    ASSERT_NE(dialog, nullptr);
    EXPECT_EQ(dialog->findChild<QLineEdit*>("exportRecording")->text().toStdString(),
              of("polystyrene").string());
    EXPECT_EQ(dialog->choices().film.from, QStringLiteral("start"));
    dialog->reject();
}

TEST_F(Playback, ABundleIsOfTheRecordingThatIsOpen) {
    const std::filesystem::path run = folder.file("mine");
    std::filesystem::copy(of("polystyrene"), run);
    openSilicon();
    stage.get<PlaybackControl>().look(run);
    window.menus().entry("bundle").trigger();
    EXPECT_TRUE(told().starts_with("A recording is being opened")) << told();
    ASSERT_TRUE(eventually([this] { return stage.get<PlaybackControl>().tick() == 0U; }, 60000));
    QSignalSpy bundled(&stage.get<BundleControl>(), &BundleControl::bundled);
    window.menus().entry("bundle").trigger();
    ASSERT_TRUE(eventually([&] { return bundled.count() == 1; }, 60000)) << told();
    EXPECT_TRUE(isBundle(folder.file("mine.zip")));
    EXPECT_TRUE(told().starts_with("Recording mine: bundled in ")) << told();
    EXPECT_NE(stage.get<PlaybackControl>().shown(), nullptr);
    lookAtBundle();
    ASSERT_TRUE(
        eventually([this] { return stage.runs().openRecording().extension() == ".zip"; }, 60000));
    window.menus().entry("bundle").trigger();
    EXPECT_TRUE(told().ends_with("run.zip is a bundle already")) << told();
}

TEST_F(Playback, ABundleOfAReplayHoldsTheLastSeconds) {
    openSilicon();
    touch();
    window.menus().entry("replayLastJump").trigger();
    ASSERT_TRUE(eventually([this] { return stage.get<PlaybackControl>().tick().has_value(); }))
        << told();
    QSignalSpy bundled(&stage.get<BundleControl>(), &BundleControl::bundled);
    window.menus().entry("bundle").trigger();
    ASSERT_TRUE(eventually([&] { return bundled.count() == 1; }, 60000)) << told();
    EXPECT_TRUE(told().starts_with("The last 10 s: bundled in ")) << told();
    EXPECT_TRUE(stage.runs().showsRecording());
}

TEST_F(Playback, StartingTheRunLeavesTheRecording) {
    look();
    QTest::mouseClick(child<QPushButton>("startPause"), Qt::LeftButton);
    EXPECT_EQ(stage.get<PlaybackControl>().shown(), nullptr);
    EXPECT_TRUE(stage.run()->loop().running());
}

TEST_F(Playback, ADamagedRunGivesOneSentenceAndLeavesTheScene) {
    openFlatScene();
    const std::filesystem::path damaged = folder.file("damaged");
    std::filesystem::copy(of("polystyrene"), damaged);
    std::filesystem::resize_file(damaged / run_files::kInput, 3000);
    stage.get<PlaybackControl>().look(damaged);
    ASSERT_TRUE(eventually([this] { return window.findChild<QMessageBox*>() != nullptr; }, 60000));
    const QString text = window.findChild<QMessageBox*>()->text();
    EXPECT_TRUE(text.contains("tick_input.csv")) << text.toStdString();
    EXPECT_FALSE(text.contains('\n'));
    EXPECT_EQ(stage.get<PlaybackControl>().shown(), nullptr);
    EXPECT_TRUE(stage.run()->loop().running());
    EXPECT_TRUE(far());
}

/// No tick is the same then, and none is to blame.
TEST_F(Playback, AScanOfAnotherSizeThanRecordedIsNamed) {
    openFlatScene();
    const std::filesystem::path other = folder.file("other");
    std::filesystem::copy(of("polystyrene"), other);
    const auto summary = other / run_files::kSummary;
    auto json = nlohmann::json::parse(contentOf(summary));
    json["input"]["size_y_m"] = 2.0 * json["input"]["size_y_m"].get<double>();
    std::ofstream(summary) << json;
    stage.get<PlaybackControl>().look(other);
    ASSERT_TRUE(eventually([this] { return window.findChild<QMessageBox*>() != nullptr; }, 60000));
    const QString text = window.findChild<QMessageBox*>()->text();
    EXPECT_TRUE(text.contains("when the run was recorded, and is now read as "))
        << text.toStdString();
    EXPECT_FALSE(text.contains("tick")) << text.toStdString();
    EXPECT_EQ(stage.get<PlaybackControl>().shown(), nullptr);
}

/// A recording of an earlier version that was cut off does not say with which size its scan was
/// read.
TEST_F(Playback, ACutOffRunOnAScanWhoseSizeWasCorrectedSaysSo) {
    const std::vector<std::int32_t> counts(std::size_t{24} * 16, 5);
    const auto scan =
        folder.write("scan.spm", nanoscopeFile({.samples = "24",
                                                .lines = "16",
                                                .dataLength = "768",
                                                .scanGrid = "\\Aspect Ratio: 3:2\r\n"},
                                               counts));
    const std::filesystem::path run = folder.file("run");
    const ProgramRun made = runProgram("explore --no-pictures " + scan.string() +
                                       " --duration 0.1 --out " + run.string());
    ASSERT_EQ(made.exitCode, 0) << made.output;
    const auto summary = nlohmann::json::parse(contentOf(run / run_files::kSummary));
    std::filesystem::remove(run / run_files::kSummary);
    nlohmann::json manifest{{"format", "asperity recording"},
                            {"format_version", 1},
                            {"input", {{"sha256", summary["input"]["sha256"]}}},
                            {"complete", false},
                            {"recovered", false}};
    std::ofstream(run / run_files::kManifest) << manifest;
    stage.get<PlaybackControl>().look(run);
    ASSERT_TRUE(eventually([this] { return stage.get<PlaybackControl>().tick() == 0U; }, 60000));
    const std::string note = stage.get<PlaybackControl>().shown()->note;
    EXPECT_NE(note.find("the recording was cut off"), std::string::npos) << note;
    EXPECT_NE(note.find("has been corrected; the scan is now read as 30 nm x 13.3 nm"),
              std::string::npos)
        << note;
    EXPECT_TRUE(told().find("has been corrected") != std::string::npos) << told();
    // One that says it is judged by that.
    manifest["input"]["size_x_m"] = summary["input"]["size_x_m"];
    manifest["input"]["size_y_m"] = summary["input"]["size_x_m"];
    std::ofstream(run / run_files::kManifest) << manifest;
    stage.get<PlaybackControl>().look(run);
    ASSERT_TRUE(eventually([this] { return window.findChild<QMessageBox*>() != nullptr; }, 60000));
    EXPECT_TRUE(window.findChild<QMessageBox*>()->text().contains(
        "it was read as 30 nm x 30 nm when the run was recorded, and is now read as 30 nm x "
        "13.3 nm, after a correction of the reader"))
        << window.findChild<QMessageBox*>()->text().toStdString();
}

/// Not by the folder that it was unpacked into.
TEST_F(Playback, ADamagedBundleIsNamedAsItWasOpened) {
    lookAtBundle();
    const std::filesystem::path scan =
        stage.get<PlaybackControl>().shown()->loaded->scene.description.sample.file;
    const std::filesystem::path kept = scan.parent_path().parent_path();
    click("backToLive");
    std::filesystem::resize_file(kept / run_files::kInput, 3000);
    stage.get<PlaybackControl>().look(folder.file("run.zip"));
    ASSERT_TRUE(eventually([this] { return window.findChild<QMessageBox*>() != nullptr; }, 60000));
    QString text = window.findChild<QMessageBox*>()->text();
    EXPECT_TRUE(text.contains("run.zip, tick_input.csv: ")) << text.toStdString();
    EXPECT_FALSE(text.contains("/bundles/")) << text.toStdString();
    delete window.findChild<QMessageBox*>();
    std::ofstream(kept / run_files::kScene) << "[sample\n";
    stage.get<SceneControl>().open(folder.file("run.zip"));
    ASSERT_TRUE(eventually([this] { return window.findChild<QMessageBox*>() != nullptr; }, 60000));
    text = window.findChild<QMessageBox*>()->text();
    EXPECT_TRUE(text.contains("run.zip, scene.toml: ")) << text.toStdString();
    EXPECT_FALSE(text.contains("/bundles/")) << text.toStdString();
}

TEST_F(Playback, ASecondRunIsOverlaidWithTheDifference) {
    look();
    stage.get<ComparisonControl>().compareWith(of("silicon") / run_files::kSummary);
    PlaybackPage& page = stage.get<PlaybackControl>().page();
    ASSERT_TRUE(eventually([&page] { return page.differencePlot().isVisible(); }, 60000));
    const RunComparison expected =
        compareRuns(readComparedRun(of("polystyrene")).trace, readComparedRun(of("silicon")).trace);
    EXPECT_EQ(page.comparison().text("differenceRms"),
              QString::fromStdString(formatSi(expected.rms, "N")));
    EXPECT_TRUE(page.comparison()
                    .text("differenceLargest")
                    .endsWith(QStringLiteral("at %1 s").arg(expected.largest.time, 0, 'f', 3)));
    EXPECT_TRUE(child<QLabel>("runsDiffer")->toolTip().contains("Young's modulus"))
        << text("runsDiffer");
    const QString table = page.forcePlot().table().tabSeparated();
    EXPECT_TRUE(table.startsWith("time [s]\tpolystyrene [N]\ttime [s]\tsilicon [N]"))
        << table.left(80).toStdString();
    click("stopComparing");
    EXPECT_FALSE(page.differencePlot().isVisible());
}

}  // namespace
}  // namespace asperity::test
