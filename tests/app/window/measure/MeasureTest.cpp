#include "app/window/curve/MeasuredCurveControl.h"
#include "app/window/live/CyclePanel.h"
#include "app/window/live/OverviewPanel.h"
#include "app/window/measure/ForceCycleControl.h"
#include "app/window/measure/MarkerControl.h"
#include "app/window/measure/ProfileControl.h"
#include "app/window/measure/RoughnessControl.h"
#include "app/window/scene/SceneControl.h"
#include "core/io/tables/CsvTable.h"
#include "tests/app/window/WindowFixture.h"
#include "tests/support/TestScenes.h"
#include "tests/ui/widgets/MouseEvents.h"
#include "ui/shell/Menus.h"
#include "ui/view/OverviewMap.h"
#include "ui/view/ZoomView.h"
#include "ui/widgets/PageParts.h"

#include <QAction>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QToolButton>
#include <QtTest>

#include <cmath>

namespace asperity::test {
namespace {

/// Of the ridges over the grooves: single precision has it without error [m].
const double kStep = std::ldexp(1.0, -27);

/// 256 x 256 pixels of 1 nm: ridges along y about x = 64 nm and 192 nm, 64 nm wide, and grooves
/// between them. The spline's ripples beside an edge fall by 3.7 a pixel.
HeightMap gratingMap() {
    HeightMap map{.columns = 256, .rows = 256, .pitchX = 1e-9, .pitchY = 1e-9};
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            map.heights.push_back((column + 32) / 64 % 2 == 0 ? 0.0 : kStep);
        }
    }
    return map;
}

/// The measuring tools as a user has them: by menu, mouse and keys.
class Measure : public Window {
protected:
    void openGrating() {
        SceneDescription scene = plainScene();
        scene.sample.leveling.clear();
        stage.runs().use({.scene = buildScene(scene, gratingMap()),
                          .format = "made for the test",
                          .sha256 = "",
                          .notes = {}});
        ASSERT_TRUE(eventually([this] { return far(); })) << state();
    }
    OverviewMap& map() { return panels.overview().map(); }
    /// Of a position [nm].
    QPointF pixel(double x, double y) { return map().toPixel({1e-9 * x, 1e-9 * y}); }
    void dragOnScan(double x1, double y1, double x2, double y2,
                    Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        dragMouse(map(), pixel(x1, y1), pixel(x2, y2), modifiers);
    }
    void click(const char* button) {
        QTest::mouseClick(child<QToolButton>(button), Qt::LeftButton);
    }
    template <typename Page>
    Page& page() {
        return *window.findChild<Page*>();
    }
    const std::vector<Marker>& markers() { return stage.edits().wanted()->markers; }
};

TEST_F(Measure, AProfileReadsTheStepOfAGrating) {
    openGrating();
    window.menus().entry("profile").trigger();
    ASSERT_TRUE(page<ProfilePage>().isVisible());
    EXPECT_NE(map().activeTool(), nullptr);
    dragOnScan(128, 90, 64, 90, Qt::ShiftModifier);  // from a groove to a ridge
    auto* step = child<QCheckBox>("stepHeight");
    step->click();
    EXPECT_EQ(text("stepReading"), "7.451 ± 0.22 nm") << "z is calibrated to 3 %";
    EXPECT_EQ(text("cursorRise"), "7.451 nm");
    // What is shown has four digits; what is computed is exact.
    const Profile profile =
        meanProfile(fieldOf(stage.run()->scene().surface), QLineF(128e-9, 90e-9, 64e-9, 90e-9), 1);
    EXPECT_NEAR(profile.heights.back() - profile.heights.front(), kStep, 1e-12 * kStep);
    QTest::keyClick(&window, Qt::Key_Escape);
    EXPECT_EQ(map().activeTool(), nullptr);
    EXPECT_FALSE(child<QToolButton>("drawProfile")->isChecked());
}

TEST_F(Measure, AToolBringsTheWholeScanToSight) {
    openGrating();
    window.menus().entry("parameters").trigger();
    ASSERT_FALSE(map().isVisible()) << "the page Scene is on top";
    window.menus().entry("profile").trigger();
    EXPECT_TRUE(map().isVisible());
}

TEST_F(Measure, EscEndsAToolBeforeItCancelsLoading) {
    openGrating();
    window.menus().entry("profile").trigger();
    QSignalSpy canceled(&stage.get<SceneControl>(), &SceneControl::openCanceled);
    stage.get<SceneControl>().open(levelScan(folder, 4096));
    QTest::keyClick(&panels.view(), Qt::Key_Escape);
    EXPECT_EQ(map().activeTool(), nullptr);
    EXPECT_EQ(canceled.count(), 0);
    handleEvents();
    QTest::keyClick(&panels.view(), Qt::Key_Escape);
    EXPECT_EQ(canceled.count(), 1);
}

TEST_F(Measure, ALineIsOfItsScanAlone) {
    openGrating();
    window.menus().entry("profile").trigger();
    dragOnScan(16, 64, 48, 64);
    EXPECT_NE(text("profileLength"), "–");
    openFlatScene();
    EXPECT_EQ(text("profileLength"), "–");
}

TEST_F(Measure, RoughnessOfARectangleOnARidgeIsNone) {
    openGrating();
    window.menus().entry("roughness").trigger();
    ASSERT_TRUE(eventually([this] { return text("sa") == "3.725 nm"; })) << text("sa");
    EXPECT_EQ(text("sz").substr(0, 3), "7.4") << "and what the spline adds at its edges";
    click("drawRectangle");
    dragOnScan(48, 20, 80, 200);
    ASSERT_TRUE(eventually([this] { return text("roughnessSubject").starts_with("Rectangle, "); }));
    const std::string sq = text("sq");
    EXPECT_TRUE(sq.ends_with(" fm") || sq.ends_with(" pm") || sq == "0 fm") << sq;
    EXPECT_NE(text("roughnessSubject").find("Leveling: none"), std::string::npos);
}

TEST_F(Measure, AMarkerIsSetOnTheScanTraveledToAndTakenBack) {
    openGrating();
    window.menus().entry("markers").trigger();
    click("placeMarkers");
    QTest::mouseDClick(&map(), Qt::LeftButton, Qt::NoModifier, pixel(100, 30).toPoint());
    ASSERT_EQ(markers().size(), 1U);
    EXPECT_EQ(markers()[0].name, "M1");
    EXPECT_NEAR(markers()[0].x, 100e-9, 2e-9);
    EXPECT_GT(std::abs(stage.run()->basePosition().x() - 100e-9), 10e-9) << "it has not traveled";
    click("travelToMarker");
    EXPECT_TRUE(eventually([this] {
        const Vector3 base = stage.run()->basePosition();
        return std::abs(base.x() - markers()[0].x) < 0.1e-9 &&
               std::abs(base.y() - markers()[0].y) < 0.1e-9;
    }));
    stage.edits().undo();
    EXPECT_TRUE(eventually([this] { return markers().empty(); }));
    EXPECT_EQ(page<MarkersPage>().model().rowCount(), 0);
    stage.edits().redo();
    EXPECT_TRUE(eventually([this] { return markers().size() == 1; }));
    EXPECT_EQ(page<MarkersPage>().model().rowCount(), 1);
}

TEST_F(Measure, MarkersAreSetAtTheTipRenamedMovedAndDeleted) {
    openGrating();
    window.menus().entry("markers").trigger();
    click("markerAtTip");
    ASSERT_EQ(markers().size(), 1U);
    EXPECT_NEAR(markers()[0].x, stage.run()->basePosition().x(), 0.5e-9);
    auto* model = child<QTableView>("markers")->model();
    model->setData(model->index(0, 0), QStringLiteral("ridge 2"));
    EXPECT_EQ(markers()[0].name, "ridge 2");
    click("placeMarkers");
    dragOnScan(1e9 * markers()[0].x, 1e9 * markers()[0].y, 20, 20);
    EXPECT_NEAR(markers()[0].x, 20e-9, 1e-9);
    page<MarkersPage>().select(0);
    click("deleteMarker");
    EXPECT_TRUE(markers().empty());
    QTest::keyClick(&panels.view(), Qt::Key_Escape);
    EXPECT_EQ(map().activeTool(), nullptr);
}

TEST_F(Measure, AMarkerIsSetWhereThePointerIs) {
    openGrating();
    window.menus().entry("markerHere").trigger();
    EXPECT_TRUE(markers().empty()) << "the pointer is over no view";
    EXPECT_TRUE(told().starts_with("Move the pointer")) << told();
    sendMouse(map(), QEvent::MouseMove, pixel(100, 30), Qt::NoButton);
    window.menus().entry("markerHere").trigger();
    ASSERT_EQ(markers().size(), 1U);
    EXPECT_NEAR(markers()[0].x, 100e-9, 1e-9);
    EXPECT_NEAR(markers()[0].y, 30e-9, 1e-9);
}

TEST_F(Measure, AForceCycleIsARowThatIsExported) {
    openGrating();
    window.menus().entry("touches").trigger();
    QTest::mouseClick(child<QPushButton>("engage"), Qt::LeftButton);
    ASSERT_TRUE(eventually([this] { return told().starts_with("Engaged"); })) << told();
    QTest::mouseClick(child<QPushButton>("withdraw"), Qt::LeftButton);
    ASSERT_TRUE(eventually([this] { return far(); })) << state();
    ForceCycleModel& model = page<ForceCyclePage>().model();
    ASSERT_TRUE(eventually(
        [&] { return model.rowCount() == 1 && model.forceCycles()[0].cycle.complete(); }));
    const std::filesystem::path file = folder.file("touches.csv");
    stage.get<ForceCycleControl>().writeTo(file);
    const CsvTable table = readCsv(file);
    ASSERT_EQ(table.rows(), 1U);
    EXPECT_EQ(table.number(0, "pull_off_force_n"), model.forceCycles()[0].cycle.pullOff->value);
    EXPECT_GT(table.number(0, "snap_in_force_n"), 0.0);
    EXPECT_NEAR(table.number(0, "max_force_n"), 5e-9, 1.5e-9);
    EXPECT_NEAR(table.number(0, "x_m"), stage.run()->basePosition().x(), 2e-9);
}

TEST_F(Measure, AMeasuredCurveIsDrawnOverThoseOfTheRun) {
    openGrating();
    std::string table = "base_m,force_N\n";
    for (int i = 0; i < 200; ++i) {
        table += std::to_string(i) + "e-9," + std::to_string(i < 150 ? 0 : i - 150) + "e-9\n";
    }
    stage.get<MeasuredCurveControl>().load(folder.write("curve.csv", table));
    EXPECT_TRUE(eventually([this] { return page<CyclePanel>().measured().has_value(); }));
    EXPECT_EQ(told(), "Measured curve: curve.csv");
}

TEST_F(Measure, ADoubleClickTravelsUnlessAToolIsActive) {
    openGrating();
    QSignalSpy chosen(&panels.overview(), &OverviewPanel::positionChosen);
    QTest::mouseDClick(&map(), Qt::LeftButton, Qt::NoModifier, pixel(90, 90).toPoint());
    EXPECT_EQ(chosen.count(), 1);
    window.menus().entry("profile").trigger();
    QTest::mouseDClick(&map(), Qt::LeftButton, Qt::NoModifier, pixel(20, 20).toPoint());
    EXPECT_EQ(chosen.count(), 1);
}

}  // namespace
}  // namespace asperity::test
