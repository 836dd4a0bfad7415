#include "ui/view/OverviewMap.h"

#include "core/SiFormat.h"
#include "ui/widgets/Steady.h"
#include "ui/widgets/Theme.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

/// In nanometers or larger units: what is smaller than a picometer is no height.
QString scanLengthText(double meters) {
    const SiScale scale = siScaleFor(std::max(std::abs(meters), 1e-9), "m");
    return QString::fromStdString(scaledText(meters, scale, 2));
}

}  // namespace

OverviewMap::OverviewMap(QWidget* parent) : QWidget(parent) {
    setMinimumSize(120, 100);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setCursor(Qt::CrossCursor);
    setMouseTracking(true);
}

InputHelps OverviewMap::help() {
    return {{tr("Double click on the whole scan"), tr("moves the tip there")}};
}

void OverviewMap::setSurface(const BSplineSurface& surface) {
    relief_.setSurface(surface);
    size_ = {surface.sizeX(), surface.sizeY()};
    scaled_ = {};
    tip_.reset();
    frame_ = {};
    path_.clear();
    crossHair_.reset();
    update();
}

void OverviewMap::setLook(const SurfaceLook& look, const SurfaceField& field) {
    relief_.setLook(look, field);
    scaled_ = {};
    update();
}

void OverviewMap::showTip(const QPointF& position) {
    tip_.reset();
    if (std::isfinite(position.x()) && std::isfinite(position.y())) {
        tip_ = position;
    }
    update();
}

void OverviewMap::hideTip() {
    tip_.reset();
    update();
}

void OverviewMap::showFrame(const QRectF& frame) {
    frame_ = frame;
    update();
}

void OverviewMap::showPath(const QPolygonF& path) {
    path_ = path;
    update();
}

void OverviewMap::showCrossHair(const std::optional<QPointF>& position, const QString& reading) {
    crossHair_ = position;
    reading_ = reading;
    update();
}

QRectF OverviewMap::mapRect() const {
    if (size_.isEmpty()) {
        return {};
    }
    const double scale = std::min(width() / size_.width(), height() / size_.height());
    const QSize pixels(std::max(1, static_cast<int>(scale * size_.width())),
                       std::max(1, static_cast<int>(scale * size_.height())));
    const QPoint corner((width() - pixels.width()) / 2, (height() - pixels.height()) / 2);
    return {corner, pixels};
}

QPointF OverviewMap::toPixel(const QPointF& position) const {
    const QRectF map = mapRect();
    return {map.left() + (map.width() * position.x() / size_.width()),
            map.bottom() - (map.height() * position.y() / size_.height())};
}

QPointF OverviewMap::toPosition(const QPointF& pixel) const {
    const QRectF map = mapRect();
    return {(pixel.x() - map.left()) / map.width() * size_.width(),
            (map.bottom() - pixel.y()) / map.height() * size_.height()};
}

double OverviewMap::heightAt(const QPointF& position) const {
    const auto entry = [](double share, int count) {
        return std::clamp(static_cast<int>(share * count), 0, count - 1);
    };
    const int column = entry(position.x() / size_.width(), relief_.image().width());
    const int row = entry(1.0 - (position.y() / size_.height()), relief_.image().height());
    return relief_.heights()[(static_cast<std::size_t>(row) *
                              static_cast<std::size_t>(relief_.image().width())) +
                             static_cast<std::size_t>(column)];
}

QString OverviewMap::toolTipAt(const QPointF& pixel) const {
    if (!mapRect().contains(pixel)) {
        return {};
    }
    const QPointF at = toPosition(pixel);
    return tr("height %1\nx %2, y %3\n%4")
        .arg(scanLengthText(heightAt(at)), scanLengthText(at.x()), scanLengthText(at.y()),
             active_ != nullptr ? active_->hint() : tr("Double click: go there"));
}

QPointF OverviewMap::onScan(const QPointF& point) const {
    return {std::clamp(point.x(), 0.0, size_.width()), std::clamp(point.y(), 0.0, size_.height())};
}

void OverviewMap::addTool(MapTool& tool) {
    tools_.push_back(&tool);
    connect(&tool, &MapTool::marksChanged, this, qOverload<>(&QWidget::update));
    connect(&tool, &QObject::destroyed, this, [this, gone = &tool] {
        if (active_ == gone) {
            activate(nullptr);
        }
        tools_.erase(std::remove(tools_.begin(), tools_.end(), gone), tools_.end());
        update();
    });
}

void OverviewMap::activate(MapTool* tool) {
    if (tool == active_) {
        return;
    }
    active_ = tool;
    pressed_ = false;
    setCursor(Qt::CrossCursor);
    Q_EMIT toolActivated(active_);
}

MapPointer OverviewMap::pointerOf(const QMouseEvent& event) const {
    return {event.localPos(), toPosition(event.localPos()), event.modifiers()};
}

bool OverviewMap::belongsToTool(const QMouseEvent& event) const {
    return active_ != nullptr && event.button() == Qt::LeftButton && !size_.isEmpty();
}

void OverviewMap::mousePressEvent(QMouseEvent* event) {
    if (belongsToTool(*event)) {
        pressed_ = true;
        active_->press(pointerOf(*event), *this);
    }
}

void OverviewMap::mouseMoveEvent(QMouseEvent* event) {
    if (mapRect().contains(event->localPos())) {
        const QPointF position = toPosition(event->localPos());
        Q_EMIT positionHovered(position.x(), position.y());
    } else {
        Q_EMIT pointerLeft();
    }
    if (active_ == nullptr || size_.isEmpty()) {
        return;
    }
    if (pressed_) {
        active_->drag(pointerOf(*event), *this);
    } else {
        setCursor(active_->cursor(pointerOf(*event), *this));
    }
}

void OverviewMap::mouseReleaseEvent(QMouseEvent* event) {
    if (belongsToTool(*event) && pressed_) {
        pressed_ = false;
        active_->release(pointerOf(*event), *this);
    }
}

bool OverviewMap::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) {
        return QWidget::event(event);
    }
    const auto* help = static_cast<QHelpEvent*>(event);
    const QString there = toolTipAt(help->pos());
    QToolTip::showText(help->globalPos(), there.isEmpty() ? toolTip() : there, this);
    return true;
}

void OverviewMap::mouseDoubleClickEvent(QMouseEvent* event) {
    if (belongsToTool(*event)) {
        active_->doubleClick(pointerOf(*event), *this);
        return;
    }
    if (event->button() == Qt::LeftButton && mapRect().contains(event->localPos())) {
        const QPointF position = toPosition(event->localPos());
        Q_EMIT positionChosen(position.x(), position.y());
    }
}

void OverviewMap::leaveEvent(QEvent* event) {
    Q_EMIT pointerLeft();
    QWidget::leaveEvent(event);
}

void OverviewMap::resizeEvent(QResizeEvent* /*event*/) { scaled_ = {}; }

void OverviewMap::paintEvent(QPaintEvent* /*event*/) {
    const QRectF map = mapRect();
    if (map.isEmpty()) {
        return;
    }
    if (scaled_.isNull()) {
        scaled_ = QPixmap::fromImage(relief_.image().scaled(
            map.size().toSize(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
    }
    QPainter painter(this);
    painter.drawPixmap(map.topLeft(), scaled_);
    painter.setClipRect(map);
    painter.setRenderHint(QPainter::Antialiasing);
    if (path_.size() > 1) {
        QPolygonF drawn;
        for (const QPointF& position : path_) {
            drawn << toPixel(position);
        }
        drawPathMark(painter, drawn);
    }
    painter.setFont(theme::textFont(theme::kSmallSize));
    drawScaleBar(painter, scaleBar(painter, map));
    drawFrame(painter);
    for (const MapTool* const tool : tools_) {
        painter.save();
        tool->paint(painter, *this);
        painter.restore();
    }
    drawTip(painter, map);
    drawCrossHair(painter, map);
}

void OverviewMap::drawCrossHair(QPainter& painter, const QRectF& map) const {
    if (!crossHair_) {
        return;
    }
    const QPointF pixel = toPixel(*crossHair_);
    painter.setPen(QPen(theme::colors().marker, 1.0));
    painter.drawLine(QPointF(map.left(), pixel.y()), QPointF(map.right(), pixel.y()));
    painter.drawLine(QPointF(pixel.x(), map.top()), QPointF(pixel.x(), map.bottom()));
    painter.setFont(theme::textFont(theme::kSmallSize));
    constexpr int kInset = 4;
    QString reading = reading_;
    if (painter.fontMetrics().horizontalAdvance(reading) > map.width() - 4 * kInset) {
        reading.replace(QLatin1String("   "), QLatin1String("\n"));  // a number a line
    }
    const QRect text = painter.fontMetrics().boundingRect(map.toRect(), Qt::AlignLeft, reading);
    QRect plate(map.topLeft().toPoint() + QPoint(kInset, kInset),
                text.size() + QSize(2 * kInset, kInset));
    if (plate.adjusted(-kInset, -kInset, kInset, kInset).contains(pixel.toPoint())) {
        // Out of the pointer's way, and not over the scale bar.
        plate.moveBottom(static_cast<int>(scaleBar(painter, map).plate.top()) - kInset);
    }
    QColor paper(theme::colors().paper);
    paper.setAlphaF(0.88);
    painter.fillRect(plate, paper);
    painter.setPen(theme::colors().ink);
    painter.drawText(plate.adjusted(kInset, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, reading);
}

ScaleBar OverviewMap::scaleBar(const QPainter& painter, const QRectF& map) const {
    ScaleBar bar = scaleBarOf(painter, map, size_.width());
    if (tip_ && bar.plate.adjusted(-12.0, -12.0, 12.0, 12.0).contains(toPixel(*tip_))) {
        bar.plate.moveRight(map.right() - 5.0);  // out of the tip's way
    }
    return bar;
}

void OverviewMap::drawFrame(QPainter& painter) const {
    if (frame_.isEmpty()) {
        return;
    }
    const QRectF drawn =
        QRectF(toPixel(frame_.bottomLeft()), toPixel(frame_.topRight())).normalized();
    drawFrameMark(painter, drawn);
}

void OverviewMap::drawTip(QPainter& painter, const QRectF& map) const {
    if (!tip_) {
        return;
    }
    // Outside the scan the mark stays at its edge, so that nobody loses the tip.
    const QPointF position = toPixel(*tip_);
    drawTipMark(painter, {std::clamp(position.x(), map.left(), map.right()),
                          std::clamp(position.y(), map.top(), map.bottom())});
}

}  // namespace asperity
