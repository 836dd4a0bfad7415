#include "ui/view/OverviewMap.h"

#include "tests/ui/view/MapSamples.h"
#include "tests/ui/widgets/MouseEvents.h"
#include "tests/ui/widgets/PanelSamples.h"
#include "ui/view/MapTool.h"
#include "ui/widgets/Theme.h"

#include <QPainter>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

struct OverviewMapTest : ::testing::Test {
    OverviewMapTest() {
        map.resize(400, 200);
        map.setSurface(test::wideSurface());
    }
    void doubleClick(const QPointF& pixel) {
        QTest::mouseDClick(&map, Qt::LeftButton, Qt::NoModifier, pixel.toPoint());
    }

    OverviewMap map;
};

/// Notes what it is told.
class NotingTool : public MapTool {
public:
    void paint(QPainter& painter, const OverviewMap& map) const override {
        painter.fillRect(QRectF(map.toPixel({120.0_nm, 70.0_nm}), QSizeF(10.0, 10.0)), Qt::cyan);
    }
    void press(const MapPointer& pointer, const OverviewMap& /*map*/) override {
        told += "p";
        position = pointer.position;
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
    QPointF position;
};

TEST_F(OverviewMapTest, KeepsTheAspectRatioAndStaysInside) {
    for (const QSize& size : {QSize(300, 300), QSize(400, 120), QSize(137, 211)}) {
        map.resize(size);
        const QRectF drawn = map.mapRect();
        EXPECT_NEAR(drawn.width() / drawn.height(), 2.0, 0.05);
        EXPECT_TRUE(QRectF(map.rect()).contains(drawn));
    }
}

TEST_F(OverviewMapTest, AReadingOutOfThePointersWayDoesNotCoverTheScaleBar) {
    const QRect drawn = map.mapRect().toRect();
    const QRect bar(drawn.left() + 5, drawn.bottom() - 24, 80, 20);
    const QImage before = map.grab().toImage().copy(bar);
    map.showCrossHair(map.toPosition(drawn.topLeft() + QPointF(100.0, 10.0)),
                      QStringLiteral("x 1.0 nm   y 2.0 nm   z 3.00 nm"));
    QImage with = map.grab().toImage().copy(bar);
    EXPECT_EQ(with, before);
}

TEST_F(OverviewMapTest, PlacesAndPixelsAreInverse) {
    map.resize(300, 200);
    const QPointF position(37.0_nm, 101.0_nm);
    const QPointF back = map.toPosition(map.toPixel(position));
    EXPECT_NEAR(back.x(), position.x(), 1e-18);
    EXPECT_NEAR(back.y(), position.y(), 1e-18);
    EXPECT_EQ(map.toPixel({0.0, 0.0}), map.mapRect().bottomLeft());
}

TEST_F(OverviewMapTest, TheHillIsWhereItIsInTheScan) {
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

TEST_F(OverviewMapTest, MarksTheTipAndKeepsTheMarkInSightOutsideTheScan) {
    const auto marked = [this] {
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

TEST_F(OverviewMapTest, DrawsTheZoomsFrameAndThePathWhereTheyAre) {
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

TEST_F(OverviewMapTest, ASmallFrameIsSeenOutsideTheTipsMark) {
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

TEST_F(OverviewMapTest, OnlyTheActiveToolHasTheMouse) {
    NotingTool tool;
    map.addTool(tool);
    EXPECT_GT(test::pixelsLike(map.grab().toImage(), Qt::cyan), 60) << "marks are always shown";
    QSignalSpy chosen(&map, &OverviewMap::positionChosen);
    QSignalSpy activated(&map, &OverviewMap::toolActivated);
    const QPointF pixel = map.toPixel({64.0_nm, 32.0_nm});
    test::dragMouse(map, pixel, pixel + QPointF(20.0, 0.0));
    doubleClick(pixel);
    EXPECT_EQ(tool.told, "");
    EXPECT_EQ(chosen.count(), 1);

    map.activate(&tool);
    EXPECT_EQ(activated.count(), 1);
    test::sendMouse(map, QEvent::MouseMove, pixel, Qt::NoButton);
    EXPECT_EQ(map.cursor().shape(), Qt::SizeAllCursor);
    test::dragMouse(map, pixel, pixel + QPointF(20.0, 0.0));
    EXPECT_EQ(tool.told, "pddr");
    EXPECT_NEAR(tool.position.x(), 64.0_nm, 0.01_nm);
    doubleClick(pixel);
    EXPECT_EQ(chosen.count(), 1) << "no travel while a tool has the mouse";

    map.activate(nullptr);
    EXPECT_EQ(map.cursor().shape(), Qt::CrossCursor);
    doubleClick(pixel);
    EXPECT_EQ(chosen.count(), 2);
}

TEST_F(OverviewMapTest, AToolMayGo) {
    {
        NotingTool tool;
        map.addTool(tool);
        map.activate(&tool);
    }
    EXPECT_EQ(map.activeTool(), nullptr);
    EXPECT_EQ(test::pixelsLike(map.grab().toImage(), Qt::cyan), 0);
}

TEST_F(OverviewMapTest, ANewSurfaceForgetsTheOldOnesMarks) {
    map.showTip({128.0_nm, 64.0_nm});
    map.showFrame({100.0_nm, 20.0_nm, 60.0_nm, 40.0_nm});
    map.setSurface(test::wideSurface());
    const QImage image = map.grab().toImage();
    EXPECT_EQ(test::pixelsLike(image, theme::colors().marker), 0);
    EXPECT_EQ(test::pixelsLike(image, theme::colors().zoom), 0);
}

}  // namespace
}  // namespace asperity
