
#include "app/window/scene/LibraryControl.h"
#include "app/window/scene/ScenePanel.h"
#include "core/io/scene/ProbeFile.h"
#include "tests/app/window/ControlFixture.h"

#include <QComboBox>
#include <QInputDialog>
#include <QToolButton>

namespace asperity::test {
namespace {

class ProbeControlTest : public ControlFixture {
protected:
    ProbeControlTest() {
        probes.setFolder(folder.path() / "own");
        panel.showScene(defaultScene(), defaultScene());
    }
    QComboBox& list() { return *window.findChild<QComboBox*>("probeLibrary"); }
    const SceneDescription& scene() { return run().scene().description; }

    ScenePanel& panel = stage.add<ScenePanelControl>().panel();
    ProbeControl& probes = stage.add<ProbeControl>();
};

TEST_F(ProbeControlTest, AnotherLeverComesWithItsCalibration) {
    useFlatScene();
    const int soft = list().findText("calibrated 2 8 n m");
    ASSERT_GE(soft, 0);
    Q_EMIT panel.probes().chosen(soft);
    ASSERT_TRUE(changeEnds());
    EXPECT_NEAR(Cantilever(scene().probe).stiffness(), 2.8, 1e-9);
    EXPECT_EQ(scene().detector.invOls, 62e-9);
    EXPECT_NEAR(scene().truth.stiffness, 2.8, 1e-9) << "the true lever is that one, too";
    EXPECT_EQ(list().currentIndex(), soft);
    EXPECT_EQ(edits.undoName(), "Probe: calibrated 2 8 n m");
}

TEST_F(ProbeControlTest, TheScenesLeverIsSavedUnderAName) {
    useFlatScene();
    SceneDescription next = scene();
    next.detector.invOls = 50e-9;
    edits.change("InvOLS", next);
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(list().currentText(), "of this scene");
    window.findChild<QToolButton*>("saveProbe")->click();
    auto* dialog = window.findChild<QInputDialog*>("askForName");
    ASSERT_NE(dialog, nullptr);
    dialog->setTextValue("Lever 7");
    dialog->accept();
    EXPECT_EQ(list().currentText(), "lever 7 (own)");
    const ProbeDescription saved = readProbe(folder.path() / "own" / "lever_7.toml");
    EXPECT_EQ(saved.lever, scene().probe);
    EXPECT_EQ(saved.detector, scene().detector);
}

}  // namespace
}  // namespace asperity::test
