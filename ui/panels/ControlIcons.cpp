#include "ui/panels/ControlIcons.h"

#include "ui/Theme.h"

#include <QPainter>
#include <QPixmap>

namespace asperity {

namespace {

constexpr int kSize = 16;  ///< [px]

void drawStart(QPainter& painter, const QColor& color) {
    painter.setBrush(color);
    painter.drawPolygon(QPolygonF({{4.0, 2.5}, {13.5, 8.0}, {4.0, 13.5}}));
}

void drawPause(QPainter& painter, const QColor& color) {
    painter.setBrush(color);
    painter.drawRect(QRectF(4.0, 3.0, 3.0, 10.0));
    painter.drawRect(QRectF(9.0, 3.0, 3.0, 10.0));
}

/// An arrow that pushes up against a line.
void drawForces(QPainter& painter, const QColor& color) {
    painter.setBrush(color);
    painter.drawRect(QRectF(7.0, 7.0, 2.0, 7.5));
    painter.drawPolygon(QPolygonF({{8.0, 2.5}, {12.0, 8.0}, {4.0, 8.0}}));
    painter.drawRect(QRectF(3.0, 1.0, 10.0, 1.2));
}

void drawRecord(QPainter& painter) {
    painter.setBrush(theme::colors().fault);
    painter.drawEllipse(QPointF(8.0, 8.0), 4.5, 4.5);
}

/// @param onAccent the color of what lies upon the accent
QPixmap drawn(ControlIcon icon, const QColor& onAccent) {
    QPixmap pixmap(kSize, kSize);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    switch (icon) {
    case ControlIcon::Start:
        drawStart(painter, onAccent);
        break;
    case ControlIcon::Pause:
        drawPause(painter, onAccent);
        break;
    case ControlIcon::PauseCurves:
        drawPause(painter, theme::colors().ink);
        break;
    case ControlIcon::ForcesOn:
        drawForces(painter, theme::colors().force);
        break;
    case ControlIcon::ForcesOff:
        drawForces(painter, theme::colors().faint);
        break;
    case ControlIcon::Record:
        drawRecord(painter);
        break;
    }
    return pixmap;
}

}  // namespace

QIcon controlIcon(ControlIcon icon) {
    QIcon both(drawn(icon, theme::colors().onAccent));
    if (icon == ControlIcon::Start || icon == ControlIcon::Pause) {
        // Their button has no accent then: what is drawn for it cannot be seen upon paper.
        both.addPixmap(drawn(icon, theme::colors().muted), QIcon::Disabled);
    }
    return both;
}

}  // namespace asperity
