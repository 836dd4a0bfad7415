#pragma once

#include <QString>

#include <vector>

class QAction;
class QMenuBar;

namespace asperity {

/// An entry of a menu that has a key.
struct ActionHelp {
    QString keys;  ///< as this system writes them: "Ctrl+O"
    QString text;  ///< with the menus below the first one: "Guide › None"
    QString tip;   ///< what it does; empty: the text says all
};

struct MenuHelp {
    QString menu;
    std::vector<ActionHelp> entries;
};

/// All entries with a key, menu by menu; menus without any are left out.
[[nodiscard]] std::vector<MenuHelp> helpOf(const QMenuBar& bar);

/// All entries of the menus and of those below them, in their order; separators and menus are none.
[[nodiscard]] std::vector<QAction*> entriesOf(const QMenuBar& bar);

/// A text of a menu without the mark of its key.
[[nodiscard]] QString plainText(const QString& text);

}  // namespace asperity
