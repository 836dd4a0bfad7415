#pragma once

#include "ui/widgets/InputHelp.h"

#include <QObject>
#include <QSet>

namespace asperity {

/// Direction of the held keys, as seen on the screen; each part is a share of full speed.
struct KeyDirection {
    double right = 0.0;
    double forward = 0.0;  ///< away from the user, in the horizontal plane
    double up = 0.0;
};

/// Keeps track of the keys that move the device while they are held on one widget: arrows along the
/// sample, Page Up and Page Down away from it and into it; Shift: a tenth of the speed, Ctrl: five
/// times as fast. Losing the focus lets go of all of them.
class HeldKeys : public QObject {
    Q_OBJECT

public:
    /// Watches `watched`, and lives as long.
    explicit HeldKeys(QObject* watched);

    [[nodiscard]] KeyDirection direction() const;

    /// The keys that move the device, and what they do with modifiers.
    [[nodiscard]] static InputHelps help();
    /// Returns whether a shortcut of this key, with these modifiers, would take it from the device.
    [[nodiscard]] static bool takes(int key, Qt::KeyboardModifiers modifiers);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QSet<int> held_;
    Qt::KeyboardModifiers modifiers_ = Qt::NoModifier;
};

}  // namespace asperity
