#include "ui/view/GestureWidget.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <array>

namespace asperity {

namespace {

constexpr double kFinely = 0.1;
constexpr double kWheelNotch = 120.0;  // eighths of a degree

/// A key that zooms, without modifiers.
struct ZoomKey {
    Qt::Key key;
    double steps;
};

constexpr std::array<ZoomKey, 3> kZoomKeys{{
    {Qt::Key_Plus, 1.0},
    {Qt::Key_Equal, 1.0},  // the same key on many keyboards
    {Qt::Key_Minus, -1.0},
}};

const ZoomKey* zoomKey(int key) {
    const auto* const found = std::find_if(kZoomKeys.begin(), kZoomKeys.end(),
                                           [key](const ZoomKey& zoom) { return zoom.key == key; });
    return found == kZoomKeys.end() ? nullptr : found;
}

double fineness(Qt::KeyboardModifiers modifiers) {
    return modifiers.testFlag(Qt::ShiftModifier) ? kFinely : 1.0;
}

}  // namespace

GestureWidget::GestureWidget(QWidget* parent) : PixelView(parent) { setMouseTracking(true); }

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
    PixelView::leaveEvent(event);
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
    if (const ZoomKey* const zoom = zoomKey(event->key())) {
        Q_EMIT zoomed(zoom->steps);
    } else {
        event->ignore();
    }
}

InputHelps GestureWidget::help() {
    return {{tr("Left drag"), tr("moves the tip along the sample")},
            {tr("Wheel"), tr("moves the tip away from the sample and into it")},
            {tr("Shift and left drag or wheel"), tr("a tenth of that")},
            {tr("Right drag"), tr("turns the view")},
            {tr("Ctrl + wheel, +, −"), tr("zoom")}};
}

bool GestureWidget::takes(int key, Qt::KeyboardModifiers modifiers) {
    return zoomKey(key) != nullptr &&
           (modifiers & ~(Qt::KeypadModifier | Qt::ShiftModifier)) == Qt::NoModifier;
}

}  // namespace asperity
