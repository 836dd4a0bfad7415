#include "ui/panels/CropPicture.h"

#include "ui/Theme.h"
#include "ui/panels/MapMarks.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

constexpr int kLeastDrag = 5;     ///< along both axes, that is no click [px]
constexpr int kWordsMargin = 12;  ///< around words [px]

/// The pixel under a place.
int pixelAt(double place, double begin, double length, int count) {
    return std::clamp(static_cast<int>(std::floor((place - begin) / length * count)), 0, count - 1);
}

}  // namespace

CropPicture::CropPicture(QWidget* parent) : QWidget(parent) {
    setMinimumSize(160, 100);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void CropPicture::setPicture(const QImage& image, const QSize& pixels, const QSizeF& size) {
    image_ = image;
    pixels_ = pixels;
    size_ = size;
    scaled_ = {};
    from_.reset();
    update();
}

void CropPicture::setWords(const QString& words) {
    words_ = words;
    update();
}

void CropPicture::setDrawable(bool drawable) {
    drawable_ = drawable;
    setCursor(drawable ? Qt::CrossCursor : Qt::ArrowCursor);
    setFocusPolicy(drawable ? Qt::ClickFocus : Qt::NoFocus);
}

void CropPicture::setCrop(const std::optional<PixelRectangle>& crop) {
    if (crop_ != crop) {
        crop_ = crop;
        update();
    }
}

/// Pixels that are not square are drawn as they are, where the size is known.
QRect CropPicture::pictureRect() const {
    if (image_.isNull()) {
        return {};
    }
    const QSizeF shape = size_.isEmpty() ? QSizeF(pixels_) : size_;
    const double scale = std::min(width() / shape.width(), height() / shape.height());
    const QSize drawn(std::max(1, static_cast<int>(scale * shape.width())),
                      std::max(1, static_cast<int>(scale * shape.height())));
    return {QPoint((width() - drawn.width()) / 2, (height() - drawn.height()) / 2), drawn};
}

QRectF CropPicture::onScreen(const PixelRectangle& part) const {
    const QRectF picture = pictureRect();
    const double x = picture.width() / pixels_.width();
    const double y = picture.height() / pixels_.height();
    return {picture.left() + (part.column * x), picture.top() + (part.row * y), part.columns * x,
            part.rows * y};
}

std::optional<PixelRectangle> CropPicture::between(const QPoint& from, const QPoint& to) const {
    const QPoint way = to - from;
    if (std::min(std::abs(way.x()), std::abs(way.y())) < kLeastDrag) {
        return std::nullopt;
    }
    const QRectF picture = pictureRect();
    const auto column = [&](int x) {
        return pixelAt(x, picture.left(), picture.width(), pixels_.width());
    };
    const auto row = [&](int y) {
        return pixelAt(y, picture.top(), picture.height(), pixels_.height());
    };
    const auto [left, right] = std::minmax({column(from.x()), column(to.x())});
    const auto [top, bottom] = std::minmax({row(from.y()), row(to.y())});
    const PixelRectangle part{left, top, right - left + 1, bottom - top + 1};
    const bool isAll = part.columns == pixels_.width() && part.rows == pixels_.height();
    return isAll ? std::nullopt : std::optional(part);
}

void CropPicture::mousePressEvent(QMouseEvent* event) {
    if (drawable_ && event->button() == Qt::LeftButton && !image_.isNull()) {
        from_ = event->pos();
        before_ = crop_;
    }
}

void CropPicture::mouseMoveEvent(QMouseEvent* event) {
    if (from_) {
        setCrop(between(*from_, event->pos()));
        Q_EMIT cropDragged(crop_);
    }
}

void CropPicture::mouseReleaseEvent(QMouseEvent* event) {
    if (from_ && event->button() == Qt::LeftButton) {
        setCrop(between(*std::exchange(from_, std::nullopt), event->pos()));
        Q_EMIT cropDrawn(crop_);
    }
}

void CropPicture::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && from_) {
        from_.reset();
        setCrop(before_);
        Q_EMIT cropDrawn(crop_);
        return;
    }
    QWidget::keyPressEvent(event);
}

void CropPicture::resizeEvent(QResizeEvent* /*event*/) { scaled_ = {}; }

void CropPicture::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setFont(theme::textFont(theme::kSmallSize));
    if (image_.isNull()) {
        painter.fillRect(rect(), theme::colors().paper);
        painter.setPen(theme::colors().muted);
        painter.drawText(rect().adjusted(kWordsMargin, kWordsMargin, -kWordsMargin, -kWordsMargin),
                         Qt::AlignCenter | Qt::TextWordWrap, words_);
        return;
    }
    const QRect picture = pictureRect();
    if (scaled_.isNull()) {
        scaled_ = QPixmap::fromImage(
            image_.scaled(picture.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
    }
    painter.drawPixmap(picture.topLeft(), scaled_);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(picture);
    drawCrop(painter, picture);
    if (!size_.isEmpty()) {
        drawScaleBar(painter, scaleBarOf(painter, picture, size_.width()));
    }
}

/// What is left out is pale.
void CropPicture::drawCrop(QPainter& painter, const QRect& picture) const {
    if (!crop_) {
        return;
    }
    const QRectF part = onScreen(*crop_);
    QPainterPath outside;
    outside.addRect(picture);
    QPainterPath inside;
    inside.addRect(part);
    QColor pale = theme::colors().paper;
    pale.setAlphaF(0.6);
    painter.fillPath(outside.subtracted(inside), pale);
    drawFrameMark(painter, part);
}

}  // namespace asperity
