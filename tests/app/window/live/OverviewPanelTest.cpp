#include "app/window/live/OverviewPanel.h"

#include "tests/ui/view/MapSamples.h"
#include "tests/ui/widgets/PanelSamples.h"
#include "ui/view/ColorScale.h"
#include "ui/view/OverviewMap.h"

#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

namespace asperity {
namespace {

void doubleClick(OverviewMap& map, const QPointF& pixel) {
    QTest::mouseDClick(&map, Qt::LeftButton, Qt::NoModifier, pixel.toPoint());
}

TEST(OverviewPanel, DoubleClickGivesThePlaceInMetersYUp) {
    OverviewPanel panel;
    panel.resize(480, 300);
    panel.setSurface(test::wideSurface());
    panel.grab();  // lays out
    const QRectF map = panel.map().mapRect();
    QSignalSpy chosen(&panel, &OverviewPanel::positionChosen);
    doubleClick(panel.map(), map.topLeft() + QPointF(0.25 * map.width(), 0.2 * map.height()));
    ASSERT_EQ(chosen.count(), 1);
    const double pixel = 256.0_nm / map.width();
    EXPECT_NEAR(chosen[0][0].toDouble(), 64.0_nm, pixel);
    EXPECT_NEAR(chosen[0][1].toDouble(), 0.8 * 128.0_nm, pixel);
}

TEST(OverviewPanel, ADoubleClickBesideTheScanOrWithAnotherButtonDoesNothing) {
    OverviewPanel panel;
    panel.resize(480, 300);
    QSignalSpy chosen(&panel, &OverviewPanel::positionChosen);
    panel.grab();
    doubleClick(panel.map(), {20.0, 20.0});
    EXPECT_EQ(chosen.count(), 0) << "no scan yet";
    panel.setSurface(test::wideSurface());
    const QRectF map = panel.map().mapRect();
    doubleClick(panel.map(), {map.center().x(), map.top() - 4.0});
    QTest::mouseDClick(&panel.map(), Qt::RightButton, Qt::NoModifier, map.center().toPoint());
    EXPECT_EQ(chosen.count(), 0);
}

TEST(OverviewPanel, ShowsTheScansSizeAndTheUnitOfItsHeights) {
    OverviewPanel panel;
    panel.setSurface(test::wideSurface());
    bool hasSize = false;
    for (const QLabel* label : panel.findChildren<QLabel*>()) {
        hasSize = hasSize || label->text() == QStringLiteral("256 × 128 nm");
    }
    EXPECT_TRUE(hasSize);
    EXPECT_EQ(panel.colorBar().heading(), QStringLiteral("height [nm]"));
}

TEST(OverviewPanel, SaysThatPartsOfTheScanAreFilledInOnlyWhereTheyAre) {
    OverviewPanel panel;
    const auto* legend = panel.findChild<QWidget*>(QStringLiteral("filledLegend"));
    ASSERT_NE(legend, nullptr);
    panel.setSurface(fitSurface(test::holedMap()));
    EXPECT_FALSE(legend->isHidden());
    panel.setSurface(fitSurface(test::hillyMap()));
    EXPECT_TRUE(legend->isHidden());
}

TEST(OverviewPanel, SaysWhatThereIsToSayOfTheScan) {
    OverviewPanel panel;
    panel.setScanNote(QStringLiteral("Contains the imaging tip's shape"), QStringLiteral("more"));
    EXPECT_EQ(test::textOf(panel, "scanNote"), QStringLiteral("Contains the imaging tip's shape"));
    EXPECT_EQ(panel.findChild<QLabel*>(QStringLiteral("scanNote"))->toolTip(),
              QStringLiteral("more"));
}

}  // namespace
}  // namespace asperity
