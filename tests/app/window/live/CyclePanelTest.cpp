#include "app/window/live/CyclePanel.h"

#include "app/window/live/CycleTable.h"
#include "core/scene/Scene.h"
#include "tests/core/haptics/cycle/SpringContact.h"
#include "tests/support/TestScenes.h"
#include "tests/ui/widgets/MouseEvents.h"
#include "tests/ui/widgets/PanelSamples.h"
#include "ui/widgets/Theme.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSignalSpy>
#include <QToolButton>
#include <QtTest>

#include <gtest/gtest.h>

namespace asperity {
namespace {

using test::SpringContact;

/// The panel with a contact that it watches.
struct CyclePanelTest : ::testing::Test {
    void SetUp() override { panel.begin(QStringLiteral("polystyrene")); }

    void cycles(int count) {
        for (int i = 0; i < count; ++i) {
            move(-2e-9);
            move(4e-9);
        }
        panel.refresh();
    }
    void move(double distance) {
        run.onTick = [this] { panel.take(run.sample); };
        run.moveTo(distance);
    }
    void changeMaterial(const char* name) {
        panel.end();
        panel.begin(QString::fromUtf8(name));
        run = SpringContact(SpringContact::kSigma);
    }
    [[nodiscard]] QString materials() const {
        QStringList names;
        for (int row = 0; row < panel.table().rows(); ++row) {
            names << panel.table().text(row, CycleTable::Material);
        }
        return names.join(QStringLiteral(", "));
    }

    CyclePanel panel;
    SpringContact run{SpringContact::kSigma};
};

TEST_F(CyclePanelTest, ReadsOutTheCycleWithUnits) {
    cycles(1);
    const CycleTable& table = panel.table();
    ASSERT_EQ(table.rows(), 1);
    EXPECT_EQ(table.text(0, CycleTable::Material), QStringLiteral("polystyrene"));
    EXPECT_TRUE(table.text(0, CycleTable::PullOff).endsWith(QStringLiteral(" nN")));
    EXPECT_NEAR(table.text(0, CycleTable::PullOff).split(' ').front().toDouble(), 5.0, 0.2);
    EXPECT_TRUE(table.text(0, CycleTable::Work).endsWith(QStringLiteral(" aJ")));
    EXPECT_NEAR(table.text(0, CycleTable::Work).split(' ').front().toDouble(),
                1e18 * SpringContact::kWork, 0.1);
    EXPECT_TRUE(table.text(0, CycleTable::Stiffness).endsWith(QStringLiteral(" N/m")));
    EXPECT_TRUE(table.details(0).contains(QStringLiteral("±")));
}

/// Of an earlier scene they stay.
TEST_F(CyclePanelTest, ToolTipsSayWhatModelAndCalibrationLeaveOpen) {
    const Scene scene = buildScene(test::plainScene(), test::flatMap());
    panel.begin(QStringLiteral("polystyrene"), &scene);
    cycles(1);
    const auto saysBoth = [this] {
        const QString text = panel.table().details(0);
        return text.contains(QStringLiteral("(noise) ± ")) && text.contains(QStringLiteral("(k)"));
    };
    EXPECT_TRUE(saysBoth()) << panel.table().details(0).toStdString();
    const ShownNumbers numbers = panel.table().numbers();
    ASSERT_FALSE(numbers.empty());
    EXPECT_GT(numbers.front().modelSigma.value_or(0.0), 0.05 * numbers.front().value);
    panel.clear();
    cycles(1);
    EXPECT_TRUE(saysBoth()) << "the run goes on";
    changeMaterial("rubber");
    EXPECT_TRUE(saysBoth()) << panel.table().details(0).toStdString();
}

TEST_F(CyclePanelTest, AnOpenCycleHasNoAreaYet) {
    move(-2e-9);
    panel.refresh();
    EXPECT_EQ(panel.table().text(0, CycleTable::PullOff), QStringLiteral("–"));
    EXPECT_EQ(panel.table().text(0, CycleTable::Hysteresis), QStringLiteral("–"));
}

TEST_F(CyclePanelTest, AnAreaThatIsNoneIsNotShown) {
    CycleTable table;
    CycleRow row{.material = {}, .cycle = {.phase = CyclePhase::Complete, .hysteresis = -3e-13}};
    table.setRows({row});
    EXPECT_EQ(table.text(0, CycleTable::Hysteresis), QStringLiteral("–"));
    row.cycle.hysteresis = 2.04e-12;
    row.cycle.areaSigma = 1e-14;
    table.setRows({row});
    EXPECT_EQ(table.text(0, CycleTable::Hysteresis), QStringLiteral("2.04 pJ"));
    EXPECT_TRUE(table.details(0).contains(QStringLiteral("2.04 pJ ± 0.01 (noise)")))
        << table.details(0).toStdString();
    row.cycle.fromStart = true;
    table.setRows({row});
    EXPECT_EQ(table.text(0, CycleTable::Hysteresis), QStringLiteral("–")) << "no approach";
}

/// While the tip is pulled, the strongest pull so far is no pull-off.
TEST_F(CyclePanelTest, ThereIsNoPullOffBeforeTheTipIsOff) {
    move(-2e-9);
    move(0.3e-9);
    panel.refresh();
    ASSERT_LT(run.sample.output.estimate.force.z(), -1e-9) << "it is pulled";
    const CycleTable& table = panel.table();
    EXPECT_EQ(table.text(0, CycleTable::PullOff), QStringLiteral("–"));
    EXPECT_EQ(table.text(0, CycleTable::Work), QStringLiteral("–"));
    EXPECT_TRUE(table.details(0).contains(QStringLiteral("strongest pull so far")));
    for (const ShownNumber& number : table.numbers()) {
        EXPECT_FALSE(number.name.contains(QStringLiteral("pull-off"))) << "copied";
    }
    move(4e-9);
    panel.refresh();
    EXPECT_NE(table.text(0, CycleTable::PullOff), QStringLiteral("–"));
    EXPECT_FALSE(table.details(0).contains(QStringLiteral("strongest pull so far")));
}

TEST_F(CyclePanelTest, EveryNumberHasThreeDigitsInTheUnitOfItsColumn) {
    CycleTable table;
    CycleRow rubber{.material = {}, .cycle = {.phase = CyclePhase::Complete}};
    rubber.cycle.pullOff = Reading{751e-12, 1e-12};
    rubber.cycle.adhesionWork = 15.04e-18;
    rubber.cycle.hysteresis = 14.7e-18;
    rubber.cycle.stiffness = Reading{0.0405, 1e-4};
    table.setRows({rubber});
    EXPECT_EQ(table.text(0, CycleTable::PullOff), QStringLiteral("751 pN"));
    EXPECT_EQ(table.text(0, CycleTable::Work), QStringLiteral("15.0 aJ"));
    EXPECT_EQ(table.text(0, CycleTable::Stiffness), QStringLiteral("40.5 mN/m"));
    CycleRow oxide = rubber;
    oxide.cycle.pullOff = Reading{5.025e-9, 1e-12};
    oxide.cycle.stiffness = Reading{57.3, 0.1};
    table.setRows({oxide, rubber});
    EXPECT_EQ(table.text(1, CycleTable::PullOff), QStringLiteral("0.751 nN")) << "they compare";
    EXPECT_EQ(table.text(1, CycleTable::Stiffness), QStringLiteral("40.5 mN/m"))
        << "0.0405 N/m is no number to read";
    EXPECT_EQ(table.text(0, CycleTable::Stiffness), QStringLiteral("57.3 N/m"));
}

TEST_F(CyclePanelTest, TwoCyclesShowOnTheSmallestScreen) {
    CycleTable table;
    table.setRows({CycleRow(), CycleRow()});
    EXPECT_EQ(table.minimumSizeHint().height(), 3 * table.fontMetrics().height());
}

TEST_F(CyclePanelTest, CyclesStayOverAChangeOfMaterial) {
    cycles(2);
    changeMaterial("silicon oxide");
    panel.refresh();
    EXPECT_EQ(materials(), QStringLiteral("polystyrene, polystyrene"));
    cycles(1);
    EXPECT_EQ(materials(), QStringLiteral("silicon oxide, polystyrene, polystyrene"));
}

/// Behind those of a recording.
TEST_F(CyclePanelTest, CyclesComeBackAsTheyWere) {
    cycles(2);
    const QString before = materials();
    const auto drawn = panel.plot().cycles().size();
    const std::function<void()> bringBack = panel.keptCycles();
    changeMaterial("gold");
    panel.restart();
    cycles(1);
    EXPECT_EQ(materials(), QStringLiteral("gold"));
    changeMaterial("polystyrene");
    bringBack();
    EXPECT_EQ(materials(), before);
    EXPECT_EQ(panel.plot().cycles().size(), drawn);
    cycles(1);
    EXPECT_EQ(panel.plot().cycles().size(), drawn + 1) << "the run goes on";
}

TEST_F(CyclePanelTest, ManyCyclesOfOneMaterialDoNotDriveTheOtherAway) {
    cycles(1);
    changeMaterial("silicon oxide");
    cycles(6);
    EXPECT_EQ(panel.table().rows(), ForceDistancePlot::kMaxCycles);
    EXPECT_TRUE(materials().endsWith(QStringLiteral("polystyrene")));
}

TEST_F(CyclePanelTest, HoveringKeepsNothing) {
    for (int i = 0; i < 3; ++i) {
        move(2e-9);
        move(4e-9);
    }
    changeMaterial("silicon oxide");
    panel.refresh();
    EXPECT_EQ(panel.table().rows(), 0);
}

TEST_F(CyclePanelTest, ClearForgetsAllButACycleInContact) {
    cycles(3);
    panel.findChild<QToolButton*>(QStringLiteral("clearCycles"))->click();
    EXPECT_EQ(panel.table().rows(), 0);
    cycles(1);
    move(-1e-9);
    panel.findChild<QToolButton*>(QStringLiteral("clearCycles"))->click();
    EXPECT_EQ(panel.table().rows(), 1);
}

TEST_F(CyclePanelTest, TheDistanceIsTheSeparationOrTheBases) {
    cycles(1);
    const double separation = panel.plot().distanceRange().low;
    EXPECT_LT(separation, 0.0) << "indented";
    panel.findChild<QComboBox*>(QStringLiteral("distanceAxis"))->setCurrentIndex(1);
    EXPECT_LE(panel.plot().distanceRange().low, -2e-9);
    EXPECT_GT(separation, panel.plot().distanceRange().low) << "the lever is bent";
}

TEST_F(CyclePanelTest, AFarApproachDoesNotSqueezeTheContact) {
    move(300e-9);
    cycles(1);
    move(300e-9);
    panel.refresh();
    EXPECT_LT(panel.plot().distanceRange().high, 3e-9);
    EXPECT_LE(panel.plot().forceRange().low, -SpringContact::kPull);
}

TEST_F(CyclePanelTest, BranchesHaveTheirColorsAndOlderOnesAreFainter) {
    panel.resize(370, 220);
    move(-4e-9);
    move(4e-9);
    panel.refresh();
    const QImage first = panel.grab().toImage();
    EXPECT_GT(test::pixelsLike(first, branchColors(0).approach), 60);
    EXPECT_GT(test::pixelsLike(first, branchColors(0).retract), 60);
    cycles(1);  // not as deep: the first one shows beyond it
    const QImage both = panel.grab().toImage();
    EXPECT_GT(test::pixelsLike(both, branchColors(1).retract),
              test::pixelsLike(first, branchColors(1).retract) + 20);
}

TEST_F(CyclePanelTest, AClickOnARowHidesItsCurves) {
    panel.resize(370, 240);
    cycles(1);
    const QImage shown = panel.plot().grab().toImage();
    auto* table = panel.findChild<CycleTable*>();
    const QPoint row(20, 3 * table->fontMetrics().height() / 2);
    QSignalSpy clicked(table, &CycleTable::rowClicked);
    QTest::mouseClick(table, Qt::LeftButton, Qt::NoModifier, row);
    ASSERT_EQ(clicked.count(), 1);
    const QImage hidden = panel.plot().grab().toImage();
    EXPECT_LT(test::pixelsLike(hidden, branchColors(0).retract),
              test::pixelsLike(shown, branchColors(0).retract) / 2);
    EXPECT_EQ(panel.table().rows(), 1) << "its row stays";
    QTest::mouseClick(table, Qt::LeftButton, Qt::NoModifier, row);
    EXPECT_GT(test::pixelsLike(panel.plot().grab().toImage(), branchColors(0).retract),
              test::pixelsLike(shown, branchColors(0).retract) / 2);
}

TEST_F(CyclePanelTest, PauseFreezesThePictureAndCyclesAreKeptOn) {
    panel.resize(370, 240);
    cycles(1);
    panel.setPaused(true);
    panel.grab();  // lays out
    panel.refresh();
    const QImage before = panel.plot().canvas().grab().toImage();
    cycles(1);
    EXPECT_EQ(panel.plot().canvas().grab().toImage(), before);
    EXPECT_EQ(panel.table().rows(), 1);
    panel.setPaused(false);
    EXPECT_EQ(panel.table().rows(), 2);
}

TEST_F(CyclePanelTest, TheCursorReadsDistanceAndBothBranches) {
    panel.resize(370, 240);
    cycles(1);
    panel.grab();  // lays out
    QWidget& canvas = panel.plot().canvas();
    const AxisRange& range = panel.plot().distanceRange();
    // In contact, where both branches are.
    const double distance = 0.5 * range.low;
    const double pixel = (distance - range.low) / (range.high - range.low) * canvas.width();
    test::sendMouse(canvas, QEvent::MouseMove, {pixel, 20.0}, Qt::NoButton);
    const QString reading = panel.plot().reading();
    EXPECT_TRUE(reading.contains(QStringLiteral("nm"))) << reading.toStdString();
    EXPECT_TRUE(reading.contains(QStringLiteral("approach "))) << reading.toStdString();
    EXPECT_TRUE(reading.contains(QStringLiteral("retract "))) << reading.toStdString();
    EXPECT_TRUE(reading.contains(QStringLiteral(" nN"))) << reading.toStdString();
}

/// Pixels of a measured curve, which is gray where those of the cycles have colors.
int grayPixels(const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor pixel = image.pixelColor(x, y);
            count += pixel.saturation() < 80 && pixel.value() < 190 ? 1 : 0;
        }
    }
    return count;
}

TEST_F(CyclePanelTest, AMeasuredCurveIsDrawnOverThemMovedAndTakenAway) {
    panel.resize(370, 260);
    cycles(1);
    const int without = grayPixels(panel.plot().canvas().grab().toImage());
    MeasuredCurve curve{.name = QStringLiteral("lever 7.csv"), .details = QStringLiteral("how")};
    for (int i = 0; i < 200; ++i) {
        const QPointF point(-2e-9 + 0.03e-9 * i, i < 100 ? 15e-9 - 0.2e-9 * i : 0.0);
        curve.approach.overSeparation << point;
        curve.approach.overBase << point;
    }
    curve.contact = {-2e-9, 1e-9};
    panel.setMeasured(curve);
    const QImage drawn = panel.plot().grab().toImage();
    EXPECT_GT(grayPixels(panel.plot().canvas().grab().toImage()), without + 40);
    EXPECT_FALSE(panel.findChild<QWidget*>(QStringLiteral("measuredName"))->isHidden());
    EXPECT_EQ(panel.findChild<QWidget*>(QStringLiteral("measuredName"))->toolTip(),
              QStringLiteral("how"));
    auto* offset = panel.findChild<QDoubleSpinBox*>(QStringLiteral("measuredOffset"));
    offset->setValue(0.5);
    EXPECT_NE(panel.plot().grab().toImage(), drawn);
    panel.findChild<QToolButton*>(QStringLiteral("removeMeasured"))->click();
    EXPECT_FALSE(panel.measured());
    EXPECT_LT(grayPixels(panel.plot().canvas().grab().toImage()), without + 10);
}

TEST_F(CyclePanelTest, FitsTheColumnOfASmallWindow) {
    EXPECT_LE(panel.minimumSizeHint().width(), 350);
    EXPECT_LE(panel.minimumSizeHint().height(), 130);
}

}  // namespace
}  // namespace asperity
