#include "app/window/Stage.h"
#include "app/window/lab/Features.h"
#include "app/window/recording/RecordingControl.h"
#include "app/window/scene/ScaleControl.h"
#include "app/window/scene/SceneControl.h"
#include "tests/app/ChildProgram.h"
#include "tests/app/ProgramRun.h"
#include "tests/app/window/WindowFixture.h"
#include "tests/core/io/heightmap/SyntheticScans.h"
#include "tests/support/Places.h"
#include "ui/shell/Menus.h"
#include "ui/widgets/NumberBox.h"

#include <QAction>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QtTest>

#include <gmock/gmock.h>

#include <sstream>
#include <string>
#include <vector>

namespace asperity::test {
namespace {

/// 32 x 16 numbers, nothing else.
std::string numbers() {
    std::ostringstream text;
    for (int row = 0; row < 16; ++row) {
        for (int column = 0; column < 32; ++column) {
            text << column % 5 << ' ';
        }
        text << '\n';
    }
    return text.str();
}

/// An image of 32 x 32 zeros; without unit where that is empty, without size where that is 0.
std::string image(int number, const char* title, const char* unit, double size) {
    const std::string key = "/" + std::to_string(number) + "/data";
    const std::string units =
        gwyUnit("si_unit_xy", size > 0.0 ? "m" : "") + gwyUnit("si_unit_z", unit);
    return gwyComponent(
               key, gwyObjectBytes("GwyDataField",
                                   gwyInteger("xres", 32) + gwyInteger("yres", 32) +
                                       gwyNumber("xreal", size) + gwyNumber("yreal", size) + units +
                                       gwyNumbers("data", std::vector<double>(32 * 32, 0.0)))) +
           gwyText(key + "/title", title);
}

class WindowThatAsks : public Window {
protected:
    ScaleDialog* dialog() {
        for (auto* each : window.findChildren<ScaleDialog*>()) {
            if (each->isVisible()) {
                return each;
            }
        }
        return nullptr;
    }
    LengthBox& box(const char* name) { return *dialog()->findChild<LengthBox*>(name); }
    void press(QDialogButtonBox::StandardButton which) {
        QTest::mouseClick(dialog()->findChild<QDialogButtonBox*>()->button(which), Qt::LeftButton);
    }
    void open(const std::filesystem::path& file) {
        stage.get<SceneControl>().open(file);
        ASSERT_TRUE(eventually([this] { return dialog() != nullptr; }));
    }
    /// Fills in what is asked for and goes on.
    void answer(double size, double height) {
        box("sizeX").setValue(size);
        box("heightPerValue").setValue(height);
        press(QDialogButtonBox::Ok);
    }
    [[nodiscard]] GivenScale shownScale() { return stage.run()->scene().description.sample.scale; }

    QSignalSpy shown{&stage.runs(), &RunControl::begun};
    QSignalSpy failed{&stage.get<SceneControl>(), &SceneControl::openFailed};
    QSignalSpy asked{&stage.get<SceneControl>(), &SceneControl::scaleAsked};
    QSignalSpy canceled{&stage.get<SceneControl>(), &SceneControl::openCanceled};
};

TEST_F(WindowThatAsks, OpensAScanOfUnknownScale) {
    open(folder.write("bare.txt", numbers()));
    EXPECT_TRUE(window.findChildren<QMessageBox*>().empty()) << "no complaint";
    EXPECT_EQ(failed.count(), 0);
    EXPECT_EQ(asked.count(), 1);
    answer(0.32, 0.5);
    ASSERT_TRUE(eventually([this] { return shown.count() == 1; }));
    EXPECT_EQ(dialog(), nullptr);
    EXPECT_TRUE(window.windowTitle().startsWith("bare.txt"));
    EXPECT_EQ(shownScale(), (GivenScale{0.32 * 1e-6, 0.16 * 1e-6, 0.5 * 1e-9}));
    EXPECT_DOUBLE_EQ(stage.run()->scene().surface.sizeX(), 320e-9);
    EXPECT_DOUBLE_EQ(stage.run()->scene().surface.sizeY(), 160e-9);
}

TEST_F(WindowThatAsks, CancelLeavesTheSceneAsItWas) {
    openFlatScene();
    const LiveRun* run = stage.run();
    const QString title = window.windowTitle();
    shown.clear();
    open(folder.write("bare.txt", numbers()));
    EXPECT_TRUE(stage.run()->loop().running()) << "meanwhile, too";
    press(QDialogButtonBox::Cancel);
    EXPECT_EQ(canceled.count(), 1);
    ASSERT_TRUE(runsFor(0.3));
    EXPECT_EQ(shown.count() + failed.count(), 0);
    EXPECT_EQ(stage.run(), run);
    EXPECT_EQ(window.windowTitle(), title);
    EXPECT_EQ(dialog(), nullptr);
}

TEST_F(WindowThatAsks, ShowsTheShippedSceneWhereTheFirstFileIsNotOpened) {
    showShippedInstead(stage);
    open(folder.write("bare.txt", numbers()));
    press(QDialogButtonBox::Cancel);
    ASSERT_TRUE(eventually([this] { return shown.count() == 1; }));
    EXPECT_THAT(stage.run()->scene().description.sample.file, testing::HasSubstr("granular_film"));
}

TEST_F(WindowThatAsks, ShowsTheShippedSceneWhereTheGivenScaleCannotBe) {
    showShippedInstead(stage);
    open(folder.write("bare.txt", numbers()));
    answer(0.32, 1e9);
    EXPECT_TRUE(eventually([this] { return failed.count() + shown.count() == 2; }));
}

/// A height that no instrument measures.
TEST_F(WindowThatAsks, SaysWhyAScanOfThisScaleCannotBeOpened) {
    open(folder.write("bare.txt", numbers()));
    box("sizeX").setValue(0.32);
    box("heightPerValue").setValue(1e9);
    dialog()->findChild<QComboBox*>("heightUnit")->setCurrentText("m");
    press(QDialogButtonBox::Ok);
    ASSERT_TRUE(eventually([this] { return failed.count() == 1; }));
    EXPECT_TRUE(failed[0][0].toString().contains("bare.txt"));
    EXPECT_EQ(window.findChildren<QMessageBox*>().size(), 1);
    open(folder.file("bare.txt"));
    EXPECT_EQ(asked.count(), 2) << "it may be tried again";
    press(QDialogButtonBox::Cancel);
}

TEST_F(WindowThatAsks, SuggestsWhatWasGivenForTheLastScanOfTheKind) {
    open(folder.write("one.txt", numbers()));
    answer(0.32, 0.5);
    ASSERT_TRUE(eventually([this] { return shown.count() == 1; }));
    open(folder.write("two.txt", numbers()));
    EXPECT_DOUBLE_EQ(box("sizeX").value(), 320.0) << "in nm";
    EXPECT_DOUBLE_EQ(box("sizeY").value(), 160.0);
    EXPECT_DOUBLE_EQ(box("heightPerValue").value(), 5.0) << "in Å";
    press(QDialogButtonBox::Ok);
    ASSERT_TRUE(eventually([this] { return shown.count() == 2; }));
    open(folder.write("other.txt", numbers() + numbers()));
    EXPECT_TRUE(box("sizeX").isBlank()) << "of other pixels";
    press(QDialogButtonBox::Cancel);
}

TEST_F(WindowThatAsks, AnotherFileTakesThePlaceOfTheQuestion) {
    open(folder.write("bare.txt", numbers()));
    stage.get<SceneControl>().open(test::dataFolder() / "samples" / "steps.gsf");
    EXPECT_EQ(dialog(), nullptr);
    ASSERT_TRUE(eventually([this] { return shown.count() == 1; }));
    EXPECT_TRUE(window.windowTitle().startsWith("steps.gsf"));
    EXPECT_EQ(canceled.count(), 0);
}

TEST_F(WindowThatAsks, AnotherChannelAndMaterialKeepTheScale) {
    open(
        folder.write("two.gwy", gwyFile(image(0, "First", "", 0.0) + image(1, "Second", "", 0.0))));
    answer(0.064, 1.0);
    ASSERT_TRUE(eventually([this] { return shown.count() == 1; }));
    const GivenScale scale = shownScale();
    const QList<QAction*> entries = window.findChild<QMenu*>("channels")->actions();
    ASSERT_EQ(entries.size(), 2);
    entries[1]->trigger();
    ASSERT_TRUE(eventually([this] { return shown.count() == 2; }));
    EXPECT_EQ(stage.run()->scene().description.sample.channel, "Second");
    EXPECT_EQ(shownScale(), scale);
    choose("material", "silicone rubber");
    ASSERT_TRUE(eventually([this] { return shown.count() == 3; }));
    EXPECT_EQ(shownScale(), scale);
}

/// The scale that was given is part of the recorded scene.
TEST_F(WindowThatAsks, ARecordingOnTheScanReplays) {
    open(folder.write("bare.txt", numbers()));
    answer(0.32, 0.5);
    ASSERT_TRUE(eventually([this] { return stage.run() != nullptr && far(); }));
    QSignalSpy finished(&stage.get<RecordingControl>(), &RecordingControl::finished);
    QTest::mouseClick(child<QPushButton>("record"), Qt::LeftButton);
    ASSERT_TRUE(runsFor(0.3));
    QTest::mouseClick(child<QPushButton>("record"), Qt::LeftButton);
    ASSERT_EQ(finished.count(), 1);
    const ProgramRun replay = runProgram("replay '" + finished[0][0].toString().toStdString() +
                                         "' --out '" + folder.file("again").string() + "'");
    EXPECT_EQ(replay.exitCode, 0) << replay.output;
    EXPECT_NE(replay.output.find("bit-identical"), std::string::npos) << replay.output;
}

/// Where there is a window it asks; without a display the program ends with 3.
TEST_F(WindowThatAsks, TheCommandLineOpensTheWindowWithTheQuestion) {
    const std::string scan = folder.write("bare.txt", numbers()).string();
    ChildProgram program({scan});
    live(4000);  // in which it would have ended
    EXPECT_FALSE(program.hasEnded());
    program.send(SIGTERM);
    EXPECT_NE(program.wait().exitCode, 3);
    EXPECT_EQ(runProgram("'" + scan + "'", "DISPLAY=").exitCode, 3);
}

TEST_F(WindowThatAsks, ASceneIsAskedForWhatItDoesNotSay) {
    (void)folder.write("bare.txt", numbers());
    open(folder.write("scene.toml", "[sample]\nfile = \"bare.txt\"\nz_scale_m = 1e-9\n"));
    EXPECT_FALSE(box("heightPerValue").isVisible());
    box("sizeX").setValue(0.32);
    press(QDialogButtonBox::Ok);
    ASSERT_TRUE(eventually([this] { return shown.count() == 1; }));
    EXPECT_EQ(shownScale(), (GivenScale{0.32e-6, 0.16e-6, 1e-9}));
}

}  // namespace
}  // namespace asperity::test
