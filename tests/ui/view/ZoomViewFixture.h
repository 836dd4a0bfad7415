#pragma once

#include "tests/ui/view/ViewMoments.h"
#include "tests/vtkplugins/NeedsDisplay.h"
#include "ui/view/ZoomView.h"

#include <QImage>
#include <QtTest>

#include <gtest/gtest.h>

#include <memory>

namespace asperity::test {

/// A view on the screen with the flat scene in it.
class ZoomViewTest : public ::testing::Test {
protected:
    void SetUp() override {
        ASPERITY_NEEDS_DISPLAY();
        scene_ = std::make_unique<Scene>(flatScene());
        moments_ = momentsOf(*scene_);
        view_ = std::make_unique<ZoomView>();
        view_->resize(640, 480);
        view_->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(view_.get()));
        view_->setScene(scene_.get());
        settle();
    }

    /// Lets the view come to rest.
    static void settle() { QTest::qWait(300); }

    QImage pictureOf(const Snapshot& snapshot) {
        view_->showSnapshot(snapshot);
        settle();
        return view_->grabFramebuffer();
    }

    [[nodiscard]] QColor colourAt(const QImage& picture, const Vector3& place) const {
        return picture.pixelColor(view_->onScreen(place).toPoint());
    }

    std::unique_ptr<Scene> scene_;
    ViewMoments moments_;
    std::unique_ptr<ZoomView> view_;
};

}  // namespace asperity::test
