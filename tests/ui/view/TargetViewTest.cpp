#include "core/Units.h"
#include "tests/ui/view/ZoomViewFixture.h"

namespace asperity::test {
namespace {

using TargetView = ZoomViewTest;

bool isGreen(const QColor& color) {
    return color.green() > 120 && color.red() < 60 && color.blue() < 100;
}

int greenPixels(const QImage& picture) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            count += isGreen(picture.pixelColor(x, y)) ? 1 : 0;
        }
    }
    return count;
}

TEST_F(TargetView, IsAGreenCrossHairInSpaceAndGoesWithIt) {
    EXPECT_EQ(greenPixels(pictureOf(moments.away)), 0);
    const Vector3 tip = moments.away.sample.output.model.tip;
    const Vector3 target(tip.x() + 8.0_nm, tip.y() - 5.0_nm, 12.0_nm);
    view->setTarget(target);
    const QImage picture = pictureOf(moments.away);
    EXPECT_TRUE(isGreen(colorAt(picture, target)));
    EXPECT_TRUE(isGreen(colorAt(picture, {target.x(), target.y(), 6.0_nm}))) << "its stem";
    EXPECT_FALSE(isGreen(colorAt(picture, {target.x() + 5.0_nm, target.y(), 6.0_nm})));
    view->setTarget(std::nullopt);
    EXPECT_EQ(greenPixels(pictureOf(moments.away)), 0);
}

TEST_F(TargetView, IsSeenThroughTheTip) {
    const Vector3 tip = moments.away.sample.output.model.tip;
    const Vector3 inside = tip + Vector3(0.0, 0.0, 5.0_nm);
    view->setTarget(inside);
    EXPECT_TRUE(isGreen(colorAt(pictureOf(moments.away), inside)));
}

TEST_F(TargetView, StaysWithAnotherScene) {
    const Vector3 tip = moments.away.sample.output.model.tip;
    view->setTarget(tip);
    view->setScene(nullptr);
    view->setScene(scene.get());
    EXPECT_GT(greenPixels(pictureOf(moments.away)), 20);
}

TEST_F(TargetView, ASurfaceAtRestIsDrawnAsIfNothingTouchedIt) {
    const Vector3 tip = moments.neck.sample.output.model.tip;
    const Vector3 beside = Vector3(tip.x(), tip.y(), 0.0) + 10.0_nm * towardsEye();
    const auto colorIn = [&](const Snapshot& moment, bool deformation) {
        view->setOptions({.grid = false, .labels = false, .deformation = deformation});
        return colorAt(pictureOf(moment), beside);
    };
    const QColor untouched = colorIn(moments.away, true);
    EXPECT_NE(colorIn(moments.neck, true), untouched) << "the neck is colored";
    EXPECT_NEAR(colorIn(moments.neck, false).hslHue(), untouched.hslHue(), 2)
        << "a tip at another height has another shadow, which has no hue";
}

}  // namespace
}  // namespace asperity::test
