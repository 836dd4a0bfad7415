#include "app/window/measure/ProfileControl.h"

#include "app/loading/SceneLoader.h"
#include "app/window/live/OverviewPanel.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/io/tables/CsvTable.h"
#include "core/surface/fit/BSplineFit.h"
#include "tests/app/window/ControlFixture.h"
#include "tests/support/PixelCount.h"
#include "tests/ui/widgets/MouseEvents.h"
#include "ui/view/OverviewMap.h"
#include "ui/widgets/PageParts.h"
#include "ui/widgets/Theme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QLabel>
#include <QSpinBox>
#include <QToolButton>

#include <cmath>
#include <limits>

namespace asperity::test {
namespace {

class ProfileControlTest : public ControlFixture {
protected:
    ProfileControlTest() {
        useFlatScene();
        map().resize(256, 256);
    }
    OverviewMap& map() { return panels.overview().map(); }
    ProfilePage& page() { return profile.page(); }
    /// Between two positions [nm].
    void draw(double x1, double y1, double x2, double y2) {
        page().setDrawing(true);
        dragMouse(map(), map().toPixel({1e-9 * x1, 1e-9 * y1}),
                  map().toPixel({1e-9 * x2, 1e-9 * y2}));
    }

    /// Of the selected line, to a tenth [nm].
    double lengthShown() {
        const QString text = page().readings().text("profileLength");
        return 0.1 * std::round(10.0 * text.section(' ', 0, 0).toDouble());
    }

    MeasuredHeights& heights = stage.add<MeasuredHeights>();
    ProfileControl& profile = stage.add<ProfileControl>();
};

TEST_F(ProfileControlTest, SamplesTheLineThatIsDrawn) {
    EXPECT_EQ(page().readings().text("profileLength"), QStringLiteral("–"));
    draw(20, 30, 100, 30);
    EXPECT_TRUE(page().readings().text("profileLength").startsWith(QStringLiteral("8")))
        << page().readings().text("profileLength").toStdString();
    EXPECT_EQ(page().readings().text("cursorRise"), QStringLiteral("0 pm")) << "the scan is level";
    EXPECT_EQ(page().readings().text("cursorAngle"), QStringLiteral("0.00°"));
    EXPECT_EQ(page().findChild<QLabel*>("profileState")->text(), QStringLiteral("Smoothing: none"));
    page().findChild<QToolButton*>("removeProfile")->click();
    EXPECT_EQ(page().readings().text("profileLength"), QStringLiteral("–"));
}

TEST_F(ProfileControlTest, ItsLineIsBackAfterARecordingOfAnotherScan) {
    draw(20, 30, 100, 30);
    const QString length = page().readings().text("profileLength");
    showRecordingOfOtherScan();
    EXPECT_EQ(page().readings().text("profileLength"), QStringLiteral("–"));
    runs.showLive();
    EXPECT_EQ(page().readings().text("profileLength"), length);
}

TEST_F(ProfileControlTest, TheSwitchShowsWhetherItsToolIsActive) {
    auto* drawing = page().findChild<QToolButton*>("drawProfile");
    drawing->click();
    EXPECT_NE(map().activeTool(), nullptr);
    map().activate(nullptr);
    EXPECT_FALSE(drawing->isChecked());
    drawing->click();
    drawing->click();
    EXPECT_EQ(map().activeTool(), nullptr);
}

TEST_F(ProfileControlTest, ItsCursorsAndStretchesCanBeDragged) {
    draw(20, 30, 100, 30);
    page().resize(700, 260);
    page().grab();                      // lays out
    QCoreApplication::processEvents();  // the plot positions its axes anew once it has its size
    ProfilePlot& plot = page().plot();
    const double length = 80e-9;
    dragMouse(plot.canvas(), {plot.pixelOf(0.0) + 1.0, 40.0}, {plot.pixelOf(0.25 * length), 40.0});
    EXPECT_NEAR(page().stops().front(), 0.25, 0.02);
    const QString distance = page().readings().text("cursorDistance");
    EXPECT_NEAR(distance.section(' ', 0, 0).toDouble(), 60.0, 1.6) << distance.toStdString();
    EXPECT_TRUE(distance.endsWith(QStringLiteral(" nm"))) << distance.toStdString();
    EXPECT_EQ(page().readings().text("stepReading"), QStringLiteral("–"));
    page().findChild<QCheckBox*>("stepHeight")->click();
    EXPECT_EQ(page().readings().text("stepReading"), QStringLiteral("0 ± 0 pm"));
}

TEST_F(ProfileControlTest, DrawsSeveralLinesAndShowsTheNumbersOfTheSelectedOne) {
    const QColor orange = toQColor(kLightPalette.orange);
    const auto orangePixels = [&] { return pixelsLike(map().grab().toImage(), orange); };
    draw(20, 30, 100, 30);
    const int without = orangePixels();
    page().findChild<QToolButton*>("addProfile")->click();
    EXPECT_EQ(page().readings().text("profileLength"), QStringLiteral("–")) << "none is selected";
    draw(20, 60, 60, 60);
    auto* lines = page().findChild<QComboBox*>("profileLines");
    ASSERT_EQ(lines->count(), 2);
    EXPECT_EQ(lines->currentText(), QStringLiteral("Line 2"));
    EXPECT_EQ(lengthShown(), 40.0);
    EXPECT_GT(orangePixels(), without + 20);
    lines->setFocus();
    QTest::keyClick(lines, Qt::Key_Up);
    EXPECT_EQ(lengthShown(), 80.0);
    draw(60, 60, 60, 100);  // on the other line: a drag from its end selects and changes that
    EXPECT_EQ(lines->currentText(), QStringLiteral("Line 2"));
    EXPECT_NEAR(lengthShown(), 56.6, 1.5);
    page().findChild<QToolButton*>("removeProfile")->click();
    EXPECT_EQ(lines->count(), 1);
    EXPECT_EQ(lengthShown(), 80.0);
    EXPECT_LE(orangePixels(), without);
    useFlatScene();
    EXPECT_EQ(lines->count(), 1) << "the scan is the same";
}

TEST_F(ProfileControlTest, DrawsAtMostAsManyLinesAsThereAreColors) {
    auto* add = page().findChild<QToolButton*>("addProfile");
    for (int line = 0; line < 6; ++line) {
        add->click();
        draw(20, 10 + 15 * line, 100, 10 + 15 * line);
    }
    EXPECT_EQ(page().findChild<QComboBox*>("profileLines")->count(), 6);
    EXPECT_FALSE(add->isEnabled());
}

TEST_F(ProfileControlTest, WritesAllProfilesWithTheirHeights) {
    draw(20, 30, 100, 30);
    page().findChild<QToolButton*>("addProfile")->click();
    draw(20, 60, 60, 60);
    const auto file = folder.file("profiles.csv");
    profile.writeTo(file);
    EXPECT_EQ(told(), "Saved as " + file.string());
    const CsvTable table = readCsv(file);
    EXPECT_EQ(table.columns(),
              (std::vector<std::string>{"profile", "distance_m", "x_m", "y_m", "z_m"}));
    EXPECT_EQ(table.text(0, "profile"), "Line 1");
    EXPECT_EQ(table.text(table.rows() - 1, "profile"), "Line 2");
    EXPECT_NEAR(table.number(table.rows() - 1, "distance_m"), 40e-9, 0.5e-9);
    EXPECT_EQ(table.number(0, "z_m"), 0.0);
    profile.writeTo(folder.file("no such folder") / "profiles.csv");
    EXPECT_NE(complaint().find("no such folder"), std::string::npos);
}

/// The scene smooths its scan: the profile is of the scan, and of the surface where that is chosen,
/// by the boxes of all pages.
TEST_F(ProfileControlTest, IsOfTheScanAndNotOfItsSmoothedCopy) {
    const auto file = folder.file("stripes.gwy");
    HeightMap stripes = flatMap();
    for (std::size_t i = 0; i < stripes.heights.size(); ++i) {
        stripes.heights[i] = i / static_cast<std::size_t>(stripes.columns) % 2 == 0 ? 0.0 : 2e-9;
    }
    writeHeightMap(file, stripes, {.title = "Height"});
    runs.use(loadScene(file, {.leveling = LevelingSteps{}, .smoothingPixels = 1.0}));
    draw(21, 21, 21, 35);  // from the middle of a row of 2 nm to that of one of 0 nm
    ASSERT_TRUE(eventually([this] { return page().readings().text("cursorRise") != "–"; }))
        << page().findChild<QLabel*>("profileState")->text().toStdString();
    const QString exact = page().readings().text("cursorRise");
    EXPECT_GT(std::abs(exact.section(' ', 0, 0).toDouble()), 1.8) << exact.toStdString();
    EXPECT_TRUE(page().findChild<QLabel*>("profileState")->text().contains("Smoothing: none; "));
    QCheckBox& box = page().smoothed();
    box.click();
    EXPECT_TRUE(heights.scan()->smoothing().startsWith("Gaussian"));
    EXPECT_NE(page().readings().text("cursorRise"), exact);
    EXPECT_TRUE(page().findChild<QLabel*>("profileState")->text().contains("Smoothing: Gaussian"));
    box.click();
    EXPECT_EQ(page().readings().text("cursorRise"), exact) << "what was read is kept";
}

/// Steps of 4 nm up at x = 64 nm, with a ridge of one row and a hole.
HeightMap steppedMap() {
    HeightMap map = flatMap();
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            double& height = map.heights[map.index(row, column)];
            height = column < 32 ? 0.0 : 4e-9;
            height += row == 20 ? 3e-9 : 0.0;
        }
    }
    return map;
}

TEST(MeanProfile, IsTheMeanOfTheLinesBesideOneAnother) {
    const BSplineSurface fitted = fitSurface(steppedMap());
    const HeightField surface = fieldOf(fitted);
    // Pixels are 2 nm; row 20 from the top has its middle at y = 87 nm.
    const QLineF onRidge(10e-9, 87e-9, 50e-9, 87e-9);
    const Profile one = meanProfile(surface, onRidge, 1);
    EXPECT_NEAR(one.heights.front(), 3e-9, 1e-14);
    const Profile three = meanProfile(surface, onRidge, 3);
    EXPECT_NEAR(three.heights.front(), 1e-9, 1e-14);
    EXPECT_EQ(one.heights.size(), three.heights.size());
    EXPECT_NEAR(three.length(), 40e-9, 1e-20);
}

TEST(MeanProfile, LeavesOutWhatHoldsNoData) {
    HeightMap map = steppedMap();
    for (int column = 0; column < 12; ++column) {
        map.heights[map.index(21, column)] = std::numeric_limits<double>::quiet_NaN();
    }
    const BSplineSurface fitted = fitSurface(map);
    const HeightField surface = fieldOf(fitted);
    const QLineF beside(9e-9, 85e-9, 61e-9, 85e-9);  // along row 21
    EXPECT_TRUE(std::isnan(meanProfile(surface, beside, 1).heights.front()));
    EXPECT_FALSE(std::isnan(meanProfile(surface, beside, 1).heights.back()));
    EXPECT_FALSE(std::isnan(meanProfile(surface, beside, 3).heights.front()));
}

}  // namespace
}  // namespace asperity::test
