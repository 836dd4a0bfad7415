#pragma once

#include "ui/view/Shading.h"
#include "ui/view/ViewCamera.h"

#include <QObject>

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

class QAction;
class QMenu;

namespace asperity {

/// Menu entries that switch the options of a view.
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

/// Menu entries that look at the surface from its sides: keys as in ParaView and Blender.
class DirectionMenu : public QObject {
    Q_OBJECT

public:
    /// Keys that choose the entries; only one menu may have them.
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
