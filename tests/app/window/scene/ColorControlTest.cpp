#include "app/window/scene/ColorControl.h"

#include "app/window/live/OverviewPanel.h"
#include "app/window/scene/SceneControl.h"
#include "tests/app/window/ControlFixture.h"
#include "tests/support/Places.h"
#include "tests/support/StepsScan.h"
#include "ui/shell/Menus.h"
#include "ui/view/ColorsMenu.h"
#include "ui/view/OverviewMap.h"
#include "ui/view/ZoomView.h"

#include <QAction>
#include <QMenu>
#include <QToolButton>

namespace asperity::test {
namespace {

class ColorControlTest : public ControlFixture {
protected:
    void choose(SurfaceQuantity quantity) {
        SurfaceLook look = panels.colors().look();
        look.quantity = quantity;
        panels.colors().choose(look);
    }
    QString shown() { return panels.view().colorScale().quantity; }
    QString shownOfAll() { return panels.overview().map().colors().quantity; }
    QAction& entry(const char* name) { return *window.findChild<QAction*>(name); }

    ColorControl& colors = stage.add<ColorControl>();
    SceneControl& scenes = stage.add<SceneControl>();
};

TEST_F(ColorControlTest, AllViewsAreColoredByTheSameQuantity) {
    useFlatScene();
    choose(SurfaceQuantity::Slope);
    EXPECT_EQ(shown(), QStringLiteral("slope"));
    EXPECT_EQ(shownOfAll(), QStringLiteral("slope"));
    choose(SurfaceQuantity::Gap);
    EXPECT_EQ(shown(), QStringLiteral("gap to the tip"));
    EXPECT_EQ(shownOfAll(), QStringLiteral("height")) << "there is no tip over the whole scan";
}

TEST_F(ColorControlTest, ReadsTheResidualInTheBackground) {
    scenes.open(folder.write("scene.toml",
                             "[sample]\nfile = \"" + kSteps.string() + "\"\nsmoothing_px = 1\n"));
    ASSERT_TRUE(eventually([this] { return runs.run() != nullptr; }));
    choose(SurfaceQuantity::Residual);
    EXPECT_EQ(shown(), QStringLiteral("height")) << "until it is read";
    ASSERT_TRUE(eventually([this] { return shown() == QStringLiteral("residual"); }));
    EXPECT_GT(panels.overview().map().colors().dataHigh, 1e-13);
    choose(SurfaceQuantity::Height);
    choose(SurfaceQuantity::Residual);
    EXPECT_EQ(shown(), QStringLiteral("residual")) << "it is kept";
}

TEST_F(ColorControlTest, SaysWhatASceneDoesNotHave) {
    EXPECT_FALSE(entry("colorBy.residual").isEnabled()) << "no scan";
    useFlatScene();
    EXPECT_FALSE(entry("colorBy.certainty").isEnabled());
    EXPECT_TRUE(
        entry("colorBy.certainty").toolTip().contains(QStringLiteral("imaging_tip_radius_m")));
    SceneDescription known = plainScene();
    known.sample.imagingTipRadius = 10e-9;
    runs.use({.scene = buildScene(known, hillyMap()), .format = "", .sha256 = "", .notes = {}});
    EXPECT_TRUE(entry("colorBy.certainty").isEnabled());
    choose(SurfaceQuantity::Certainty);
    EXPECT_EQ(shown(), QStringLiteral("certainty"));
    useFlatScene();
    EXPECT_EQ(shown(), QStringLiteral("height"));
    EXPECT_NE(told().find("certainty"), std::string::npos);
}

TEST_F(ColorControlTest, ColorsAndRangeAreBackAfterARecording) {
    SceneDescription known = plainScene();
    known.sample.imagingTipRadius = 10e-9;
    runs.use({.scene = buildScene(known, hillyMap()), .format = "", .sha256 = "", .notes = {}});
    SurfaceLook look = panels.colors().look();
    look.quantity = SurfaceQuantity::Certainty;
    look.of(SurfaceQuantity::Height).pinned = true;
    look.of(SurfaceQuantity::Height).rule = RangeRule::Own;
    look.of(SurfaceQuantity::Height).low = -3e-9;
    look.of(SurfaceQuantity::Height).high = 4e-9;
    panels.colors().choose(look);
    showRecordingOfOtherScan();
    EXPECT_EQ(shown(), QStringLiteral("height")) << "it has no certainty";
    choose(SurfaceQuantity::Slope);
    SurfaceLook other = panels.colors().look();
    other.of(SurfaceQuantity::Height) = QuantityColors();
    panels.colors().choose(other);
    runs.showLive();
    EXPECT_EQ(shown(), QStringLiteral("certainty"));
    EXPECT_EQ(panels.colors().look(), look);
    EXPECT_TRUE(entry("colorBy.certainty").isEnabled());
}

TEST_F(ColorControlTest, ASampleOfSeveralMaterialsShowsThem) {
    useFlatScene();
    EXPECT_FALSE(entry("colorBy.youngs_modulus").isEnabled()) << "it is the same everywhere";
    scenes.open(test::dataFolder() / "scenes/particles.toml");
    ASSERT_TRUE(eventually([this] { return entry("colorBy.youngs_modulus").isEnabled(); }));
    choose(SurfaceQuantity::YoungsModulus);
    EXPECT_EQ(shown(), QStringLiteral("Young's modulus"));
    EXPECT_EQ(shownOfAll(), QStringLiteral("Young's modulus"));
    EXPECT_NEAR(panels.overview().map().colors().dataLow, 2e9, 1e6);
    // Of a material with the Poisson's ratio of polystyrene, as stiff as silicon oxide.
    EXPECT_NEAR(panels.overview().map().colors().dataHigh, 70e9 * (1.0 - 0.16) / (1.0 - 0.0729),
                1e7);
    choose(SurfaceQuantity::FrictionCoefficient);
    EXPECT_NEAR(panels.overview().map().colors().dataHigh, 0.3, 1e-3);
    useFlatScene();
    EXPECT_EQ(shown(), QStringLiteral("height"));
}

TEST_F(ColorControlTest, AFileThatIsGoneIsTold) {
    const std::filesystem::path copy = folder.file("gone.gsf");
    std::filesystem::copy_file(kSteps, copy);
    scenes.open(copy);
    ASSERT_TRUE(eventually([this] { return runs.run() != nullptr; }));
    std::filesystem::remove(copy);
    choose(SurfaceQuantity::Residual);
    ASSERT_TRUE(
        eventually([this] { return panels.colors().look().quantity == SurfaceQuantity::Height; }));
    EXPECT_NE(complaint().find("gone.gsf"), std::string::npos);
    EXPECT_EQ(shown(), QStringLiteral("height"));
}

TEST_F(ColorControlTest, APinnedRangeStaysForAnotherMaterial) {
    useFlatScene();
    SurfaceLook look = panels.colors().look();
    look.of(SurfaceQuantity::Height).pinned = true;
    panels.colors().choose(look);
    const double high = panels.overview().map().colors().high;
    runs.use(
        {.scene = buildScene(plainScene(), hillyMap()), .format = "", .sha256 = "", .notes = {}});
    EXPECT_EQ(panels.overview().map().colors().high, high);
    EXPECT_TRUE(panels.overview().map().colors().clipsHigh());
}

TEST_F(ColorControlTest, AButtonBesideTheBarsShowsTheDentAlone) {
    useFlatScene();
    const auto buttons = window.findChildren<QToolButton*>("dentOnly");
    ASSERT_EQ(buttons.size(), 2) << "of the large view and of the second one";
    for (QToolButton* const button : buttons) {
        button->click();
        EXPECT_EQ(shown(), QStringLiteral("displacement"));
        EXPECT_TRUE(buttons[0]->isChecked() && buttons[1]->isChecked());
        button->click();
        EXPECT_EQ(shown(), QStringLiteral("height"));
        EXPECT_FALSE(buttons[0]->isChecked() || buttons[1]->isChecked());
    }
}

}  // namespace
}  // namespace asperity::test
