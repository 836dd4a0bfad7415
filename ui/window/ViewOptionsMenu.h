#pragma once

#include "ui/view/ViewOptions.h"

#include <QObject>

class QAction;
class QMenu;

namespace asperity {

/// What stands in a menu to switch the live view.
class ViewOptionsMenu : public QObject {
    Q_OBJECT

public:
    /// Adds its entries to the menu, which owns it.
    explicit ViewOptionsMenu(QMenu& menu);

Q_SIGNALS:
    void optionsChosen(ViewOptions options);

private:
    QAction* addSwitch(QMenu& menu, const QString& text, bool ViewOptions::*option);
    void addHeightScales(QMenu& menu);
    void addLights(QMenu& menu);

    ViewOptions options_;
};

}  // namespace asperity
