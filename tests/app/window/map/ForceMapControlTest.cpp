#include "app/window/map/ForceMapControl.h"

#include "app/window/map/ForceMapPage.h"
#include "tests/app/window/ControlFixture.h"
#include "ui/shell/Menus.h"
#include "ui/widgets/NumberBox.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QSpinBox>
#include <QToolButton>

#include <optional>
#include <string>

namespace asperity::test {
namespace {

/// The page and what the control offers, without views and menus of a window.
class ForceMapControlTest : public ControlFixture {
protected:
    void SetUp() override {
        QObject::connect(&stage, &Stage::fieldOffered, &listener,
                         [this](const std::optional<SurfaceField>& field) { offered = field; });
        QObject::connect(&stage, &Stage::fieldWanted, &listener, [this] { ++wishes; });
    }
    template <class Widget>
    Widget& part(const char* name) {
        return *maps.page().findChild<Widget*>(QString::fromLatin1(name));
    }
    void click(const char* name) { part<QToolButton>(name).click(); }
    bool isOn(const char* button) { return part<QToolButton>(button).isEnabled(); }
    std::string state() { return maps.page().state().toStdString(); }
    std::string refusal() { return part<QLabel>("mapRefusal").text().toStdString(); }
    void choosePixels(int columns, int rows) {
        part<QSpinBox>("mapColumns").setValue(columns);
        part<QSpinBox>("mapRows").setValue(rows);
    }
    void chooseSides(double left, double right) {
        part<NumberBox>("mapLeft").setValue(left);
        part<NumberBox>("mapRight").setValue(right);
    }
    bool ends() {
        return eventually([this] { return !isOn("cancelMap"); }, 60000);
    }
    void map(int columns, int rows) {
        choosePixels(columns, rows);
        click("startMap");
        ASSERT_TRUE(ends());
        ASSERT_NE(maps.map(), nullptr) << state();
    }
    /// A map that takes minutes, with some of its rows.
    void startLong() {
        useFlatScene();
        choosePixels(60, 2000);
        click("startMap");
        ASSERT_TRUE(isOn("cancelMap"));
        ASSERT_TRUE(
            eventually([this] { return state().find("left") != std::string::npos; }, 120000));
    }

    ForceMapControl& maps = stage.add<ForceMapControl>();
    std::optional<SurfaceField> offered;
    int wishes = 0;  ///< that the surface is colored by it
    QObject listener;
};

TEST_F(ForceMapControlTest, OffersTheQuantitiesOfAFinishedMapAsColors) {
    useFlatScene();
    ASSERT_NO_FATAL_FAILURE(map(4, 3));
    EXPECT_TRUE(state().starts_with("4 × 3 pixels, approach to ")) << state();
    ASSERT_TRUE(offered);
    EXPECT_EQ(offered->quantity(), SurfaceQuantity::ForceMap);
    EXPECT_EQ(offered->name(), "adhesion force");
    EXPECT_FALSE(offered->hasGaps());
    EXPECT_EQ(wishes, 1);
    auto& shown = part<QComboBox>("mapQuantity");
    shown.setCurrentIndex(shown.findText(QStringLiteral("contact stiffness")));
    EXPECT_EQ(offered->name(), "contact stiffness");
    EXPECT_EQ(wishes, 2);
    const Vector2 position = maps.map()->plan().position(1, 2);
    EXPECT_FLOAT_EQ(
        static_cast<float>(offered->at({position.x(), position.y(), 0.0}, Vector3::UnitZ())),
        static_cast<float>(maps.map()->valuesAt(1, 2)[MapQuantity::Stiffness]));
}

TEST_F(ForceMapControlTest, CanceledItKeepsAndOffersItsRows) {
    ASSERT_NO_FATAL_FAILURE(startLong());
    EXPECT_FALSE(offered);
    window.works().cancel();  // as Esc and the bottom line do
    ASSERT_TRUE(ends());
    EXPECT_NE(state().find("canceled: "), std::string::npos) << state();
    ASSERT_NE(maps.map(), nullptr);
    EXPECT_LT(maps.map()->part().count(), 2000);
    ASSERT_TRUE(offered);
    EXPECT_TRUE(offered->hasGaps());
}

TEST_F(ForceMapControlTest, CanceledAtOnceLeavesNothing) {
    useFlatScene();
    choosePixels(2000, 2000);
    click("startMap");
    click("cancelMap");
    ASSERT_TRUE(ends());
    EXPECT_EQ(maps.map(), nullptr);
    EXPECT_EQ(state(), "No row was finished");
    EXPECT_FALSE(offered);
    EXPECT_EQ(wishes, 0);
    EXPECT_TRUE(isOn("startMap"));
    EXPECT_FALSE(isOn("saveMap"));
}

TEST_F(ForceMapControlTest, OfAScanThatGoesMeanwhileIsCanceled) {
    ASSERT_NO_FATAL_FAILURE(startLong());
    HeightMap other = flatMap();
    other.pitchX = 1e-9;
    other.pitchY = 1e-9;
    runs.use({.scene = buildScene(plainScene(), other),
              .format = "made for the test",
              .sha256 = "",
              .notes = {}});
    EXPECT_NE(told().find("the force map is canceled"), std::string::npos) << told();
    EXPECT_FALSE(isOn("cancelMap"));
    EXPECT_EQ(maps.map(), nullptr);
    ASSERT_NO_FATAL_FAILURE(map(3, 2));
    EXPECT_NEAR(maps.map()->plan().region.right, 64e-9, 1e-15) << "the one that is shown now";
    EXPECT_EQ(maps.map()->part().count(), 2);
}

TEST_F(ForceMapControlTest, IsBackAfterARecordingOfAnotherScan) {
    useFlatScene();
    ASSERT_NO_FATAL_FAILURE(map(4, 3));
    const std::string words = state();
    showRecordingOfOtherScan();
    EXPECT_FALSE(offered) << "it says nothing of that scan";
    EXPECT_NE(state().find("back with the live tip"), std::string::npos) << state();
    EXPECT_NE(refusal().find("back to the live tip"), std::string::npos) << refusal();
    auto& shown = part<QComboBox>("mapQuantity");
    shown.setCurrentIndex(shown.findText(QStringLiteral("contact stiffness")));
    EXPECT_FALSE(offered);
    runs.showLive();
    ASSERT_TRUE(offered);
    EXPECT_EQ(offered->name(), "contact stiffness");
    EXPECT_EQ(state(), words);
    EXPECT_TRUE(refusal().empty()) << refusal();
}

TEST_F(ForceMapControlTest, StaysWithAnotherRunOnItsScan) {
    useFlatScene();
    ASSERT_NO_FATAL_FAILURE(map(3, 2));
    const HeldMap* const before = maps.map();
    useFlatScene();
    EXPECT_EQ(maps.map(), before);
    EXPECT_TRUE(offered);
    EXPECT_TRUE(isOn("saveMap"));
}

TEST_F(ForceMapControlTest, SaysWhatItCannotMap) {
    EXPECT_EQ(refusal(), "Open a scan or a scene first");
    EXPECT_FALSE(isOn("startMap"));
    useFlatScene();
    EXPECT_EQ(refusal(), "");
    choosePixels(0, 5);
    EXPECT_NE(refusal().find("1 to 65536 pixels"), std::string::npos) << refusal();
    EXPECT_FALSE(isOn("startMap"));
    choosePixels(60000, 60000);
    EXPECT_NE(refusal().find("4 GiB"), std::string::npos) << refusal();
    choosePixels(5, 5);
    EXPECT_EQ(refusal(), "");
    EXPECT_TRUE(isOn("startMap"));
    chooseSides(0.0, 200.0);
    EXPECT_NE(refusal().find("outside the scan"), std::string::npos) << refusal();
    chooseSides(50.0, 50.0);
    EXPECT_NE(refusal().find("is empty"), std::string::npos) << refusal();
    chooseSides(50.0, 60.0);
    EXPECT_EQ(refusal(), "");
    part<NumberBox>("mapSetpoint").setValue(-3.0);
    EXPECT_NE(refusal().find("The setpoint must lie between"), std::string::npos) << refusal();
    EXPECT_FALSE(isOn("startMap"));
}

TEST_F(ForceMapControlTest, IsLockedAndCanceledWhileTheSceneIsFixed) {
    ASSERT_NO_FATAL_FAILURE(startLong());
    stage.play(20);
    runs.fix(QStringLiteral("a study is under way"));
    ASSERT_TRUE(eventually([this] { return !maps.page().isEnabled(); }));
    EXPECT_TRUE(eventually([this] { return !window.menus().entry("forceMap").isEnabled(); }));
    EXPECT_EQ(refusal(), "a study is under way");
    runs.fix({});
    ASSERT_TRUE(eventually([this] { return maps.page().isEnabled(); }));
    ASSERT_TRUE(ends());
    EXPECT_NE(state().find("canceled: "), std::string::npos) << state();
    EXPECT_EQ(refusal(), "");
}

}  // namespace
}  // namespace asperity::test
