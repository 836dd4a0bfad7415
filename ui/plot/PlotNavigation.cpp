#include "ui/plot/PlotNavigation.h"

#include "vtkplugins/pictures/Ticks.h"

#include <QMouseEvent>
#include <QRubberBand>
#include <QWheelEvent>
#include <QWidget>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kHandleReach = 6.0;  ///< of the pointer [px]

constexpr double kNotch = 1.25;        ///< by which a notch of the wheel zooms
constexpr double kNotchAngle = 120.0;  ///< of a wheel [1/8 degree]
constexpr double kMinZoomDrag = 6.0;   ///< of a rectangle along an axis [px]
constexpr double kMaxZoom = 1e5;       ///< beyond it rounding shows
constexpr double kMaxOut = 20.0;       ///< wholes that are seen at most

double width(const AxisRange& range) { return range.high - range.low; }

/// Scaled about a position; factor above 1: more is seen.
AxisRange zoomed(const AxisRange& range, double about, double factor) {
    return {about + factor * (range.low - about), about + factor * (range.high - about)};
}

AxisRange shifted(const AxisRange& range, double by) { return {range.low + by, range.high + by}; }

/// Moved into the limits, and not wider than they are.
AxisRange within(const AxisRange& range, const AxisRange& limits) {
    if (width(range) >= width(limits)) {
        return limits;
    }
    const double by =
        std::max(0.0, limits.low - range.low) + std::min(0.0, limits.high - range.high);
    return shifted(range, by);
}

bool isSensible(const AxisRange& range, const AxisRange& whole) {
    return std::isfinite(range.low) && std::isfinite(range.high) &&
           width(range) > width(whole) / kMaxZoom && width(range) < kMaxOut * width(whole);
}

}  // namespace

PlotHandles::PlotHandles(QWidget& canvas, const PlotNavigation& navigation)
    : QObject(&canvas), canvas_(canvas), navigation_(navigation) {
    canvas.installEventFilter(this);  // after the navigation's: it is asked before
}

int PlotHandles::handleAt(double pixel) const {
    int nearest = -1;
    double distance = kHandleReach;
    for (int i = 0; i < positions_.size(); ++i) {
        const double one = std::abs(navigation_.pixelOf(positions_[i]) - pixel);
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

PlotNavigation::PlotNavigation(QWidget& canvas, const std::optional<AxisRange>& xLimits)
    : QObject(&canvas)
    , canvas_(canvas)
    , xLimits_(xLimits)
    , band_(new QRubberBand(QRubberBand::Rectangle, &canvas)) {
    canvas.setMouseTracking(true);
    canvas.setCursor(Qt::CrossCursor);
    canvas.installEventFilter(this);
}

QString PlotNavigation::help() {
    return tr("Wheel: zoom (Ctrl: only along, Shift: only up and down);\n"
              "drag: zoom into a rectangle; right drag: move; double click: all");
}

const PlotWindow& PlotNavigation::fit(const PlotWindow& whole) {
    whole_ = whole;
    if (!zoomed_) {
        shown_ = whole;
    }
    return shown_;
}

void PlotNavigation::reset() {
    if (zoomed_) {
        zoomed_ = false;
        shown_ = whole_;
        Q_EMIT windowChanged();
    }
}

std::optional<double> PlotNavigation::cursor() const {
    if (!pointer_ || drag_ != Drag::None) {
        return std::nullopt;
    }
    return positionOf(*pointer_).x();
}

double PlotNavigation::xOf(double pixel) const { return positionOf({pixel, 0.0}).x(); }

double PlotNavigation::pixelOf(double x) const {
    const QRectF area = canvas_.contentsRect();
    return area.left() + (x - shown_.x.low) / width(shown_.x) * area.width();
}

QPointF PlotNavigation::positionOf(const QPointF& pixel) const {
    const QRectF area = canvas_.contentsRect();
    return {shown_.x.low + (pixel.x() - area.left()) / area.width() * width(shown_.x),
            shown_.y.high - (pixel.y() - area.top()) / area.height() * width(shown_.y)};
}

void PlotNavigation::look(const PlotWindow& window) {
    const AxisRange x = xLimits_ ? within(window.x, *xLimits_) : window.x;
    if (isSensible(x, whole_.x) && isSensible(window.y, whole_.y)) {
        shown_ = {x, window.y};
        zoomed_ = true;
        Q_EMIT windowChanged();
    }
}

bool PlotNavigation::eventFilter(QObject* watched, QEvent* event) {
    const auto mouse = [event]() -> const QMouseEvent& {
        return *static_cast<QMouseEvent*>(event);
    };
    switch (event->type()) {
    case QEvent::MouseButtonPress:
        press(mouse());
        return true;
    case QEvent::MouseMove:
        move(mouse());
        return true;
    case QEvent::MouseButtonRelease:
        release(mouse());
        return true;
    case QEvent::MouseButtonDblClick:
        reset();
        return true;
    case QEvent::Wheel:
        turnWheel(*static_cast<QWheelEvent*>(event));
        return true;
    case QEvent::Leave:
        pointer_.reset();
        Q_EMIT cursorMoved();
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

void PlotNavigation::press(const QMouseEvent& event) {
    const bool pans =
        event.button() != Qt::LeftButton || event.modifiers().testFlag(Qt::ControlModifier);
    drag_ = pans ? Drag::Pan : Drag::Rectangle;
    pressed_ = event.localPos();
    before_ = shown_;
    Q_EMIT cursorMoved();
}

void PlotNavigation::move(const QMouseEvent& event) {
    pointer_ = event.localPos();
    const QPointF way = event.localPos() - pressed_;
    if (drag_ == Drag::Pan && way.manhattanLength() > 0.0) {
        const QRectF area = canvas_.contentsRect();
        look({shifted(before_.x, -way.x() / area.width() * width(before_.x)),
              shifted(before_.y, way.y() / area.height() * width(before_.y))});
    } else if (drag_ == Drag::Rectangle && way.manhattanLength() > kMinZoomDrag) {
        band_->setGeometry(QRect(pressed_.toPoint(), event.pos()).normalized());
        band_->show();
    }
    Q_EMIT cursorMoved();
}

void PlotNavigation::release(const QMouseEvent& event) {
    const Drag ended = drag_;
    drag_ = Drag::None;
    band_->hide();
    if (ended == Drag::Rectangle) {
        zoomInto(QRectF(pressed_, event.localPos()).normalized());
    }
    Q_EMIT cursorMoved();
}

void PlotNavigation::zoomInto(const QRectF& pixels) {
    const QRectF seen = pixels.intersected(QRectF(canvas_.contentsRect()));
    const bool wide = seen.width() >= kMinZoomDrag;
    const bool high = seen.height() >= kMinZoomDrag;
    if (!wide && !high) {
        return;
    }
    const QPointF lowest = positionOf(seen.bottomLeft());
    const QPointF highest = positionOf(seen.topRight());
    look({wide ? AxisRange{lowest.x(), highest.x()} : shown_.x,
          high ? AxisRange{lowest.y(), highest.y()} : shown_.y});
}

void PlotNavigation::turnWheel(const QWheelEvent& event) {
    const double notches = event.angleDelta().y() / kNotchAngle;
    const double factor = std::pow(kNotch, -notches);
    const QPointF about = positionOf(event.position());
    const bool onlyX = event.modifiers().testFlag(Qt::ControlModifier);
    const bool onlyY = event.modifiers().testFlag(Qt::ShiftModifier);
    look({onlyY ? shown_.x : zoomed(shown_.x, about.x(), factor),
          onlyX ? shown_.y : zoomed(shown_.y, about.y(), factor)});
}

std::vector<double> axisTicks(double low, double high, int room) {
    constexpr int kMaxTicks = 6;
    std::vector<double> ticks = niceTicks(low, high, room);
    for (int count = room + 1; ticks.size() < 2 && count <= kMaxTicks; ++count) {
        ticks = niceTicks(low, high, count);
    }
    if (ticks.size() > 2 && static_cast<int>(ticks.size()) > room + 1) {
        ticks = {ticks.front(), ticks.back()};  // more would lie on one another
    }
    return ticks;
}

}  // namespace asperity
