#include "app/window/scene/OpenDialog.h"

#include "app/window/scene/CropFields.h"
#include "app/window/scene/LevelingEditor.h"
#include "app/window/scene/PreviewPane.h"
#include "app/window/scene/ScaleControl.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/Waits.h"
#include "ui/shell/Dialogs.h"
#include "ui/widgets/NumberBox.h"
#include "ui/widgets/Theme.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QSpinBox>
#include <QToolButton>
#include <QTreeView>
#include <QTreeWidget>
#include <QtTest>

#include <gtest/gtest.h>

namespace asperity::test {
namespace {

QImage gray() {
    QImage image(64, 48, QImage::Format_RGB32);
    image.fill(Qt::gray);
    return image;
}

OpenPreview twoChannels() {
    return {.format = "Gwyddion .gwy",
            .channels = {{"Height", "m", "forward", {64, 48}, true},
                         {"Phase", "deg", "forward", {64, 48}, false}},
            .channel = "Height",
            .pixels = {64, 48},
            .size = {6.4e-6, 4.8e-6},
            .gap = std::nullopt,
            .isMap = true,
            .leveling = {LevelingStep::Plane},
            .levelPoints = std::nullopt,
            .crop = std::nullopt,
            .before = gray(),
            .after = gray(),
            .facts = {{"previewSize", "Size", "6.4 µm × 4.8 µm", "Width and height"}},
            .notes = {"orientation: flipped"},
            .refusal = {}};
}

class OpenDialogTest : public ::testing::Test {
protected:
    OpenDialogTest() {
        dialog.setFolder(QString::fromStdString(folder.path().string()));
        dialog.show();
    }
    QPushButton& ok() {
        return *dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open);
    }
    QString message() { return dialog.findChild<QLabel*>("openMessage")->text(); }
    template <class Widget>
    Widget& child(const char* name) {
        return *dialog.findChild<Widget*>(QString::fromUtf8(name));
    }
    void choose(const std::filesystem::path& path) {
        dialog.choose(QString::fromStdString(path.string()));
    }

    ScratchFolder folder;
    std::filesystem::path file = folder.write("a.gwy", "one");
    std::filesystem::path other = folder.write("b.gwy", "two");
    OpenDialog dialog{{"Scans (*.gwy)", "All files (*)"}, nullptr};
    QSignalSpy selected{&dialog, &OpenDialog::selected};
    QSignalSpy changed{&dialog, &OpenDialog::choicesChanged};
    QSignalSpy opened{&dialog, &OpenDialog::opened};
};

TEST_F(OpenDialogTest, BeginsWithoutAFileAndFitsTheScreen) {
    EXPECT_FALSE(ok().isEnabled());
    EXPECT_TRUE(dialog.screen()->availableGeometry().contains(dialog.geometry()));
    QTest::keyClick(&dialog, Qt::Key_Return);
    EXPECT_TRUE(opened.isEmpty());
    EXPECT_TRUE(dialog.isVisible());
}

/// What a screen of 1024 x 700 leaves a dialog.
TEST_F(OpenDialogTest, FitsASmallScreenWhateverTheFileAsksFor) {
    const auto expectFits = [this](const char* what) {
        handleEvents();
        EXPECT_LE(dialog.minimumSizeHint().width(), 1000) << what;
        EXPECT_LE(dialog.minimumSizeHint().height(), 680) << what;
    };
    expectFits("no file");
    choose(file);
    OpenPreview preview = twoChannels();
    dialog.showPreview(preview);
    expectFits("a scan");
    preview.gap = ScaleGap{.size = true, .height = true};
    preview.leveling = {LevelingStep::ThreePoint};
    preview.levelPoints = {Vector2(1e-6, 1e-6), Vector2(5e-6, 1e-6), Vector2(1e-6, 4e-6)};
    dialog.showPreview(preview);
    ASSERT_TRUE(child<NumberBox>("levelPlace0x").isVisible());
    ASSERT_TRUE(child<ScaleForm>("previewScale").isVisible());
    expectFits("no scale, and a plane through three points");
}

/// Letters of values, names of files and folders, and buttons.
TEST_F(OpenDialogTest, CutsNothingOnASmallScreen) {
    choose(file);
    OpenPreview preview = twoChannels();
    preview.facts = {{"previewRange", "Heights", "-11.5 nm to 16.2 nm", "Lowest and highest"},
                     {"previewRms", "Rms", "4.37 nm before leveling, 4.21 nm after", "About"}};
    dialog.showPreview(preview);
    dialog.resize(1000, 658);
    handleEvents();
    ASSERT_EQ(dialog.size(), QSize(1000, 658));
    for (const char* fact : {"previewRange", "previewRms"}) {
        const auto& value = child<QLabel>(fact);
        EXPECT_TRUE(eventually([&] {
            return value.height() >= value.heightForWidth(value.width());
        })) << fact;
        EXPECT_GE(value.width(), theme::scaled(120)) << fact;
    }
    const auto& list = child<QTreeView>("treeView");
    EXPECT_TRUE(list.isColumnHidden(3)) << "no dates";
    EXPECT_GE(list.columnWidth(0), theme::scaled(150));
    dialog.resize(dialog.sizeHint());
    EXPECT_TRUE(eventually([&] { return !list.isColumnHidden(3); })) << "there is room for dates";
}

TEST_F(OpenDialogTest, WantsWhatALargeScreenHas) {
    EXPECT_EQ(dialog.sizeHint(), QSize(theme::scaled(1220), theme::scaled(760)));
}

TEST_F(OpenDialogTest, AsksForAPreviewOfEachFileThatIsChosen) {
    choose(file);
    ASSERT_EQ(selected.count(), 1);
    EXPECT_EQ(selected[0][0].toString().toStdString(), file.string());
    EXPECT_FALSE(ok().isEnabled()) << "nothing is known of it yet";
    choose(other);
    EXPECT_EQ(selected.count(), 2);
    EXPECT_EQ(child<QLabel>("openName").text(), "b.gwy");
}

TEST_F(OpenDialogTest, ShowsWhatTheFileHoldsAndOpensIt) {
    choose(file);
    dialog.showPreview(twoChannels());
    auto& channels = child<QTreeWidget>("previewChannels");
    ASSERT_EQ(channels.topLevelItemCount(), 2);
    EXPECT_EQ(channels.currentItem()->text(0), "Height");
    EXPECT_EQ(channels.currentItem()->text(3), "64 × 48");
    EXPECT_EQ(child<QLabel>("previewSize").text(), "6.4 µm × 4.8 µm");
    EXPECT_FALSE(child<QLabel>("previewSize").toolTip().isEmpty());
    EXPECT_TRUE(child<QPlainTextEdit>("previewNotes").toPlainText().contains("flipped"));
    EXPECT_FALSE(child<ScaleForm>("previewScale").isVisible());
    ASSERT_TRUE(ok().isEnabled());
    QTest::mouseClick(&ok(), Qt::LeftButton);
    ASSERT_EQ(opened.count(), 1);
    EXPECT_EQ(opened[0][0].toString().toStdString(), file.string());
    EXPECT_FALSE(dialog.isVisible());
    EXPECT_TRUE(changed.isEmpty()) << "the user has chosen nothing";
}

TEST_F(OpenDialogTest, WhatIsChosenIsSaid) {
    choose(file);
    dialog.showPreview(twoChannels());
    const OpenChoices& choices = dialog.preview().choices();
    EXPECT_TRUE(choices.channel.isEmpty());
    EXPECT_FALSE(choices.leveling);
    EXPECT_FALSE(choices.crop);
    auto& channels = child<QTreeWidget>("previewChannels");
    channels.setCurrentItem(channels.topLevelItem(1));
    EXPECT_EQ(choices.channel, "Phase");
    EXPECT_EQ(changed.count(), 1);
    auto* leveling = dialog.findChild<LevelingEditor*>();
    leveling->findChild<QListWidget*>("levelingSteps")->setCurrentRow(0);
    QTest::mouseClick(leveling->findChild<QToolButton*>("removeLevelingStep"), Qt::LeftButton);
    EXPECT_EQ(choices.leveling, LevelingSteps());
    EXPECT_EQ(changed.count(), 2);
    child<QSpinBox>("cropColumns").setValue(10);
    EXPECT_EQ(choices.crop, (PixelRectangle{0, 0, 10, 48}));
    EXPECT_EQ(child<CropPicture>("previewBefore").crop(), choices.crop);
    EXPECT_EQ(changed.count(), 3);
    QTest::mouseClick(&child<QPushButton>("cropWhole"), Qt::LeftButton);
    EXPECT_EQ(choices.crop, (PixelRectangle{0, 0, 64, 48})) << "all of it, whatever a scene says";
    choose(other);
    EXPECT_FALSE(choices.crop) << "of another file nothing is chosen";
    EXPECT_TRUE(choices.channel.isEmpty());
}

TEST_F(OpenDialogTest, TheMouseDrawsThePartToLoad) {
    choose(file);
    dialog.showPreview(twoChannels());
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
    auto& picture = child<CropPicture>("previewBefore");
    const QRect drawn = picture.pictureRect();
    QTest::mousePress(&picture, Qt::LeftButton, Qt::NoModifier, drawn.topLeft());
    QTest::mouseRelease(&picture, Qt::LeftButton, Qt::NoModifier, drawn.center());
    ASSERT_TRUE(dialog.preview().choices().crop);
    EXPECT_EQ(dialog.preview().choices().crop->column, 0);
    EXPECT_NEAR(dialog.preview().choices().crop->columns, 32, 1);
    EXPECT_NEAR(child<QSpinBox>("cropRows").value(), 24, 1);
}

TEST_F(OpenDialogTest, SaysWhyAChannelCannotBeOpened) {
    choose(file);
    OpenPreview phase = twoChannels();
    phase.channel = "Phase";
    phase.refusal = "it has the unit deg; a height map is a length";
    dialog.showPreview(phase);
    EXPECT_EQ(message(), phase.refusal);
    EXPECT_FALSE(ok().isEnabled());
    dialog.showPreview(twoChannels());
    EXPECT_EQ(message(), "");
    EXPECT_TRUE(ok().isEnabled());
}

TEST_F(OpenDialogTest, ABadFileIsSaidAndAnotherOneCanBeChosen) {
    choose(file);
    dialog.showFailure("a.gwy: byte 0: <b>no</b> height map");
    EXPECT_EQ(message(), "a.gwy: byte 0: <b>no</b> height map");
    EXPECT_EQ(child<QLabel>("openMessage").textFormat(), Qt::PlainText);
    EXPECT_FALSE(ok().isEnabled());
    EXPECT_TRUE(dialog.isVisible());
    choose(other);
    EXPECT_EQ(message(), "");
    dialog.showPreview(twoChannels());
    EXPECT_TRUE(ok().isEnabled());
}

/// A pixel of one channel may be damaged: the others can still be chosen.
TEST_F(OpenDialogTest, ABadChannelLeavesTheOthersToChoose) {
    choose(file);
    dialog.showPreview(twoChannels());
    dialog.showFailure("a pixel is damaged");
    EXPECT_FALSE(ok().isEnabled());
    EXPECT_EQ(child<QTreeWidget>("previewChannels").topLevelItemCount(), 2);
}

TEST_F(OpenDialogTest, AsksForAMissingScale) {
    choose(file);
    OpenPreview preview = twoChannels();
    preview.gap = ScaleGap{"Height", 64, 48, true, true};
    preview.size = {};
    dialog.showPreview(preview);
    EXPECT_TRUE(child<ScaleForm>("previewScale").isVisible());
    EXPECT_FALSE(ok().isEnabled());
    child<LengthBox>("sizeX").setValue(8.0);
    EXPECT_FALSE(ok().isEnabled());
    EXPECT_EQ(dialog.preview().choices().scale, GivenScale()) << "half of it is none";
    child<LengthBox>("heightPerValue").setValue(2.0);
    EXPECT_TRUE(ok().isEnabled());
    EXPECT_EQ(dialog.preview().choices().scale, (GivenScale{8e-6, 6e-6, 2e-9}));
    dialog.showPreview(preview);
    EXPECT_EQ(child<LengthBox>("sizeX").value(), 8.0) << "what was typed stays";
}

TEST_F(OpenDialogTest, AFileThatIsWantedSoonOpensOnceItIsKnown) {
    choose(file);
    dialog.findChild<FileChooser*>()->accept();  // by Return or a double click
    EXPECT_TRUE(opened.isEmpty());
    dialog.showPreview(twoChannels());
    EXPECT_EQ(opened.count(), 1);
    EXPECT_FALSE(dialog.isVisible());
}

TEST_F(OpenDialogTest, AFileThatIsWantedButCannotBeOpenedStaysInTheDialog) {
    choose(file);
    dialog.findChild<FileChooser*>()->accept();
    OpenPreview preview = twoChannels();
    preview.gap = ScaleGap{"Height", 64, 48, true, false};
    dialog.showPreview(preview);
    EXPECT_TRUE(opened.isEmpty());
    child<LengthBox>("sizeX").setValue(6.4);
    EXPECT_TRUE(opened.isEmpty()) << "it asks again";
    EXPECT_TRUE(dialog.isVisible());
}

TEST_F(OpenDialogTest, ATypedNameIsChosenToo) {
    auto& name = child<QLineEdit>("fileNameEdit");
    name.setText("b.gw");
    EXPECT_TRUE(selected.isEmpty());
    name.setText("b.gwy");
    ASSERT_EQ(selected.count(), 1);
    EXPECT_EQ(selected[0][0].toString().toStdString(), other.string());
}

TEST_F(OpenDialogTest, ReturnInTheLineOpensIt) {
    auto& name = child<QLineEdit>("fileNameEdit");
    name.setText("b.gwy");
    dialog.showPreview(twoChannels());
    QTest::keyClick(&name, Qt::Key_Return);
    EXPECT_EQ(opened.count(), 1);
}

TEST_F(OpenDialogTest, AClickInTheListChooses) {
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
    auto& list = child<QTreeView>("treeView");
    const auto rows = [&] { return list.model()->rowCount(list.rootIndex()); };
    ASSERT_TRUE(eventually([&] { return rows() == 2; }));
    const QModelIndex second = list.model()->index(1, 0, list.rootIndex());
    QTest::mouseClick(list.viewport(), Qt::LeftButton, Qt::NoModifier,
                      list.visualRect(second).center());
    ASSERT_EQ(selected.count(), 1);
    EXPECT_EQ(selected[0][0].toString().toStdString(), other.string());
}

TEST_F(OpenDialogTest, ListsFilesThatWereOpenedBefore) {
    dialog.setRecent(
        {{QString::fromStdString(file.string()), "a.gwy", true}, {"/gone/c.gwy", "c.gwy", false}});
    auto& recent = child<QListWidget>("recentFiles");
    ASSERT_EQ(recent.count(), 2);
    EXPECT_TRUE(recent.item(0)->text().startsWith("a.gwy"));
    EXPECT_FALSE(recent.item(1)->flags() & Qt::ItemIsEnabled);
    QTest::mouseClick(recent.viewport(), Qt::LeftButton, Qt::NoModifier,
                      recent.visualItemRect(recent.item(0)).center());
    ASSERT_EQ(selected.count(), 1);
    EXPECT_EQ(selected[0][0].toString().toStdString(), file.string());
}

TEST_F(OpenDialogTest, ShowsHowFarASlowLookIs) {
    auto& bar = child<QProgressBar>("previewProgress");
    EXPECT_FALSE(bar.isVisible());
    dialog.setProgress(0.5);
    EXPECT_TRUE(bar.isVisible());
    EXPECT_EQ(bar.value(), 50);
    dialog.setProgress(std::nullopt);
    EXPECT_FALSE(bar.isVisible());
}

TEST_F(OpenDialogTest, EscOpensNothing) {
    choose(file);
    dialog.showPreview(twoChannels());
    QTest::keyClick(dialog.findChild<FileChooser*>(), Qt::Key_Escape);
    EXPECT_FALSE(dialog.isVisible());
    EXPECT_TRUE(opened.isEmpty());
}

TEST_F(OpenDialogTest, IsInTheFolderOfAFileWhosePathWasTyped) {
    ScratchFolder elsewhere;
    const std::filesystem::path typed = elsewhere.write("c.gwy", "three");
    auto& name = child<QLineEdit>("fileNameEdit");
    name.clear();
    QTest::keyClicks(&name, QString::fromStdString(typed.string()));
    ASSERT_TRUE(eventually([&] {
        return selected.value(selected.count() - 1).value(0).toString() ==
               QString::fromStdString(typed.string());
    }));
    EXPECT_EQ(dialog.folder(), QString::fromStdString(elsewhere.path().string()));
}

}  // namespace
}  // namespace asperity::test
