#include "app/window/live/ControlBar.h"
#include "app/window/scene/LibraryControl.h"
#include "app/window/scene/ScenePanel.h"
#include "core/io/scene/SceneFile.h"
#include "core/scene/SceneFieldChange.h"
#include "tests/app/window/ControlFixture.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QInputDialog>
#include <QMessageBox>
#include <QToolButton>

namespace asperity::test {
namespace {

class MaterialControlTest : public ControlFixture {
protected:
    MaterialControlTest() {
        materials.setFolder(own);
        panel.showScene(defaultScene(), defaultScene());
    }

    /// Answers the dialog that asks for a name.
    void name(const char* text) {
        auto* dialog = window.findChild<QInputDialog*>("askForName");
        ASSERT_NE(dialog, nullptr);
        dialog->setTextValue(text);
        dialog->accept();
        delete dialog;
    }
    /// Answers a question. @return what was asked
    std::string answer(const char* button) {
        auto* box = window.findChild<QMessageBox*>("askWhether");
        if (box == nullptr) {
            ADD_FAILURE() << "nothing is asked";
            return {};
        }
        for (QAbstractButton* offered : box->buttons()) {
            if (QString(offered->text()).remove('&') == QString::fromUtf8(button)) {
                offered->click();
            }
        }
        const std::string question = box->text().toStdString();
        delete box;
        return question;
    }
    void press(const char* button) { window.findChild<QToolButton*>(button)->click(); }
    const SampleMaterial& material() { return run().scene().description.sample.material; }
    void soften() {
        SampleMaterial softer = material();
        softer.elastic.youngsModulus *= 0.5;
        softer.name += kEditedSuffix;
        edits.change("softer", withMaterial(run().scene().description, softer));
        ASSERT_TRUE(changeEnds());
    }

    const std::filesystem::path own = folder.path() / "own";
    QComboBox& list() { return *window.findChild<QComboBox*>("material"); }

    ScenePanel& panel = stage.add<ScenePanelControl>().panel();
    MaterialControl& materials = stage.add<MaterialControl>();
};

TEST_F(MaterialControlTest, AnotherMaterialIsAnotherRun) {
    useFlatScene();
    const int rubber = list().findText("silicone rubber");
    ASSERT_GE(rubber, 0);
    EXPECT_NE(list().currentIndex(), rubber);
    Q_EMIT panels.controls().materialChosen(rubber);
    EXPECT_EQ(list().currentIndex(), rubber);
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(run().scene().description.sample.material.name, "silicone_rubber");
    EXPECT_EQ(list().currentIndex(), rubber);
    EXPECT_EQ(edits.undoName(), "Material: silicone rubber");
}

TEST_F(MaterialControlTest, AMaterialThatNoFileHasIsListedToo) {
    SceneDescription scene = plainScene();
    scene.sample.material.name = "of_this_test";
    scene.sample.material.elastic.youngsModulus *= 1.5;
    runs.use({.scene = buildScene(scene, flatMap()), .format = "", .sha256 = "", .notes = {}});
    EXPECT_EQ(list().currentText().toStdString(), "of this test");
}

TEST_F(MaterialControlTest, AnEditedOneIsSavedAsTheUsersOwn) {
    useFlatScene();
    soften();
    EXPECT_EQ(list().currentText(), "polystyrene (edited)");
    press("saveMaterial");
    EXPECT_EQ(window.findChild<QInputDialog*>("askForName")->textValue(), "polystyrene");
    name("My foam");
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(material().name, "My foam");
    EXPECT_EQ(list().currentText(), "My foam (own)");
    EXPECT_EQ(readMaterialFile(own / "my_foam.toml"), material());
    EXPECT_NE(contentOf(own / "my_foam.toml").find("Changed from polystyrene"), std::string::npos)
        << "where its numbers come from";
    MaterialControl next(stage);
    next.setFolder(own);
    EXPECT_EQ(list().currentText(), "My foam (own)") << "in a later session, too";
}

/// “My glass” and “my_glass” have one file.
TEST_F(MaterialControlTest, AnotherOwnOneIsReplacedOnlyWhereTheUserAgrees) {
    useFlatScene();
    soften();
    press("saveMaterial");
    name("My Glass");
    ASSERT_TRUE(changeEnds());
    const SampleMaterial first = readMaterialFile(own / "my_glass.toml");
    soften();
    press("saveMaterial");
    name("my_glass");
    EXPECT_NE(answer("Cancel").find("My Glass"), std::string::npos);
    EXPECT_EQ(readMaterialFile(own / "my_glass.toml"), first);
    press("saveMaterial");
    name("my_glass");
    answer("Replace");
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(readMaterialFile(own / "my_glass.toml"), material());
    EXPECT_NE(material(), first);
    press("renameMaterial");
    name("MY GLASS");  // the same file: nothing else is lost
    EXPECT_EQ(window.findChild<QMessageBox*>("askWhether"), nullptr);
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(material().name, "MY GLASS");
}

TEST_F(MaterialControlTest, OneOfTheProgramIsNeitherReplacedNorDeleted) {
    useFlatScene();
    soften();
    press("saveMaterial");
    name("Silicon oxide");
    EXPECT_NE(complaint().find("comes with the program"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(own));
    EXPECT_FALSE(window.findChild<QToolButton*>("deleteMaterial")->isEnabledTo(&window));
}

TEST_F(MaterialControlTest, OwnOnesAreRenamedAndDeleted) {
    useFlatScene();
    soften();
    press("saveMaterial");
    name("foam");
    ASSERT_TRUE(changeEnds());
    press("renameMaterial");
    name("foam 2");
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(list().currentText(), "foam 2 (own)");
    EXPECT_FALSE(std::filesystem::exists(own / "foam.toml"));
    EXPECT_TRUE(std::filesystem::exists(own / "foam_2.toml"));
    press("deleteMaterial");
    EXPECT_NE(answer("Cancel").find("foam 2"), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(own / "foam_2.toml"));
    press("deleteMaterial");
    answer("Delete");
    EXPECT_FALSE(std::filesystem::exists(own / "foam_2.toml"));
    EXPECT_EQ(list().currentText(), "foam 2") << "the scene still has it";
    EXPECT_EQ(complaint(), "");
}

}  // namespace
}  // namespace asperity::test
