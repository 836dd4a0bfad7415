#include "core/Units.h"
#include "tests/support/TestScenes.h"
#include "tests/ui/view/ZoomViewFixture.h"
#include "ui/view/SurfacePick.h"
#include "vtkplugins/pictures/Palette.h"

#include <QSignalSpy>

#include <cmath>

namespace asperity::test {

namespace {

/// A position of the surface that the tip leaves alone, and one in its dent.
const Vector2 kAside(80.0_nm, 50.0_nm);

}  // namespace

TEST_F(ZoomViewTest, FindsThePlaceUnderThePointer) {
    const Scene hilly = hillyScene();
    view->setScene(&hilly);
    settle();
    for (const double heightScale : {1.0, 5.0}) {
        view->setOptions({.heightScale = heightScale});
        for (const ViewDirection side : {ViewDirection::Top, ViewDirection::Front}) {
            view->lookFrom(side);
            for (const bool perspective : {false, true}) {
                view->setPerspective(perspective);
                settle();
                const double y =
                    side == ViewDirection::Front ? view->window()->bottom + 1.0_nm : 60.0_nm;
                const Vector3 position(58.0_nm, y, hilly.surface.at(58.0_nm, y).height);
                const auto found = view->positionAt(view->onScreen(position));
                ASSERT_TRUE(found) << heightScale << " " << static_cast<int>(side);
                EXPECT_NEAR(found->x(), position.x(), 1e-12) << heightScale;
                if (side == ViewDirection::Top) {
                    EXPECT_NEAR(found->y(), position.y(), 1e-12) << heightScale;
                }
            }
        }
    }
    EXPECT_FALSE(view->positionAt({3.0, 3.0})) << "the backdrop";
    view->setScene(nullptr);
}

TEST_F(ZoomViewTest, FindsThePlaceInTheDentWhereItHasGone) {
    pictureOf(moments.deep);
    const Vector2 rest =
        moments.deep.sample.output.model.closest.point.head<2>() + Vector2(1.0_nm, -2.0_nm);
    const double displacement = view->reading(rest)->value;
    EXPECT_GT(displacement, 0.1_nm);
    const auto found = view->positionAt(view->onScreen({rest.x(), rest.y(), -displacement}));
    ASSERT_TRUE(found);
    EXPECT_LT((*found - rest).norm(), 0.02_nm);
}

TEST(SurfaceReading, SaysNoDigitThatTheScanDoesNotHold) {
    SurfaceReading reading{.position = {1.23456e-6, 12.3456e-9, 3.2149e-9}, .pixel = 20.0_nm};
    EXPECT_EQ(textOf(reading), QStringLiteral("x 1.235 µm   y 12 nm   z 3.21 nm"));
    reading.pixel = 1.0_nm;
    EXPECT_EQ(textOf(reading), QStringLiteral("x 1.2346 µm   y 12.3 nm   z 3.21 nm"));
    reading.quantity = QStringLiteral("displacement");
    reading.unit = QStringLiteral("m");
    reading.value = 30e-15;
    EXPECT_TRUE(textOf(reading).endsWith(QStringLiteral("displacement 0 pm")))
        << textOf(reading).toStdString();
}

TEST_F(ZoomViewTest, ReadsPlaceHeightAndTheQuantityOfTheColors) {
    pictureOf(moments.deep);
    const SurfaceReading aside = *view->reading(kAside);
    EXPECT_TRUE(textOf(aside).startsWith(QStringLiteral("x 80.0 nm   y 50.0 nm   z 0.00")));
    SurfaceLook look;
    look.quantity = SurfaceQuantity::Pressure;
    view->setLook(look, SurfaceField(SurfaceQuantity::Pressure));
    const Vector2 middle = moments.deep.sample.output.model.closest.point.head<2>();
    const SurfaceReading inside = *view->reading(middle);
    EXPECT_EQ(inside.quantity, QStringLiteral("contact pressure"));
    EXPECT_GT(inside.value, 1e8);
    EXPECT_TRUE(textOf(inside).contains(QStringLiteral("Pa")));
    EXPECT_EQ(view->reading(kAside)->value, 0.0);
    look.quantity = SurfaceQuantity::Slope;
    view->setLook(look, SurfaceField(SurfaceQuantity::Slope));
    EXPECT_TRUE(textOf(*view->reading(kAside)).endsWith(QStringLiteral("slope 0 °")));
}

TEST_F(ZoomViewTest, DrawsTheCrossHairWhereItPoints) {
    const QImage without = pictureOf(moments.away);
    view->showCrossHair(kAside);
    const QImage with = pictureOf(moments.away);
    // The line is one pixel wide and mixes with what is below it.
    const auto redAt = [&](const QImage& picture, const Vector3& position) {
        const QPoint center = view->onScreen(position).toPoint();
        int most = 0;
        for (int dy = -2; dy <= 2; ++dy) {
            for (int dx = -2; dx <= 2; ++dx) {
                const QColor color = picture.pixelColor(center + QPoint(dx, dy));
                most = std::max(most, color.red() - std::max(color.green(), color.blue()));
            }
        }
        return most;
    };
    constexpr int kRed = 40;
    const Vector3 onLine(kAside.x() + 6.0_nm, kAside.y(), 0.0);
    EXPECT_LT(redAt(without, onLine), kRed);
    EXPECT_GT(redAt(with, onLine), kRed);
    EXPECT_LT(redAt(with, {kAside.x() + 6.0_nm, kAside.y() + 6.0_nm, 0.0}), kRed);
    view->showCrossHair(std::nullopt);
    EXPECT_LT(redAt(pictureOf(moments.away), onLine), kRed);
}

TEST_F(ZoomViewTest, TheCrossHairCostsNoFrameWhileSnapshotsCome) {
    pictureOf(moments.away);
    QSignalSpy frames(view.get(), &ZoomView::frameRendered);
    view->showSnapshot(moments.away);
    view->showCrossHair(kAside);
    view->showCrossHair(Vector2(81.0_nm, 50.0_nm));
    QTest::qWait(40);  // longer than until a frame that is due: none may follow
    EXPECT_EQ(frames.count(), 1);
    QTest::qWait(100);  // after which snapshots have ceased
    view->showCrossHair(kAside);
    settle();
    EXPECT_EQ(frames.count(), 2);
}

TEST_F(ZoomViewTest, SaysWhereThePointerIs) {
    pictureOf(moments.away);
    QSignalSpy hovered(view.get(), &ZoomView::positionHovered);
    QSignalSpy left(view.get(), &ZoomView::pointerLeft);
    const QPointF pixel = view->onScreen({kAside.x(), kAside.y(), 0.0});
    QTest::mouseMove(view.get(), pixel.toPoint());
    ASSERT_TRUE(eventually([&] { return hovered.count() >= 1; }));
    EXPECT_NEAR(hovered.last()[0].toDouble(), kAside.x(), 0.4_nm);
    EXPECT_NEAR(hovered.last()[1].toDouble(), kAside.y(), 0.4_nm);
    QTest::mouseMove(view.get(), QPoint(3, 3));
    EXPECT_TRUE(eventually([&] { return left.count() >= 1; }));
}

}  // namespace asperity::test
