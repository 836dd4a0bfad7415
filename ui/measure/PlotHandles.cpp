#include "ui/measure/PlotHandles.h"

#include "ui/panels/PlotNavigation.h"

#include <QMouseEvent>
#include <QWidget>

#include <cmath>

namespace asperity {

namespace {

constexpr double kHandleReach = 6.0;  ///< of the pointer [px]

}  // namespace

PlotHandles::PlotHandles(QWidget& canvas, const PlotNavigation& navigation)
    : QObject(&canvas), canvas_(canvas), navigation_(navigation) {
    canvas.installEventFilter(this);  // after the navigation's: it is asked before
}

int PlotHandles::handleAt(double pixel) const {
    int nearest = -1;
    double distance = kHandleReach;
    for (int i = 0; i < places_.size(); ++i) {
        const double one = std::abs(navigation_.pixelOf(places_[i]) - pixel);
        if (one <= distance) {
            distance = one;
            nearest = i;
        }
    }
    return nearest;
}

bool PlotHandles::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::MouseButtonPress && event->type() != QEvent::MouseMove &&
        event->type() != QEvent::MouseButtonRelease) {
        return QObject::eventFilter(watched, event);
    }
    const auto* mouse = static_cast<QMouseEvent*>(event);
    if (event->type() == QEvent::MouseButtonPress && mouse->button() == Qt::LeftButton) {
        held_ = handleAt(mouse->localPos().x());
        return held_ >= 0;
    }
    if (held_ < 0) {
        canvas_.setCursor(handleAt(mouse->localPos().x()) >= 0 ? Qt::SplitHCursor
                                                               : Qt::CrossCursor);
        return false;
    }
    Q_EMIT dragged(held_, navigation_.xOf(mouse->localPos().x()));
    if (event->type() == QEvent::MouseButtonRelease) {
        held_ = -1;
    }
    return true;
}

}  // namespace asperity
