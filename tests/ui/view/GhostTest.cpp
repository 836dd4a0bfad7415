#include "core/Units.h"
#include "tests/ui/view/ZoomViewFixture.h"
#include "vtkplugins/pictures/Palette.h"

namespace asperity::test {

namespace {

int pixelsNear(const QImage& picture, const Color& color) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const QColor pixel = picture.pixelColor(x, y);
            count += std::abs(pixel.red() - color.red) + std::abs(pixel.green() - color.green) +
                                 std::abs(pixel.blue() - color.blue) <
                             30
                         ? 1
                         : 0;
        }
    }
    return count;
}

}  // namespace

TEST_F(ZoomViewTest, ShowsTheCommandedTipAsAGhostBelowTheRealOne) {
    const QImage without = pictureOf(moments.deep);
    EXPECT_EQ(pixelsNear(without, kLightPalette.commanded), 0);
    view->setOptions({.commandedTip = true});
    const QImage with = pictureOf(moments.deep);
    EXPECT_GT(pixelsNear(with, kLightPalette.commanded), 100);
    const Vector3& base = moments.deep.sample.output.base.position;
    EXPECT_LT(base.z(), moments.deep.sample.output.model.tip.z() - 0.5_nm);
}

TEST_F(ZoomViewTest, ShowsTheTrueTipWhereTheInstrumentHasIt) {
    view->setOptions({.trueTip = true});
    Snapshot snapshot = moments.away;
    snapshot.trueTip.reset();
    EXPECT_EQ(pixelsNear(pictureOf(snapshot), kLightPalette.trueTip), 0) << "it knows none";
    snapshot.trueTip = snapshot.sample.output.tip + Vector3(6.0_nm, 0.0, 1.0_nm);
    const QImage first = pictureOf(snapshot);
    EXPECT_GT(pixelsNear(first, kLightPalette.trueTip), 100);
    *snapshot.trueTip += Vector3(0.0, 0.0, 4.0_nm);
    EXPECT_NE(pictureOf(snapshot), first) << "it goes with the true tip";
}

}  // namespace asperity::test
