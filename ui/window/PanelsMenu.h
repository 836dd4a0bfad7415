#pragma once

#include <QObject>

class QMenu;

namespace asperity {

class WindowLayout;

/// What stands in the menu that hides and shows the parts of the window.
class PanelsMenu : public QObject {
    Q_OBJECT

public:
    /// Keeps the entries of the menu, which owns it, as the parts of the window are.
    PanelsMenu(QMenu& menu, WindowLayout& layout);

private:
    void fill();
    void check();

    QMenu& menu_;
    WindowLayout& layout_;
};

}  // namespace asperity
