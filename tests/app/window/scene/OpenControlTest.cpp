#include "app/window/scene/OpenControl.h"

#include "app/window/scene/CropFields.h"
#include "app/window/scene/LevelingEditor.h"
#include "app/window/scene/PreviewPane.h"
#include "tests/app/window/ControlFixture.h"
#include "tests/core/io/heightmap/RealScans.h"
#include "tests/support/Places.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/StepsScan.h"
#include "ui/shell/Menus.h"
#include "ui/widgets/NumberBox.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>
#include <QTreeWidget>

#include <algorithm>
#include <vector>

namespace asperity::test {
namespace {

class OpenControlTest : public ControlFixture {
protected:
    OpenDialog& dialog() { return *control.dialog(); }
    QPushButton& ok() {
        return *dialog().findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open);
    }
    QString message() { return dialog().findChild<QLabel*>("openMessage")->text(); }
    QString fact(const char* name) {
        auto* label = dialog().findChild<QLabel*>(QString::fromUtf8(name));
        return label == nullptr ? QString() : label->text();
    }
    template <class Widget>
    Widget& child(const char* name) {
        return *dialog().findChild<Widget*>(QString::fromUtf8(name));
    }
    void choose(const std::filesystem::path& file) {
        dialog().choose(QString::fromStdString(file.string()));
    }
    /// Chooses a file and waits for what is known of it.
    void look(const std::filesystem::path& file) {
        choose(file);
        ASSERT_TRUE(eventually([this] {
            return ok().isEnabled() || !message().isEmpty() || !fact("previewSize").isEmpty();
        })) << file;
    }
    std::unique_ptr<QSettings> settings() {
        return std::make_unique<QSettings>(QString::fromStdString(folder.file("a.ini").string()),
                                           QSettings::IniFormat);
    }
    QList<QAction*> recentEntries() { return window.findChild<QMenu*>("recent")->actions(); }

    SceneControl& scenes = stage.add<SceneControl>();
    OpenControl& control = stage.add<OpenControl>();
    QSignalSpy begun{&runs, &RunControl::begun};
};

TEST_F(OpenControlTest, TheMenuAsksAndTheWindowGoesOn) {
    window.menus().entry("open").trigger();
    ASSERT_NE(control.dialog(), nullptr);
    EXPECT_TRUE(dialog().isVisible());
    const OpenDialog* const first = control.dialog();
    control.ask();
    EXPECT_EQ(control.dialog(), first) << "one of them";
    dialog().reject();
    EXPECT_TRUE(eventually([this] { return control.dialog() == nullptr; }));
}

TEST_F(OpenControlTest, OpensWhatIsPreviewed) {
    control.ask();
    look(kSteps);
    EXPECT_EQ(fact("previewFormat"), "Gwyddion Simple Field .gsf");
    EXPECT_FALSE(fact("previewPitch").isEmpty());
    ASSERT_TRUE(ok().isEnabled());
    QTest::mouseClick(&ok(), Qt::LeftButton);
    ASSERT_TRUE(eventually([this] { return begun.count() == 1; }));
    EXPECT_TRUE(window.windowTitle().startsWith("steps.gsf"));
}

TEST_F(OpenControlTest, OpensWithTheChoicesOfTheDialog) {
    control.ask();
    look(kSteps);
    auto& editor = *dialog().findChild<LevelingEditor*>();
    for (QAction* step : editor.findChild<QToolButton*>("addLevelingStep")->menu()->actions()) {
        if (step->text() == "minimum to zero") {
            step->trigger();
        }
    }
    child<QSpinBox>("cropColumn").setValue(16);
    child<QSpinBox>("cropRows").setValue(40);
    const QString before = fact("previewRms");
    EXPECT_TRUE(eventually([&] { return fact("previewRms") != before; })) << "previewed so";
    const PixelRectangle part = *dialog().preview().choices().crop;
    QTest::mouseClick(&ok(), Qt::LeftButton);
    ASSERT_TRUE(eventually([this] { return begun.count() == 1; }));
    const SampleDescription& sample = run().scene().description.sample;
    EXPECT_EQ(sample.crop, part);
    EXPECT_EQ(textOf(sample.leveling), "plane, zero");
    EXPECT_EQ(run().scene().surface.grid().rows, 40);
    EXPECT_EQ(run().scene().surface.grid().columns, part.columns);
}

TEST_F(OpenControlTest, SaysWhyABadFileOrSceneCannotBeOpenedAndLives) {
    const auto bad = folder.write("broken.gsf", "no scan at all");
    const auto scene = folder.write("bad.toml", "[sample]\nfile = \"a.gsf\"\nradius = 3\n");
    control.ask();
    look(bad);
    EXPECT_TRUE(message().contains("broken.gsf")) << message().toStdString();
    EXPECT_FALSE(ok().isEnabled());
    look(scene);
    EXPECT_TRUE(message().contains("unknown key 'radius'")) << message().toStdString();
    look(kSteps);
    EXPECT_TRUE(ok().isEnabled());
    EXPECT_EQ(message(), "");
    EXPECT_EQ(complaint(), "") << "all of it in the dialog";
}

TEST_F(OpenControlTest, AsksForAMissingScaleAndSuggestsItNextTime) {
    const auto first = folder.write("one.txt", "0 1 2 3\n1 2 3 4\n2 3 4 5\n0 1 2 3\n");
    const auto second = folder.write("two.txt", "0 1 2 3\n1 2 3 4\n2 3 4 5\n0 1 2 4\n");
    control.ask();
    look(first);
    EXPECT_FALSE(ok().isEnabled());
    child<LengthBox>("sizeX").setValue(4.0);
    child<LengthBox>("heightPerValue").setValue(2.0);
    EXPECT_TRUE(eventually([this] { return fact("previewRange") == "0 m to 10 nm"; }))
        << fact("previewRange").toStdString();
    QTest::mouseClick(&ok(), Qt::LeftButton);
    ASSERT_TRUE(eventually([this] { return begun.count() == 1; }));
    EXPECT_EQ(run().scene().description.sample.scale, (GivenScale{4e-6, 4e-6, 2e-9}));
    ASSERT_TRUE(eventually([this] { return control.dialog() == nullptr; }));
    control.ask();
    look(second);
    EXPECT_TRUE(eventually([this] { return ok().isEnabled(); })) << "suggested";
    EXPECT_EQ(child<LengthBox>("sizeX").value(), 4.0);
}

TEST_F(OpenControlTest, AnotherFileTakesThePlaceOfASlowOne) {
    std::string slow;  // texts are read whole
    for (int row = 0; row < 1500; ++row) {
        for (int column = 0; column < 1500; ++column) {
            slow += std::to_string((row * column) % 97) + ' ';
        }
        slow += '\n';
    }
    const auto text = folder.write("slow.txt", slow);
    control.ask();
    choose(text);
    choose(kSteps);
    ASSERT_TRUE(eventually([this] { return ok().isEnabled(); }));
    EXPECT_EQ(fact("previewFormat"), "Gwyddion Simple Field .gsf");
    QTest::qWait(500);  // in which the slow one is given up
    EXPECT_EQ(fact("previewFormat"), "Gwyddion Simple Field .gsf") << "nothing comes of it";
}

TEST_F(OpenControlTest, RemembersFilesAndFolder) {
    control.remember(settings());
    EXPECT_FALSE(window.findChild<QMenu*>("recent")->menuAction()->isEnabled());
    control.ask();
    look(kSteps);
    QTest::mouseClick(&ok(), Qt::LeftButton);
    ASSERT_TRUE(eventually([this] { return begun.count() == 1; }));
    ASSERT_TRUE(eventually([this] { return control.dialog() == nullptr; }));
    EXPECT_TRUE(recentEntries().front()->text().endsWith("steps.gsf"));
    RecentFiles next;
    next.remember(settings());
    ASSERT_EQ(next.files().size(), 1U);
    EXPECT_TRUE(std::filesystem::equivalent(next.files().front(), kSteps));
    EXPECT_TRUE(std::filesystem::equivalent(next.folder().toStdString(), kSteps.parent_path()));
    control.ask();
    EXPECT_EQ(child<QListWidget>("recentFiles").count(), 1);
    EXPECT_TRUE(std::filesystem::equivalent(dialog().folder().toStdString(), kSteps.parent_path()));
}

TEST_F(OpenControlTest, TheMenuOpensAFileAgainAndTellsOneThatIsGone) {
    const auto gone = folder.file("gone.gsf");
    std::filesystem::copy_file(kSteps, gone);
    scenes.open(gone);
    ASSERT_TRUE(eventually([this] { return begun.count() == 1; }));
    scenes.open(kSteps);
    ASSERT_TRUE(eventually([this] { return begun.count() == 2; }));
    std::filesystem::remove(gone);
    Q_EMIT window.findChild<QMenu*>("recent")->aboutToShow();
    ASSERT_GE(recentEntries().size(), 3);
    EXPECT_TRUE(recentEntries()[0]->isEnabled());
    EXPECT_FALSE(recentEntries()[1]->isEnabled());
    EXPECT_TRUE(recentEntries()[1]->toolTip().contains("is not there any more"));
    recentEntries()[0]->trigger();
    EXPECT_TRUE(eventually([this] { return begun.count() == 3; }));
    recentEntries().back()->trigger();
    EXPECT_TRUE(eventually([this] { return control.recent().files().empty(); }));
    EXPECT_FALSE(window.findChild<QMenu*>("recent")->menuAction()->isEnabled());
}

/// The window is asked again every few milliseconds whether it lives.
TEST_F(OpenControlTest, LooksIntoEveryRealScanWithoutBlockingTheWindow) {
    ASPERITY_NEEDS_SHARED_DATA();
    QElapsedTimer since;
    qint64 longest = 0;
    QTimer pulse;
    QObject::connect(&pulse, &QTimer::timeout, [&] {
        longest = std::max(longest, since.isValid() ? since.restart() : 0);
        since.start();
    });
    control.ask();
    pulse.start(5);
    for (const std::string& file : allScans()) {
        since.invalidate();
        look(sharedData("afm/" + file));
        EXPECT_TRUE(message().isEmpty() || !ok().isEnabled()) << file;
    }
    EXPECT_LT(longest, 1000) << "ms; a stalled machine aside";
}

}  // namespace
}  // namespace asperity::test
