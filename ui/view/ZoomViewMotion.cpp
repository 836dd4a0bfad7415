// How ZoomView moves: the person's mouse and keys, the camera, the level of detail.
#include "ui/view/ZoomView.h"

#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderer.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <cmath>

namespace asperity {

namespace {

constexpr double kZoomStep = 1.2;
constexpr double kTurnPerPixel = 0.006;            // [rad]
constexpr double kLiftPerHalfWidth = 1.0 / 400.0;  // 0.1 nm in a frame 80 nm wide
constexpr double kFinely = 0.1;
constexpr double kWheelNotch = 120.0;  // eighths of a degree

}  // namespace

void ZoomView::mousePressEvent(QMouseEvent* event) {
    pointer_ = event->localPos();
    dragging_ = event->buttons().testFlag(Qt::LeftButton);
}

void ZoomView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF pixels = event->localPos() - pointer_;
    pointer_ = event->localPos();
    if (event->buttons().testFlag(Qt::LeftButton)) {
        dragBy(pixels, event->modifiers().testFlag(Qt::ShiftModifier));
    } else if (event->buttons().testFlag(Qt::RightButton)) {
        turnBy(pixels);
    }
}

void ZoomView::mouseReleaseEvent(QMouseEvent* event) {
    dragging_ = event->buttons().testFlag(Qt::LeftButton);
}

void ZoomView::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / kWheelNotch;
    if (event->modifiers().testFlag(Qt::ControlModifier)) {
        zoomBy(notches);
    } else if (frame_) {
        const double finely = event->modifiers().testFlag(Qt::ShiftModifier) ? kFinely : 1.0;
        Q_EMIT tipDragged(0.0, 0.0, notches * finely * kLiftPerHalfWidth * halfWidth());
    }
    event->accept();
}

void ZoomView::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:  // the same key on many keyboards
        zoomBy(1.0);
        break;
    case Qt::Key_Minus:
        zoomBy(-1.0);
        break;
    default:
        event->ignore();
    }
}

void ZoomView::zoomBy(double steps) { setHalfWidth(halfWidth() * std::pow(kZoomStep, -steps)); }

void ZoomView::turnBy(const QPointF& pixels) {
    camera_.turn(-kTurnPerPixel * pixels.x(), kTurnPerPixel * pixels.y());
    disturb();
    renderSoon();
}

void ZoomView::dragBy(const QPointF& pixels, bool finely) {
    if (!frame_) {
        return;
    }
    const double scale = (finely ? kFinely : 1.0) * metresPerPixel();
    const Vector3 move = camera_.horizontalMove(scale * pixels.x(), -scale * pixels.y());
    Q_EMIT tipDragged(move.x(), move.y(), 0.0);
}

QPointF ZoomView::onScreen(const Vector3& place) const {
    still_->SetWorldPoint(place.x(), place.y(), place.z(), 1.0);
    still_->WorldToDisplay();
    const double* display = still_->GetDisplayPoint();
    const double ratio = devicePixelRatioF();
    return {display[0] / ratio, height() - display[1] / ratio};
}

void ZoomView::resizeEvent(QResizeEvent* event) {
    QVTKOpenGLNativeWidget::resizeEvent(event);
    aimCamera();
    renderSoon();
}

double ZoomView::metresPerPixel() const {
    return 2.0 * still_->GetActiveCamera()->GetParallelScale() / height();
}

void ZoomView::aimCamera() {
    cache_.invalidate();
    if (frame_) {
        camera_.apply(still_->GetActiveCamera(), frameBox(),
                      static_cast<double>(width()) / height());
    }
}

/// Something of the still layer moves: for a while it is drawn coarsely.
void ZoomView::disturb() {
    settling_.start();
    terrainDue_ = true;
    aimCamera();
}

void ZoomView::settle() {
    terrainDue_ = true;
    renderSoon();
}

/// A frame within a few milliseconds, unless another one is drawn before.
void ZoomView::renderSoon() {
    contactDue_ = true;
    if (!frameDue_.isActive()) {
        frameDue_.start();
    }
}

void ZoomView::renderNow() {
    frameDue_.stop();
    showPicture();
    if (isValid()) {
        renderWindow_->Render();
        Q_EMIT frameRendered();
    }
}

}  // namespace asperity
