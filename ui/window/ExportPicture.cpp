#include "ui/window/ExportPicture.h"

#include "ui/Theme.h"

#include <QPainter>

namespace asperity {

namespace {

constexpr int kCheck = 8;      // [px]
constexpr int kWordEdge = 24;  // [px]

/// Light whatever the theme, as the page that a picture goes to.
void paintChecks(QPainter& painter, const QRect& area) {
    const QColor light = toQColor(kLightPalette.paper);
    painter.fillRect(area, light);
    painter.save();
    painter.setClipRect(area);
    for (int y = 0; y * kCheck < area.height(); ++y) {
        for (int x = y % 2; x * kCheck < area.width(); x += 2) {
            painter.fillRect(area.left() + x * kCheck, area.top() + y * kCheck, kCheck, kCheck,
                             light.darker(112));
        }
    }
    painter.restore();
}

}  // namespace

ExportPicture::ExportPicture(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("exportPreview"));
    setToolTip(tr("The picture as it will be, smaller"));
    setMinimumSize(theme::scaled(280), theme::scaled(210));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void ExportPicture::setPicture(const QImage& picture) {
    picture_ = picture;
    words_.clear();
    update();
}

void ExportPicture::setWords(const QString& words) {
    picture_ = {};
    words_ = words;
    update();
}

void ExportPicture::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setPen(theme::colors().muted);
    if (picture_.isNull()) {
        painter.drawText(rect().adjusted(kWordEdge, 0, -kWordEdge, 0),
                         Qt::AlignCenter | Qt::TextWordWrap, words_);
        return;
    }
    QRect area(QPoint(), picture_.size().scaled(size(), Qt::KeepAspectRatio));
    area.moveCenter(rect().center());
    if (picture_.hasAlphaChannel()) {
        paintChecks(painter, area);
    }
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(area, picture_);
    painter.drawRect(area.adjusted(0, 0, -1, -1));
}

}  // namespace asperity
