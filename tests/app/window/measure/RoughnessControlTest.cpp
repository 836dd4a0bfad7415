#include "app/window/measure/RoughnessControl.h"

#include "app/loading/SceneLoader.h"
#include "app/window/live/OverviewPanel.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "tests/app/window/ControlFixture.h"
#include "tests/ui/widgets/MouseEvents.h"
#include "ui/view/OverviewMap.h"
#include "ui/widgets/PageParts.h"

#include <QCheckBox>
#include <QToolButton>

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

}  // namespace
}  // namespace asperity::test
