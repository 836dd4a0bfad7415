#include "core/Units.h"
#include "tests/ui/view/ZoomViewFixture.h"
#include "ui/Theme.h"

#include <cstdlib>

namespace asperity::test {

namespace {

/// Pixels of the ink's color within a square about a place.
int inkNear(const QImage& picture, const QPoint& center, int half) {
    const QColor ink = toQColor(theme::palette().ink);
    int count = 0;
    for (int y = center.y() - half; y <= center.y() + half; ++y) {
        for (int x = center.x() - half; x <= center.x() + half; ++x) {
            if (picture.rect().contains(x, y)) {
                const QColor color = picture.pixelColor(x, y);
                const int difference = std::abs(color.red() - ink.red()) +
                                       std::abs(color.green() - ink.green()) +
                                       std::abs(color.blue() - ink.blue());
                count += difference < 60 ? 1 : 0;
            }
        }
    }
    return count;
}

}  // namespace

TEST_F(ZoomViewTest, DrawsTheMarkersInItsWindowWithTheirNames) {
    const Vector3 place(80.0_nm, 50.0_nm, 0.0);
    view->setOptions({.axes = false, .scaleBars = false});
    const QImage without = pictureOf(moments.away);
    const QPoint center = view->onScreen(place).toPoint();
    // The run's own description is the one that is shown: a marker may come while it is.
    scene->description.markers = {{"grain", place.x(), place.y()}, {"far", -1.0, -1.0}};
    const QImage with = pictureOf(moments.away);
    EXPECT_GT(inkNear(with, center, 8), inkNear(without, center, 8) + 8) << "its cross";
    const QPoint name = center + QPoint(30, 0);
    EXPECT_GT(inkNear(with, name, 20), inkNear(without, name, 20) + 20) << "its name";
    scene->description.markers.clear();
    EXPECT_EQ(inkNear(pictureOf(moments.away), center, 40), inkNear(without, center, 40));
}

}  // namespace asperity::test
