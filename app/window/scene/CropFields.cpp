#include "app/window/scene/CropFields.h"

#include "ui/view/MapTool.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/NumberBox.h"
#include "ui/widgets/ShownText.h"
#include "ui/widgets/Theme.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace asperity {

namespace {

constexpr int kMinCropDrag = 5;   ///< along both axes, that is no click [px]
constexpr int kWordsMargin = 12;  ///< around words [px]

/// The pixel under a position.
int pixelAt(double at, double begin, double length, int count) {
    return std::clamp(static_cast<int>(std::floor((at - begin) / length * count)), 0, count - 1);
}

constexpr int kCropGap = 6;  // [px]

/// Returns whether a number is being typed, which does not count yet.
bool isTyped(const QSpinBox& box) {
    return box.hasFocus() && box.findChild<QLineEdit*>()->isModified();
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
    if (std::min(std::abs(way.x()), std::abs(way.y())) < kMinCropDrag) {
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

CropFields::CropFields(QWidget* parent) : QWidget(parent) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(kCropGap);
    column_ = addBox(*grid, {0, 0}, "cropColumn", tr("From column"),
                     tr("First column of the part to load [pixel]; 0 is the left one"));
    columns_ =
        addBox(*grid, {1, 0}, "cropColumns", tr("Columns"), tr("How many columns to load [pixel]"));
    row_ = addBox(*grid, {0, 1}, "cropRow", tr("From row"),
                  tr("First row of the part to load [pixel]; 0 is the top one"));
    rows_ = addBox(*grid, {1, 1}, "cropRows", tr("Rows"), tr("How many rows to load [pixel]"));
    extent_ = captionLabel({}, this);
    extent_->setObjectName(QStringLiteral("cropExtent"));
    extent_->setToolTip(tr("Size of the part to load; positions count from its lower left corner"));
    whole_ = new QPushButton(tr("Whole scan"), this);
    whole_->setObjectName(QStringLiteral("cropWhole"));
    whole_->setAutoDefault(false);
    whole_->setToolTip(tr("Load all of the scan"));
    grid->addWidget(extent_, 4, 0);
    grid->addWidget(whole_, 4, 1);
    connect(whole_, &QPushButton::clicked, this, [this] {
        setCrop(std::nullopt);
        Q_EMIT cropEntered(crop_);
    });
    showNumbers(Typed::Goes);
}

QSpinBox* CropFields::addBox(QGridLayout& grid, const QPoint& cell, const char* name,
                             const QString& caption, const QString& tip) {
    auto* box = new QSpinBox(this);
    box->setObjectName(QString::fromUtf8(name));
    box->setToolTip(tip);
    box->setKeyboardTracking(false);
    guardFromWheel(*box);
    grid.addWidget(captionLabel(caption, this), 2 * cell.y(), cell.x());
    grid.addWidget(box, 2 * cell.y() + 1, cell.x());
    connect(box, qOverload<int>(&QSpinBox::valueChanged), this, &CropFields::enter);
    return box;
}

void CropFields::showScan(const QSize& pixels, const QSizeF& size,
                          const std::optional<PixelRectangle>& crop) {
    pixels_ = pixels.expandedTo({1, 1});
    size_ = size;
    crop_ = crop;
    showNumbers(Typed::Stays);
}

void CropFields::setCrop(const std::optional<PixelRectangle>& crop) {
    crop_ = crop;
    showNumbers(Typed::Goes);
}

/// Another beginning moves the part, and cuts what would lie beyond the scan.
void CropFields::enter() {
    const int column = std::min(column_->value(), pixels_.width() - 1);
    const int row = std::min(row_->value(), pixels_.height() - 1);
    const PixelRectangle part{column, row, std::min(columns_->value(), pixels_.width() - column),
                              std::min(rows_->value(), pixels_.height() - row)};
    const bool isAll = part == PixelRectangle{0, 0, pixels_.width(), pixels_.height()};
    setCrop(isAll ? std::nullopt : std::optional(part));
    Q_EMIT cropEntered(crop_);
}

void CropFields::showNumbers(Typed typed) {
    const PixelRectangle part =
        crop_.value_or(PixelRectangle{0, 0, pixels_.width(), pixels_.height()});
    const auto put = [typed](QSpinBox& box, int least, int most, int value) {
        if (typed == Typed::Stays && isTyped(box)) {
            return;
        }
        const QSignalBlocker blocker(box);
        box.setRange(least, most);
        box.setValue(value);
    };
    put(*column_, 0, pixels_.width() - 1, part.column);
    put(*row_, 0, pixels_.height() - 1, part.row);
    put(*columns_, 1, pixels_.width(), part.columns);
    put(*rows_, 1, pixels_.height(), part.rows);
    whole_->setEnabled(crop_.has_value());
    extent_->setText(
        size_.isEmpty()
            ? QString()
            : tr("%1 × %2").arg(siText(size_.width() * part.columns / pixels_.width(), "m"),
                                siText(size_.height() * part.rows / pixels_.height(), "m")));
}

}  // namespace asperity
