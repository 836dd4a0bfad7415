#include "ui/panels/OverviewPanel.h"

#include "core/Units.h"
#include "core/surface/fit/BSplineFit.h"
#include "tests/support/TestScenes.h"
#include "tests/ui/MouseEvents.h"
#include "tests/ui/panels/PanelSamples.h"
#include "ui/Theme.h"
#include "ui/panels/AxisTicks.h"
#include "ui/panels/ColorBarWidget.h"
#include "ui/panels/MapTool.h"
#include "ui/panels/OverviewMap.h"

#include <QPainter>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {
namespace {

ReliefImage reliefImage(const BSplineSurface& surface) {
    ReliefImage relief;
    relief.setSurface(surface);
    return relief;
}

/// Level but for one hill near the upper left corner; twice as wide as high.
BSplineSurface wideSurface() {
    HeightMap map{.columns = 128, .rows = 64, .pitchX = 2.0_nm, .pitchY = 2.0_nm};
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            const double distance = std::hypot(column - 16.0, row - 12.0);
            map.heights.push_back(10.0_nm * std::exp(-distance * distance / 40.0));
        }
    }
    return fitSurface(map);
}

/// Hills with the first rows and part of the left half without data.
HeightMap holedMap() {
    HeightMap map = test::hillyMap();
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            if (row < 4 || (column < 20 && row > 20 && row < 40)) {
                map.heights[map.index(row, column)] = std::numeric_limits<double>::quiet_NaN();
            }
        }
    }
    return map;
}

void doubleClick(OverviewMap& map, const QPointF& pixel) {
    QTest::mouseDClick(&map, Qt::LeftButton, Qt::NoModifier, pixel.toPoint());
}

TEST(OverviewPanel, DoubleClickGivesThePlaceInMetersYUp) {
    OverviewPanel panel;
    panel.resize(480, 300);
    panel.setSurface(wideSurface());
    panel.grab();  // lays out
    const QRectF map = panel.map().mapRect();
    QSignalSpy chosen(&panel, &OverviewPanel::placeChosen);
    doubleClick(panel.map(), map.topLeft() + QPointF(0.25 * map.width(), 0.2 * map.height()));
    ASSERT_EQ(chosen.count(), 1);
    const double pixel = 256.0_nm / map.width();
    EXPECT_NEAR(chosen[0][0].toDouble(), 64.0_nm, pixel);
    EXPECT_NEAR(chosen[0][1].toDouble(), 0.8 * 128.0_nm, pixel);
}

TEST(OverviewPanel, ADoubleClickBesideTheScanOrWithAnotherButtonDoesNothing) {
    OverviewPanel panel;
    panel.resize(480, 300);
    QSignalSpy chosen(&panel, &OverviewPanel::placeChosen);
    panel.grab();
    doubleClick(panel.map(), {20.0, 20.0});
    EXPECT_EQ(chosen.count(), 0) << "no scan yet";
    panel.setSurface(wideSurface());
    const QRectF map = panel.map().mapRect();
    doubleClick(panel.map(), {map.center().x(), map.top() - 4.0});
    QTest::mouseDClick(&panel.map(), Qt::RightButton, Qt::NoModifier, map.center().toPoint());
    EXPECT_EQ(chosen.count(), 0);
}

TEST(OverviewPanel, ShowsTheScansSizeAndTheUnitOfItsHeights) {
    OverviewPanel panel;
    panel.setSurface(wideSurface());
    bool hasSize = false;
    for (const QLabel* label : panel.findChildren<QLabel*>()) {
        hasSize = hasSize || label->text() == QStringLiteral("256 × 128 nm");
    }
    EXPECT_TRUE(hasSize);
    EXPECT_EQ(panel.colorBar().heading(), QStringLiteral("height [nm]"));
}

TEST(OverviewMap, KeepsTheAspectRatioAndStaysInside) {
    OverviewMap map;
    map.setSurface(wideSurface());
    for (const QSize& size : {QSize(300, 300), QSize(400, 120), QSize(137, 211)}) {
        map.resize(size);
        const QRectF drawn = map.mapRect();
        EXPECT_NEAR(drawn.width() / drawn.height(), 2.0, 0.05);
        EXPECT_TRUE(QRectF(map.rect()).contains(drawn));
    }
}

TEST(OverviewMap, PlacesAndPixelsAreInverse) {
    OverviewMap map;
    map.resize(300, 200);
    map.setSurface(wideSurface());
    const QPointF place(37.0_nm, 101.0_nm);
    const QPointF back = map.toPlace(map.toPixel(place));
    EXPECT_NEAR(back.x(), place.x(), 1e-18);
    EXPECT_NEAR(back.y(), place.y(), 1e-18);
    EXPECT_EQ(map.toPixel({0.0, 0.0}), map.mapRect().bottomLeft());
}

TEST(OverviewMap, TheHillIsWhereItIsInTheScan) {
    OverviewMap map;
    map.resize(400, 200);
    map.setSurface(wideSurface());
    const QImage image = map.grab().toImage();
    const QPoint hill = map.toPixel({33.0_nm, 103.0_nm}).toPoint();
    const QPoint level = map.toPixel({200.0_nm, 40.0_nm}).toPoint();
    EXPECT_GT(image.pixelColor(hill).lightness(), image.pixelColor(level).lightness() + 50);
    EXPECT_TRUE(map.toolTipAt(hill).contains(QStringLiteral("height 9."))) << "10 nm high";
    const QString words = map.toolTipAt(map.toPixel({200.0_nm, 40.0_nm}));
    EXPECT_TRUE(words.startsWith(QStringLiteral("height 0.00 nm\nx 200.00 nm, y 40.00 nm")))
        << words.toStdString();
    EXPECT_TRUE(map.toolTipAt({-5.0, 20.0}).isEmpty());
}

TEST(OverviewMap, MarksTheTipAndKeepsTheMarkInSightOutsideTheScan) {
    OverviewMap map;
    map.resize(400, 200);
    map.setSurface(wideSurface());
    const auto marked = [&map] {
        return test::pixelsLike(map.grab().toImage(), theme::colors().marker);
    };
    EXPECT_EQ(marked(), 0);
    map.showTip({128.0_nm, 64.0_nm});
    const int inside = marked();
    EXPECT_GT(inside, 30);
    const QPoint ring = map.toPixel({128.0_nm, 64.0_nm}).toPoint() + QPoint(5, 0);
    EXPECT_LT(std::abs(map.grab().toImage().pixelColor(ring).red() - theme::colors().marker.red()),
              40);
    map.showTip({900.0_nm, 64.0_nm});
    EXPECT_GT(marked(), inside / 4);
    map.showTip({NAN, 64.0_nm});
    EXPECT_EQ(marked(), 0);
}

TEST(OverviewMap, DrawsTheZoomsFrameAndThePathWhereTheyAre) {
    OverviewMap map;
    map.resize(400, 200);
    map.setSurface(wideSurface());
    map.showFrame({100.0_nm, 20.0_nm, 60.0_nm, 40.0_nm});
    const QImage framed = map.grab().toImage();
    EXPECT_GT(test::pixelsLike(framed, theme::colors().zoom), 100);
    const QPoint onEdge = map.toPixel({130.0_nm, 60.0_nm}).toPoint();
    int found = 0;
    for (int dy = -2; dy <= 2; ++dy) {
        found +=
            test::pixelsLike(framed.copy(onEdge.x(), onEdge.y() + dy, 1, 1), theme::colors().zoom);
    }
    EXPECT_GE(found, 1) << "its upper edge";
    const int before = test::pixelsLike(framed, theme::colors().ink);
    map.showPath(QVector<QPointF>{{20.0_nm, 20.0_nm}, {240.0_nm, 110.0_nm}});
    EXPECT_GT(test::pixelsLike(map.grab().toImage(), theme::colors().ink), before + 50);
}

TEST(OverviewMap, ASmallFrameIsSeenOutsideTheTipsMark) {
    OverviewMap map;
    map.resize(400, 200);
    map.setSurface(wideSurface());
    const QPointF middle(128.0_nm, 64.0_nm);
    map.showFrame({middle.x() - 2.0_nm, middle.y() - 2.0_nm, 4.0_nm, 4.0_nm});
    map.showTip(middle);
    const QImage image = map.grab().toImage();
    const QPoint center = map.toPixel(middle).toPoint();
    for (const QPoint& way : {QPoint(-1, -1), QPoint(-1, 1), QPoint(1, -1), QPoint(1, 1)}) {
        QRect outside(QPoint(), QSize(10, 10));
        outside.moveCenter(center + 14 * way);
        EXPECT_GE(test::pixelsLike(image.copy(outside), theme::colors().zoom), 8)
            << way.x() << ", " << way.y();
    }
    map.showFrame({middle.x() - 20.0_nm, middle.y() - 20.0_nm, 40.0_nm, 40.0_nm});
    const QImage large = map.grab().toImage();
    EXPECT_EQ(test::pixelsLike(large.copy(QRect(center - QPoint(18, 18), QSize(36, 36))),
                               theme::colors().zoom),
              0)
        << "no brackets in a frame that is large enough";
}

/// Notes what it is told.
class NotingTool : public MapTool {
public:
    void paint(QPainter& painter, const OverviewMap& map) const override {
        painter.fillRect(QRectF(map.toPixel({120.0_nm, 70.0_nm}), QSizeF(10.0, 10.0)), Qt::cyan);
    }
    void press(const MapPointer& pointer, const OverviewMap& /*map*/) override {
        told += "p";
        place = pointer.place;
    }
    void drag(const MapPointer& /*pointer*/, const OverviewMap& /*map*/) override { told += "d"; }
    void release(const MapPointer& /*pointer*/, const OverviewMap& /*map*/) override {
        told += "r";
    }
    void doubleClick(const MapPointer& /*pointer*/, const OverviewMap& /*map*/) override {
        told += "2";
    }
    [[nodiscard]] Qt::CursorShape cursor(const MapPointer& /*pointer*/,
                                         const OverviewMap& /*map*/) const override {
        return Qt::SizeAllCursor;
    }

    std::string told;
    QPointF place;
};

TEST(OverviewMap, OnlyTheActiveToolHasTheMouse) {
    OverviewMap map;
    map.resize(400, 200);
    map.setSurface(wideSurface());
    NotingTool tool;
    map.addTool(tool);
    EXPECT_GT(test::pixelsLike(map.grab().toImage(), Qt::cyan), 60) << "marks are always shown";
    QSignalSpy chosen(&map, &OverviewMap::placeChosen);
    QSignalSpy activated(&map, &OverviewMap::toolActivated);
    const QPointF pixel = map.toPixel({64.0_nm, 32.0_nm});
    test::dragMouse(map, pixel, pixel + QPointF(20.0, 0.0));
    doubleClick(map, pixel);
    EXPECT_EQ(tool.told, "");
    EXPECT_EQ(chosen.count(), 1);

    map.activate(&tool);
    EXPECT_EQ(activated.count(), 1);
    test::sendMouse(map, QEvent::MouseMove, pixel, Qt::NoButton);
    EXPECT_EQ(map.cursor().shape(), Qt::SizeAllCursor);
    test::dragMouse(map, pixel, pixel + QPointF(20.0, 0.0));
    EXPECT_EQ(tool.told, "pddr");
    EXPECT_NEAR(tool.place.x(), 64.0_nm, 0.01_nm);
    doubleClick(map, pixel);
    EXPECT_EQ(chosen.count(), 1) << "no travel while a tool has the mouse";

    map.activate(nullptr);
    EXPECT_EQ(map.cursor().shape(), Qt::CrossCursor);
    doubleClick(map, pixel);
    EXPECT_EQ(chosen.count(), 2);
}

TEST(OverviewMap, AToolMayGo) {
    OverviewMap map;
    map.resize(400, 200);
    map.setSurface(wideSurface());
    {
        NotingTool tool;
        map.addTool(tool);
        map.activate(&tool);
    }
    EXPECT_EQ(map.activeTool(), nullptr);
    EXPECT_EQ(test::pixelsLike(map.grab().toImage(), Qt::cyan), 0);
}

TEST(OverviewMap, ANewSurfaceForgetsTheOldOnesMarks) {
    OverviewMap map;
    map.resize(400, 200);
    map.setSurface(wideSurface());
    map.showTip({128.0_nm, 64.0_nm});
    map.showFrame({100.0_nm, 20.0_nm, 60.0_nm, 40.0_nm});
    map.setSurface(wideSurface());
    const QImage image = map.grab().toImage();
    EXPECT_EQ(test::pixelsLike(image, theme::colors().marker), 0);
    EXPECT_EQ(test::pixelsLike(image, theme::colors().zoom), 0);
}

TEST(ReliefImage, IsAtMost512PixelsAndCoversTheHeights) {
    const ReliefImage relief = reliefImage(wideSurface());
    EXPECT_EQ(relief.image().size(), QSize(512, 256));
    EXPECT_EQ(relief.heights().size(), 512U * 256U);
    EXPECT_NEAR(relief.colors().high, 10.0_nm, 0.1_nm);
    EXPECT_NEAR(relief.colors().low, 0.0, 0.1_nm);
}

TEST(ReliefImage, IsLitFromTheUpperLeft) {
    const BSplineSurface surface = fitSurface(test::hillyMap());
    const ReliefImage relief = reliefImage(surface);
    const auto lightness = [&](double x, double y) {
        const int column = static_cast<int>(x / surface.sizeX() * relief.image().width());
        const int row = static_cast<int>((1.0 - y / surface.sizeY()) * relief.image().height());
        return relief.image().pixelColor(column, row).lightness();
    };
    // A hill's flanks at equal height, on either side of its top at 15 nm, 15 nm.
    EXPECT_GT(lightness(8.0_nm, 22.0_nm), lightness(22.0_nm, 8.0_nm) + 20);
}

TEST(ReliefImage, TakesTheQuantityAndItsColors) {
    ReliefImage relief = reliefImage(wideSurface());
    SurfaceLook look;
    look.quantity = SurfaceQuantity::Slope;
    look.of(SurfaceQuantity::Slope).map = ColorMap::Gray;
    relief.setLook(look, SurfaceField(SurfaceQuantity::Slope));
    EXPECT_EQ(relief.colors().quantity, QStringLiteral("slope"));
    const auto colorAt = [&relief](double x, double y) {
        return relief.image().pixelColor(static_cast<int>(2.0 * x / 1.0_nm),
                                         static_cast<int>(256.0 - 2.0 * y / 1.0_nm));
    };
    EXPECT_LT(colorAt(200.0_nm, 40.0_nm).lightness(), 10) << "level: black";
    EXPECT_EQ(colorAt(40.0_nm, 104.0_nm).saturation(), 0);
    EXPECT_GT(colorAt(40.0_nm, 104.0_nm).lightness(), 60) << "the hill's flank";
}

TEST(ReliefImage, ShowsHeightsForWhatChangesWithTheTip) {
    ReliefImage relief = reliefImage(wideSurface());
    SurfaceLook look;
    look.quantity = SurfaceQuantity::Pressure;
    relief.setLook(look, SurfaceField(SurfaceQuantity::Pressure));
    EXPECT_EQ(relief.colors().quantity, QStringLiteral("height"));
}

TEST(ReliefImage, KeepsAPinnedRangeOverAnotherScan) {
    ReliefImage relief = reliefImage(wideSurface());
    SurfaceLook look;
    look.of(SurfaceQuantity::Height).pinned = true;
    relief.setLook(look, SurfaceField());
    const double high = relief.colors().high;
    relief.setSurface(fitSurface(test::slopedMap(0.5)));
    EXPECT_EQ(relief.colors().high, high);
    EXPECT_TRUE(relief.colors().clipsHigh()) << "and says so";
    look.of(SurfaceQuantity::Height).pinned = false;
    relief.setLook(look, SurfaceField());
    EXPECT_GT(relief.colors().high, 2.0 * high);
}

TEST(ReliefImage, ALevelScanHasOneColor) {
    const ReliefImage relief = reliefImage(fitSurface(test::flatMap()));
    EXPECT_EQ(relief.image().pixel(0, 0), relief.image().pixel(300, 200));
}

TEST(ColorBarWidget, NamesTheQuantityWithItsPrefix) {
    ColorBarWidget bar;
    EXPECT_TRUE(bar.heading().isEmpty());
    bar.setScale({.quantity = QStringLiteral("displacement"),
                  .unit = QStringLiteral("m"),
                  .low = -400e-12,
                  .high = 0.0,
                  .colors = {Qt::red, Qt::white}});
    EXPECT_EQ(bar.heading(), QStringLiteral("displacement [pm]"));
}

TEST(ReliefImage, IsGrayWhereTheScanHoldsNoData) {
    EXPECT_FALSE(reliefImage(fitSurface(test::hillyMap())).hasFilled());
    const ReliefImage relief = reliefImage(fitSurface(holedMap()));
    EXPECT_TRUE(relief.hasFilled());
    const auto colorfulness = [&](double x, double y) {
        const QColor color =
            relief.image().pixelColor(static_cast<int>(x * relief.image().width()),
                                      static_cast<int>(y * relief.image().height()));
        return std::max({color.red(), color.green(), color.blue()}) -
               std::min({color.red(), color.green(), color.blue()});
    };
    EXPECT_EQ(colorfulness(0.2, 0.5), 0);
    EXPECT_EQ(colorfulness(0.8, 0.01), 0) << "the rows without data lie at the top";
    EXPECT_GT(colorfulness(0.8, 0.5), 40);
    EXPECT_GT(colorfulness(0.8, 0.99), 40);
}

TEST(OverviewPanel, SaysThatPartsOfTheScanAreFilledInOnlyWhereTheyAre) {
    OverviewPanel panel;
    const auto* legend = panel.findChild<QWidget*>(QStringLiteral("filledLegend"));
    ASSERT_NE(legend, nullptr);
    panel.setSurface(fitSurface(holedMap()));
    EXPECT_FALSE(legend->isHidden());
    panel.setSurface(fitSurface(test::hillyMap()));
    EXPECT_TRUE(legend->isHidden());
}

TEST(OverviewPanel, SaysWhatThereIsToSayOfTheScan) {
    OverviewPanel panel;
    panel.setScanNote(QStringLiteral("Holds the imaging tip's shape"), QStringLiteral("more"));
    EXPECT_EQ(test::textOf(panel, "scanNote"), QStringLiteral("Holds the imaging tip's shape"));
    EXPECT_EQ(panel.findChild<QLabel*>(QStringLiteral("scanNote"))->toolTip(),
              QStringLiteral("more"));
}

TEST(AxisTicks, AreNeverOnlyOne) {
    EXPECT_EQ(axisTicks(0.0, 10.0, 5), (std::vector<double>{0.0, 2.0, 4.0, 6.0, 8.0, 10.0}));
    EXPECT_GE(axisTicks(-8.0, 8.0, 2).size(), 2U);
    EXPECT_GE(axisTicks(1.1, 13.9, 1).size(), 2U);
}

TEST(ColorBarWidget, RunsFromTheFirstColorToTheLast) {
    ColorBarWidget bar;
    bar.resize(200, bar.sizeHint().height());
    EXPECT_EQ(test::pixelsLike(bar.grab().toImage(), Qt::red), 0) << "nothing to show yet";
    bar.setScale({.quantity = QStringLiteral("height"),
                  .unit = QStringLiteral("m"),
                  .low = 0.0,
                  .high = 1e-9,
                  .colors = {Qt::red, Qt::blue}});
    const QImage image = bar.grab().toImage();
    int reds = 0;
    int blues = 0;
    for (int y = 0; y < image.height(); ++y) {
        reds += test::pixelsLike(image.copy(15, y, 1, 1), Qt::red);
        blues += test::pixelsLike(image.copy(184, y, 1, 1), Qt::blue);
    }
    EXPECT_GE(reds, 8);
    EXPECT_GE(blues, 8);
}

}  // namespace
}  // namespace asperity
