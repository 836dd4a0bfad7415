#include "ui/HeldKeys.h"

#include <QKeyEvent>

namespace asperity {

namespace {

bool movesTheDevice(int key) {
    static const QSet<int> kKeys{Qt::Key_Left, Qt::Key_Right,  Qt::Key_Up,
                                 Qt::Key_Down, Qt::Key_PageUp, Qt::Key_PageDown};
    return kKeys.contains(key);
}

double speed(Qt::KeyboardModifiers modifiers) {
    if (modifiers.testFlag(Qt::ShiftModifier)) {
        return 0.1;
    }
    return modifiers.testFlag(Qt::ControlModifier) ? 5.0 : 1.0;
}

}  // namespace

HeldKeys::HeldKeys(QObject* watched) : QObject(watched) { watched->installEventFilter(this); }

double HeldKeys::pull(int positive, int negative) const {
    return (held_.contains(positive) ? 1.0 : 0.0) - (held_.contains(negative) ? 1.0 : 0.0);
}

KeyDirection HeldKeys::direction() const {
    const double share = speed(modifiers_);
    return {.right = share * pull(Qt::Key_Right, Qt::Key_Left),
            .forward = share * pull(Qt::Key_Up, Qt::Key_Down),
            .up = share * pull(Qt::Key_PageUp, Qt::Key_PageDown)};
}

bool HeldKeys::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusOut) {
        held_.clear();
    }
    if (event->type() != QEvent::KeyPress && event->type() != QEvent::KeyRelease) {
        return QObject::eventFilter(watched, event);
    }
    const auto* key = static_cast<QKeyEvent*>(event);
    modifiers_ = key->modifiers();
    if (!movesTheDevice(key->key())) {
        return QObject::eventFilter(watched, event);
    }
    if (event->type() == QEvent::KeyPress) {
        held_.insert(key->key());
    } else if (!key->isAutoRepeat()) {
        held_.remove(key->key());
    }
    return true;
}

}  // namespace asperity
