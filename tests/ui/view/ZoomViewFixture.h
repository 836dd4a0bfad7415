#pragma once

#include "tests/support/Waits.h"
#include "tests/ui/view/ViewMoments.h"
#include "tests/vtkplugins/NeedsDisplay.h"
#include "ui/view/ZoomView.h"

#include <QApplication>
#include <QImage>
#include <QMouseEvent>
#include <QtTest>

#include <gtest/gtest.h>

#include <memory>

namespace asperity::test {

/// A view on the screen with the flat scene in it.
class ZoomViewTest : public ::testing::Test {
protected:
    void SetUp() override {
        ASPERITY_NEEDS_DISPLAY();
        scene = std::make_unique<Scene>(flatScene());
        moments = momentsOf(*scene);
        view = std::make_unique<ZoomView>();
        view->resize(640, 480);
        view->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(view.get()));
        view->setScene(scene.get());
        settle();
    }

    /// Waits for the final frame.
    void settle() {
        ASSERT_TRUE(eventually([this] { return view->isSettled(); }));
    }

    QImage pictureOf(const Snapshot& snapshot) {
        view->showSnapshot(snapshot);
        settle();
        return view->frame();
    }

    /// Turns the view a little, as a user does with the right button.
    void turn() {
        QTest::mousePress(view.get(), Qt::RightButton, Qt::NoModifier, {100, 100});
        QMouseEvent move(QEvent::MouseMove, QPointF(110.0, 100.0), Qt::RightButton, Qt::RightButton,
                         Qt::NoModifier);
        QApplication::sendEvent(view.get(), &move);
        QTest::mouseRelease(view.get(), Qt::RightButton, Qt::NoModifier, {110, 100});
    }

    [[nodiscard]] QColor colorAt(const QImage& picture, const Vector3& position) const {
        return picture.pixelColor(view->onScreen(position).toPoint());
    }

    /// Unit, level.
    [[nodiscard]] Vector3 towardsEye() const {
        const Vector3 out = view->camera().out();
        return Vector3(out.x(), out.y(), 0.0).normalized();
    }

    std::unique_ptr<Scene> scene;
    ViewMoments moments;
    std::unique_ptr<ZoomView> view;
};

}  // namespace asperity::test
