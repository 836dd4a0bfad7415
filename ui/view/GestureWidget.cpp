#include "ui/view/GestureWidget.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

namespace asperity {

namespace {

constexpr double kFinely = 0.1;
constexpr double kWheelNotch = 120.0;  // eighths of a degree

double fineness(Qt::KeyboardModifiers modifiers) {
    return modifiers.testFlag(Qt::ShiftModifier) ? kFinely : 1.0;
}

}  // namespace

GestureWidget::GestureWidget(QWidget* parent) : QVTKOpenGLNativeWidget(parent) {
    setMouseTracking(true);
}

void GestureWidget::mousePressEvent(QMouseEvent* event) {
    pointer_ = event->localPos();
    dragging_ = event->buttons().testFlag(Qt::LeftButton);
}

void GestureWidget::mouseMoveEvent(QMouseEvent* event) {
    const QPointF pixels = event->localPos() - pointer_;
    pointer_ = event->localPos();
    if (event->buttons().testFlag(Qt::LeftButton)) {
        Q_EMIT dragged(fineness(event->modifiers()) * pixels);
    } else if (event->buttons().testFlag(Qt::RightButton)) {
        Q_EMIT turned(pixels);
    } else if (event->buttons() == Qt::NoButton) {
        Q_EMIT hovered(pointer_);
    }
}

void GestureWidget::mouseReleaseEvent(QMouseEvent* event) {
    dragging_ = event->buttons().testFlag(Qt::LeftButton);
}

void GestureWidget::leaveEvent(QEvent* event) {
    Q_EMIT unhovered();
    QVTKOpenGLNativeWidget::leaveEvent(event);
}

void GestureWidget::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / kWheelNotch;
    if (event->modifiers().testFlag(Qt::ControlModifier)) {
        Q_EMIT zoomed(notches);
    } else {
        Q_EMIT lifted(fineness(event->modifiers()) * notches);
    }
    event->accept();
}

void GestureWidget::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:  // the same key on many keyboards
        Q_EMIT zoomed(1.0);
        break;
    case Qt::Key_Minus:
        Q_EMIT zoomed(-1.0);
        break;
    default:
        event->ignore();
    }
}

}  // namespace asperity
