#include "ui/widgets/HeldKeys.h"

#include <QKeyEvent>
#include <QKeySequence>
#include <QStringList>

#include <algorithm>
#include <array>

namespace asperity {

namespace {

/// A key that moves the device while it is held.
struct MovingKey {
    Qt::Key key;
    double KeyDirection::*axis;
    double sign;
    const char* effect;
};

constexpr const char* kAlong = QT_TRANSLATE_NOOP("HeldKeys", "along the sample, as on the screen");
constexpr std::array<MovingKey, 6> kMovingKeys{{
    {Qt::Key_Left, &KeyDirection::right, -1.0, kAlong},
    {Qt::Key_Right, &KeyDirection::right, 1.0, kAlong},
    {Qt::Key_Up, &KeyDirection::forward, 1.0, kAlong},
    {Qt::Key_Down, &KeyDirection::forward, -1.0, kAlong},
    {Qt::Key_PageUp, &KeyDirection::up, 1.0, QT_TRANSLATE_NOOP("HeldKeys", "away from the sample")},
    {Qt::Key_PageDown, &KeyDirection::up, -1.0, QT_TRANSLATE_NOOP("HeldKeys", "into the sample")},
}};

/// What a modifier does to the speed; the first that is held counts.
struct SpeedKey {
    Qt::KeyboardModifier modifier;
    double factor;
    const char* name;
    const char* effect;
};

constexpr std::array<SpeedKey, 2> kSpeedKeys{{
    {Qt::ShiftModifier, 0.1, QT_TRANSLATE_NOOP("HeldKeys", "Shift and such a key"),
     QT_TRANSLATE_NOOP("HeldKeys", "a tenth of the speed")},
    {Qt::ControlModifier, 5.0, QT_TRANSLATE_NOOP("HeldKeys", "Ctrl and such a key"),
     QT_TRANSLATE_NOOP("HeldKeys", "five times as fast")},
}};

bool movesTheDevice(int key) {
    return std::any_of(kMovingKeys.begin(), kMovingKeys.end(),
                       [key](const MovingKey& moving) { return moving.key == key; });
}

double speed(Qt::KeyboardModifiers modifiers) {
    for (const SpeedKey& key : kSpeedKeys) {
        if (modifiers.testFlag(key.modifier)) {
            return key.factor;
        }
    }
    return 1.0;
}

}  // namespace

HeldKeys::HeldKeys(QObject* watched) : QObject(watched) { watched->installEventFilter(this); }

KeyDirection HeldKeys::direction() const {
    KeyDirection direction;
    for (const MovingKey& moving : kMovingKeys) {
        if (held_.contains(moving.key)) {
            direction.*moving.axis += moving.sign * speed(modifiers_);
        }
    }
    return direction;
}

/// One line for all keys of the same effect.
InputHelps HeldKeys::help() {
    InputHelps lines;
    for (const MovingKey& moving : kMovingKeys) {
        const QString name = QKeySequence(moving.key).toString(QKeySequence::NativeText);
        const QString effect = tr(moving.effect);
        if (!lines.empty() && lines.back().effect == effect) {
            lines.back().input += QStringLiteral(", ") + name;
        } else {
            lines.push_back({name, effect});
        }
    }
    for (const SpeedKey& key : kSpeedKeys) {
        lines.push_back({tr(key.name), tr(key.effect)});
    }
    return lines;
}

bool HeldKeys::takes(int key, Qt::KeyboardModifiers modifiers) {
    Qt::KeyboardModifiers others = modifiers;
    for (const SpeedKey& speed : kSpeedKeys) {
        others.setFlag(speed.modifier, false);
    }
    return movesTheDevice(key) && (others & ~Qt::KeypadModifier) == Qt::NoModifier;
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
