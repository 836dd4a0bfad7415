#include "app/window/scene/LevelingEditor.h"
#include "app/window/scene/SceneControl.h"
#include "app/window/scene/ScenePanel.h"
#include "app/window/session/SessionControl.h"
#include "core/io/scene/SceneFile.h"
#include "tests/app/window/WindowFixture.h"
#include "tests/support/Places.h"
#include "ui/shell/Menus.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QComboBox>
#include <QMenu>
#include <QToolButton>
#include <QtTest>

#include <algorithm>

namespace asperity::test {
namespace {

const std::filesystem::path kSamples = test::dataFolder() / "samples";

/// A scan in the real window, changed and undone by keys.
class Undo : public Window {
protected:
    void openScan(const char* name) {
        QSignalSpy begun(&stage.runs(), &RunControl::begun);
        stage.get<SceneControl>().open(kSamples / name);
        ASSERT_TRUE(eventually([&] { return begun.count() > 0; }));
        ASSERT_TRUE(eventually([this] { return far(); })) << state();
    }
    const SceneDescription& scene() { return stage.run()->scene().description; }
    /// Ctrl+Z and Ctrl+Shift+Z reach the menu once its entry can work.
    void pressUndo() {
        ASSERT_TRUE(eventually([this] { return window.menus().entry("undo").isEnabled(); }));
        QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
        ASSERT_TRUE(changeEnds());
    }
    void pressRedo() {
        ASSERT_TRUE(eventually([this] { return window.menus().entry("redo").isEnabled(); }));
        QTest::keyClick(&window, Qt::Key_Y, Qt::ControlModifier);
        ASSERT_TRUE(changeEnds());
    }
    /// Types a number into the scene page.
    void enter(const char* key, const char* text) {
        window.showSidePage(window.findChild<ScenePanel*>());
        auto* control = child<QWidget>(key);
        control->setFocus();
        QTest::keyClick(control, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(control, QString::fromUtf8(text));
        QTest::keyClick(control, Qt::Key_Return);
        ASSERT_TRUE(changeEnds());
    }
    std::string undoText() {
        EXPECT_TRUE(framesPass());
        return window.menus().entry("undo").text().toStdString();
    }
    double height() {
        const BSplineSurface& surface = stage.run()->scene().surface;
        return surface.at(0.4 * surface.sizeX(), 0.6 * surface.sizeY()).height;
    }
};

TEST_F(Undo, LevelUndoRedo) {
    openScan("steps.gsf");
    const double before = height();
    window.showSidePage(window.findChild<ScenePanel*>());
    auto* add = window.findChild<ScenePanel*>()->findChild<QToolButton*>("addLevelingStep");
    add->menu()->actions().last()->trigger();
    ASSERT_TRUE(changeEnds());
    EXPECT_EQ(undoText(), "&Undo Leveling: plane, zero");
    const double after = height();
    EXPECT_NE(after, before);
    pressUndo();
    EXPECT_EQ(height(), before);
    EXPECT_EQ(child<LevelingEditor>("sample.level")->steps(), LevelingSteps{LevelingStep::Plane});
    ASSERT_TRUE(framesPass());
    EXPECT_EQ(window.menus().entry("redo").text(), "&Redo Leveling: plane, zero");
    pressRedo();
    EXPECT_EQ(height(), after);
}

TEST_F(Undo, MaterialAndParameterOneAfterTheOther) {
    openScan("steps.gsf");
    const SceneDescription first = scene();
    choose("material", "silicone rubber");
    ASSERT_TRUE(changeEnds());
    enter("tip.radius_m", "20");
    EXPECT_EQ(undoText(), "&Undo Tip radius: 20 nm");
    pressUndo();
    EXPECT_EQ(undoText(), "&Undo Material: silicone rubber");
    EXPECT_EQ(scene().tip.radius, 15e-9);
    pressUndo();
    EXPECT_EQ(scene(), first);
    EXPECT_EQ(child<QComboBox>("material")->currentText(), "polystyrene");
    EXPECT_FALSE(eventually([this] { return window.menus().entry("undo").isEnabled(); }, 300));
    EXPECT_TRUE(stage.run()->loop().running());
}

TEST_F(Undo, OpenThenUndo) {
    openScan("steps.gsf");
    openScan("grating.gsf");
    EXPECT_EQ(undoText(), "&Undo Open grating.gsf");
    pressUndo();
    EXPECT_TRUE(window.windowTitle().startsWith("steps.gsf"));
    EXPECT_TRUE(eventually([this] { return far(); })) << state();
    pressRedo();
    EXPECT_TRUE(window.windowTitle().startsWith("grating.gsf"));
}

TEST_F(Undo, ANumberBoxUndoesWhatIsTypedAndThenTheScene) {
    openScan("steps.gsf");
    enter("tip.radius_m", "20");
    auto* box = child<QAbstractSpinBox>("tip.radius_m");
    ASSERT_TRUE(box->hasFocus());
    ASSERT_TRUE(eventually([this] { return window.menus().entry("undo").isEnabled(); }));
    QTest::keyClicks(box, "5");
    QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(scene().tip.radius, 20e-9) << "what was typed goes first";
    QTest::keyClick(box, Qt::Key_Return);
    ASSERT_TRUE(changeEnds());
    box->clearFocus();
    pressUndo();
    EXPECT_EQ(scene().tip.radius, 15e-9);
}

TEST_F(Undo, TheSceneIsSavedAsItIsNow) {
    openScan("steps.gsf");
    enter("tip.radius_m", "20");
    turn("forceGain", "250");
    const std::filesystem::path file = folder.file("mine");
    stage.get<SessionControl>().saveAs(file);
    EXPECT_NE(told().find("mine.toml"), std::string::npos);
    const SceneDescription saved = readScene(folder.file("mine.toml"));
    EXPECT_EQ(saved.tip.radius, 20e-9);
    EXPECT_EQ(saved.settings.forceGain, 250.0);
    SceneDescription same = saved;
    same.settings = scene().settings;
    EXPECT_EQ(same, scene());
}

TEST_F(Undo, F7ShowsTheScenePage) {
    openFlatScene();
    EXPECT_FALSE(window.findChild<ScenePanel*>()->isVisible());
    QTest::keyClick(&window, Qt::Key_F7);
    EXPECT_TRUE(window.findChild<ScenePanel*>()->isVisible());
}

}  // namespace
}  // namespace asperity::test
