#pragma once

#include <QObject>

class QMenu;

namespace asperity {

/// Which theme the windows have: one of a menu's entries.
class ThemeMenu : public QObject {
    Q_OBJECT

public:
    /// Adds its entries to the menu, which owns it.
    explicit ThemeMenu(QMenu& menu);
};

}  // namespace asperity
