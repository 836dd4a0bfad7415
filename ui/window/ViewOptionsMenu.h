#pragma once

#include "ui/view/ViewOptions.h"

#include <QObject>

#include <map>
#include <utility>
#include <vector>

class QAction;
class QMenu;

namespace asperity {

/// What stands in a menu to switch a view.
class ViewOptionsMenu : public QObject {
    Q_OBJECT

public:
    /// Adds its entries to the menu, which owns it.
    explicit ViewOptionsMenu(QMenu& menu);

    [[nodiscard]] const ViewOptions& options() const { return options_; }
    /// Shows options without asking for them.
    void setOptions(const ViewOptions& options);

    using Switch = bool ViewOptions::*;
    /// The entry of a switch.
    [[nodiscard]] QAction& action(Switch option) const;

Q_SIGNALS:
    void optionsChosen(ViewOptions options);

private:
    void addSwitch(QMenu& menu, const QString& text, Switch option, const QString& toolTip);
    void addHeightScales(QMenu& menu);
    void addLights(QMenu& menu);
    void choose(const ViewOptions& options);
    void askForHeightScale();

    QMenu& menu_;
    ViewOptions options_;
    std::vector<std::pair<Switch, QAction*>> switches_;
    std::vector<std::pair<Light, QAction*>> lights_;
    std::map<int, QAction*> factors_;
    QAction* ownFactor_ = nullptr;
};

}  // namespace asperity
