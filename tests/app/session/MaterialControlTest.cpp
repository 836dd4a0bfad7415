#include "app/session/MaterialControl.h"

#include "tests/app/session/ControlFixture.h"
#include "ui/panels/ControlBar.h"

#include <QComboBox>

namespace asperity::test {
namespace {

class MaterialControlTest : public ControlFixture {
protected:
    QComboBox& list() { return *window.findChild<QComboBox*>("material"); }

    MaterialControl materials{window, runs, edits};
};

TEST_F(MaterialControlTest, AnotherMaterialIsAnotherRun) {
    useFlatScene();
    const int rubber = list().findText("silicone rubber");
    ASSERT_GE(rubber, 0);
    EXPECT_NE(list().currentIndex(), rubber);
    Q_EMIT window.controls().materialChosen(rubber);
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

}  // namespace
}  // namespace asperity::test
