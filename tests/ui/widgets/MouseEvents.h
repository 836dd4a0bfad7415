#pragma once

#include <QApplication>
#include <QMouseEvent>
#include <QWheelEvent>
#include <QWidget>

namespace asperity::test {

/// Sends a widget one event of the mouse. QTest::mouseMove() tells of no pressed button.
inline void sendMouse(QWidget& widget, QEvent::Type type, const QPointF& position,
                      Qt::MouseButton button, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    const bool moves = type == QEvent::MouseMove;
    const Qt::MouseButtons held =
        type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::MouseButtons(button);
    QMouseEvent event(type, position, widget.mapToGlobal(position.toPoint()),
                      moves ? Qt::NoButton : button, held, modifiers);
    QApplication::sendEvent(&widget, &event);
}

/// Press, move in two steps, release.
inline void dragMouse(QWidget& widget, const QPointF& from, const QPointF& to,
                      Qt::KeyboardModifiers modifiers = Qt::NoModifier,
                      Qt::MouseButton button = Qt::LeftButton) {
    sendMouse(widget, QEvent::MouseButtonPress, from, button, modifiers);
    sendMouse(widget, QEvent::MouseMove, 0.5 * (from + to), button, modifiers);
    sendMouse(widget, QEvent::MouseMove, to, button, modifiers);
    sendMouse(widget, QEvent::MouseButtonRelease, to, button, modifiers);
}

inline void sendWheel(QWidget& widget, const QPointF& position, int notches,
                      Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QWheelEvent event(position, widget.mapToGlobal(position.toPoint()), {}, {0, 120 * notches},
                      Qt::NoButton, modifiers, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&widget, &event);
}

}  // namespace asperity::test
