#pragma once

#include "ui/widgets/InputHelp.h"

#include <QString>
#include <QWidget>

#include <functional>
#include <vector>

class QLineEdit;
class QPagedPaintDevice;
class QTextBrowser;
class QAction;
class QMenuBar;

namespace asperity {

/// A part of the cheat sheet.
struct HelpSection {
    QString title;
    InputHelps lines;
};

/// A window of its own that lists all keys and all that the mouse does, to be searched, copied and
/// printed. The list is made when it opens: it is that of the window as it is then.
class CheatSheet : public QWidget {
    Q_OBJECT

public:
    using MakeSections = std::function<std::vector<HelpSection>()>;

    CheatSheet(MakeSections makeSections, QWidget* parent);

    [[nodiscard]] QString text() const;
    void print(QPagedPaintDevice& paper) const;

protected:
    void showEvent(QShowEvent* event) override;

private:
    void list();
    void askAndPrint();

    MakeSections makeSections_;
    QLineEdit* search_;
    QTextBrowser* list_;
};

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

/// All that keys and mouse do in the window: its menus' keys, and what its parts say of themselves.
[[nodiscard]] std::vector<HelpSection> windowHelp(const QMenuBar& bar);

}  // namespace asperity
