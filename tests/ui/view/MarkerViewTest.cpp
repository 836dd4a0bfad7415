#include "core/Units.h"
#include "tests/ui/view/ZoomViewFixture.h"

namespace asperity::test {

namespace {

/// Pixels within a square about a position that differ in two pictures.
int changedNear(const QImage& one, const QImage& other, const QPoint& center, int half) {
    int count = 0;
    for (int y = center.y() - half; y <= center.y() + half; ++y) {
        for (int x = center.x() - half; x <= center.x() + half; ++x) {
            if (one.rect().contains(x, y)) {
                count += one.pixel(x, y) != other.pixel(x, y) ? 1 : 0;
            }
        }
    }
    return count;
}

}  // namespace

TEST_F(ZoomViewTest, DrawsTheMarkersInItsWindowWithTheirNames) {
    const Vector3 position(80.0_nm, 50.0_nm, 0.0);
    view->setOptions({.axes = false, .scaleBars = false});
    const QImage without = pictureOf(moments.away);
    const QPoint center = view->onScreen(position).toPoint();
    // The run's own description is the one that is shown: a marker may come while it is.
    scene->description.markers = {{"grain", position.x(), position.y()}, {"far", -1.0, -1.0}};
    const QImage with = pictureOf(moments.away);
    EXPECT_GT(changedNear(with, without, center, 8), 8) << "its cross";
    const QPoint name = center + QPoint(30, 0);
    EXPECT_GT(changedNear(with, without, name, 20), 100) << "its name";
    scene->description.markers.clear();
    EXPECT_EQ(changedNear(pictureOf(moments.away), without, center, 40), 0);
}

}  // namespace asperity::test
