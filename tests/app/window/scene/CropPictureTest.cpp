#include "app/window/scene/CropFields.h"

#include <QtTest>

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace asperity::test {
namespace {

/// A picture of 400 x 200 pixels, each 10 nm, drawn on 400 x 200 px of the screen.
class CropPictureTest : public ::testing::Test {
protected:
    CropPictureTest() {
        picture.setDrawable(true);
        picture.resize(400, 300);
        QImage image(100, 50, QImage::Format_RGB32);  // a preview has fewer pixels than the scan
        image.fill(Qt::blue);
        picture.setPicture(image, {400, 200}, {4e-6, 2e-6});
        QObject::connect(&picture, &CropPicture::cropDrawn,
                         [this](const auto& crop) { drawn.push_back(crop); });
        QObject::connect(&picture, &CropPicture::cropDragged, [this](const auto&) { ++dragged; });
        picture.show();
    }
    void drag(const QPoint& from, const QPoint& to) {
        press(from);
        move(to);
        QTest::mouseRelease(&picture, Qt::LeftButton, Qt::NoModifier, to);
    }
    void press(const QPoint& at) {
        QTest::mousePress(&picture, Qt::LeftButton, Qt::NoModifier, at);
    }
    /// QTest::mouseMove() tells of no pressed button.
    void move(const QPoint& to) {
        QMouseEvent event(QEvent::MouseMove, to, picture.mapToGlobal(to), Qt::NoButton,
                          Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&picture, &event);
    }

    CropPicture picture;
    std::vector<std::optional<PixelRectangle>> drawn;
    int dragged = 0;
};

TEST_F(CropPictureTest, KeepsTheShapeOfTheScan) {
    EXPECT_EQ(picture.pictureRect(), QRect(0, 50, 400, 200));
    QImage image(10, 10, QImage::Format_RGB32);
    picture.setPicture(image, {10, 10}, {1e-6, 2e-6});  // pixels twice as high as wide
    EXPECT_EQ(picture.pictureRect(), QRect(125, 0, 150, 300));
    picture.setPicture(image, {10, 10}, {});
    EXPECT_EQ(picture.pictureRect(), QRect(50, 0, 300, 300));
}

TEST_F(CropPictureTest, TheMouseDrawsAPartInPixelsOfTheScan) {
    drag({100, 90}, {199, 149});
    ASSERT_EQ(drawn.size(), 1U);
    EXPECT_EQ(drawn[0], (PixelRectangle{.column = 100, .row = 40, .columns = 100, .rows = 60}));
    EXPECT_EQ(dragged, 1);
    drag({199, 149}, {100, 90});
    EXPECT_EQ(drawn[1], drawn[0]) << "in whatever direction";
}

TEST_F(CropPictureTest, BeyondTheScanItEndsAtItsEdge) {
    drag({300, 200}, {900, 900});
    ASSERT_EQ(drawn.size(), 1U);
    EXPECT_EQ(drawn[0], (PixelRectangle{300, 150, 100, 50}));
    drag({-50, 0}, {900, 900});
    EXPECT_EQ(drawn[1], std::nullopt) << "all of it is no part";
}

TEST_F(CropPictureTest, AClickTakesItBack) {
    picture.setCrop(PixelRectangle{10, 10, 50, 50});
    QTest::mouseClick(&picture, Qt::LeftButton, Qt::NoModifier, {100, 100});
    ASSERT_EQ(drawn.size(), 1U);
    EXPECT_EQ(drawn[0], std::nullopt);
    EXPECT_EQ(picture.crop(), std::nullopt);
}

TEST_F(CropPictureTest, EscWhileItIsDrawnKeepsTheOneBefore) {
    const PixelRectangle before{10, 10, 50, 50};
    picture.setCrop(before);
    press({100, 100});
    move({200, 200});
    EXPECT_NE(picture.crop(), before);
    QTest::keyClick(&picture, Qt::Key_Escape);
    EXPECT_EQ(picture.crop(), before);
}

TEST_F(CropPictureTest, APictureThatOnlyShowsIsNotDrawnOn) {
    picture.setDrawable(false);
    drag({100, 90}, {199, 149});
    EXPECT_TRUE(drawn.empty());
    EXPECT_EQ(dragged, 0);
}

TEST_F(CropPictureTest, WhatIsLeftOutIsPale) {
    picture.setCrop(PixelRectangle{200, 0, 200, 200});
    const QImage image = picture.grab().toImage();
    EXPECT_EQ(image.pixelColor(300, 120), QColor(Qt::blue));
    EXPECT_GT(image.pixelColor(100, 120).red(), 100);
}

}  // namespace
}  // namespace asperity::test
