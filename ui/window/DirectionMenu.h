#pragma once

#include "ui/view/ViewCamera.h"

#include <QObject>

#include <cstdint>

class QAction;
class QMenu;

namespace asperity {

/// What stands in a menu to look at the surface from its sides: keys as in ParaView and Blender.
class DirectionMenu : public QObject {
    Q_OBJECT

public:
    /// Whether keys choose the entries: those of one menu alone.
    enum class Keys : std::uint8_t { None, Digits };

    /// Adds its entries to the menu, which owns it.
    DirectionMenu(QMenu& menu, Keys keys);

    /// Shows whether there is perspective without asking for it.
    void setPerspective(bool perspective);

Q_SIGNALS:
    void sideChosen(asperity::ViewDirection side);
    void perspectiveChosen(bool perspective);

private:
    QAction* perspective_;
};

}  // namespace asperity
