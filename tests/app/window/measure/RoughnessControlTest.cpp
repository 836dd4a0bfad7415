#include "app/window/measure/RoughnessControl.h"

#include "app/loading/SceneLoader.h"
#include "app/window/live/OverviewPanel.h"
#include "app/window/measure/MarkerControl.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/io/tables/CsvTable.h"
#include "tests/app/window/ControlFixture.h"
#include "tests/ui/widgets/MouseEvents.h"
#include "ui/view/OverviewMap.h"
#include "ui/widgets/PageParts.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QToolButton>

#include <filesystem>
#include <limits>

namespace asperity::test {
namespace {

/// Rows of 0 and 2 nm by turns; one pixel holds no data.
HeightMap stripedMap() {
    HeightMap map = flatMap();
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            map.heights[map.index(row, column)] = row % 2 == 0 ? 0.0 : 2e-9;
        }
    }
    map.heights[map.index(2, 2)] = std::numeric_limits<double>::quiet_NaN();
    return map;
}

class RoughnessControlTest : public ControlFixture {
protected:
    RoughnessControlTest() {
        SceneDescription description = plainScene();
        description.sample.leveling.clear();
        runs.use({.scene = buildScene(description, stripedMap()),
                  .format = "made for the test",
                  .sha256 = "",
                  .notes = {}});
        map().resize(256, 256);
    }
    OverviewMap& map() { return panels.overview().map(); }
    QString reading(const char* name) { return page().readings().text(name); }
    RoughnessPage& page() { return roughness.page(); }
    void look() {
        window.showTool(&page());
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    }

    MeasuredHeights& heights = stage.add<MeasuredHeights>();
    RoughnessControl& roughness = stage.add<RoughnessControl>();
};

TEST_F(RoughnessControlTest, IsComputedOnceSomebodyLooks) {
    roughness.refresh();
    EXPECT_EQ(reading("sa"), QStringLiteral("–"));
    look();
    ASSERT_TRUE(eventually([this] { return reading("sa") != QStringLiteral("–"); }));
    EXPECT_EQ(reading("sa"), QStringLiteral("1 nm"));
    EXPECT_EQ(reading("sq"), QStringLiteral("1 nm"));
    EXPECT_EQ(reading("sz"), QStringLiteral("2 nm"));
    const QString subject = page().subject();
    EXPECT_TRUE(subject.contains(QStringLiteral("Whole scan, 128 nm × 128 nm")))
        << subject.toStdString();
    EXPECT_TRUE(subject.contains(QStringLiteral("excluded: 1 without data")));
    EXPECT_TRUE(subject.contains(QStringLiteral("Leveling: none")));
    EXPECT_TRUE(subject.contains(QStringLiteral("Smoothing: none")));
    EXPECT_TRUE(subject.contains(QStringLiteral("Calibration: z ± 3 %, x and y ± 1 %")));
}

TEST_F(RoughnessControlTest, OfARectangleThatIsDrawn) {
    look();
    ASSERT_TRUE(eventually([this] { return reading("sa") != QStringLiteral("–"); }));
    page().findChild<QToolButton*>("drawRectangle")->click();
    dragMouse(map(), map().toPixel({20e-9, 20e-9}), map().toPixel({60e-9, 100e-9}));
    EXPECT_TRUE(
        eventually([this] { return page().subject().startsWith(QStringLiteral("Rectangle, ")); }));
    EXPECT_TRUE(page().subject().contains(QStringLiteral("excluded: 0 without data")))
        << page().subject().toStdString();
    page().findChild<QToolButton*>("wholeScan")->click();
    EXPECT_TRUE(
        eventually([this] { return page().subject().startsWith(QStringLiteral("Whole scan, ")); }));
}

TEST_F(RoughnessControlTest, NamesTheOtherParametersOfIso) {
    look();
    ASSERT_TRUE(eventually([this] { return reading("sa") != QStringLiteral("–"); }));
    EXPECT_EQ(reading("sku"), QStringLiteral("1"));
    EXPECT_NE(reading("sp"), QStringLiteral("–"));
    EXPECT_EQ(reading("str"), QStringLiteral("–"));  // rows go on to the border
    EXPECT_NE(reading("sdq"), QStringLiteral("–"));
}

/// The scene smooths the scan; the page measures the scan, and the smoothed one where it is asked.
TEST_F(RoughnessControlTest, IsOfTheScanAndNotOfItsSmoothedCopy) {
    const auto file = folder.file("stripes.gwy");
    writeHeightMap(file, stripedMap(), {.title = "Height"});
    runs.use(loadScene(file, {.leveling = LevelingSteps{}, .smoothingPixels = 1.0}));
    look();
    ASSERT_TRUE(eventually([this] { return reading("sq") == QStringLiteral("1 nm"); }))
        << page().subject().toStdString();
    EXPECT_TRUE(page().subject().contains(QStringLiteral("Smoothing: none")))
        << page().subject().toStdString();
    EXPECT_TRUE(page().subject().contains(QStringLiteral("excluded: 1 without data")));
    page().findChild<QCheckBox*>("measureSmoothed")->click();
    ASSERT_TRUE(eventually([this] { return page().subject().contains("Smoothing: Gaussian"); }))
        << page().subject().toStdString();
    EXPECT_NE(reading("sq"), QStringLiteral("1 nm"));
}

/// Heights that were read are read no more; those of another file are.
TEST_F(RoughnessControlTest, KeepsTheHeightsThatWereReadForTheirScanAlone) {
    const auto file = folder.file("stripes.gwy");
    writeHeightMap(file, stripedMap(), {.title = "Height"});
    const SceneOverrides overrides{.leveling = LevelingSteps{}, .smoothingPixels = 1.0};
    runs.use(loadScene(file, overrides));
    look();
    ASSERT_TRUE(eventually([this] { return reading("sq") == QStringLiteral("1 nm"); }));
    std::filesystem::remove(file);
    page().smoothed().click();
    ASSERT_TRUE(eventually([this] { return page().subject().contains("Smoothing: Gaussian"); }));
    page().smoothed().click();
    EXPECT_TRUE(eventually([this] { return reading("sq") == QStringLiteral("1 nm"); }));
    HeightMap higher = stripedMap();
    for (double& height : higher.heights) {
        height *= 3.0;
    }
    writeHeightMap(file, higher, {.title = "Height"});
    runs.use(loadScene(file, overrides));  // another file of the same name
    EXPECT_TRUE(eventually([this] { return reading("sq") == QStringLiteral("3 nm"); }))
        << reading("sq").toStdString();
    runs.use(
        loadScene(file, {.leveling = LevelingSteps{LevelingStep::Zero}, .smoothingPixels = 1.0}));
    EXPECT_TRUE(eventually([this] { return page().subject().contains("Leveling: zero"); }));
}

TEST_F(RoughnessControlTest, MarkersHaveTheHeightsOfTheSameChoice) {
    MarkerControl& markers = stage.add<MarkerControl>();
    const auto file = folder.file("stripes.gwy");
    writeHeightMap(file, stripedMap(), {.title = "Height"});
    runs.use(loadScene(file, {.leveling = LevelingSteps{}, .smoothingPixels = 1.0}));
    SceneDescription next = *edits.wanted();
    next.markers.push_back({"ridge", 21e-9, 21e-9});  // the middle of a pixel
    edits.change(QStringLiteral("Marker"), next);
    window.showTool(&markers.page());
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    const auto height = [&markers] {
        return markers.page().model().index(0, MarkerModel::Z).data().toString();
    };
    EXPECT_TRUE(eventually([&] { return height() == QStringLiteral("2.00"); }))
        << height().toStdString();
    page().smoothed().click();
    EXPECT_TRUE(markers.page().smoothed().isChecked());
    EXPECT_LT(height().toDouble(), 1.9);
    EXPECT_GT(height().toDouble(), 0.9) << "the mean of all stripes is 1";
}

TEST_F(RoughnessControlTest, SaysWhyTheScanCannotBeRead) {
    const auto file = folder.file("stripes.gwy");
    writeHeightMap(file, stripedMap(), {.title = "Height"});
    runs.use(loadScene(file, {.leveling = LevelingSteps{}, .smoothingPixels = 1.0}));
    std::filesystem::remove(file);
    look();
    const auto* state = page().findChild<QLabel*>("roughnessState");
    EXPECT_TRUE(eventually([&] { return state->text().contains("stripes.gwy"); }))
        << state->text().toStdString();
    EXPECT_FALSE(page().findChild<QToolButton*>("exportRoughness")->isEnabled());
}

TEST_F(RoughnessControlTest, DrawsHistogramAndSpectrumOfWhatItMeasures) {
    look();
    ASSERT_TRUE(eventually([this] { return reading("sa") != QStringLiteral("–"); }));
    const QString histogram = page().histogram().table().tabSeparated();
    EXPECT_TRUE(histogram.startsWith("height [m]\tshare of the area\n")) << histogram.toStdString();
    EXPECT_EQ(histogram.count('\n'), 129);
    auto* curves = page().findChild<QComboBox*>("roughnessCurve");
    EXPECT_TRUE(page().histogram().isVisible());
    curves->setFocus();
    QTest::keyClick(curves, Qt::Key_Down);
    EXPECT_TRUE(page().spectrum().isVisible());
    const QString powers = page().spectrum().table().tabSeparated();
    EXPECT_TRUE(powers.startsWith("frequency [1/m]\tpower spectral density [m^4]\n"));
    EXPECT_GT(powers.count('\n'), 32);
}

TEST_F(RoughnessControlTest, WritesNumbersHistogramAndSpectrum) {
    using Table = RoughnessPage::Table;
    look();
    ASSERT_TRUE(eventually([this] { return reading("sa") != QStringLiteral("–"); }));
    const auto written = [this](Table table) {
        const auto file = folder.file("table.csv");
        roughness.writeTo(file, table);
        EXPECT_EQ(told(), "Saved as " + file.string());
        return readCsv(file);
    };
    const CsvTable numbers = written(Table::Numbers);
    ASSERT_EQ(numbers.rows(), 1U);
    EXPECT_NEAR(numbers.number(0, "Sq_m"), 1e-9, 1e-12);
    const CsvTable histogram = written(Table::Histogram);
    EXPECT_EQ(histogram.rows(), 128U);
    EXPECT_EQ(histogram.number(0, "share_above"), 1.0);
    const CsvTable spectrum = written(Table::Spectrum);
    double sum = 0.0;
    for (std::size_t i = 0; i < spectrum.rows(); ++i) {
        sum += spectrum.number(i, "psd_m4") * spectrum.number(i, "waves");
    }
    EXPECT_NEAR(sum / (128e-9 * 128e-9), 1e-18, 1e-21);
}

}  // namespace
}  // namespace asperity::test
