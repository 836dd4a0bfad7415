#include "ui/view/PixelView.h"

#include "ui/widgets/Theme.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderWindow.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace asperity {

namespace {

/// Of red, green, blue and alpha bytes to that of QImage::Format_RGB32.
std::uint32_t colorOf(std::uint32_t rgba) {
    constexpr std::uint32_t kByte = 0xffU;
    const std::uint32_t red = rgba & kByte;
    const std::uint32_t green = (rgba >> 8U) & kByte;
    const std::uint32_t blue = (rgba >> 16U) & kByte;
    return 0xff000000U | (red << 16U) | (green << 8U) | blue;
}

/// The rows of OpenGL begin at the bottom.
void copyFrame(const unsigned char* drawn, QImage& frame) {
    const auto columns = static_cast<std::size_t>(frame.width());
    for (int row = 0; row < frame.height(); ++row) {
        const auto from = static_cast<std::size_t>(frame.height() - 1 - row) * columns;
        auto* const to = reinterpret_cast<std::uint32_t*>(frame.scanLine(row));
        for (std::size_t i = 0; i < columns; ++i) {
            std::uint32_t rgba = 0;
            std::memcpy(&rgba, drawn + sizeof(rgba) * (from + i), sizeof(rgba));
            to[i] = colorOf(rgba);
        }
    }
}

qint64 areaOf(const QSize& size) { return qint64{size.width()} * size.height(); }

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

PixelView::PixelView(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    window_->SetOffScreenRendering(1);
    window_->SetMultiSamples(0);                // multisampling takes half the frame rate
    renderWindow().SetFrameBlitModeToNoBlit();  // its pixels are read where they are drawn
}

PixelView::~PixelView() = default;

vtkOpenGLRenderWindow& PixelView::renderWindow() const {
    return *vtkOpenGLRenderWindow::SafeDownCast(window_);
}

QSize PixelView::pixels(double ratio) const {
    return (QSizeF(size()) * ratio).toSize().expandedTo(QSize(1, 1));
}

double PixelView::drawnRatio() const {
    constexpr double kCoarsePixels = 500'000.0;
    const double area = std::max(1.0, static_cast<double>(width()) * height());
    const double screen = devicePixelRatioF();
    return coarse_ ? std::min(screen, std::sqrt(kCoarsePixels / area)) : screen;
}

void PixelView::setCoarse(bool coarse) {
    coarse_ = coarse;
    const QSize size = pixels(drawnRatio());
    window_->SetSize(size.width(), size.height());
}

bool PixelView::makeBuffers() {
    const QSize size = pixels(drawnRatio());
    const bool areSmall = areaOf(size) > areaOf(buffers_);
    hasJustMadeBuffers_ = isVisible() && areSmall && !hasJustMadeBuffers_;
    if (hasJustMadeBuffers_) {
        window_->SetSize(size.width(), size.height());
        renderWindow().Start();
        renderWindow().End();
        buffers_ = size;
    }
    return hasJustMadeBuffers_;
}

bool PixelView::drawFrame() {
    if (!isVisible()) {
        return false;
    }
    const double ratio = drawnRatio();
    const QSize size = pixels(ratio);
    window_->SetSize(size.width(), size.height());
    window_->Render();
    buffers_ = size;
    window_->GetRGBACharPixelData(0, 0, size.width() - 1, size.height() - 1, 0, drawn_);
    const auto values = static_cast<vtkIdType>(4) * size.width() * size.height();
    if (drawn_->GetNumberOfValues() != values) {  // OpenGL could not draw it
        return false;
    }
    if (frame_.size() != size) {
        frame_ = QImage(size, QImage::Format_RGB32);
    }
    frame_.setDevicePixelRatio(ratio);
    copyFrame(drawn_->GetPointer(0), frame_);
    update();
    return true;
}

void PixelView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    if (frame_.isNull() || frame_.size() != pixels(frame_.devicePixelRatio())) {  // another size's
        painter.fillRect(rect(), theme::colors().backdrop);
    }
    if (frame_.isNull()) {
        return;
    }
    if (frame_.devicePixelRatio() == devicePixelRatioF()) {
        painter.drawImage(0, 0, frame_);
    } else {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(rect(), frame_);
    }
    Q_EMIT painted();
}

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
