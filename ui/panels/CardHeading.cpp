#include "ui/panels/CardHeading.h"

#include "ui/Theme.h"

#include <QApplication>
#include <QMouseEvent>

namespace asperity {

CardHeading::CardHeading(const QString& title, QWidget* parent) : QToolButton(parent) {
    setProperty("heading", true);
    setText(title);
    setFont(theme::boldFont());
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setFocusPolicy(Qt::NoFocus);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    secondClick_.setSingleShot(true);
    connect(&secondClick_, &QTimer::timeout, this, &CardHeading::foldRequested);
    connect(this, &QToolButton::clicked, this, &CardHeading::take);
}

void CardHeading::setActive() { setAttribute(Qt::WA_TransparentForMouseEvents, false); }

void CardHeading::setState(bool folded, bool enlarged) {
    setArrowType(folded ? Qt::RightArrow : Qt::DownArrow);
    setToolTip(enlarged ? tr("Double click: back to its place")
               : folded ? tr("Click: unfold this panel. Double click: enlarge it")
                        : tr("Click: fold this panel. Double click: enlarge it"));
}

bool CardHeading::isOnArrow(const QPoint& place) const { return place.x() <= iconSize().width(); }

void CardHeading::mousePressEvent(QMouseEvent* event) {
    pressedArrow_ = isOnArrow(event->pos());
    QToolButton::mousePressEvent(event);
}

void CardHeading::take() {
    if (pressedArrow_) {
        Q_EMIT foldRequested();
    } else {
        secondClick_.start(QApplication::doubleClickInterval());
    }
}

void CardHeading::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || isOnArrow(event->pos())) {
        QToolButton::mouseDoubleClickEvent(event);  // two clicks on the arrow are two clicks
        return;
    }
    secondClick_.stop();
    Q_EMIT enlargeRequested();
}

}  // namespace asperity
