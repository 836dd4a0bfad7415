#include "app/maps/MapPart.h"
#include "app/window/live/OverviewPanel.h"
#include "app/window/map/ForceMapControl.h"
#include "app/window/map/ForceMapPage.h"
#include "app/window/map/PixelCurveView.h"
#include "app/window/scene/SceneControl.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/map/PixelCycle.h"
#include "tests/app/ProgramRun.h"
#include "tests/app/window/WindowFixture.h"
#include "tests/support/TestScenes.h"
#include "tests/ui/widgets/MouseEvents.h"
#include "ui/plot/ForceDistancePlot.h"
#include "ui/shell/Menus.h"
#include "ui/view/ColorsMenu.h"
#include "ui/view/OverviewMap.h"
#include "ui/view/ZoomView.h"
#include "ui/widgets/Theme.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QSpinBox>
#include <QToolButton>
#include <QtTest>

#include <algorithm>
#include <cmath>

namespace asperity::test {
namespace {

/// Measure > Force map as a user has it, on soft hills of 128 nm x 128 nm.
class ForceMap : public Window {
protected:
    void SetUp() override {
        Window::SetUp();
        writeHeightMap(hills(), hillyMap(), {.title = "Height"});
        open(hills());
        window.menus().entry("forceMap").trigger();
        ASSERT_TRUE(page().isVisible());
    }
    [[nodiscard]] std::filesystem::path hills() const { return folder.file("hills.gwy"); }
    void open(const std::filesystem::path& file) {
        QSignalSpy taken(&stage.get<SceneControl>(), &SceneControl::sceneTaken);
        stage.get<SceneControl>().open(file);
        ASSERT_TRUE(eventually([&] { return taken.count() == 1; }));
    }
    ForceMapControl& maps() { return stage.get<ForceMapControl>(); }
    ForceMapPage& page() { return maps().page(); }
    PixelCurveView& pixel() { return page().pixel(); }
    OverviewMap& scan() { return panels.overview().map(); }
    QToolButton& button(const char* name) { return *child<QToolButton>(name); }
    void click(const char* name) { QTest::mouseClick(&button(name), Qt::LeftButton); }
    void type(const char* name, const QString& number) {
        auto* box = child<QAbstractSpinBox>(name);
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, number);
        QTest::keyClick(box, Qt::Key_Tab);
    }
    void typePixels(int columns, int rows) {
        type("mapColumns", QString::number(columns));
        type("mapRows", QString::number(rows));
    }
    void typeRegion(const char* left, const char* right, const char* bottom, const char* top) {
        type("mapLeft", QString::fromLatin1(left));
        type("mapRight", QString::fromLatin1(right));
        type("mapBottom", QString::fromLatin1(bottom));
        type("mapTop", QString::fromLatin1(top));
    }
    bool ends() {
        return eventually([this] { return !button("cancelMap").isEnabled(); }, 60000);
    }
    void map(int columns, int rows) {
        typePixels(columns, rows);
        click("startMap");
        ASSERT_TRUE(ends());
        ASSERT_NE(maps().map(), nullptr) << page().state().toStdString();
    }
    /// A map that takes minutes, with some of its rows.
    void startLong() {
        typePixels(60, 2000);
        click("startMap");
        ASSERT_TRUE(button("cancelMap").isEnabled());
        ASSERT_TRUE(
            eventually([this] { return page().state().contains(QStringLiteral("left")); }, 120000));
    }
    void clickPixel(int column, int row) {
        const Vector2 position = maps().map()->plan().position(row, column);
        const QPointF pixel = scan().toPixel({position.x(), position.y()});
        dragMouse(scan(), pixel, pixel);
    }
    std::string complaint() {
        auto* box = window.findChild<QMessageBox*>();
        const std::string text = box != nullptr ? box->text().toStdString() : std::string();
        delete box;
        return text;
    }
    [[nodiscard]] QString shownColors() { return panels.view().colorScale().quantity; }
    /// The window's files and those of the command, which is asked for the same.
    void expectCommandGivesTheSame(const std::string& options) {
        maps().saveTo(folder.file("window.gwy"));
        ASSERT_EQ(complaint(), "");
        ASSERT_TRUE(eventually([this] { return told().find("Saved as") != std::string::npos; }));
        const ProgramRun run = runProgram("map " + hills().string() + " --out " +
                                          folder.file("command.gwy").string() + " " + options);
        ASSERT_EQ(run.exitCode, 0) << run.output;
        for (const char* const end : {".gwy", ".vti", ".exr", "_1.png"}) {
            const std::string bytes = contentOf(folder.file(std::string("window") + end));
            EXPECT_FALSE(bytes.empty()) << end;
            EXPECT_EQ(bytes, contentOf(folder.file(std::string("command") + end))) << end;
        }
    }
};

TEST_F(ForceMap, IsTheMapOfTheCommandToTheByte) {
    typeRegion("20.3", "110.7", "33.1", "90");
    type("mapSetpoint", QStringLiteral("3.5"));
    map(9, 6);
    EXPECT_TRUE(
        page().state().startsWith(QStringLiteral("9 × 6 pixels, approach to 3.5 nN, model")))
        << page().state().toStdString();
    expectCommandGivesTheSame(
        "--region 20.3e-9,33.1e-9,110.7e-9,90e-9 --grid 9x6 --setpoint 3.5nN");
}

TEST_F(ForceMap, OfModeContactAndOfTheTruthLikewise) {
    child<QComboBox>("mapMode")->setCurrentIndex(1);
    child<QComboBox>("mapInstrument")->setCurrentIndex(1);
    map(12, 4);
    EXPECT_EQ(shownColors(), QStringLiteral("friction force"));
    expectCommandGivesTheSame("--mode contact --truth --grid 12x4");
}

TEST_F(ForceMap, ColorsTheSurfaceByAQuantity) {
    map(8, 8);
    EXPECT_EQ(shownColors(), QStringLiteral("adhesion force"));
    EXPECT_EQ(scan().colors().quantity, QStringLiteral("adhesion force"));
    EXPECT_EQ(scan().colors().unit, QStringLiteral("N"));
    auto* shown = child<QComboBox>("mapQuantity");
    EXPECT_EQ(shown->findText(QStringLiteral("validity flags")), -1) << "flags are no amounts";
    shown->setCurrentIndex(shown->findText(QStringLiteral("contact stiffness")));
    EXPECT_EQ(scan().colors().quantity, QStringLiteral("contact stiffness"));
    const MapValues values = maps().map()->valuesAt(3, 5);
    const Vector2 position = maps().map()->plan().position(3, 5);
    EXPECT_FLOAT_EQ(
        static_cast<float>(maps().layer()->at({position.x(), position.y(), 0.0}, Vector3::UnitZ())),
        static_cast<float>(values[MapQuantity::Stiffness]));
    panels.colors().choose({});
    EXPECT_EQ(shownColors(), QStringLiteral("height")) << "the user's choice";
}

TEST_F(ForceMap, AClickShowsThePixelsCurve) {
    map(8, 8);
    ASSERT_TRUE(button("pickPixel").isChecked());
    clickPixel(5, 2);
    EXPECT_TRUE(pixel().title().startsWith(QStringLiteral("Pixel 6, 3: x 88.00, y 88.00 nm")))
        << pixel().title().toStdString();
    const MapValues values = maps().map()->valuesAt(2, 5);
    const std::vector<DrawnCycle>& curves = pixel().plot().cycles();
    ASSERT_EQ(curves.size(), 1U);
    double pull = 0.0;
    for (const QPointF& point : curves.front().retract) {
        pull = std::max(pull, -point.y());
    }
    EXPECT_EQ(pull, values[MapQuantity::AdhesionForce]);
    ASSERT_TRUE(curves.front().pullOff && curves.front().snapIn);
    EXPECT_EQ(-curves.front().pullOff->y(), values[MapQuantity::PullOffForce]);
    EXPECT_EQ(curves.front().approach.back().x(), values[MapQuantity::Height]);
    EXPECT_EQ(pixel().reading(MapQuantity::AdhesionForce),
              shownValue(values[MapQuantity::AdhesionForce], QStringLiteral("N"), 4));
    child<QComboBox>("pixelAxis")->setCurrentIndex(1);
    EXPECT_GT(pixel().plot().cycles().front().approach.front().x(),
              curves.front().approach.back().x());
    const double before = window.findChild<QComboBox*>("mapQuantity")->currentIndex();
    press(Qt::Key_Escape);
    EXPECT_FALSE(button("pickPixel").isChecked()) << "Esc ends it";
    EXPECT_EQ(window.findChild<QComboBox*>("mapQuantity")->currentIndex(), before);
}

TEST_F(ForceMap, OfModeContactAClickSaysWhatTheCurveIs) {
    child<QComboBox>("mapMode")->setCurrentIndex(1);
    map(6, 3);
    clickPixel(2, 1);
    EXPECT_TRUE(pixel().title().contains(QStringLiteral("Mode contact has no curve")));
    EXPECT_EQ(pixel().plot().cycles().size(), 1U);
    EXPECT_EQ(
        pixel().reading(MapQuantity::HeightTrace),
        shownValue(maps().map()->valuesAt(1, 2)[MapQuantity::HeightTrace], QStringLiteral("m"), 4));
}

TEST_F(ForceMap, CanceledKeepsItsRows) {
    startLong();
    click("cancelMap");
    ASSERT_TRUE(ends());
    ASSERT_NE(maps().map(), nullptr);
    EXPECT_TRUE(page().state().contains(QStringLiteral("canceled: ")))
        << page().state().toStdString();
    const int rows = maps().map()->part().count();
    ASSERT_GT(rows, 0);
    ASSERT_LT(rows, 2000);
    EXPECT_TRUE(scan().hasGaps());
    EXPECT_TRUE(child<QWidget>("filledLegend")->isVisible());
    // The lower half of the scan holds no data: gray, which no color of the bar is.
    const QImage picture = scan().grab().toImage();
    const QPoint low = scan().toPixel({100e-9, 10e-9}).toPoint();  // beside the scale bar
    for (int x = -15; x <= 15; ++x) {
        EXPECT_LT(picture.pixelColor(low + QPoint(x, 0)).saturation(), 10) << x;
    }
    clickPixel(3, 1999);
    EXPECT_TRUE(pixel().title().contains(QStringLiteral("ended before this row")));
    EXPECT_EQ(pixel().reading(MapQuantity::AdhesionForce), QStringLiteral("–"));
}

TEST_F(ForceMap, EscAndTheBottomLineCancelIt) {
    map(3, 2);  // from then on a click picks pixels, which Esc ends, too
    startLong();
    press(Qt::Key_Escape);
    ASSERT_TRUE(ends());
    EXPECT_TRUE(page().state().contains(QStringLiteral("canceled: ")));
}

TEST_F(ForceMap, IsOfTheSceneThatItWasStartedWith) {
    map(8, 8);
    SceneDescription other = *stage.edits().wanted();
    other.sample.material.workOfAdhesion *= 0.5;
    stage.edits().change(QStringLiteral("half"), other);
    ASSERT_TRUE(changeEnds());
    EXPECT_TRUE(page().state().contains(QStringLiteral("has been changed since")))
        << page().state().toStdString();
    EXPECT_EQ(shownColors(), QStringLiteral("adhesion force, earlier scene"));
    const double before = maps().map()->valuesAt(2, 5)[MapQuantity::AdhesionForce];
    clickPixel(5, 2);
    double pull = 0.0;
    for (const QPointF& point : pixel().plot().cycles().front().retract) {
        pull = std::max(pull, -point.y());
    }
    EXPECT_EQ(pull, before) << "the curve is of the map's scene, too";
    stage.edits().undo();
    ASSERT_TRUE(eventually([this] { return shownColors() == QStringLiteral("adhesion force"); }));
    EXPECT_FALSE(page().state().contains(QStringLiteral("has been changed since")));
}

TEST_F(ForceMap, AChangeWhileItRunsIsNotInIt) {
    startLong();
    SceneDescription other = *stage.edits().wanted();
    other.sample.material.workOfAdhesion *= 0.5;
    stage.edits().change(QStringLiteral("half"), other);
    ASSERT_TRUE(changeEnds());
    click("cancelMap");
    ASSERT_TRUE(ends());
    ASSERT_NE(maps().map(), nullptr);
    EXPECT_NE(maps().map()->loaded().scene.description.sample.material.workOfAdhesion,
              other.sample.material.workOfAdhesion);
    EXPECT_EQ(shownColors(), QStringLiteral("adhesion force, earlier scene"));
}

TEST_F(ForceMap, GoesWithItsScan) {
    map(8, 8);
    open(levelScan(folder, 64));
    EXPECT_EQ(maps().map(), nullptr);
    EXPECT_EQ(shownColors(), QStringLiteral("height"));
    EXPECT_FALSE(button("saveMap").isEnabled());
    EXPECT_EQ(page().state(), QString());
    EXPECT_EQ(child<QComboBox>("mapQuantity")->count(), 0);
    EXPECT_EQ(page().form().request().grid, (MapGrid{64, 64}));
}

TEST_F(ForceMap, OfOnePixel) {
    map(1, 1);
    clickPixel(0, 0);
    EXPECT_EQ(pixel().plot().cycles().size(), 1U);
}

TEST_F(ForceMap, TellsHowLongItWillTake) {
    typePixels(100, 100);
    EXPECT_TRUE(eventually([this] {
        const std::string words = text("mapEstimate");
        return words.starts_with("10000 pixels: about ") ||
               words == "10000 pixels: less than a second";
    })) << text("mapEstimate");
}

TEST_F(ForceMap, ARectangleIsDrawnOnTheScan) {
    click("drawMapRegion");
    dragMouse(scan(), scan().toPixel({20e-9, 30e-9}), scan().toPixel({100e-9, 70e-9}));
    const MapRegion region = page().form().request().region.value();
    EXPECT_NEAR(region.left, 20e-9, 1e-9);
    EXPECT_NEAR(region.bottom, 30e-9, 1e-9);
    EXPECT_NEAR(region.right, 100e-9, 1e-9);
    EXPECT_NEAR(region.top, 70e-9, 1e-9);
    EXPECT_EQ(child<QComboBox>("mapArea")->currentText(), QStringLiteral("rectangle"));
}

TEST_F(ForceMap, ReplacesNoScanAndNoFileUnasked) {
    map(3, 3);
    maps().saveTo(hills());
    EXPECT_NE(complaint().find("the scene is made of this"), std::string::npos);
    maps().saveTo(folder.file("map.txt"));
    EXPECT_NE(complaint().find(".gwy"), std::string::npos);
    const std::filesystem::path kept = folder.write("other.vti", "mine");
    maps().saveTo(folder.file("other"));
    auto* question = window.findChild<QMessageBox*>("askWhether");
    ASSERT_NE(question, nullptr);
    question->reject();
    EXPECT_EQ(contentOf(kept), "mine");
    EXPECT_FALSE(std::filesystem::exists(folder.file("other.gwy")));
}

/// The window closes while a map runs: it ends with it, at once.
TEST_F(ForceMap, EndsWithTheWindow) { startLong(); }

}  // namespace
}  // namespace asperity::test
