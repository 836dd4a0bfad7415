#include "ui/view/ZoomPicture.h"

#include "tests/support/TestScenes.h"
#include "tests/ui/view/ViewMoments.h"
#include "ui/view/ViewFrame.h"

#include <vtkGenericOpenGLRenderWindow.h>

#include <QtTest>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity::test {
namespace {

HeightMap mapOfPitch(double pitch) {
    HeightMap map = flatMap();
    map.pitchX = pitch;
    map.pitchY = pitch;
    return map;
}

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

/// The panels are drawn in every second frame: the number at the arrow is theirs, not the one of
/// the tick between.
TEST_F(ZoomPictureTest, WritesTheForceThatThePanelsShow) {
    picture.setScene(&scene);
    Snapshot deep = momentsOf(scene).deep;
    picture.setSample(deep.sample);
    deep.sample.output.estimate.force = {0.0, 0.0, 5.1e-9};
    picture.setSample(deep.sample);
    EXPECT_EQ(picture.writtenForce(), "5.10 nN") << "as many digits as in the panels";
    picture.setWrittenForce("0.88 nN");
    picture.setSample(deep.sample);
    EXPECT_EQ(picture.writtenForce(), "0.88 nN");
    picture.setScene(&scene);
    EXPECT_EQ(picture.writtenForce(), "") << "of another scene";
}

/// Its shank would leave the block of sample through a side.
TEST_F(ZoomPictureTest, TheFrameWidensForATipThatIsPressedInDeep) {
    const Scene wide = buildScene(plainScene(), mapOfPitch(6e-9));
    picture.setScene(&wide);
    const double usual = picture.frame()->halfWidth();
    Snapshot deep = momentsOf(wide).deep;
    const ViewCamera camera;
    picture.setSample(deep.sample);
    picture.showSample(camera, false);
    EXPECT_EQ(picture.frame()->halfWidth(), usual) << "there is room";
    ContactState& contact = deep.sample.output.model.contact;
    contact.indentation = 130e-9;
    picture.setSample(deep.sample);
    picture.showSample(camera, false);
    const double widened = picture.frame()->halfWidth();
    const TipOutline outline{wide.description.tip.shape()};
    EXPECT_GT(widened, 1.5 * outline.radius(contact.indentation));
    contact.indentation = 1e-9;
    picture.setSample(deep.sample);
    picture.showSample(camera, false);
    EXPECT_EQ(picture.frame()->halfWidth(), widened) << "it does not come back by itself";
    picture.setHalfWidth(usual);
    picture.keepHalfWidth();
    contact.indentation = 130e-9;
    picture.setSample(deep.sample);
    picture.showSample(camera, false);
    EXPECT_EQ(picture.frame()->halfWidth(), usual) << "it was asked for";
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

TEST_F(ZoomPictureTest, SaysWhatItDoesNotShowAsItIs) {
    using testing::ElementsAre;
    picture.setScene(&scene);
    EXPECT_TRUE(picture.notes({}).empty());
    ViewOptions options;
    options.heightScale = 5.0;
    picture.setOptions(options);
    EXPECT_THAT(picture.notes({}), ElementsAre("heights ×5"));
    picture.setOptions({});
    const Scene wide = buildScene(plainScene(), mapOfPitch(4e-9));
    picture.setScene(&wide);
    picture.setHalfWidth(1e-6);
    EXPECT_THAT(picture.notes({}), ElementsAre("lever not to scale"));
    const Scene coarse = buildScene(plainScene(), mapOfPitch(24e-9));
    picture.setScene(&coarse);
    picture.setHalfWidth(picture.scale().least);
    EXPECT_THAT(picture.notes({}),
                ElementsAre("Scan pixel 24 nm: coarse for a tip radius of 15 nm"));
    picture.setScene(nullptr);
}

/// Half of it higher than the other.
Scene stepScene() {
    HeightMap map = flatMap();
    for (int row = 0; row < map.rows; ++row) {
        for (int column = map.columns / 2; column < map.columns; ++column) {
            map.heights[map.index(row, column)] = 30e-9;
        }
    }
    return buildScene(plainScene(), map);
}

/// A slide over other heights zoomed out.
TEST(ZoomPictureScale, StaysWhileTheTipIsInContact) {
    const Scene scene = stepScene();
    vtkNew<vtkGenericOpenGLRenderWindow> window;
    window->SetSize(900, 700);
    ZoomPicture picture(window);
    const ViewCamera camera;
    QObject::connect(&picture, &ZoomPicture::terrainPlaced,
                     [&] { picture.aim(camera, 900.0 / 700.0); });
    picture.setScene(&scene);
    picture.setHalfWidth(picture.scale().least);
    const auto show = [&](const Snapshot& snapshot) {
        picture.setSample(snapshot.sample);
        picture.showSample(camera, false);
        return picture.metersPerPixel(700);
    };
    const ViewMoments moments = momentsOf(scene);
    const double size = scene.surface.sizeX();
    const double position = moments.deep.sample.output.model.tip.x();
    const Vector3 toLowEnd(0.1 * size - position, 0.0, 0.0);
    const Vector3 toStep(0.5 * size - position, 0.0, 0.0);
    const double before = show(movedBy(moments.deep, toLowEnd));
    EXPECT_EQ(show(movedBy(moments.deep, toStep)), before);
    ASSERT_EQ(moments.away.sample.output.model.contact.contactRadius, 0.0);
    (void)show(movedBy(moments.away, toLowEnd));
    EXPECT_NE(show(movedBy(moments.away, toStep)), before) << "it fits between contacts";
}

}  // namespace
}  // namespace asperity::test
