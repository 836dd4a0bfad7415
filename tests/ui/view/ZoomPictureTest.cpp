#include "ui/view/ZoomPicture.h"

#include "tests/ui/view/ViewMoments.h"

#include <vtkGenericOpenGLRenderWindow.h>

#include <QtTest>

#include <gtest/gtest.h>

namespace asperity::test {
namespace {

/// What there is to say of a picture without drawing it.
class ZoomPictureTest : public ::testing::Test {
protected:
    const Scene scene = flatScene();
    vtkNew<vtkGenericOpenGLRenderWindow> window;
    ZoomPicture picture{window};
    QSignalSpy placed{&picture, &ZoomPicture::terrainPlaced};
    QSignalSpy moved{&picture, &ZoomPicture::frameChanged};
};

TEST_F(ZoomPictureTest, ShowsTheMiddleOfASceneAtItsUsualWidth) {
    EXPECT_FALSE(picture.frame().has_value());
    picture.setScene(&scene);
    ASSERT_TRUE(picture.frame().has_value());
    EXPECT_EQ(placed.count(), 1);
    EXPECT_EQ(moved.count(), 1);
    EXPECT_EQ(picture.frame()->halfWidth(), picture.scale().usual);
    picture.setScene(nullptr);
    EXPECT_FALSE(picture.frame().has_value());
}

TEST_F(ZoomPictureTest, ComesNoNearerThanItsScaleSays) {
    picture.setScene(&scene);
    picture.setHalfWidth(0.0);
    EXPECT_EQ(picture.frame()->halfWidth(), picture.scale().least);
    EXPECT_EQ(moved.count(), 2);
}

TEST_F(ZoomPictureTest, TheFrameGoesWithTheTipUnlessItIsDragged) {
    picture.setScene(&scene);
    const ViewCamera camera;
    const Snapshot deep = momentsOf(scene).deep;
    picture.setSample(deep.sample);
    picture.showSample(camera, false);
    const Vector2 before = picture.frame()->center();
    const double way = 0.6 * picture.frame()->halfWidth();
    picture.setSample(movedBy(deep, {way, 0.0, 0.0}).sample);
    picture.showSample(camera, true);
    EXPECT_EQ(picture.frame()->center(), before);
    picture.showSample(camera, false);
    EXPECT_GT(picture.frame()->center().x(), before.x());
}

}  // namespace
}  // namespace asperity::test
